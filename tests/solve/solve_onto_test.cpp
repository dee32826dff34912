// SPDX-License-Identifier: Apache-2.0
// Fields on tet meshes as users of the library get them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "harmonics/random_samples.hpp"
#include "solve/tuned_solve.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::RandomSamples;

constexpr double kDegree_rad = std::numbers::pi / 180;

TetMesh turned(TetMesh mesh, const Quaternion& rotation) {
  for (Vector3& p : mesh.vertices) p = rotate(rotation, p);
  return mesh;
}

TetMesh scaled_mesh(TetMesh mesh, double factor) {
  for (Vector3& p : mesh.vertices) p = factor * p;
  return mesh;
}

/// The angle in degrees between a direction and the nearest axis, exact for small ones too.
double angle_to_nearest_axis_deg(const Frame& frame, const Vector3& direction) {
  double least = INFINITY;
  for (const Vector3& axis : frame.axes) {
    least = std::min(least, std::atan2(norm(cross(axis, direction)), std::abs(dot(axis, direction))));
  }
  return least / kDegree_rad;
}

/// The largest angle in degrees from an axis of the frame of a rotation to the nearest of `frame`.
double largest_angle_deg(const Frame& frame, const Quaternion& rotation) {
  double largest = 0;
  for (const Vector3& axis : axes_of(rotation))
    largest = std::max(largest, angle_to_nearest_axis_deg(frame, axis));
  return largest;
}

/// A boundary vertex of a mesh whose faces are all within 15 degrees of their area-weighted normal.
struct SmoothVertex {
  std::size_t vertex;
  Vector3 normal;
};

/// From the tets alone.
std::vector<SmoothVertex> smooth_vertices(const TetMesh& mesh) {
  std::map<std::array<std::uint32_t, 3>, std::pair<int, Vector3>> faces;
  for (const auto& tet : mesh.tets) {
    for (std::size_t opposite = 0; opposite < 4; ++opposite) {
      std::array<std::uint32_t, 3> face{tet[(opposite + 1) % 4], tet[(opposite + 2) % 4],
                                        tet[(opposite + 3) % 4]};
      std::sort(face.begin(), face.end());
      const Vector3 a = mesh.vertices[face[0]], b = mesh.vertices[face[1]], c = mesh.vertices[face[2]];
      Vector3 area = cross(b - a, c - a);
      if (dot(area, a - mesh.vertices[tet[opposite]]) < 0) area = -area;
      faces[face].first += 1;
      faces[face].second = area;
    }
  }
  std::vector<std::vector<Vector3>> areas(mesh.vertices.size());
  for (const auto& [face, use] : faces) {
    for (const std::uint32_t v : face) {
      if (use.first == 1) areas[v].push_back(use.second);
    }
  }
  std::vector<SmoothVertex> result;
  for (std::size_t v = 0; v < areas.size(); ++v) {
    Vector3 sum{0, 0, 0};
    for (const Vector3& area : areas[v]) sum += area;
    if (areas[v].empty()) continue;
    const Vector3 normal = normalised(sum);
    if (std::all_of(areas[v].begin(), areas[v].end(), [&](const Vector3& area) {
          return dot(normalised(area), normal) > std::cos(15 * kDegree_rad);
        }))
      result.push_back({v, normal});
  }
  return result;
}

SolveReport::Onto onto_of(const TetFrameField& field) {
  return field.report().onto.value();
}

TEST(SolveOnto, GivesATiltedBoxItsOwnFrameOnVerticesAndTets) {
  for (const unsigned seed : {1u, 2u}) {
    const Quaternion tilt = RandomSamples(seed).rotation();
    const TetFrameField field = solve_onto(TetDomain(turned(TetBox{{8, 6, 5}}.mesh(0.15), tilt)));
    for (std::size_t i = 0; i < field.domain().mesh().vertices.size(); ++i) {
      ASSERT_LT(largest_angle_deg(field.vertex_frame(i), tilt), 0.1);
    }
    for (std::size_t t = 0; t < field.domain().mesh().tets.size(); ++t) {
      ASSERT_LT(largest_angle_deg(field.tet_frame(t), tilt), 0.1);
    }
    EXPECT_TRUE(onto_of(field).singular.interior_faces == 0);
  }
}

class SolveOntoCylinder : public ::testing::Test {
 protected:
  static TetDomain domain(double factor = 1) { return TetDomain(scaled_mesh(tet_cylinder(8), factor)); }
};

TEST_F(SolveOntoCylinder, LowersTheDirichletEnergyOfWhatIsCarriedOver) {
  const TetFrameField field = solve_onto(domain());
  SolveTuning carried_only;
  carried_only.onto.relaxation_sweeps = carried_only.onto.most_sweeps = 0;
  const TetFrameField carried = carry_onto(field.grid(), domain(), carried_only);
  EXPECT_LT(onto_of(field).dirichlet, onto_of(carried).dirichlet);
}

TEST_F(SolveOntoCylinder, EndsAsLowAsFromTheBestOfItsStarts) {
  SolveTuning options;
  options.onto.race_margin = 1;  // all are finished
  const SolveReport::Onto best = onto_of(solve_onto(domain(), options));
  std::vector<OtherStart> starts = options.onto.other_starts;
  starts.insert(starts.begin(), OtherStart{});
  options.onto.other_starts.clear();
  const SolveTuning sized = sized_for(domain(), options);
  std::vector<double> energies;
  for (const OtherStart& start : starts) {
    SolveTuning own = sized;
    own.cell_size *= start.cell_size;
    own.solver.boundary_weight *= start.boundary_weight;
    energies.push_back(onto_of(solve_onto(domain(), own)).dirichlet);
  }
  // The race interrupts the sweeps once, so cells that rest wake up.
  EXPECT_NEAR(best.dirichlet / *std::min_element(energies.begin(), energies.end()), 1, 2e-3);
  EXPECT_NEAR(best.dirichlet / energies[best.start], 1, 2e-3);
}

TEST_F(SolveOntoCylinder, HoldsTheNormalsOfSmoothVerticesExactly) {
  for (const TetBoundary boundary : {TetBoundary::kAll, TetBoundary::kSmoothOnly}) {
    SolveTuning options;
    options.boundary = boundary;
    const TetFrameField field = solve_onto(domain(), options);
    const auto smooth = smooth_vertices(field.domain().mesh());
    EXPECT_GT(smooth.size(), 200u);
    for (const auto& [vertex, normal] : smooth) {
      ASSERT_LT(angle_to_nearest_axis_deg(field.vertex_frame(vertex), normal), 1e-9) << vertex;
    }
  }
}

TEST_F(SolveOntoCylinder, IsTheSameFieldInUnitsOfAnotherPowerOfTwo) {
  const TetFrameField expected = solve_onto(domain());
  for (const int power : {-9, 11}) {
    const double factor = std::ldexp(1.0, power);
    const TetFrameField field = solve_onto(domain(factor));
    EXPECT_NEAR(onto_of(field).dirichlet / factor / onto_of(expected).dirichlet, 1, 1e-6);
    EXPECT_EQ(onto_of(field).singular.interior_faces, onto_of(expected).singular.interior_faces);
  }
}

TEST_F(SolveOntoCylinder, IsTheSameToTheBitForOneAndTwoThreads) {
  std::vector<std::vector<Frame>> frames;
  std::vector<double> energies;
  for (const int threads : {1, 2}) {
    SolveTuning options;
    options.threads = threads;
    const TetFrameField field = solve_onto(domain(), options);
    frames.emplace_back();
    for (std::size_t i = 0; i < field.domain().mesh().vertices.size(); ++i)
      frames.back().push_back(field.vertex_frame(i));
    for (std::size_t t = 0; t < field.domain().mesh().tets.size(); ++t)
      frames.back().push_back(field.tet_frame(t));
    energies.push_back(onto_of(field).dirichlet);
  }
  EXPECT_TRUE(std::equal(frames[0].begin(), frames[0].end(), frames[1].begin(), frames[1].end(),
                         [](const Frame& a, const Frame& b) { return a.axes == b.axes; }));
  EXPECT_EQ(energies[0], energies[1]);
}

void expect_same_bits(const TetFrameField& a, const TetFrameField& b) {
  EXPECT_EQ(a.vertex_quaternions(), b.vertex_quaternions());
  EXPECT_EQ(a.tet_quaternions(), b.tet_quaternions());
  EXPECT_EQ(onto_of(a).dirichlet, onto_of(b).dirichlet);
}

TEST_F(SolveOntoCylinder, WithAFieldOnTheGridMadeElsewhereIsTheSameToTheBit) {
  OntoStart start;
  start.solve = [](const FrameField* earlier, const TriangleMesh& surface, const SolveTuning& sized,
                   const Monitor& monitor) {
    EXPECT_EQ(earlier, nullptr);
    return std::optional(solve(surface, sized, monitor));
  };
  expect_same_bits(solve_onto(domain(), start, SolveTuning(), {}).value(), solve_onto(domain()));
}

TEST_F(SolveOntoCylinder, FromAnEarlierFieldIsWhatThatBecomesToTheBit) {
  const FrameField earlier = solve_onto(domain()).grid();
  SolveTuning options;
  options.seed = 7;
  OntoStart start;
  start.earlier = &earlier;
  const TetFrameField field = solve_onto(domain(), start, options, {}).value();
  SolveTuning sized = sized_for(domain(), options);
  sized.onto.other_starts.clear();
  expect_same_bits(field, carry_onto(solve_from(earlier, domain().boundary(), sized), domain(), sized));
}

TEST_F(SolveOntoCylinder, IsNothingWhereAnotherProcessHasTheFieldOnTheGrid) {
  OntoStart start;
  start.solve = [](const FrameField*, const TriangleMesh&, const SolveTuning&,
                   const Monitor&) -> std::optional<FrameField> { return std::nullopt; };
  EXPECT_FALSE(solve_onto(domain(), start, SolveTuning(), {}));
}

TEST_F(SolveOntoCylinder, HasNearlyTheSameEnergyHoweverItIsTurned) {
  // On coarser tets the places that singular curves can take differ by 3 %.
  const TetMesh mesh = tet_cylinder(12);
  const double upright = onto_of(solve_onto(TetDomain(mesh))).dirichlet;
  for (const unsigned seed : {3u, 4u, 5u}) {
    const Quaternion turn = RandomSamples(seed).rotation();
    EXPECT_NEAR(onto_of(solve_onto(TetDomain(turned(mesh, turn)))).dirichlet / upright, 1, 0.01) << seed;
  }
}

TEST_F(SolveOntoCylinder, InDegreeThreeHasNearlyTheEnergyOfDegreeFour) {
  SolveTuning options;
  options.degree = Degree::kThree;
  EXPECT_NEAR(onto_of(solve_onto(domain(), options)).dirichlet / onto_of(solve_onto(domain())).dirichlet, 1,
              0.03);
}

TEST_F(SolveOntoCylinder, CountsTheVerticesThatTheGridDoesNotReach) {
  const TetFrameField field = solve_onto(domain());
  EXPECT_EQ(onto_of(field).outside_vertices, 0u);
  const TetFrameField larger = carry_onto(field.grid(), domain(1.5));
  EXPECT_GT(onto_of(larger).outside_vertices, 100u);
  const auto& warnings = larger.report().warnings;
  EXPECT_TRUE(std::any_of(warnings.begin(), warnings.end(), [](const Warning& warning) {
    return warning.kind == WarningKind::kVerticesOutside &&
           warning.text.find("in no cell") != std::string::npos;
  }));
}

TEST_F(SolveOntoCylinder, StopsWhenInterrupted) {
  const FrameField field = solve_onto(domain()).grid();
  Monitor monitor;
  monitor.cancel();
  try {
    carry_onto(field, domain(), SolveOptions(), monitor);
    FAIL() << "went on";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
}

TEST(SolveOnto, OfABentPlateTwoTetsThickDoesNotDependOnTheGrid) {
  TetMesh plate = TetBox{{60, 24, 2}}.mesh();
  for (Vector3& p : plate.vertices) {
    // Bent along one direction by 200 degrees, and wavy along the other.
    const double angle_rad = p[0] / 17, wave = 3 * std::sin(p[1] / 8), radius = 17 + p[2] + wave;
    p = {radius * std::cos(angle_rad), radius * std::sin(angle_rad), p[1]};
  }
  const TetDomain domain(std::move(plate));
  std::vector<double> energies;
  for (const double edges : {0.8, 2.0, 3.0}) {
    SolveTuning options;
    options.onto.cell_size_edges = edges;
    energies.push_back(solve_onto(domain, options).report().onto->dirichlet);
  }
  EXPECT_GT(energies[0], 1);
  for (const double energy : energies) EXPECT_NEAR(energy / energies[0], 1, 1e-3);
}

TEST(CarryOnto, RefusesOptionsOutOfRange) {
  const TetDomain domain(TetBox{{2, 2, 2}}.mesh());
  SolveOptions options;
  options.resolution = 4;
  const FrameField field = solve(domain.boundary(), options);
  const auto refused = [&](const std::function<void(SolveOptions&)>& change) {
    SolveOptions changed = options;
    change(changed);
    try {
      carry_onto(field, domain, changed);
    } catch (const Error& error) {
      return error.kind() == ErrorKind::kUsage;
    }
    return false;
  };
  EXPECT_FALSE(refused([](SolveOptions&) {}));
  EXPECT_TRUE(refused([](SolveOptions& wrong) { wrong.threads = -1; }));
  EXPECT_TRUE(refused([](SolveOptions& wrong) { wrong.resolution = 3; }));
  EXPECT_TRUE(refused([](SolveOptions& wrong) { wrong.cell_size = NAN; }));
  EXPECT_TRUE(refused([](SolveOptions& wrong) { wrong.crease_angle_deg = 0; }));
  EXPECT_TRUE(refused([](SolveOptions& wrong) { wrong.crease_angle_deg = NAN; }));
}

TEST(SizedFor, TakesCellsOfTheSizeOfTheEdges) {
  const TetDomain domain(TetBox{{20, 10, 10}}.mesh());
  // Six tets to a unit cube, of the volume of a regular tet with this edge.
  EXPECT_NEAR(domain.typical_edge_length(), std::cbrt(std::sqrt(2.0)), 1e-12);
  SolveTuning options;
  options.onto.cell_size_edges = 0.5;
  EXPECT_EQ(sized_for(domain, options).cell_size, 0.5 * domain.typical_edge_length());
}

TEST(SizedFor, IsNotLedAstrayByATinyPartOfManyTets) {
  TetMesh mesh = TetBox{{10, 10, 10}}.mesh();
  const TetMesh lump = TetBox{{10, 10, 10}}.mesh();
  const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
  for (const Vector3& v : lump.vertices) mesh.vertices.push_back(0.01 * v + Vector3{12, 0, 0});
  for (const auto& [a, b, c, d] : lump.tets)
    mesh.tets.push_back({first + a, first + b, first + c, first + d});
  EXPECT_GT(sized_for(TetDomain(mesh)).cell_size, 0.5);
}

TEST(SizedFor, TakesAFewCellsAtLeast) {
  SolveTuning options;
  options.onto.fewest_cells = 12;
  EXPECT_EQ(sized_for(TetDomain(TetBox{{6, 2, 2}}.mesh()), options).cell_size, 0.5);
}

TEST(SizedFor, LeavesSizesThatAreGiven) {
  const TetDomain domain(TetBox{{6, 2, 2}}.mesh());
  SolveTuning with_size, with_resolution;
  with_size.cell_size = 0.1;
  with_resolution.resolution = 33;
  EXPECT_EQ(sized_for(domain, with_size).cell_size, 0.1);
  EXPECT_EQ(sized_for(domain, with_resolution).cell_size, 0);
  EXPECT_EQ(sized_for(domain, with_resolution).resolution, 33);
}

}  // namespace
}  // namespace crossgrain

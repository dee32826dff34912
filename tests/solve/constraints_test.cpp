// SPDX-License-Identifier: Apache-2.0
// Solves with constraints, as users of the library get them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "field/field_data.hpp"
#include "harmonics/random_samples.hpp"
#include "solve/tuned_solve.hpp"
#include "support/shapes.hpp"
#include "tets/tet_meshes.hpp"

namespace crossgrain {
namespace {

using testing::misorientation_rad;
using testing::RandomSamples;

constexpr double kDegree_rad = std::numbers::pi / 180;

std::vector<Vector3> axes_in_list(const Quaternion& frame) {
  const auto axes = axes_of(frame);
  return {axes.begin(), axes.end()};
}

Quaternion turn_about(const Vector3& axis, double angle_deg) {
  return from_rotation_vector(angle_deg * kDegree_rad * axis);
}

SolveOptions options_with(Constraints constraints, int resolution) {
  SolveOptions options;
  options.constraints = std::move(constraints);
  options.resolution = resolution;
  return options;
}

/// How far the field's interpolated frame at a point is from a rotation's.
double off_deg(const FrameField& field, const Vector3& point, const Quaternion& frame) {
  const auto axes = field.sample(point).frame.axes;
  double largest = 0;
  for (const Vector3& asked : axes_of(frame)) {
    double cosine = 0;
    for (const Vector3& axis : axes) cosine = std::max(cosine, std::abs(dot(axis, asked)));
    largest = std::max(largest, std::acos(std::min(1.0, cosine)));
  }
  return largest / kDegree_rad;
}

TEST(ConstrainedSolve, TurnsTheFieldAtThePointOfAFrame) {
  const TriangleMesh box = make_box({1, 1, 1});
  const Quaternion asked = turn_about(normalised(Vector3{1, 2, -1}), 40);
  const Vector3 place{0.03, -0.05, 0.11};
  ASSERT_GT(off_deg(solve(box, options_with({}, 24)), place, asked), 25);
  double before = INFINITY;
  for (const double weight : {0.001, 0.01, 0.1, 1.0}) {
    const FrameField field = solve(box, options_with({.points = {{place, axes_in_list(asked), weight}}}, 24));
    const double off = off_deg(field, place, asked);
    EXPECT_LT(off, before);
    before = off;
    const auto& report = field.report().constraints->points;
    EXPECT_EQ(report.count, 1u);
    EXPECT_NEAR(*report.angle_deg.max, off, 1e-4);
  }
  EXPECT_LT(before, 1);
}

TEST(ConstrainedSolve, MeetsAPointAlikeAtAnyResolutionButItsReachShrinks) {
  const TriangleMesh box = make_box({1, 1, 1});
  const Quaternion asked = turn_about({0, 0, 1}, 40);
  const Vector3 place{0.03, -0.05, 0.11}, beside{0.18, -0.05, 0.11};
  std::vector<double> turned_beside;
  for (const int resolution : {12, 24, 48}) {
    const FrameField field = solve(box, options_with({.points = {{place, axes_in_list(asked)}}}, resolution));
    EXPECT_LT(off_deg(field, place, asked), 1);
    turned_beside.push_back(40 - off_deg(field, beside, asked));
  }
  // A point holds a field of least energy by its cells only: what is left at a distance falls with them.
  EXPECT_LT(turned_beside[1], 0.7 * turned_beside[0]);
  EXPECT_LT(turned_beside[2], 0.7 * turned_beside[1]);
  EXPECT_GT(turned_beside[2], 2);
}

TEST(ConstrainedSolve, InDegreeThreeTurnsTheFieldToo) {
  const Quaternion asked = turn_about({0, 0, 1}, 30);
  SolveOptions options = options_with({.points = {{{0, 0, 0}, axes_in_list(asked)}}}, 16);
  options.degree = Degree::kThree;
  EXPECT_LT(off_deg(solve(make_box({1, 1, 1}), options), {0, 0, 0}, asked), 3);
}

TEST(ConstrainedSolve, TurnsWithModelAndConstraints) {
  const Quaternion asked = turn_about({0, 0, 1}, 35), turn = RandomSamples(4).rotation();
  const TriangleMesh box = make_box({1, 0.8, 0.9});
  const Vector3 place{0.1, 0.05, -0.1};
  Constraints upright{.points = {{place, axes_in_list(asked)}}}, turned = upright;
  upright.polylines = {{{{-0.3, -0.2, 0.3}, {0.2, 0.3, 0.2}}}};
  turned.points[0].at = rotate(turn, place);
  turned.points[0].axes = axes_in_list(turn * asked);
  turned.polylines = upright.polylines;
  for (Vector3& point : turned.polylines[0].points) point = rotate(turn, point);
  // The turned box has a larger bounding box: cells of the same size.
  SolveOptions options = options_with(upright, 0);
  options.cell_size = 1.0 / 32;
  const FrameField field = solve(box, options);
  options.constraints = turned;
  const FrameField turned_field = solve(rotate_mesh(box, turn), options);
  RandomSamples random(5);
  double sum_deg = 0;
  constexpr int kPlaces = 200;
  for (int k = 0; k < kPlaces; ++k) {
    const Vector3 probe = 0.35 * std::cbrt((k + 0.5) / kPlaces) * random.direction();
    const auto& axes = field.sample(probe).frame.axes;
    const auto& others = turned_field.sample(rotate(turn, probe)).frame.axes;
    double largest = 0;
    for (const Vector3& axis : axes) {
      double cosine = 0;
      for (const Vector3& other : others) cosine = std::max(cosine, std::abs(dot(rotate(turn, axis), other)));
      largest = std::max(largest, std::acos(std::min(1.0, cosine)) / kDegree_rad);
    }
    sum_deg += largest;
  }
  EXPECT_LT(sum_deg / kPlaces, 2);
  EXPECT_NEAR(*field.report().constraints->polylines.angle_deg.mean,
              *turned_field.report().constraints->polylines.angle_deg.mean, 4);
}

TEST(ConstrainedSolve, FollowsAStressThatTurnsAlongABeam) {
  const TriangleMesh beam = make_box({3, 1, 1});
  const auto twist_deg = [](double x) { return 20 * x; };
  Constraints constraints;
  for (double x = -1.4; x < 1.45; x += 0.1) {
    for (double y = -0.2; y < 0.25; y += 0.1) {
      for (double z = -0.2; z < 0.25; z += 0.1) {
        const double c = std::cos(2 * twist_deg(x) * kDegree_rad),
                     s = std::sin(2 * twist_deg(x) * kDegree_rad);
        // Tension along one axis across the beam, pressure along the other.
        constraints.stresses.push_back({{x, y, z}, {0, c, -c, s, 0, 0}});
      }
    }
  }
  const FrameField field = solve(beam, options_with(constraints, 30));
  for (const double x : {-1.2, -0.55, 0.0, 0.35, 0.9, 1.3})
    EXPECT_LT(off_deg(field, {x, 0.02, 0.01}, turn_about({1, 0, 0}, twist_deg(x))), 2) << x;
  const SolveReport::Constraints& report = *field.report().constraints;
  EXPECT_EQ(report.stresses.count, constraints.stresses.size());
  EXPECT_EQ(report.stresses.outside, 0u);
  EXPECT_LT(*report.stresses.angle_deg.mean, 2);
  // The surface is still met.
  EXPECT_LT(field.report().alignment_deg.mean.value(), 3);
}

TEST(ConstrainedSolve, LetsTheSurfaceSpeakWhereManyStressesShareItsCells) {
  // All along the boundary layer, ten a cell, and 30 degrees off the surface.
  Constraints constraints;
  RandomSamples random(6);
  const double c = std::cos(60 * kDegree_rad), s = std::sin(60 * kDegree_rad);
  for (int k = 0; k < 4000; ++k) {
    const Vector3 direction = random.direction();
    constraints.stresses.push_back({{0.45 * direction[0], 0.45 * direction[1], 0.49}, {c, -c, 0, 0, 0, s}});
  }
  const FrameField field = solve(make_box({1, 1, 1}), options_with(constraints, 16));
  // They agree with the top of the box, whose normal is z.
  EXPECT_LT(*field.report().constraints->stresses.angle_deg.mean, 4);
  EXPECT_LT(field.report().alignment_deg.mean.value(), 6);
}

TEST(ConstrainedSolve, OntoTetsTurnsTheVerticesInside) {
  const Quaternion asked = turn_about(normalised(Vector3{1, 2, -1}), 30);
  const TetMesh mesh = TetBox{{8, 8, 8}}.mesh();
  const TetDomain domain(mesh);
  Vector3 middle{0, 0, 0};
  for (const Vector3& p : mesh.vertices) middle += (1.0 / static_cast<double>(mesh.vertices.size())) * p;
  const auto off_in_the_middle = [&](double weight) {
    SolveOptions options;
    if (weight > 0) options.constraints.points = {{middle, axes_in_list(asked), weight}};
    const TetFrameField field = solve_onto(domain, options);
    std::size_t nearest = 0;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      if (norm(mesh.vertices[v] - middle) < norm(mesh.vertices[nearest] - middle)) nearest = v;
    }
    double largest = 0;
    for (const Vector3& axis : axes_of(asked)) {
      double cosine = 0;
      for (const Vector3& other : field.vertex_frame(nearest).axes)
        cosine = std::max(cosine, std::abs(dot(axis, other)));
      largest = std::max(largest, std::acos(std::min(1.0, cosine)) / kDegree_rad);
    }
    return largest;
  };
  EXPECT_GT(off_in_the_middle(0), 20);
  EXPECT_LT(off_in_the_middle(1), 3);
  EXPECT_LT(off_in_the_middle(10), 0.5);
}

TEST(ConstrainedSolve, OfATetMeshKnowsTheTagsOfItsBoundary) {
  TetMesh mesh = TetBox{{4, 4, 4}}.mesh();
  const TriangleMesh plain = TetDomain(mesh).boundary();
  EXPECT_TRUE(plain.faces.empty());
  // The vertices of the boundary are numbered anew: tag the first triangle by its place.
  std::array<std::uint32_t, 3> first;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector3& corner = plain.vertices[plain.triangles[0][k]];
    first[k] = static_cast<std::uint32_t>(std::find(mesh.vertices.begin(), mesh.vertices.end(), corner) -
                                          mesh.vertices.begin());
  }
  mesh.feature_faces = {{{first[1], first[0], first[2]}, 42}};
  const TriangleMesh tagged = TetDomain(mesh).boundary();
  ASSERT_EQ(tagged.faces.size(), tagged.triangles.size());
  EXPECT_EQ(tagged.faces[0], 42);
  EXPECT_EQ(std::count(tagged.faces.begin(), tagged.faces.end(), 0),
            static_cast<std::ptrdiff_t>(tagged.faces.size()) - 1);
}

TEST(ConstrainedSolve, FollowsAPolylineInAPlate) {
  const TriangleMesh plate = make_box({4, 3, 1});
  const Vector3 a{-1.5, -1.1, 0}, b{-0.5, 0.9, 0}, c{1.5, 1.1, 0};
  const auto mean_deg = [&](double weight, bool is_there) {
    Constraints constraints{.polylines = {{{a, b, c}, {}, is_there ? weight : 1e-9}}};
    const FrameField field = solve(plate, options_with(constraints, 40));
    const auto& report = field.report().constraints->polylines;
    EXPECT_NEAR(report.length, norm(b - a) + norm(c - b), 1e-12);
    EXPECT_EQ(report.outside, 0u);
    EXPECT_EQ(report.outside_length, 0);
    return *report.angle_deg.mean;
  };
  const double without = mean_deg(1, false), at_1 = mean_deg(1, true), at_10 = mean_deg(10, true);
  EXPECT_GT(without, 10);
  EXPECT_LT(at_1, 6);
  EXPECT_LT(at_10, at_1);
}

TEST(ConstrainedSolve, TurnsTheFieldOnAFaceAboutItsNormal) {
  TriangleMesh box = make_box({1, 1, 1});
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    const auto& [a, b, c] = box.triangles[t];
    const bool top = std::min({box.vertices[a][2], box.vertices[b][2], box.vertices[c][2]}) > 0;
    box.faces.push_back(top ? 7 : 1);
  }
  const Vector3 axis = axes_of(turn_about({0, 0, 1}, 30))[0];
  const FrameField field = solve(box, options_with({.faces = {{7, {axis}}}}, 32));
  const auto& faces = field.report().constraints->faces;
  EXPECT_EQ(faces.count, 1u);
  EXPECT_NEAR(faces.area, 1, 1e-5);
  EXPECT_LT(*faces.angle_deg.mean, 6);
  EXPECT_LT(off_deg(field, {0.1, 0.05, 0.49}, turn_about({0, 0, 1}, 30)), 4);
}

TEST(ConstrainedSolve, RefinesWhereConstraintsAre) {
  const TriangleMesh ball = make_sphere(0.8, 4);
  const Vector3 place{0.02, 0.03, -0.01};
  const Constraints constraints{.points = {{place, axes_in_list({1, 0, 0, 0})}}};
  const auto size_at = [&](const SolveOptions& options) {
    SolveTuning plain(options);
    plain.solver.energy_density_threshold = std::numeric_limits<double>::infinity();
    const FrameField field = solve(ball, plain);
    const Octree& tree = field.data().tree;
    return tree.cell_size(tree.find_containing(*tree.root().locate(place)));
  };
  EXPECT_NEAR(size_at(options_with(constraints, 64)), 1.6 / 64, 1e-3);
  EXPECT_GT(size_at(options_with({}, 64)), 1.5 * 1.6 / 64);
}

TEST(ConstrainedSolve, GivesTheSameBitsOnOneThreadAndTwo) {
  TriangleMesh box = make_box({1, 0.9, 0.8});
  box.faces.assign(box.triangles.size(), 3);
  Constraints constraints{.points = {{{0.1, 0.1, 0.1}, axes_in_list(turn_about({0, 0, 1}, 30))}},
                          .polylines = {{{{-0.4, -0.4, -0.3}, {0.4, 0.3, 0.3}}}},
                          .faces = {{3, {{0, 0.6, 0.8}}, 0.2}}};
  RandomSamples random(8);
  for (int k = 0; k < 500; ++k)
    constraints.stresses.push_back({0.3 * random.direction(), {1, 2, 3, 0.1 * k, 0.3, 0.2}});
  SolveOptions options = options_with(constraints, 24);
  options.threads = 1;
  const FrameField first = solve(box, options);
  options.threads = 2;
  const FrameField second = solve(box, options);
  const auto &a = first.data().frames, &b = second.data().frames;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
    ASSERT_TRUE(a[i].w == b[i].w && a[i].x == b[i].x && a[i].y == b[i].y && a[i].z == b[i].z);
  EXPECT_EQ(first.report().constraints->stresses.angle_deg.mean,
            second.report().constraints->stresses.angle_deg.mean);
}

TEST(ConstrainedSolve, IsThatWithoutConstraintsWhereTheySayNothing) {
  const TriangleMesh box = make_box({1, 0.9, 0.8});
  const FrameField plain = solve(box, options_with({}, 16));
  const FrameField same = solve(box, options_with({.stresses = {{{0, 0, 0}, {5, 5, 5, 0, 0, 0}}}}, 16));
  EXPECT_FALSE(plain.report().constraints.has_value());
  EXPECT_EQ(same.report().constraints->isotropic_stresses, 1u);
  EXPECT_FALSE(same.report().constraints->stresses.angle_deg.mean.has_value());
  EXPECT_EQ(plain.report().energy.total, same.report().energy.total);
}

TEST(ConstrainedSolve, CountsWhatIsOutsideAndWarnsOnce) {
  const std::vector<Vector3> x{{1, 0, 0}};
  const Constraints constraints{.points = {{{0, 0, 0}, x}, {{0, 0, 7}, x}, {{0.51, 0.51, 0.51}, x}},
                                .polylines = {{{{0, 0, 0}, {0, 0, 2}}, x},
                                              {{{0, 0, 0}, {0.4, 0, 0}}, x},
                                              {{{1e30, 0, 0}, {1e30, 1, 0}}, x}},
                                .stresses = {{{-3, 0, 0}, {1, 0, 0, 0, 0, 0}}}};
  const FrameField field = solve(make_box({1, 1, 1}), options_with(constraints, 16));
  const SolveReport::Constraints& report = *field.report().constraints;
  // The corner of the box is within half a cell.
  EXPECT_EQ(report.points.outside, 1u);
  EXPECT_EQ(report.stresses.outside, 1u);
  EXPECT_EQ(report.polylines.outside, 2u);
  EXPECT_NEAR(report.polylines.length, 3.4, 1e-9);
  EXPECT_NEAR(report.polylines.outside_length, 2.5, 0.1);
  const Warning expected(
      WarningKind::kConstraintsOutside,
      "constraints outside the solid: 1 of 3 points, 1 of 1 stress, 2 of 3 polylines (in part), the first "
      "at 0 0 7; they have no effect");
  EXPECT_EQ(std::count(field.report().warnings.begin(), field.report().warnings.end(), expected), 1);
}

std::string error_of(const TriangleMesh& mesh, const Constraints& constraints) {
  try {
    solve(mesh, options_with(constraints, 8));
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    return error.what();
  }
  return "";
}

TEST(ConstrainedSolve, RefusesWhatCannotBeMeant) {
  const TriangleMesh box = make_box({1, 1, 1});
  const std::vector<Vector3> x{{1, 0, 0}};
  EXPECT_NE(error_of(box, {.points = {{{500, 0, 0}, x}}}).find("same unit"), std::string::npos);
  EXPECT_NE(error_of(box, {.polylines = {{{{2, -2, 0}, {2, 2, 0}}}}}).find("same unit"), std::string::npos);
  EXPECT_EQ(error_of(box, {.polylines = {{{{-2, 0, 0}, {2, 0, 0}}}}}), "");
  EXPECT_NE(error_of(box, {.faces = {{2}}}).find("no numbered faces"), std::string::npos);
  EXPECT_NE(error_of(box, {.points = {{{0, 0, 0}, x, -1}}}).find("weight"), std::string::npos);
}

}  // namespace
}  // namespace crossgrain

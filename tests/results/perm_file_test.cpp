// SPDX-License-Identifier: Apache-2.0
// The matchings of .perm files: against a search over all 24, there and back, and composed around edges. The
// files are read, and all of this is worked out, with nothing of the library but the tets that its solid has.
//
// The models are in the folder that CROSSGRAIN_SHARED names; their tests are skipped where it is absent.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/reading.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/solve.hpp"
#include "files/temporary_folder.hpp"
#include "measure/made_tets.hpp"
#include "results/frame_file_rows.hpp"
#include "results/onto_files.hpp"
#include "results/sample_field.hpp"
#include "singularity/tet_matchings.hpp"
#include "solve/tet_domain_data.hpp"

namespace crossgrain {
namespace {

using frame_files::Permutation;
using frame_files::Row;
using EdgeEnds = std::pair<std::uint32_t, std::uint32_t>;
using FaceCorners = std::array<std::uint32_t, 3>;

constexpr Permutation kStay{1, 2, 3};

/// First `first`, then `second`.
Permutation composed(const Permutation& first, const Permutation& second) {
  Permutation both;
  for (std::size_t k = 0; k < 3; ++k) {
    const int image = second[static_cast<std::size_t>(std::abs(first[k]) - 1)];
    both[k] = first[k] > 0 ? image : -image;
  }
  return both;
}

/// How well frames agree once named alike: the sum of the cosines of the angles between their axes.
double agreement(const Row& from, const Row& to, const Permutation& matching) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto j = static_cast<std::size_t>(std::abs(matching[k]) - 1);
    for (std::size_t i = 0; i < 3; ++i) sum += (matching[k] > 0 ? 1 : -1) * from[3 * k + i] * to[3 * j + i];
  }
  return sum;
}

/// Those of the 48 signed permutations that turn the cube, or the others, which reflect it.
std::vector<Permutation> cube_symmetries(bool turning) {
  std::vector<Permutation> symmetries;
  Permutation order = kStay;
  do {
    for (int signs = 0; signs < 8; ++signs) {
      Permutation symmetry = order;
      int flips = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        if (signs >> k & 1) symmetry[k] = -symmetry[k], ++flips;
        for (std::size_t j = k + 1; j < 3; ++j) flips += order[k] > order[j];
      }
      if ((flips % 2 == 0) == turning) symmetries.push_back(symmetry);
    }
  } while (std::next_permutation(order.begin(), order.end()));
  return symmetries;
}

/// The files of a field, and the tets that they number.
struct Written {
  std::vector<std::array<std::uint32_t, 4>> tets;
  std::vector<Row> axes;
  frame_files::PermFile perm;
  std::map<std::array<std::uint32_t, 2>, Permutation> matchings;
  std::map<FaceCorners, std::vector<std::uint32_t>> tets_of_face;

  Written(const std::filesystem::path& folder, const TetMesh& mesh)
      : tets(mesh.tets),
        axes(frame_files::read_fra(folder / "onto.fra")),
        perm(frame_files::read_perm(folder / "onto.perm")) {
    for (const auto& [pair, matching] : perm.rows) matchings.insert({pair, matching});
    for (std::uint32_t t = 0; t < tets.size(); ++t) {
      for (std::size_t opposite = 0; opposite < 4; ++opposite)
        tets_of_face[face_of(t, opposite)].push_back(t);
    }
  }

  FaceCorners face_of(std::uint32_t tet, std::size_t opposite) const {
    FaceCorners face;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 4; ++k)
      if (k != opposite) face[count++] = tets[tet][k];
    std::sort(face.begin(), face.end());
    return face;
  }

  /// Where nothing is said, axes keep their names.
  Permutation matching(std::uint32_t from, std::uint32_t to) const {
    if (const auto forth = matchings.find({from, to}); forth != matchings.end()) return forth->second;
    const auto back = matchings.find({to, from});
    if (back == matchings.end()) return kStay;
    Permutation inverse;
    for (std::size_t k = 0; k < 3; ++k) {
      const int image = back->second[k];
      inverse[static_cast<std::size_t>(std::abs(image) - 1)] = static_cast<int>(k + 1) * (image > 0 ? 1 : -1);
    }
    return inverse;
  }

  /// The product of the matchings around an edge, from face to face; nothing where the way does not close.
  std::optional<Permutation> around(const EdgeEnds& edge, std::uint32_t start) const {
    const auto beside = [&](std::uint32_t tet) {
      std::vector<std::size_t> corners;
      for (std::size_t k = 0; k < 4; ++k)
        if (tets[tet][k] != edge.first && tets[tet][k] != edge.second) corners.push_back(k);
      return corners;
    };
    Permutation product = kStay;
    std::uint32_t tet = start;
    FaceCorners entered = face_of(start, beside(start)[0]);
    do {
      const auto corners = beside(tet);
      const FaceCorners a = face_of(tet, corners[0]), b = face_of(tet, corners[1]);
      const FaceCorners left = a == entered ? b : a;
      const auto& sides = tets_of_face.at(left);
      if (sides.size() != 2) return std::nullopt;
      const std::uint32_t next = sides[0] == tet ? sides[1] : sides[0];
      product = composed(product, matching(tet, next));
      entered = left;
      tet = next;
    } while (tet != start);
    return product;
  }

  std::set<EdgeEnds> turning_edges() const {
    std::map<EdgeEnds, std::uint32_t> first_tets;
    for (std::uint32_t t = 0; t < tets.size(); ++t) {
      for (const std::uint32_t v : tets[t])
        for (const std::uint32_t w : tets[t])
          if (v < w) first_tets.insert({{v, w}, t});
    }
    std::set<EdgeEnds> edges;
    for (const auto& [edge, tet] : first_tets) {
      const auto product = around(edge, tet);
      if (product && *product != kStay) edges.insert(edge);
    }
    return edges;
  }
};

std::set<EdgeEnds> edges_of_graph(const TetSolid& solid, const TetField& field) {
  const SingularEdges singular =
      singular_tet_edges(solid, field.tet_frames, tet_matchings(solid, field.tet_frames));
  std::set<EdgeEnds> edges;
  for (const SingularEdge& edge : singular.edges) {
    const auto [a, b] = std::minmax(singular.points[edge.ends[0]].name, singular.points[edge.ends[1]].name);
    edges.insert({static_cast<std::uint32_t>(a), static_cast<std::uint32_t>(b)});
  }
  return edges;
}

/// Every row is of two tets that share a face, no two of the same, and none says what holds anyway.
void expect_well_formed(const Written& written) {
  ASSERT_EQ(written.perm.tets, written.tets.size());
  ASSERT_EQ(written.axes.size(), written.tets.size());
  std::set<std::array<std::uint32_t, 2>> neighbours;
  for (const auto& [face, tets] : written.tets_of_face)
    if (tets.size() == 2) neighbours.insert({std::min(tets[0], tets[1]), std::max(tets[0], tets[1])});
  std::set<std::array<std::uint32_t, 2>> seen;
  for (const auto& [pair, matching] : written.perm.rows) {
    const std::array<std::uint32_t, 2> ascending{std::min(pair[0], pair[1]), std::max(pair[0], pair[1])};
    EXPECT_TRUE(neighbours.contains(ascending)) << pair[0] << " and " << pair[1];
    EXPECT_TRUE(seen.insert(ascending).second) << pair[0] << " and " << pair[1];
    EXPECT_NE(matching, kStay);
  }
}

/// Of no face does any other naming bring the frames nearer, reflections neither, from either side.
void expect_best_of_all(const Written& written) {
  constexpr double kRounding = 1e-12;
  const auto turns = cube_symmetries(true), reflections = cube_symmetries(false);
  ASSERT_EQ(turns.size(), 24u);
  ASSERT_EQ(reflections.size(), 24u);
  std::size_t undecided = 0;
  for (const auto& [face, tets] : written.tets_of_face) {
    if (tets.size() != 2) continue;
    for (const auto& [from, to] : {std::pair(tets[0], tets[1]), std::pair(tets[1], tets[0])}) {
      const auto agreed = [&](const Permutation& m) {
        return agreement(written.axes[from], written.axes[to], m);
      };
      const Permutation chosen = written.matching(from, to);
      const double best = agreed(chosen);
      for (const Permutation& other : turns) {
        if (other == chosen) continue;
        ASSERT_LE(agreed(other), best + kRounding) << from << " to " << to;
        if (agreed(other) > best - kRounding) ++undecided;
      }
      for (const Permutation& other : reflections) ASSERT_LT(agreed(other), best) << from << " to " << to;
    }
  }
  EXPECT_EQ(undecided, 0u) << "faces with two that are equally near";
}

void expect_there_and_back(const Written& written) {
  for (const auto& [pair, matching] : written.perm.rows) {
    EXPECT_EQ(composed(written.matching(pair[0], pair[1]), written.matching(pair[1], pair[0])), kStay);
    EXPECT_EQ(written.matching(pair[0], pair[1]), matching);
  }
}

struct MadeField {
  explicit MadeField(TetMesh mesh, double spread_rad) : solid(solid_of(std::move(mesh))) {
    onto.vertex_frames = scattered_frames(solid.mesh.vertices.size(), spread_rad);
    onto.tet_frames = scattered_frames(solid.mesh.tets.size(), spread_rad);
    OutputOptions options;
    options.formats = {"fra", "perm"};
    write_field_onto(field_of(sample_data(Degree::kFour)), sample_report(), {solid, onto, {}}, folder.path(),
                     {}, options);
  }

  TemporaryFolder folder;
  TetSolid solid;
  TetField onto;
};

TEST(PermFile, OfFramesThatAgreeHasNoRows) {
  const MadeField made(tet_box({2, 2, 2}), 0);
  EXPECT_EQ(content_of(made.folder.path() / "onto.perm"), "PERM 1\n48 0 3\n");
}

TEST(PermFile, SaysWhereEachAxisGoes) {
  MadeField made(tet_box({1, 1, 1}), 0);
  // One tet has its axes named anew: they are y, z and x, those of all others x, y and z.
  made.onto.tet_frames[0] = {0.5, 0.5, 0.5, 0.5};
  const auto axes = axes_of(made.onto.tet_frames[0]);
  EXPECT_EQ(axes[0], (Vector3{0, 1, 0}));
  OutputOptions options;
  options.formats = {"perm"};
  write_field_onto(field_of(sample_data(Degree::kFour)), sample_report(), {made.solid, made.onto, {}},
                   made.folder.path(), {}, options);
  const auto perm = frame_files::read_perm(made.folder.path() / "onto.perm");
  ASSERT_EQ(perm.rows.size(), 2u) << "two of its faces are inside";
  for (const auto& [pair, matching] : perm.rows) {
    EXPECT_EQ(pair[0], 0u);
    EXPECT_EQ(matching, (Permutation{2, 3, 1})) << "u is y, v is z, w is x";
  }
}

class ScatteredFrames : public ::testing::TestWithParam<double> {};

TEST_P(ScatteredFrames, HaveTheBestMatchingsThereAndBackAndTheEdgesOfTheGraph) {
  const MadeField made(tet_box({5, 4, 6}, 0.2), GetParam());
  const Written written(made.folder.path(), made.solid.mesh);
  expect_well_formed(written);
  expect_best_of_all(written);
  expect_there_and_back(written);
  const std::set<EdgeEnds> edges = written.turning_edges();
  EXPECT_EQ(edges, edges_of_graph(made.solid, made.onto));
  EXPECT_FALSE(edges.empty());
}

INSTANTIATE_TEST_SUITE_P(SpreadRad, ScatteredFrames, ::testing::Values(0.3, 0.6, 3.0));

TEST(PermFile, PassesOverFacesToTetsThatAreLeftOut) {
  TetMesh mesh = tet_box({3, 3, 3});
  mesh.tets.insert(mesh.tets.begin() + 7, {0, 1, 4, 5});  // a square of the boundary
  const MadeField made(mesh, 0.6);
  ASSERT_EQ(made.solid.left_out_tets, 1u);
  const Written written(made.folder.path(), made.solid.mesh);
  EXPECT_EQ(written.turning_edges(), edges_of_graph(made.solid, made.onto));
}

class TetModel : public ::testing::TestWithParam<std::string> {};

TEST_P(TetModel, HasTheBestMatchingsThereAndBackAndTheEdgesOfTheGraph) {
  const char* shared = std::getenv("CROSSGRAIN_SHARED");
  const auto path =
      std::filesystem::path(shared ? shared : CROSSGRAIN_DEFAULT_SHARED) / "models" / "good" / GetParam();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const TetDomain domain(read_tets(path));
  const TetFrameField field = solve_onto(domain);
  const TemporaryFolder folder;
  OutputOptions options;
  options.formats = {"fra", "perm"};
  write_field(field, folder.path(), {}, options);
  const Written written(folder.path(), domain.mesh());
  expect_well_formed(written);
  expect_best_of_all(written);
  expect_there_and_back(written);
  const std::set<EdgeEnds> edges = written.turning_edges();
  EXPECT_EQ(edges, edges_of_graph(domain.data().solid, field.data()));
  RecordProperty("faces", static_cast<int>(written.perm.rows.size()));
  RecordProperty("edges", static_cast<int>(edges.size()));
}

INSTANTIATE_TEST_SUITE_P(Shared, TetModel,
                         ::testing::Values("notch5_0.mesh", "plate.msh", "rod.msh", "s02u_prism.vtk",
                                           "sphere_r0.12.mesh", "square_pyramid_500.mesh"),
                         [](const auto& model) {
                           return model.param.substr(0, model.param.find_first_of("._")) +
                                  std::to_string(model.index);
                         });

}  // namespace
}  // namespace crossgrain

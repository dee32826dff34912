// SPDX-License-Identifier: Apache-2.0
// What a solve must not depend on: how the triangles and vertices of a model are numbered, how often it lists
// a triangle, where the model is, how large it is, and which coordinate axis is called x.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <string>

#include "crossgrain/solve.hpp"
#include "support/nightly.hpp"
#include "support/shapes.hpp"

namespace crossgrain {
namespace {

/// Relative differences of energies: of sums in another order, which the sweeps carry on until they stop, and
/// of sweeps that visit the cells another way round and settle elsewhere.
constexpr double kRounding = 1e-6, kOtherWay = 0.01;

/// What is compared: the number of arcs of each index, of nodes and of ends on the surface, and the energy.
struct Answered {
  std::map<double, int> arcs;
  std::size_t nodes = 0, ends = 0;
  double energy = 0;
  bool same_graph(const Answered& other) const {
    return arcs == other.arcs && nodes == other.nodes && ends == other.ends;
  }
};

FrameField solved(const TriangleMesh& mesh) {
  SolveOptions options;
  options.resolution = 40;
  return solve(mesh, options);
}

Answered answered(const FrameField& field) {
  Answered answer;
  for (const auto& arc : field.singularities().arcs) ++answer.arcs[arc.index];
  for (const auto& node : field.singularities().nodes) {
    answer.nodes += node.degree() > 1;
    answer.ends += node.on_boundary;
  }
  answer.energy = field.report().energy.total;
  return answer;
}

struct Model {
  const char* name;
  TriangleMesh mesh;
};

const std::vector<Model>& models() {
  static const std::vector<Model> all = [] {
    std::vector<Model> some{{"bracket", make_bracket(32)}, {"cylinder", make_cylinder(0.55, 0.7, 64, 8)}};
    if (is_nightly()) {
      some.push_back({"torus", make_torus(1, 0.4, 48, 24)});
      some.push_back({"box with a hole", make_box_with_hole(48)});
    }
    return some;
  }();
  return all;
}

/// Returns the answer for a model as it is.
const Answered& expected_of(const Model& model) {
  static std::map<std::string, Answered> known;
  if (!known.contains(model.name)) known[model.name] = answered(solved(model.mesh));
  return known.at(model.name);
}

/// Compares each model with one that is the same but for `change`.
template <class Change>
void compare(double tolerance, const Change& change) {
  for (const Model& model : models()) {
    const Answered& expected = expected_of(model);
    const Answered found = answered(solved(change(model.mesh)));
    EXPECT_TRUE(found.same_graph(expected)) << model.name;
    EXPECT_NEAR(found.energy / expected.energy, 1, tolerance) << model.name;
  }
}

TriangleMesh shuffled_triangles(TriangleMesh mesh) {
  std::mt19937 engine(1);
  std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), engine);
  for (auto& triangle : mesh.triangles)
    std::rotate(triangle.begin(), triangle.begin() + engine() % 3, triangle.end());
  return mesh;
}

TriangleMesh shuffled_vertices(TriangleMesh mesh) {
  std::mt19937 engine(2);
  std::vector<std::uint32_t> place(mesh.vertices.size());
  std::iota(place.begin(), place.end(), 0u);
  std::shuffle(place.begin(), place.end(), engine);
  const std::vector<Vector3> vertices = mesh.vertices;
  for (std::size_t k = 0; k < place.size(); ++k) mesh.vertices[place[k]] = vertices[k];
  for (auto& triangle : mesh.triangles)
    for (std::uint32_t& vertex : triangle) vertex = place[vertex];
  return mesh;
}

TEST(ASolve, DoesNotDependOnTheOrderOfTriangles) {
  compare(kRounding, shuffled_triangles);
}

TEST(ASolve, DoesNotDependOnTheNumbersOfVertices) {
  compare(kRounding, shuffled_vertices);
}

TEST(ASolve, DoesNotDependOnHowOftenATriangleIsListed) {
  compare(0, [](TriangleMesh mesh) {
    for (std::size_t k = 0; k < 20; ++k) mesh.triangles.push_back(mesh.triangles[7 * k]);
    return mesh;
  });
}

TEST(ASolve, DoesNotDependOnWhereTheModelIs) {
  compare(kRounding, [](const TriangleMesh& mesh) { return translate_mesh(mesh, {1024, -512, 256}); });
}

TEST(ASolve, OfAModelScaledByAPowerOfTwoIsTheSameToTheBit) {
  for (const Model& model : models()) {
    const Answered scaled = answered(solved(scale_mesh(model.mesh, 1.0 / 64)));
    EXPECT_EQ(scaled.energy * 64, expected_of(model).energy) << model.name;
    EXPECT_TRUE(scaled.same_graph(expected_of(model))) << model.name;
  }
}

TEST(ASolve, TurnsWithAModelTurnedByQuarters) {
  for (const bool other_way : {false, true}) {
    compare(kOtherWay, [&](TriangleMesh mesh) {
      for (Vector3& v : mesh.vertices) v = other_way ? Vector3{v[1], -v[0], v[2]} : Vector3{v[1], v[2], v[0]};
      return mesh;
    });
  }
}

}  // namespace
}  // namespace crossgrain

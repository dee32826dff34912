// SPDX-License-Identifier: Apache-2.0
// Random lattices put onto random surfaces with random features.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <random>

#include "base/vector3.hpp"
#include "fit/feature_fit.hpp"
#include "fit/hex_lattice.hpp"
#include "measure/hex_faces.hpp"
#include "support/nightly.hpp"
#include "surface/topology.hpp"

namespace crossgrain::testing {
namespace {

using Random = std::mt19937_64;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

/// A wavy map of space, which moves points by at most about `strength`.
std::function<Vector3(const Vector3&)> random_map(Random& random, double strength) {
  std::array<Vector3, 3> waves, directions;
  std::array<double, 3> phases{};
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      waves[k][axis] = uniform(random, -1.5, 1.5);
      directions[k][axis] = uniform(random, -strength, strength) / 3;
    }
    phases[k] = uniform(random, 0, 6);
  }
  return [=](const Vector3& p) {
    Vector3 moved = p;
    for (std::size_t k = 0; k < 3; ++k) moved += std::sin(dot(waves[k], p) + phases[k]) * directions[k];
    return moved;
  };
}

struct RandomCase {
  HexMesh mesh;
  TriangleMesh model;
};

/// Cubes with a few missing, moved by one map; their surface, moved by another one, with faces of random
/// numbers. Some touch themselves in edges and vertices.
RandomCase random_case(std::uint64_t seed) {
  Random random(seed);
  const double missing = uniform(random, 0, 0.15);
  const std::array<int, 3> cells{2 + static_cast<int>(random() % 3), 2 + static_cast<int>(random() % 3),
                                 2 + static_cast<int>(random() % 4)};
  RandomCase made;
  made.mesh = lattice_mesh(cells, [&](int, int, int) { return uniform(random, 0, 1) < missing ? 0 : 1; });
  made.mesh.regions.clear();
  const auto to_mesh = random_map(random, 0.5), to_model = random_map(random, uniform(random, 0, 0.7));
  made.model.vertices = made.mesh.vertices;
  const std::uint64_t faces = 1 + random() % 20;
  for (const HexSide& side : boundary_of(made.mesh)) {
    const auto& [a, b, c, d] = side.vertices;
    made.model.triangles.insert(made.model.triangles.end(), {{a, b, c}, {a, c, d}});
    made.mesh.boundary.push_back({side.vertices, 0});
    for (int half = 0; half < 2; ++half)
      made.model.faces.push_back(1 + static_cast<std::int32_t>((a / 7 + (random() % 9 == 0)) % faces));
  }
  for (Vector3& v : made.model.vertices) v = to_model(v);
  for (Vector3& v : made.mesh.vertices) v = to_mesh(v);
  return made;
}

/// The least determinant of trilinear maps at places of a lattice in each hexahedron.
double least_sampled(const HexMesh& mesh) {
  double least = INFINITY;
  constexpr int kSteps = 5;
  for (const auto& h : mesh.hexahedra)
    for (int place = 0; place < kSteps * kSteps * kSteps; ++place) {
      const Vector3 t{place % kSteps / (kSteps - 1.0), place / kSteps % kSteps / (kSteps - 1.0),
                      place / kSteps / kSteps / (kSteps - 1.0)};
      const auto along = [&](const std::array<std::size_t, 8>& ends, double u, double v) {
        const auto edge = [&](std::size_t k) {
          return mesh.vertices[h[ends[2 * k + 1]]] - mesh.vertices[h[ends[2 * k]]];
        };
        return (1 - u) * ((1 - v) * edge(0) + v * edge(2)) + u * ((1 - v) * edge(1) + v * edge(3));
      };
      const Vector3 x = along({0, 1, 3, 2, 4, 5, 7, 6}, t[1], t[2]);
      const Vector3 y = along({0, 3, 1, 2, 4, 7, 5, 6}, t[0], t[2]);
      const Vector3 z = along({0, 4, 1, 5, 3, 7, 2, 6}, t[0], t[1]);
      least = std::min(least, dot(cross(x, y), z));
    }
  return least;
}

TEST(RandomFits, CallNoMeshValidThatIsInvertedAnywhere) {
  const std::uint64_t count = is_nightly() ? 2000 : 15;
  std::size_t fitted = 0;
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const RandomCase made = random_case(seed);
    const FeatureComplex features = feature_complex(prepare_surface(CheckedMesh::derived(weld(made.model))));
    const FeatureFit fit = fitted_to_features(made.mesh, features, {1, 1});
    fitted += fit.best_try > 0;
    EXPECT_EQ(fit.best.invalid == 0, fit.tries[fit.best_try].inverted == 0) << seed;
    if (fit.best.invalid == 0) {
      EXPECT_GT(least_sampled(fit.best.mesh), 0) << seed;
    }
    EXPECT_GE(fit.best.mesh.hexahedra.size(), made.mesh.hexahedra.size()) << seed;
    EXPECT_EQ(topology_of(fit.best.mesh).crowded_faces, topology_of(made.mesh).crowded_faces) << seed;
    EXPECT_EQ(topology_of(fit.best.mesh).open_edges, topology_of(made.mesh).open_edges) << seed;
  }
  EXPECT_GT(fitted, count / 10) << "some are worth fitting";
}

}  // namespace
}  // namespace crossgrain::testing

// SPDX-License-Identifier: Apache-2.0
#include "fit/curve_routing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

#include "base/vector3.hpp"
#include "fit/hex_lattice.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

/// Straight curves between points, all on the surface of one solid.
FeatureComplex segments(const std::vector<std::array<Vector3, 2>>& ends) {
  FeatureComplex features;
  features.faces.push_back({1, 1, 0, {}, 1, 1, 1});
  for (const auto& [a, b] : ends) {
    const auto first = static_cast<std::uint32_t>(features.vertices.size());
    features.vertices.insert(features.vertices.end(), {a, b});
    features.curves.push_back(
        {{first, first + 1}, {0, 0}, {{0, true}, {0, false}}, false, false, 0, norm(b - a)});
  }
  return features;
}

/// A plate, its surface, and curves between vertices of its top.
struct Plate {
  HexMesh mesh;
  QuadComplex surface;
  FeatureComplex features;
  SolidSets sets;
  std::vector<CurveNet> nets;

  Plate(int cells, const std::vector<std::array<std::array<double, 2>, 2>>& ends, unsigned seed)
      : mesh(shaken(cells, seed)),
        surface(mesh),
        features(segments(places(ends))),
        sets(surface, mesh.vertices.size(), features) {
    const std::vector<std::array<Vector3, 2>> wished = places(ends);
    for (std::uint32_t c = 0; c < wished.size(); ++c)
      nets.push_back({c, {nearest(wished[c][0]), nearest(wished[c][1])}, {kNowhere, kNowhere}});
  }

  static HexMesh shaken(int cells, unsigned seed) {
    HexMesh mesh = testing::lattice_mesh({cells, cells, 1}, [](int, int, int) { return 1; });
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> off(-0.2, 0.2);
    for (Vector3& vertex : mesh.vertices)
      for (double& x : vertex) x += off(random);
    return mesh;
  }

  static std::vector<std::array<Vector3, 2>> places(
      const std::vector<std::array<std::array<double, 2>, 2>>& ends) {
    std::vector<std::array<Vector3, 2>> result;
    for (const auto& [a, b] : ends) result.push_back({Vector3{a[0], a[1], 1}, Vector3{b[0], b[1], 1}});
    return result;
  }

  std::uint32_t nearest(const Vector3& p) const {
    return *std::ranges::min_element(surface.vertices(), {},
                                     [&](std::uint32_t v) { return norm(mesh.vertices[v] - p); });
  }
};

/// The least cost of all simple paths to a vertex, by walking them all.
void walk(const Plate& plate, CurveRouting& routing, std::uint32_t goal, std::vector<std::uint32_t>& path,
          double cost, double& least) {
  if (cost >= least) return;
  if (path.back() == goal) {
    least = cost;
    return;
  }
  for (const std::uint32_t edge : plate.surface.edges_of(path.back())) {
    const std::uint32_t next = plate.surface.other_end(edge, path.back());
    if (std::ranges::find(path, next) != path.end()) continue;
    const double step = routing.edge_cost(0, 0, edge, path.back());
    path.push_back(next);
    walk(plate, routing, goal, path, cost + step, least);
    path.pop_back();
  }
}

TEST(CurveRouting, FindsThePathOfLeastCostAmongAll) {
  for (unsigned seed = 1; seed <= 20; ++seed) {
    const Plate plate(3, {{{{0, 0.4}, {3, 2.3}}}}, seed);
    CurveRouting routing(plate.mesh, plate.surface, plate.features, plate.sets, 1);
    const auto path = routing.least_path(plate.nets[0]);
    double cost = 0;
    for (std::size_t k = 1; k < path.size(); ++k)
      cost += routing.edge_cost(0, 0, plate.surface.edge_between(path[k - 1], path[k]), path[k - 1]);
    std::vector<std::uint32_t> walked{plate.nets[0].ends[0]};
    double least = INFINITY;
    walk(plate, routing, plate.nets[0].ends[1], walked, 0, least);
    EXPECT_NEAR(cost, least, 1e-12);
  }
}

/// Whether disjoint paths exist on the surface, by trying all for one net after the other.
bool are_routable(const Plate& plate, std::size_t net, std::set<std::uint32_t>& used, std::uint32_t at) {
  if (net == plate.nets.size()) return true;
  const std::uint32_t goal = plate.nets[net].ends[1];
  for (const std::uint32_t edge : plate.surface.edges_of(at)) {
    const std::uint32_t next = plate.surface.other_end(edge, at);
    if (next == goal) {
      if (net + 1 == plate.nets.size()) return true;
      if (are_routable(plate, net + 1, used, plate.nets[net + 1].ends[0])) return true;
      continue;
    }
    if (!used.insert(next).second) continue;
    if (are_routable(plate, net, used, next)) return true;
    used.erase(next);
  }
  return false;
}

TEST(CurveRouting, FindsDisjointPathsWhereTheyExist) {
  std::mt19937 random(5);
  int routed = 0, routable = 0;
  for (unsigned seed = 1; seed <= 400; ++seed) {
    const auto place = [&] { return std::array<double, 2>{double(random() % 3), double(random() % 3)}; };
    const Plate plate(2, {{place(), place()}, {place(), place()}, {place(), place()}}, seed);
    std::set<std::uint32_t> ends;
    for (const CurveNet& net : plate.nets) ends.insert(net.ends.begin(), net.ends.end());
    if (ends.size() < 6) continue;
    CurveRouting routing(plate.mesh, plate.surface, plate.features, plate.sets, 1);
    const auto paths = routing.disjoint_paths(plate.nets);
    std::set<std::uint32_t> seen;
    bool are_all = true;
    for (std::size_t k = 0; k < paths.size(); ++k) {
      are_all = are_all && !paths[k].empty();
      if (paths[k].empty()) continue;
      EXPECT_EQ(paths[k].front(), plate.nets[k].ends[0]);
      EXPECT_EQ(paths[k].back(), plate.nets[k].ends[1]);
      for (const std::uint32_t vertex : paths[k]) EXPECT_TRUE(seen.insert(vertex).second);
      for (std::size_t i = 1; i < paths[k].size(); ++i)
        EXPECT_NE(plate.surface.edge_between(paths[k][i - 1], paths[k][i]), QuadComplex::kNone);
    }
    std::set<std::uint32_t> used = ends;
    const bool exist = are_routable(plate, 0, used, plate.nets[0].ends[0]);
    EXPECT_TRUE(exist || !are_all);
    routable += exist;
    routed += are_all;
  }
  EXPECT_GT(routable, 10);
  EXPECT_EQ(routed, routable);
}

}  // namespace
}  // namespace crossgrain

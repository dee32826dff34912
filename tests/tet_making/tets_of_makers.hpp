// SPDX-License-Identifier: Apache-2.0
// Measures of tets that another program has made.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/features.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/tet_making.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {

inline bool is_installed(TetMaker maker) {
  return !(maker == TetMaker::kGmsh ? gmsh_program() : netgen_program()).empty();
}

inline TetMakingOptions tets_of_size(double size) {
  TetMakingOptions options;
  options.size = size;
  return options;
}

inline double volume_of(const TetMesh& mesh, std::size_t tet) {
  const auto& [a, b, c, d] = mesh.tets[tet];
  const Vector3& origin = mesh.vertices[a];
  return dot(mesh.vertices[b] - origin, cross(mesh.vertices[c] - origin, mesh.vertices[d] - origin)) / 6;
}

inline std::map<std::int32_t, double> volumes_of_regions(const TetMesh& mesh) {
  std::map<std::int32_t, double> volumes;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) volumes[mesh.regions[t]] += volume_of(mesh, t);
  return volumes;
}

inline double volume_of(const TetMesh& mesh) {
  double volume = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) volume += volume_of(mesh, t);
  return volume;
}

template <class Features>
std::set<std::int32_t> tags_of(const Features& features) {
  std::set<std::int32_t> tags;
  for (const auto& feature : features) tags.insert(feature.tag);
  return tags;
}

template <class Map>
std::set<std::int32_t> keys_of(const Map& map) {
  std::set<std::int32_t> keys;
  for (const auto& [key, value] : map) keys.insert(key);
  return keys;
}

template <std::size_t N>
Vector3 middle_of(const TetMesh& mesh, const std::array<std::uint32_t, N>& vertices) {
  Vector3 sum{0, 0, 0};
  for (const std::uint32_t v : vertices) sum += mesh.vertices[v];
  return (1.0 / N) * sum;
}

inline double distance_to(const std::vector<std::array<Vector3, 3>>& triangles, const Vector3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& corners : triangles)
    least = std::min(least, norm(nearest_on_triangle(corners, point) - point));
  return least;
}

inline double distance_to(const std::vector<Vector3>& polyline, const Vector3& point) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k + 1 < polyline.size(); ++k)
    least = std::min(least, distance_to_segment(point, polyline[k], polyline[k + 1]));
  return least;
}

/// All tets are positive, all vertices are used, and nothing is wrong with the mesh as a domain.
inline void expect_sound(const TetMesh& mesh) {
  ASSERT_FALSE(mesh.tets.empty());
  double least = std::numeric_limits<double>::infinity();
  std::vector<bool> is_used(mesh.vertices.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    least = std::min(least, volume_of(mesh, t));
    for (const std::uint32_t v : mesh.tets[t]) is_used[v] = true;
  }
  EXPECT_GT(least, 0);
  EXPECT_EQ(std::count(is_used.begin(), is_used.end(), false), 0);
  TetMesh silent = mesh;
  silent.warnings.clear();
  const TetDomain domain(std::move(silent));
  for (const Warning& warning : domain.warnings()) ADD_FAILURE() << sentence_of(warning);
}

}  // namespace crossgrain

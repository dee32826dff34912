// SPDX-License-Identifier: Apache-2.0
#include "measure/hex_quality.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/hex_faces.hpp"

namespace crossgrain {
namespace {

double determinant(const Vector3& a, const Vector3& b, const Vector3& c) {
  return dot(cross(a, b), c);
}

double scaled_jacobian(const HexMesh& mesh, const std::array<std::uint32_t, 8>& hexahedron) {
  double least = 1;
  for (std::size_t k = 0; k < 8; ++k) {
    std::array<Vector3, 3> edges;
    for (std::size_t n = 0; n < 3; ++n)
      edges[n] = normalised(mesh.vertices[hexahedron[kHexNeighbours[k][n]]] - mesh.vertices[hexahedron[k]]);
    least = std::min(least, determinant(edges[0], edges[1], edges[2]));
  }
  return least;
}

/// The determinant of the trilinear map is of degree two at most along each axis, so that two points of Gauss
/// along each integrate it exactly.
double volume(const HexMesh& mesh, const std::array<std::uint32_t, 8>& hexahedron) {
  static const std::array<double, 2> points{0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)};
  constexpr std::array<std::array<int, 3>, 8> kPlaces{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};
  double sum = 0;
  for (const double x : points) {
    for (const double y : points) {
      for (const double z : points) {
        const std::array<double, 3> at{x, y, z};
        std::array<Vector3, 3> columns{};
        for (std::size_t k = 0; k < 8; ++k) {
          for (std::size_t axis = 0; axis < 3; ++axis) {
            double weight = kPlaces[k][axis] ? 1 : -1;
            for (std::size_t other = 0; other < 3; ++other)
              if (other != axis) weight *= kPlaces[k][other] ? at[other] : 1 - at[other];
            columns[axis] += weight * mesh.vertices[hexahedron[k]];
          }
        }
        sum += determinant(columns[0], columns[1], columns[2]) / 8;
      }
    }
  }
  return sum;
}

}  // namespace

std::vector<double> scaled_jacobians(const HexMesh& mesh) {
  std::vector<double> result(mesh.hexahedra.size());
  parallel_for(result.size(), [&](std::size_t h) { result[h] = scaled_jacobian(mesh, mesh.hexahedra[h]); });
  return result;
}

Vector3 centre_of(const HexMesh& mesh, std::size_t hexahedron) {
  Vector3 sum{0, 0, 0};
  for (const std::uint32_t v : mesh.hexahedra[hexahedron]) sum += mesh.vertices[v];
  return 0.125 * sum;
}

std::vector<double> volumes_of(const HexMesh& mesh) {
  std::vector<double> result(mesh.hexahedra.size());
  parallel_for(result.size(), [&](std::size_t h) { result[h] = volume(mesh, mesh.hexahedra[h]); });
  return result;
}

double area_of(const HexMesh& mesh, const HexMesh::Face& face) {
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vector3& at = mesh.vertices[face.vertices[k]];
    sum += 0.25 * norm(cross(mesh.vertices[face.vertices[(k + 1) % 4]] - at,
                             mesh.vertices[face.vertices[(k + 3) % 4]] - at));
  }
  return sum;
}

double boundary_area(const HexMesh& mesh) {
  double sum = 0;
  for (const HexMesh::Face& face : mesh.boundary) sum += area_of(mesh, face);
  return sum;
}

ShortestEdge shortest_edge(const HexMesh& mesh) {
  ShortestEdge shortest{INFINITY, {0, 0, 0}};
  for (const auto& hexahedron : mesh.hexahedra)
    for (const auto& [a, b] : kHexEdges) {
      const Vector3 &p = mesh.vertices[hexahedron[a]], &q = mesh.vertices[hexahedron[b]];
      if (const double length = norm(p - q); length < shortest.length) shortest = {length, 0.5 * (p + q)};
    }
  return shortest;
}

double mean_edge(const HexMesh& mesh) {
  double sum = 0;
  for (const auto& hexahedron : mesh.hexahedra)
    for (const auto& [a, b] : kHexEdges)
      sum += norm(mesh.vertices[hexahedron[a]] - mesh.vertices[hexahedron[b]]);
  const auto edges = static_cast<double>(kHexEdges.size() * mesh.hexahedra.size());
  return edges > 0 ? sum / edges : 0;
}

}  // namespace crossgrain

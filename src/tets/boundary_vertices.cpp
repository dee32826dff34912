// SPDX-License-Identifier: Apache-2.0
#include "tets/boundary_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/vector3.hpp"
#include "surface/surface.hpp"
#include "tets/boundary_edges.hpp"

namespace crossgrain {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

/// The sharp edges at a vertex; only the first two are needed.
struct SharpEdges {
  std::uint32_t count = 0;
  std::array<std::uint32_t, 2> far_ends{};

  void add(std::uint32_t far_end) {
    if (count < 2) far_ends[count] = far_end;
    ++count;
  }
};

std::vector<TriangleShape> shapes_of_faces(const TetSolid& solid) {
  const std::vector<Vector3>& vertices = solid.mesh.vertices;
  std::vector<TriangleShape> shapes;
  shapes.reserve(solid.boundary.size());
  for (const auto& [a, b, c] : solid.boundary)
    shapes.push_back(shape_of({vertices[a], vertices[b], vertices[c]}));
  return shapes;
}

/// Lists the vertices, and at each its faces. Returns the place of each vertex of the solid in that list.
std::vector<std::uint32_t> gather_faces(const TetSolid& solid, const std::vector<TriangleShape>& shapes,
                                        BoundaryVertices& out) {
  std::vector<std::uint32_t> faces_at(solid.mesh.vertices.size(), 0), place(solid.mesh.vertices.size(), 0);
  for (std::size_t f = 0; f < shapes.size(); ++f) {
    if (shapes[f].area == 0) continue;
    for (const std::uint32_t v : solid.boundary[f]) ++faces_at[v];
  }
  out.face_begin.push_back(0);
  for (std::uint32_t v = 0; v < faces_at.size(); ++v) {
    if (faces_at[v] == 0) continue;
    place[v] = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.push_back(v);
    out.face_begin.push_back(out.face_begin.back() + faces_at[v]);
  }
  out.faces.resize(out.face_begin.back());
  std::vector<std::uint32_t> next(out.face_begin.begin(), out.face_begin.end() - 1);
  for (std::size_t f = 0; f < shapes.size(); ++f) {
    if (shapes[f].area == 0) continue;
    for (const std::uint32_t v : solid.boundary[f])
      out.faces[next[place[v]]++] = {shapes[f].normal, shapes[f].area / 3};
  }
  return place;
}

/// Edges of two faces with an angle between them, and those of more faces, at the vertices of `out`.
std::vector<SharpEdges> find_sharp_edges(const TetSolid& solid, const std::vector<TriangleShape>& shapes,
                                         const std::vector<std::uint32_t>& place, double sharp_dihedral_deg,
                                         std::size_t vertex_count) {
  std::vector<SharpEdges> sharp(vertex_count);
  const double flattest_cosine = std::cos(sharp_dihedral_deg * kDegree);
  std::vector<BoundaryEdgeUse> uses = boundary_edge_uses(solid.boundary);
  std::erase_if(uses, [&](const BoundaryEdgeUse& use) { return shapes[use.face].area == 0; });
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    const BoundaryEdgeUse& edge = uses[begin];
    while (end < uses.size() && uses[end].same_edge(edge)) ++end;
    // An edge of one face lies beside a face without area, which hides how the boundary goes on.
    if (end - begin == 1) continue;
    if (end - begin == 2 &&
        dot(shapes[edge.face].normal, shapes[uses[begin + 1].face].normal) >= flattest_cosine)
      continue;
    sharp[place[edge.low]].add(edge.high);
    sharp[place[edge.high]].add(edge.low);
  }
  return sharp;
}

double spread_deg_of(const Vector3& mean, std::span<const FaceAtVertex> faces) {
  double least_cosine = 1;
  for (const FaceAtVertex& face : faces) least_cosine = std::min(least_cosine, dot(face.normal, mean));
  return std::acos(std::max(least_cosine, -1.0)) / kDegree;
}

/// Along a crease through `vertex`; {0, 0, 0} where its sharp edges are none.
Vector3 crease_tangent(const std::vector<Vector3>& vertices, std::uint32_t vertex, const SharpEdges& sharp,
                       double crease_turn_deg) {
  if (sharp.count != 2) return {0, 0, 0};
  const Vector3 to_first = normalised(vertices[sharp.far_ends[0]] - vertices[vertex]);
  const Vector3 to_second = normalised(vertices[sharp.far_ends[1]] - vertices[vertex]);
  if (-dot(to_first, to_second) <= std::cos(crease_turn_deg * kDegree)) return {0, 0, 0};
  return normalised(to_first - to_second);
}

}  // namespace

BoundaryVertices classify_boundary_vertices(const TetSolid& solid, const BoundaryVertexOptions& options) {
  BoundaryVertices out;
  const std::vector<TriangleShape> shapes = shapes_of_faces(solid);
  const std::vector<std::uint32_t> place = gather_faces(solid, shapes, out);
  const std::vector<SharpEdges> sharp =
      find_sharp_edges(solid, shapes, place, options.sharp_dihedral_deg, out.size());
  for (std::size_t k = 0; k < out.size(); ++k) {
    Vector3 sum{0, 0, 0};
    for (const FaceAtVertex& face : out.faces_at(k)) sum += face.area_third * face.normal;
    out.normals.push_back(normalised(sum));
    out.spread_deg.push_back(spread_deg_of(out.normals[k], out.faces_at(k)));
    const bool smooth = out.spread_deg[k] < options.smooth_spread_deg;
    out.tangents.push_back(
        smooth ? Vector3{0, 0, 0}
               : crease_tangent(solid.mesh.vertices, out.vertices[k], sharp[k], options.crease_turn_deg));
    out.classes.push_back(smooth                                ? BoundaryClass::kSmooth
                          : out.tangents[k] == Vector3{0, 0, 0} ? BoundaryClass::kCorner
                                                                : BoundaryClass::kCrease);
  }
  return out;
}

}  // namespace crossgrain

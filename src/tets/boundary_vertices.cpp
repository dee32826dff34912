// SPDX-License-Identifier: Apache-2.0
#include "tets/boundary_vertices.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/ascending.hpp"
#include "base/degree.hpp"
#include "base/elementary.hpp"
#include "base/vector3.hpp"
#include "surface/crease_gaps.hpp"
#include "surface/crease_network.hpp"
#include "surface/edge_uses.hpp"
#include "surface/surface.hpp"

namespace crossgrain {
namespace {

/// The sharp edges at a vertex; only the first two are needed.
struct SharpEdges {
  std::uint32_t count = 0;
  std::array<std::uint32_t, 2> far_ends{};

  void add(std::uint32_t far_end) {
    if (count < 2) far_ends[count] = far_end;
    ++count;
  }
};

/// Faces of the boundary, followed by those of the walls inside.
struct AllFaces {
  std::vector<std::array<std::uint32_t, 3>> faces;
  std::vector<TriangleShape> shapes;
  std::size_t on_boundary;

  AllFaces(const TetSolid& solid, const InnerFeatures& features)
      : faces(solid.boundary), on_boundary(solid.boundary.size()) {
    faces.insert(faces.end(), features.faces.begin(), features.faces.end());
    shapes.reserve(faces.size());
    for (const auto& face : faces) shapes.push_back(shape_of(corners_of(face, solid.mesh.vertices)));
  }

  bool is_inner(std::size_t face) const { return face >= on_boundary; }

  /// Cosine of the angle between the normals of two faces, on one side of their common edge. All boundary
  /// faces point outward.
  double cosine(const EdgeUse& a, const EdgeUse& b) const {
    const double between = dot(shapes[a.triangle].normal, shapes[b.triangle].normal);
    if (!is_inner(a.triangle) && !is_inner(b.triangle)) return between;
    return a.forward == b.forward ? -between : between;
  }
};

/// Lists the vertices and the faces at each. Returns the position of each vertex of the solid in that list.
std::vector<std::uint32_t> gather_faces(std::size_t vertex_count, const AllFaces& all,
                                        const InnerFeatures& features, BoundaryVertices& out) {
  std::vector<std::uint32_t> faces_at(vertex_count, 0), place(vertex_count, 0);
  std::vector<std::uint8_t> on_edge(vertex_count, 0), has_inner(vertex_count, 0);
  for (std::size_t f = 0; f < all.faces.size(); ++f) {
    if (all.shapes[f].area == 0) continue;
    for (const std::uint32_t v : all.faces[f]) {
      ++faces_at[v];
      if (all.is_inner(f)) has_inner[v] = 1;
    }
  }
  for (const auto& edge : features.edges)
    for (const std::uint32_t v : edge) on_edge[v] = 1;
  out.face_begin.push_back(0);
  for (std::uint32_t v = 0; v < faces_at.size(); ++v) {
    if (faces_at[v] == 0 && !on_edge[v]) continue;
    place[v] = static_cast<std::uint32_t>(out.vertices.size());
    out.vertices.push_back(v);
    out.face_begin.push_back(out.face_begin.back() + faces_at[v]);
  }
  out.faces.resize(out.face_begin.back());
  std::vector<std::uint32_t> next(out.face_begin.begin(), out.face_begin.end() - 1);
  for (std::size_t f = 0; f < all.faces.size(); ++f) {
    if (all.shapes[f].area == 0) continue;
    for (const std::uint32_t v : all.faces[f]) {
      const std::uint32_t first = out.face_begin[place[v]];
      Vector3 normal = all.shapes[f].normal;
      if (has_inner[v] && next[place[v]] > first && dot(normal, out.faces[first].normal) < 0)
        normal = -normal;
      out.faces[next[place[v]]++] = {normal, all.shapes[f].area / 3};
    }
  }
  return place;
}

using VertexPair = std::array<std::uint32_t, 2>;

/// Edges between two faces with an angle that count as creases, edges of more than two faces, and tagged
/// edges; ascending.
std::vector<VertexPair> sharp_and_tagged(const AllFaces& all, const InnerFeatures& features,
                                         const std::vector<Vector3>& vertices,
                                         const BoundaryVertexOptions& options) {
  std::vector<VertexPair> edges;
  std::vector<SharpEdge> sharp;
  std::vector<std::uint32_t> holding;
  const CreaseAngles angles{.least_deg = options.sharp_dihedral_deg, .fading = options.fading};
  const double flattest_cosine = std::cos(least_turn_in_gaps(angles));
  std::vector<EdgeUse> uses = sorted_edge_uses(all.faces);
  std::erase_if(uses, [&](const EdgeUse& use) { return all.shapes[use.triangle].area == 0; });
  for_each_edge(std::span(uses), [&](std::span<const EdgeUse> edge) {
    const VertexPair ends{edge[0].low(), edge[0].high()};
    // An edge of one face is next to a face without area, which hides how the boundary continues, or is the
    // end of a wall.
    if (edge.size() != 2) holding.insert(holding.end(), ends.begin(), ends.end());
    if (edge.size() > 2) edges.push_back(ends);
    if (edge.size() != 2) return;
    const double cosine = all.cosine(edge[0], edge[1]);
    if (cosine >= flattest_cosine) return;
    const double turn_rad = arc_cosine(std::max(cosine, -1.0));
    const double area = all.shapes[edge[0].triangle].area + all.shapes[edge[1].triangle].area;
    const double length = norm(vertices[ends[1]] - vertices[ends[0]]);
    sharp.push_back({ends, turn_rad, length_in_radii(turn_rad, length, area)});
  });
  for (const auto& [a, b] : features.edges) {
    if (a != b) edges.push_back({std::min(a, b), std::max(a, b)});
  }
  for (const VertexPair& edge : edges) holding.insert(holding.end(), edge.begin(), edge.end());
  sharp = with_closed_gaps(std::move(sharp), vertices, holding, angles);
  const std::vector<std::uint8_t> counts = are_creases(sharp, holding, options.fading);
  for (std::size_t e = 0; e < sharp.size(); ++e)
    if (counts[e]) edges.push_back(sharp[e].vertices);
  sort_uniquely(edges);
  return edges;
}

/// The sharp edges at each of the listed vertices.
std::vector<SharpEdges> sharp_edges_at(const std::vector<VertexPair>& edges,
                                       const std::vector<std::uint32_t>& place, std::size_t vertex_count) {
  std::vector<SharpEdges> sharp(vertex_count);
  for (const auto& [low, high] : edges) {
    sharp[place[low]].add(high);
    sharp[place[high]].add(low);
  }
  return sharp;
}

double spread_deg_of(const Vector3& mean, std::span<const FaceAtVertex> faces) {
  if (faces.empty()) return 180;
  double least_cosine = 1;
  for (const FaceAtVertex& face : faces) least_cosine = std::min(least_cosine, dot(face.normal, mean));
  return arc_cosine(std::max(least_cosine, -1.0)) / kDegree;
}

/// Unit tangent of the crease through `vertex`, or, if `ends_count`, of the crease that ends there; {0, 0, 0}
/// if its sharp edges form no crease.
Vector3 crease_tangent(const std::vector<Vector3>& vertices, std::uint32_t vertex, const SharpEdges& sharp,
                       double crease_turn_deg, bool ends_count) {
  if (sharp.count == 0 || sharp.count > 2 || (sharp.count == 1 && !ends_count)) return {0, 0, 0};
  const Vector3 to_first = normalised(vertices[sharp.far_ends[0]] - vertices[vertex]);
  if (sharp.count == 1) return to_first;
  const Vector3 to_second = normalised(vertices[sharp.far_ends[1]] - vertices[vertex]);
  if (-dot(to_first, to_second) <= std::cos(crease_turn_deg * kDegree)) return {0, 0, 0};
  return normalised(to_first - to_second);
}

/// Smallest part of a tangent across the normal of a smooth vertex: below it the tangent adds nothing to the
/// normal.
constexpr double kLeastAcross = 0.5;

/// The part of a tangent across a unit normal, normalised; {0, 0, 0} below kLeastAcross.
Vector3 across(const Vector3& tangent, const Vector3& normal) {
  const Vector3 part = tangent - dot(tangent, normal) * normal;
  return norm(part) < kLeastAcross ? Vector3{0, 0, 0} : normalised(part);
}

/// The edges of walls between regions, ascending.
std::vector<VertexPair> edges_between_regions(const std::vector<InnerWall>& walls) {
  std::vector<VertexPair> edges;
  for (const InnerWall& wall : walls) {
    for (std::size_t k = 0; k < 3 && wall.separates_regions; ++k) {
      edges.push_back(ascending(VertexPair{wall.vertices[k], wall.vertices[(k + 1) % 3]}));
    }
  }
  std::sort(edges.begin(), edges.end());
  return edges;
}

}  // namespace

InnerFeatures features_of(const TetSolid& solid, const std::vector<InnerWall>& walls, bool unite) {
  InnerFeatures features;
  for (const InnerWall& wall : walls) {
    if (!unite || !wall.separates_regions) features.faces.push_back(wall.vertices);
  }
  const std::vector<VertexPair> left_out = unite ? edges_between_regions(walls) : std::vector<VertexPair>{};
  for (const VertexPair& edge : followed_edges(solid, walls)) {
    if (!std::binary_search(left_out.begin(), left_out.end(), ascending(edge)))
      features.edges.push_back(edge);
  }
  return features;
}

std::vector<VertexPair> crease_edges(const TetSolid& solid, const BoundaryVertexOptions& options,
                                     const InnerFeatures& features) {
  return sharp_and_tagged(AllFaces(solid, features), features, solid.mesh.vertices, options);
}

BoundaryVertices classify_boundary_vertices(const TetSolid& solid, const BoundaryVertexOptions& options,
                                            const InnerFeatures& features) {
  BoundaryVertices out;
  const AllFaces all(solid, features);
  const std::vector<std::uint32_t> place = gather_faces(solid.mesh.vertices.size(), all, features, out);
  const std::vector<SharpEdges> sharp =
      sharp_edges_at(sharp_and_tagged(all, features, solid.mesh.vertices, options), place, out.size());
  std::vector<std::uint8_t> tagged(out.size(), 0);
  for (const auto& edge : features.edges)
    for (const std::uint32_t v : edge) tagged[place[v]] = 1;
  for (std::size_t k = 0; k < out.size(); ++k) {
    Vector3 sum{0, 0, 0};
    for (const FaceAtVertex& face : out.faces_at(k)) sum += face.area_third * face.normal;
    out.normals.push_back(normalised(sum));
    out.spread_deg.push_back(spread_deg_of(out.normals[k], out.faces_at(k)));
    const bool smooth = out.spread_deg[k] < options.smooth_spread_deg;
    Vector3 tangent{0, 0, 0};
    if (!smooth || tagged[k])
      tangent = crease_tangent(solid.mesh.vertices, out.vertices[k], sharp[k], options.crease_turn_deg,
                               tagged[k] != 0);
    out.tangents.push_back(smooth ? across(tangent, out.normals[k]) : tangent);
    out.classes.push_back(smooth                                ? BoundaryClass::kSmooth
                          : out.tangents[k] == Vector3{0, 0, 0} ? BoundaryClass::kCorner
                                                                : BoundaryClass::kCrease);
  }
  return out;
}

}  // namespace crossgrain

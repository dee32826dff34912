// SPDX-License-Identifier: Apache-2.0
#include "tets/tet_solid.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>

#include "base/ascending.hpp"
#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/place.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"
#include "tets/boundary_edges.hpp"
#include "tets/tet_faces.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using Tets = std::vector<std::array<std::uint32_t, 4>>;

std::string numbers(std::span<const std::uint32_t> values) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i == 0 ? "" : i + 1 < values.size() ? ", " : " and ") + std::to_string(values[i]);
  return text;
}

/// Number of items of a kind, and the first of them.
struct Tally {
  std::size_t count = 0;
  std::size_t first = 0;

  void add(std::size_t index) {
    if (count++ == 0 || index < first) first = index;
  }
};

void warn(std::vector<Warning>& warnings, WarningKind kind, const Tally& tally, const char* element,
          const char* what) {
  if (tally.count == 0) return;
  warnings.emplace_back(kind, std::string(what) + ": " + std::to_string(tally.count) + "; the first is " +
                                  counted_from_0(element, tally.first));
}

void check_indices(const TetMesh& mesh) {
  if (mesh.tets.empty()) throw Error(ErrorKind::kInput, "the mesh has no tets");
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const std::uint32_t vertex : mesh.tets[t]) {
      if (vertex < mesh.vertices.size()) continue;
      fail_index(counted_from_0("tet", t), vertex, mesh.vertices.size());
    }
  }
}

/// Checks the vertex indices of tagged edges or triangles.
template <class Features>
void check_features(const Features& features, std::size_t vertex_count, const char* kind) {
  for (std::size_t k = 0; k < features.size(); ++k) {
    for (const std::uint32_t vertex : features[k].vertices) {
      if (vertex < vertex_count) continue;
      fail_index(counted_from_0(kind, k), vertex, vertex_count);
    }
  }
}

/// Exchanges two vertices of inverted tets. Returns the shapes before that.
std::vector<TetShape> turn_tets(TetMesh& mesh) {
  std::vector<TetShape> shapes(mesh.tets.size());
  parallel_for(shapes.size(), [&](std::size_t t) {
    shapes[t] = shape_of_tet(mesh.vertices, mesh.tets[t]);
    if (shapes[t] == TetShape::kInverted) std::swap(mesh.tets[t][2], mesh.tets[t][3]);
  });
  return shapes;
}

[[noreturn]] void refuse_face(std::span<const std::uint32_t> vertices, std::span<const FaceUse> uses) {
  const std::array first = {uses[0].tet, uses[1].tet, uses[2].tet};
  throw Error(ErrorKind::kInput, {"", "face of vertices " + numbers(vertices) + " (counted from 0)",
                                  "belongs to " + std::to_string(uses.size()) + " tets, among them " +
                                      numbers(first) + ", where a solid has two at most",
                                  Remedy::kRemoveOverlaps});
}

/// Unsets `take` for tets with the same four vertices as an earlier one.
Tally drop_repeated_tets(const TetFaces& faces, const Tets& tets, std::vector<std::uint8_t>& take) {
  Tally repeated;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> apexes;  // opposite vertex and tet
  faces.visit([&](const auto&, std::span<const FaceUse> uses) {
    apexes.clear();
    for (const FaceUse& use : uses) apexes.emplace_back(tets[use.tet][use.corner], use.tet);
    std::sort(apexes.begin(), apexes.end());
    for (std::size_t i = 1; i < apexes.size(); ++i) {
      const auto [apex, tet] = apexes[i];
      if (apex != apexes[i - 1].first || !take[tet]) continue;
      take[tet] = 0;
      repeated.add(tet);
    }
  });
  return repeated;
}

/// Whether a face has more than two tets, or two with the same vertices.
bool has_crowded_face(const TetFaces& faces, const Tets& tets) {
  bool crowded = false;
  faces.visit([&](const auto&, std::span<const FaceUse> uses) {
    crowded |= uses.size() > 2 ||
               (uses.size() == 2 && tets[uses[0].tet][uses[0].corner] == tets[uses[1].tet][uses[1].corner]);
  });
  return crowded;
}

/// The faces of all tets with four distinct vertices. Unsets `take` for repeated tets.
TetFaces faces_of_solid(const TetMesh& mesh, std::vector<std::uint8_t>& take,
                        std::vector<Warning>& warnings) {
  TetFaces faces(mesh.vertices.size(), mesh.tets, take);
  if (!has_crowded_face(faces, mesh.tets)) return faces;
  const Tally repeated = drop_repeated_tets(faces, mesh.tets, take);
  warn(warnings, WarningKind::kRepeatedTets, repeated, "tet",
       "tets of the same vertices as an earlier one, left out");
  if (repeated.count > 0) faces = TetFaces(mesh.vertices.size(), mesh.tets, take);
  faces.visit([](const auto& vertices, std::span<const FaceUse> uses) {
    if (uses.size() > 2) refuse_face(vertices, uses);
  });
  return faces;
}

/// Whether to negate `even` of the faces of each tet. Flat tets have no orientation of their own and get the
/// one that fits their neighbours.
std::vector<std::uint8_t> orient_flat_tets(const TetFaces& faces, const std::vector<TetShape>& shapes) {
  // Each pass goes at least one flat tet deeper into a cluster of them; deeper ones stay as they are.
  constexpr int kPasses = 16;
  std::vector<std::uint8_t> reversed(shapes.size(), 0);
  std::vector<std::uint8_t> known(shapes.size());
  for (std::size_t t = 0; t < shapes.size(); ++t) known[t] = shapes[t] != TetShape::kFlat;
  bool changed = std::count(known.begin(), known.end(), 0) > 0;
  for (int pass = 0; pass < kPasses && changed; ++pass) {
    changed = false;
    faces.visit([&](const auto&, std::span<const FaceUse> uses) {
      if (uses.size() != 2 || known[uses[0].tet] == known[uses[1].tet]) return;
      const FaceUse& from = known[uses[0].tet] ? uses[0] : uses[1];
      const FaceUse& to = known[uses[0].tet] ? uses[1] : uses[0];
      const bool from_even = from.even != (reversed[from.tet] != 0);
      reversed[to.tet] = to.even == from_even;
      known[to.tet] = 1;
      changed = true;
    });
  }
  return reversed;
}

/// Fills in `inner_faces`, `boundary` and `boundary_tets`, and joins tets across faces; `new_index` is kNoTet
/// for flat tets. Returns the tally of faces with both tets on the same side, with the lowest such tet.
Tally sort_out_faces(const TetFaces& faces, const std::vector<std::uint32_t>& new_index,
                     const std::vector<std::uint8_t>& reversed, DisjointSets& connected, TetSolid& solid) {
  Tally folded;
  solid.inner_faces.reserve(faces.use_count() / 2);
  faces.visit([&](const std::array<std::uint32_t, 3>& v, std::span<const FaceUse> uses) {
    const std::uint32_t tet = new_index[uses[0].tet];
    if (uses.size() == 1) {
      const bool even = uses[0].even != (reversed[uses[0].tet] != 0);
      solid.boundary.push_back(even ? v : std::array{v[0], v[2], v[1]});
      solid.boundary_tets.push_back(tet);
      return;
    }
    connected.join(uses[0].tet, uses[1].tet);
    const std::uint32_t other = new_index[uses[1].tet];
    if (tet == kNoTet && other == kNoTet) return;
    solid.inner_faces.push_back({v, {std::min(tet, other), std::max(tet, other)}});
    if (tet != kNoTet && other != kNoTet && uses[0].even == uses[1].even) folded.add(std::min(tet, other));
  });
  return folded;
}

/// Numbers the components in the order of their first tets. Flat tets also connect.
void number_components(DisjointSets& connected, const std::vector<std::uint32_t>& new_index,
                       TetSolid& solid) {
  std::vector<std::uint32_t> component_of_root(new_index.size(), kNoComponent);
  solid.tet_components.resize(solid.mesh.tets.size());
  solid.vertex_components.assign(solid.mesh.vertices.size(), kNoComponent);
  for (std::uint32_t t = 0; t < new_index.size(); ++t) {
    if (new_index[t] == kNoTet) continue;
    std::uint32_t& component = component_of_root[connected.root(t)];
    if (component == kNoComponent) component = static_cast<std::uint32_t>(solid.components++);
    solid.tet_components[new_index[t]] = component;
    for (const std::uint32_t v : solid.mesh.tets[new_index[t]])
      solid.vertex_components[v] = std::min(solid.vertex_components[v], component);
  }
}

/// Moves the tets that are kept to the front, and flat ones to `flat_tets`. Returns their new indices, kNoTet
/// for the others.
std::vector<std::uint32_t> keep_tets(TetMesh& mesh, const std::vector<TetShape>& shapes,
                                     const std::vector<std::uint8_t>& take, Tets& flat_tets) {
  Tets& tets = mesh.tets;
  std::vector<std::uint32_t> new_index(tets.size(), kNoTet);
  std::uint32_t count = 0;
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (take[t] && shapes[t] == TetShape::kFlat) flat_tets.push_back(tets[t]);
    if (!take[t] || shapes[t] == TetShape::kFlat) continue;
    tets[count] = tets[t];
    if (!mesh.regions.empty()) mesh.regions[count] = mesh.regions[t];
    new_index[t] = count++;
  }
  tets.resize(count);
  if (!mesh.regions.empty()) mesh.regions.resize(count);
  return new_index;
}

void warn_of_unused_vertices(TetSolid& solid, std::vector<Warning>& warnings) {
  Tally unused;
  for (std::size_t v = 0; v < solid.vertex_components.size(); ++v)
    if (solid.vertex_components[v] == kNoComponent) unused.add(v);
  solid.unused_vertices = unused.count;
  warn(warnings, WarningKind::kUnusedVertices, unused, "vertex",
       "vertices of no tet, which keep their numbers");
}

void warn_of_boundary_faults(const TetSolid& solid, std::vector<Warning>& warnings) {
  const BoundaryFaults faults = find_boundary_faults(solid.boundary);
  if (faults.edges > 0) {
    const auto& [a, b] = faults.first_edge;
    const std::vector<Vector3>& vertices = solid.mesh.vertices;
    warnings.emplace_back(WarningKind::kTouchingEdges,
                          "edges where the solid touches itself (more than two boundary faces): " +
                              std::to_string(faults.edges) + "; the first joins vertices " +
                              numbers(faults.first_edge) + " (counted from 0) at " +
                              words_of_place(0.5 * (vertices[a] + vertices[b])));
  }
  if (faults.vertices > 0)
    warnings.emplace_back(WarningKind::kTouchingVertices,
                          "vertices where the solid touches itself: " + std::to_string(faults.vertices) +
                              "; the first is " + counted_from_0("vertex", faults.first_vertex) + " at " +
                              words_of_place(solid.mesh.vertices[faults.first_vertex]));
}

/// Warns of boundary faces at the same place with different vertices: the file has the vertices between two
/// parts twice, so the two sides are not coupled.
void warn_of_unmerged_vertices(const TetSolid& solid, std::vector<Warning>& warnings) {
  const TriangleMesh surface = boundary_surface(solid);
  const std::vector<std::uint32_t> first = first_equal_vertices(surface.vertices);
  std::vector<std::pair<std::array<std::uint32_t, 3>, std::size_t>> faces;
  for (std::size_t f = 0; f < surface.triangles.size(); ++f) {
    const auto& [a, b, c] = surface.triangles[f];
    faces.emplace_back(ascending(std::array{first[a], first[b], first[c]}), f);
  }
  std::sort(faces.begin(), faces.end());
  std::size_t count = 0, example = 0;
  for (std::size_t k = 1; k < faces.size(); ++k) {
    if (faces[k].first == faces[k - 1].first && count++ == 0) example = k;
  }
  if (count == 0) return;
  warnings.emplace_back(
      WarningKind::kUnmergedVertices,
      "pairs of tets that lie face to face without sharing vertices: " + std::to_string(count) +
          "; the first has vertices " + numbers(solid.boundary[faces[example - 1].second]) + " and " +
          numbers(solid.boundary[faces[example].second]) +
          " (counted from 0); the parts are solved separately",
      Remedy::kMergeVertices);
}

}  // namespace

std::vector<std::int32_t> tags_of_faces(const TetMesh& mesh,
                                        const std::vector<std::array<std::uint32_t, 3>>& faces) {
  if (mesh.feature_faces.empty()) return {};
  std::map<std::array<std::uint32_t, 3>, std::int32_t> tags;
  const auto key = [](std::array<std::uint32_t, 3> vertices) {
    std::sort(vertices.begin(), vertices.end());
    return vertices;
  };
  for (const TetMesh::Face& face : mesh.feature_faces) tags.emplace(key(face.vertices), face.tag);
  std::vector<std::int32_t> result;
  for (const auto& face : faces) {
    const auto found = tags.find(key(face));
    result.push_back(found == tags.end() ? 0 : found->second);
  }
  return result;
}

TetSolid prepare_tets(TetMesh mesh, std::vector<Warning>& warnings) {
  check_vertices(mesh.vertices);
  check_indices(mesh);
  check_features(mesh.feature_edges, mesh.vertices.size(), "tagged edge");
  check_features(mesh.feature_faces, mesh.vertices.size(), "tagged triangle");
  const std::size_t given = mesh.tets.size();
  const std::vector<TetShape> shapes = turn_tets(mesh);
  Tally inverted, flat, faulty;
  std::vector<std::uint8_t> take(given);
  for (std::size_t t = 0; t < given; ++t) {
    take[t] = shapes[t] != TetShape::kCollapsed;
    if (shapes[t] == TetShape::kInverted) inverted.add(t);
    if (shapes[t] == TetShape::kFlat || shapes[t] == TetShape::kCollapsed) flat.add(t);
    if (shapes[t] != TetShape::kPositive) faulty.add(t);
  }
  if (flat.count == given)
    throw Error(ErrorKind::kInput,
                "none of the " + std::to_string(given) + " tets has volume (the first is tet 0)",
                Remedy::kExportAgain);
  warn(warnings, WarningKind::kInvertedTets, inverted, "tet", "inverted tets, reoriented");
  warn(warnings, WarningKind::kFlatTets, flat, "tet", "tets without volume, left out");

  const TetFaces faces = faces_of_solid(mesh, take, warnings);
  TetSolid solid;
  solid.inverted_tets = inverted.count;
  solid.faulty_tets = faulty.count;
  if (faulty.count > 0) solid.faulty_place = centroid_of_tet(mesh, faulty.first);
  const std::vector<std::uint32_t> new_index = keep_tets(mesh, shapes, take, solid.flat_tets);
  solid.left_out_tets = given - mesh.tets.size();
  solid.mesh = std::move(mesh);
  DisjointSets connected(given);
  const Tally folded = sort_out_faces(faces, new_index, orient_flat_tets(faces, shapes), connected, solid);
  warn(warnings, WarningKind::kOverlappingTets, folded, "a face of tet",
       "faces with both tets on the same side, where the mesh overlaps itself");
  if (solid.boundary.empty())
    throw Error(ErrorKind::kInput,
                "every face has two tets, so there is no boundary and the mesh folds over itself (tet 0 is "
                "the first)",
                Remedy::kExportAgain);
  number_components(connected, new_index, solid);
  warn_of_unused_vertices(solid, warnings);
  warn_of_boundary_faults(solid, warnings);
  warn_of_unmerged_vertices(solid, warnings);
  return solid;
}

TriangleMesh boundary_surface(const TetSolid& solid) {
  constexpr std::uint32_t kUnused = UINT32_MAX;
  std::vector<std::uint32_t> new_index(solid.mesh.vertices.size(), kUnused);
  for (const auto& face : solid.boundary)
    for (const std::uint32_t v : face) new_index[v] = 0;
  TriangleMesh surface;
  for (std::size_t v = 0; v < new_index.size(); ++v) {
    if (new_index[v] == kUnused) continue;
    new_index[v] = static_cast<std::uint32_t>(surface.vertices.size());
    surface.vertices.push_back(solid.mesh.vertices[v]);
  }
  surface.triangles.reserve(solid.boundary.size());
  for (const auto& [a, b, c] : solid.boundary)
    surface.triangles.push_back({new_index[a], new_index[b], new_index[c]});
  return surface;
}

}  // namespace crossgrain

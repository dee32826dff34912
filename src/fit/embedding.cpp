// SPDX-License-Identifier: Apache-2.0
#include "fit/embedding.hpp"

#include <algorithm>
#include <utility>

#include "fit/corner_vertices.hpp"
#include "fit/curve_routing.hpp"
#include "fit/embedding_room.hpp"
#include "fit/nowhere.hpp"
#include "fit/soft_paths.hpp"

namespace crossgrain {
namespace {

/// The corners and curves of features on the surface of a mesh as it is.
struct SharpTry {
  QuadComplex surface;
  CornerVertices corners;
  std::vector<std::vector<std::uint32_t>> paths;
  std::vector<std::vector<std::uint32_t>> crowded_paths;  ///< of curves without a path, through others

  std::size_t faults() const {
    return crowded_paths.size() + static_cast<std::size_t>(std::ranges::count_if(
                                      corners.exits, [](const CornerExits& exits) { return !exits.fits; }));
  }
};

std::vector<CurveNet> nets_of(const FeatureComplex& features, const CornerVertices& corners) {
  std::vector<CurveNet> nets;
  for (std::uint32_t c = 0; c < features.curves.size(); ++c) {
    CurveNet net{c, {kNowhere, kNowhere}, {kNowhere, kNowhere}};
    bool has_ends = true;
    for (std::size_t k = 0; k < 2; ++k) {
      const std::uint32_t corner = features.curves[c].corners[k];
      if (corner == FeatureComplex::kNone) continue;
      const auto& ends = features.corners[corner].ends;
      const auto end = std::ranges::find(ends, FeatureComplex::End{c, k == 1}) - ends.begin();
      net.ends[k] = corners.vertices[corner];
      net.exits[k] = corners.exits[corner].edges[static_cast<std::size_t>(end)];
      has_ends = has_ends && net.ends[k] != kNowhere;
    }
    if (has_ends) nets.push_back(net);
  }
  return nets;
}

SharpTry try_on(const HexMesh& mesh, const FeatureComplex& features, double size) {
  SharpTry result{surface_of(mesh, features), {}, {}, {}};
  const SolidSets sets(result.surface, mesh.vertices.size(), features);
  result.corners = corner_vertices(mesh, result.surface, features, sets, size);
  CurveRouting routing(mesh, result.surface, features, sets, size);
  for (const std::uint32_t vertex : result.corners.vertices)
    if (vertex != kNowhere) routing.block(vertex);
  const std::vector<CurveNet> nets = nets_of(features, result.corners);
  auto paths = routing.disjoint_paths(nets);
  result.paths.resize(features.curves.size());
  for (std::size_t k = 0; k < nets.size(); ++k) {
    if (paths[k].empty()) result.crowded_paths.push_back(routing.crowded_path(nets[k]));
    result.paths[nets[k].curve] = std::move(paths[k]);
  }
  return result;
}

/// Adds hexahedra where a try has failed; whether any were added.
bool make_room(HexMesh& mesh, const SharpTry& failed) {
  std::vector<std::uint32_t> vertices;
  for (std::size_t c = 0; c < failed.corners.vertices.size(); ++c)
    if (failed.corners.vertices[c] != kNowhere && !failed.corners.exits[c].fits)
      vertices.push_back(failed.corners.vertices[c]);
  return add_edges_at(mesh, failed.surface, vertices) ||
         widen_around(mesh, failed.surface, failed.crowded_paths);
}

void find_curve_faults(const FeatureComplex& features, Embedding& embedding) {
  std::vector<Embedding::Fault> faults;
  for (std::uint32_t c = 0; c < features.corners.size(); ++c)
    if (embedding.vertex_of_corner[c] == kNowhere)
      faults.push_back({Embedding::FaultKind::kCorner, c, features.corners[c].point});
  for (std::uint32_t c = 0; c < features.curves.size(); ++c) {
    if (!embedding.path_of_curve[c].empty()) continue;
    const CurveLine line(features, c);
    faults.push_back({Embedding::FaultKind::kCurve, c, line.at(line.length() / 2)});
  }
  embedding.faults.insert(embedding.faults.begin(), faults.begin(), faults.end());
}

}  // namespace

Embedding embedded(HexMesh& mesh, FeatureComplex& features, double size, const EmbeddingOptions& options) {
  std::vector<bool> is_soft;
  for (const FeatureComplex::Curve& curve : features.curves) is_soft.push_back(curve.is_soft);
  const CoarserFeatures sharp = without_curves(features, is_soft);
  SharpTry best = try_on(mesh, sharp.complex, size);
  for (int round = 0; options.makes_room && best.faults() > 0 && round < kMostRooms; ++round) {
    HexMesh wider = mesh;
    if (!make_room(wider, best)) break;
    SharpTry next = try_on(wider, sharp.complex, size);
    if (next.faults() >= best.faults()) break;
    mesh = std::move(wider);
    best = std::move(next);
  }
  const SharpPaths paths{sharp, best.corners.vertices, best.paths};
  Embedding embedding = with_soft_paths(mesh, best.surface, features, paths, size);
  find_curve_faults(features, embedding);
  return embedding;
}

}  // namespace crossgrain

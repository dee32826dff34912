// SPDX-License-Identifier: Apache-2.0
#include "surface/closing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "crossgrain/message.hpp"
#include "surface/edge_uses.hpp"
#include "surface/hole_filling.hpp"
#include "surface/open_edges.hpp"
#include "surface/stitching.hpp"
#include "surface/topology.hpp"
#include "surface/united_surface.hpp"

namespace crossgrain {
namespace {

StitchedSurface stitched_along_edges(TriangleMesh mesh, double gap) {
  return stitched(divided_at_open_vertices(weld(std::move(mesh)), gap), gap);
}

/// The widest gap along which open edges run, where many do, as where each triangle was rounded by itself; 0
/// otherwise, since few cracks are filled like other holes.
double widest_crack(const TriangleMesh& mesh, double size) {
  constexpr double kMany = 0.5;  // of the triangles
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  const OpenEdges open = find_open_edges(mesh.vertices, uses, size);
  if (static_cast<double>(open.cracks.size()) < kMany * static_cast<double>(mesh.triangles.size())) return 0;
  double widest = 0;
  for (const CrackSide& side : open.cracks) widest = std::max(widest, side.gap);
  return widest;
}

MendedSurface filled(MendedSurface mended) {
  if (mended.closed) return mended;
  MendedSurface closed = mend_surface(CheckedMesh::derived(with_filled_holes(mended.surface.mesh).mesh));
  closed.topology = mended.topology;
  closed.findings = std::move(mended.findings);
  closed.open_loops.clear();
  return closed;
}

TriangleMesh without_cracks(TriangleMesh mesh, std::vector<Warning>& warnings) {
  const double size = longest_side(box_of_solid_triangles(mesh));
  StitchedSurface whole = stitched_along_edges(std::move(mesh), kStitchShare * size);
  // Gaps are measured at the middles of edges, and vertices are farther apart.
  constexpr double kWider = 2;
  const double gap = std::min(kWider * widest_crack(whole.mesh, size), kCrackGap * size);
  if (gap > kStitchShare * size) {
    StitchedSurface wider = stitched_along_edges(std::move(whole.mesh), gap);
    whole = {std::move(wider.mesh), whole.merged + wider.merged, std::max(whole.widest, wider.widest)};
  }
  if (whole.merged > 0)
    warnings.emplace_back(WarningKind::kSurfaceFinding,
                          fmt::format("cracks: {} on open edges, at most {:.3g} apart, merged with others",
                                      counted(whole.merged, "vertex", "vertices"), whole.widest));
  return std::move(whole.mesh);
}

}  // namespace

MendedSurface closed_surface(CheckedMesh checked, std::vector<Warning>& warnings) {
  TriangleMesh given = *std::move(checked);
  warnings.insert(warnings.end(), given.warnings.begin(), given.warnings.end());
  given.warnings.clear();
  return filled(mend_surface(CheckedMesh::derived(without_cracks(std::move(given), warnings))));
}

MendedSurface united_surface(const SearchableSurface& surface) {
  MendedSurface united = filled(mend_surface(CheckedMesh::derived(united_triangles(surface))));
  united.topology = surface.mended().topology;
  united.findings = surface.mended().findings;
  return united;
}

}  // namespace crossgrain

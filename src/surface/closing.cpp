// SPDX-License-Identifier: Apache-2.0
#include "surface/closing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

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

/// The gap that nine in ten of the open edges that run along each other are within, where many do, as where
/// each triangle was rounded by itself; 0 otherwise, since few cracks are filled like other holes.
double width_of_cracks(const TriangleMesh& mesh, double size) {
  constexpr double kMany = 0.5;  // of the triangles
  const std::vector<EdgeUse> uses = sorted_edge_uses(mesh.triangles);
  const OpenEdges open = find_open_edges(mesh.vertices, uses, size);
  if (open.cracks.empty() ||
      static_cast<double>(open.cracks.size()) < kMany * static_cast<double>(mesh.triangles.size()))
    return 0;
  std::vector<double> gaps;
  for (const CrackSide& side : open.cracks) gaps.push_back(side.gap);
  // Not the widest, which may be one by chance.
  const auto nearly_all = gaps.begin() + static_cast<std::ptrdiff_t>(9 * (gaps.size() - 1) / 10);
  std::ranges::nth_element(gaps, nearly_all);
  return *nearly_all;
}

MendedSurface filled(MendedSurface mended) {
  if (mended.closed) return mended;
  MendedSurface closed = mend_surface(CheckedMesh::derived(with_filled_holes(mended.surface.mesh).mesh));
  closed.topology = mended.topology;
  closed.findings = std::move(mended.findings);
  return closed;
}

TriangleMesh without_cracks(TriangleMesh mesh, std::vector<Warning>& warnings) {
  const double size = longest_side(box_of_solid_triangles(mesh));
  StitchedSurface whole = stitched_along_edges(std::move(mesh), kStitchShare * size);
  // Gaps are measured at the middles of edges, and vertices are farther apart.
  constexpr double kWider = 2;
  const double gap = std::min(kWider * width_of_cracks(whole.mesh, size), kCrackGap * size);
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

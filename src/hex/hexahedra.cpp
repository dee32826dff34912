// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hexahedra.hpp"

#include <algorithm>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex/hex_map.hpp"
#include "hex/hex_options.hpp"
#include "hex/hex_reasons.hpp"
#include "hex/hex_report.hpp"
#include "hex/hex_search.hpp"

namespace crossgrain {
namespace {

/// Adds tags of the faces of the boundary, and regions of hexahedra.
void add_tags(const TetSolid& solid, const MapSurface& surface, const std::vector<Foot>& feet,
              const std::vector<std::uint32_t>& centre_tets, HexMesh& mesh) {
  if (!solid.mesh.regions.empty())
    for (const std::uint32_t tet : centre_tets) mesh.regions.push_back(solid.mesh.regions[tet]);
  const std::vector<std::int32_t> tags = tags_of_faces(solid.mesh, solid.boundary);
  if (tags.empty()) return;
  for (HexMesh::Face& face : mesh.boundary) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : face.vertices) centre += 0.25 * mesh.vertices[v];
    const auto of_face = std::find_if(face.vertices.begin(), face.vertices.end(),
                                      [&](std::uint32_t v) { return feet[v].kind == Foot::Kind::kFace; });
    const MapSurface::Place place = of_face == face.vertices.end() ? surface.nearest_of_all(centre)
                                                                   : surface.nearest(feet[*of_face], centre);
    face.tag = tags[place.face];
  }
}

}  // namespace

Hexahedra hexahedra(const TetFrameField& field, const HexOptions& options, const Monitor& monitor) {
  check_options(options);
  check_repairable(field.domain());
  const ThreadLimit limit(options.threads);
  const WatchedLoops watched(monitor, Stops::kHeeded);
  HexSearch search(field, options, monitor);
  HexCandidate best = search.best();
  HexReport report = std::move(search.report());
  report.used_size = best.attempt.size;
  Stopwatch stopwatch;
  stopwatch.start();
  const FollowedField& followed = *best.followed;
  const ExtractedHexahedra& extracted = best.mapped->hexahedra;
  const MapSurface surface(followed.matched());
  report.quality_before = quality_of(extracted.mesh);
  HexMesh mesh = std::move(best.mapped->smoothed);

  mesh.unit = field.domain().mesh().unit;
  add_tags(followed.solid(), surface, best.mapped->feet, extracted.centre_tets, mesh);
  report.left_out = extracted.left_out;
  measure(mesh, followed.solid(), report);
  report.outcome = mesh.hexahedra.empty()       ? HexOutcome::kNone
                   : best.mapped->is_complete() ? HexOutcome::kAllHex
                                                : HexOutcome::kPartial;
  report.is_coarse = report.outcome == HexOutcome::kAllHex && best.mapped->is_coarse;
  explain(best, report);
  report.analysis_seconds = stopwatch.restart();
  SolveReport whole = best.field.report();
  whole.hexahedra = report;
  HexMap map = hex_map_of(followed.unknowns(), best.mapped->map, report.used_size);
  return {std::move(mesh), std::move(report), best.field.with_report(std::move(whole)), std::move(map)};
}

}  // namespace crossgrain

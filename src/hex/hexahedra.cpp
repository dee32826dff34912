// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/thread_limit.hpp"
#include "fit/feature_fit.hpp"
#include "hex/attempt_kinds.hpp"
#include "hex/feature_judgement.hpp"
#include "hex/field_mapping.hpp"
#include "hex/hex_forecast.hpp"
#include "hex/hex_making.hpp"
#include "hex/hex_map.hpp"
#include "hex/hex_report.hpp"
#include "hex/model_fit.hpp"
#include "hex/solid_judgement.hpp"
#include "solve/tet_domain_data.hpp"
#include "surface/model_faces.hpp"
#include "tets/tet_shape.hpp"

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

/// One size for all that is too coarse, with its forecast: that for the volume, and for faces without quads
/// where it is not much less. Half of a size makes eight times as many hexahedra.
void choose_size(const std::vector<ModelFace>& faces, const TetSolid& solid, HexReport& report) {
  constexpr double kLeastOfSize = 0.5;
  if (report.remedy != Remedy::kUseHexSize) return;
  double& size = report.remedy_number;
  if (const auto other = size_for_faces(faces, solid, report); other && *other >= kLeastOfSize * size)
    size = std::min(size, *other);
  report.remedy_hexahedra = hexahedra_in(solid, size);
}

/// Adds what faces without quads and the fit say of hexahedra that fill the model.
void warn_of_fit(const TetSolid& solid, bool fills, const HexReport& report, SolveReport& whole) {
  if (!fills) return;
  for (std::optional<Warning>& warning :
       std::array{faces_without_quads(whole.faces, solid, report), poor_fit(report)})
    if (warning) whole.warnings.push_back(std::move(*warning));
}

void check_options(const HexOptions& options) {
  const auto demand = [](bool holds, const char* what) {
    if (!holds) throw Error(ErrorKind::kUsage, {"", "hexahedra", what});
  };
  demand(options.size >= 0 && std::isfinite(options.size), "their size must be a number from 0");
  demand(options.size > 0 || (options.cells > 0 && std::isfinite(options.cells)),
         "there must be a positive number of them along the longest side");
}

/// Interfaces between regions would be torn: their vertices move as those inside.
bool is_one_region(const HexMesh& mesh) {
  return std::ranges::all_of(mesh.regions, [&](std::int32_t region) { return region == mesh.regions[0]; });
}

/// What kept better hexahedra from being tried.
struct EarlyEnd {
  bool is_stopped;
  std::optional<Error> limit;
};

/// Makes a mesh keep features. Throws at a stop unless the monitor allows it.
void fit(const FeatureComplex& features, const AttemptQueue& queue, HexMesh& mesh, HexReport& report,
         EarlyEnd& end) {
  if (features.faces.size() > kMostListedFaces) return;
  const WatchedLoops watched(queue.monitor(), Stops::kHeeded);
  FeatureFit fitted = fitted_to_features(mesh, features, report.used_size);
  if (fitted.is_stopped && !queue.may_be_stopped()) watched.check();
  mesh = std::move(fitted.best.mesh);
  if (!fitted.tries.empty()) report.features = features_kept(fitted.best.measure);
  report.fit_tries = std::move(fitted.tries);
  report.best_fit = fitted.best_try;
  end.is_stopped |= fitted.is_stopped;
  if (!end.limit) end.limit = std::move(fitted.limit);
}

/// Returns the best of a queue that has a mesh, with the report of all attempts.
Hexahedra best_hexahedra(const AttemptQueue& queue) {
  Stopwatch stopwatch;
  const HexCandidate& best = *queue.best();
  const FollowedField& followed = *best.followed;
  const TetFrameField& field = followed.field();
  const ExtractedHexahedra& extracted = best.following->extracted;
  HexReport report;
  report.size = best.asked_size;
  report.used_size = best.attempt.size;
  report.expected = queue.expected_hexahedra();
  report.quality_before = quality_of(extracted.mesh);
  HexMesh mesh = best.made->mesh;
  mesh.unit = field.domain().mesh().unit;
  add_tags(followed.solid(), MapSurface(followed.matched()), best.following->feet, extracted.centre_tets,
           mesh);
  report.left_out = extracted.left_out.size();
  if (report.left_out > 0)
    report.left_out_place = centroid_of_tet(followed.solid().mesh, extracted.left_out.front());
  const std::vector<BodyContact> contacts = body_contacts(followed.solid());
  const bool has_inner_boundary = !contacts.empty() && contacts.front().is_of_areas();
  const bool is_complete = queue.attempts()[queue.best_attempt()].outcome == HexOutcome::kAllHex;
  std::optional<FeatureComplex> features;
  if (is_complete && contacts.empty()) features = features_of_model(field.domain());
  EarlyEnd end{queue.is_stopped(), queue.limit()};
  if (features && is_one_region(mesh)) fit(*features, queue, mesh, report, end);
  measure(mesh, followed.solid(), has_inner_boundary ? FitTo::kEachSolid : FitTo::kCommonSurface, report);
  report.outcome = queue.attempts()[queue.best_attempt()].outcome;
  report.is_coarse = report.outcome == HexOutcome::kAllHex && best.made->is_coarse;
  explain(best, report);
  SolveReport whole = field.report();
  judge_solids(mesh, {extracted.centre_tets, followed.solid()}, field.domain(), contacts, report, whole);
  if (report.outcome == HexOutcome::kAllHex) {
    if (features && !report.features) report.features = features_kept(mesh, *features, report.used_size);
    judge_features(mesh, report);
    explain_shapes(queue.least_quality(), report);
  } else {
    report.features.reset();
  }
  mesh.is_partial = is_partial(report.outcome);
  count_quads(mesh, whole.faces);
  choose_size(whole.faces, followed.solid(), report);
  const bool is_up_to_solids = is_partial(report.outcome) && best.made->are_complete();
  if (end.is_stopped && !is_up_to_solids) report.remedy = Remedy::kLetFinish;
  report.attempts = queue.attempts();
  report.best_attempt = queue.best_attempt();
  report.is_stopped = end.is_stopped;
  const HexSeconds& seconds = queue.seconds();
  report.repair_seconds = seconds.repair;
  report.map_seconds = seconds.map;
  report.extraction_seconds = seconds.extraction;
  report.smoothing_seconds = seconds.smoothing;
  report.analysis_seconds = stopwatch.restart();
  warn_of_fit(followed.solid(), best.made->fills, report, whole);
  if (end.limit && report.outcome != HexOutcome::kAllHex) whole.warnings.push_back(ended_at(*end.limit));
  HexMap map = hex_map_of(followed.unknowns(), best.following->map, report.used_size);
  whole.hexahedra = std::move(report);
  whole.answer.is_meshed = true;
  return {std::move(mesh), field.with_report(std::move(whole)), std::move(map)};
}

}  // namespace

double asked_size(const TetDomain& domain, const HexOptions& options) {
  return options.size > 0 ? options.size : longest_side(domain.data().box) / options.cells;
}

double expected_hexahedra(const TetDomain& domain, double size) {
  return expected_hexahedra(domain.boundary(), volume_of(domain.mesh()), size);
}

StartingField starting_field(TetFrameField field, const HexOptions& options) {
  const double size = asked_size(field.domain(), options);
  return {std::move(field), size};
}

Hexahedra best_of_attempts(const std::function<void(AttemptQueue&)>& begin, const HexOptions& options,
                           const HexTuning& tuning, const Monitor& monitor) {
  check_options(options);
  AttemptQueue queue(tuning.most_work, tuning.least_quality, monitor);
  queue.add(repaired_fields(tuning));
  queue.add(part_of_model(tuning));
  queue.add(smaller_hexahedra(options, tuning));
  begin(queue);
  {
    const WatchedLoops watched(queue.monitor(), Stops::kHeeded);
    queue.run();
  }
  return best_hexahedra(queue);
}

Hexahedra hexahedra(const TetFrameField& field, const HexOptions& options, const Monitor& monitor) {
  check_repairable(field.domain());
  const ThreadLimit limit(options.threads);
  const auto begin = [&](AttemptQueue& queue) {
    StartingField start = starting_field(field, options);
    queue.expect(expected_hexahedra(field.domain(), start.size));
    queue.start_on(std::move(start));
  };
  return best_of_attempts(begin, options, HexTuning(), monitor);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

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
#include "crossgrain/message.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex/attempt_kinds.hpp"
#include "hex/candidate_fitting.hpp"
#include "hex/feature_judgement.hpp"
#include "hex/field_mapping.hpp"
#include "hex/hex_forecast.hpp"
#include "hex/hex_making.hpp"
#include "hex/hex_map.hpp"
#include "hex/hex_report.hpp"
#include "hex/lattice_search.hpp"
#include "hex/model_fit.hpp"
#include "hex/solid_judgement.hpp"
#include "sampling/tet_walk.hpp"
#include "solve/tet_domain_data.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// One size for all that is too coarse, with its forecast: for the volume, below those that were tried by the
/// way of the best, and for faces without quads where it is not much less. Half of a size makes eight times
/// as many hexahedra.
void choose_size(const std::vector<ModelFace>& faces, const TetSolid& solid, HexReport& report) {
  constexpr double kLeastOfSize = 0.5;
  if (report.remedy != Remedy::kUseHexSize) return;
  double& size = report.remedy_number;
  for (const HexAttempt& attempt : report.attempts)
    if (attempt.size > 0 && attempt.is_of_lattice() == report.is_of_lattice())
      size = std::min(size, next_smaller_size(attempt.size));
  if (const auto other = size_for_faces(faces, solid, report); other && *other >= kLeastOfSize * size)
    size = std::min(size, *other);
  report.remedy_hexahedra = hexahedra_in(solid, size);
}

/// Adds what faces without quads and the fit say of hexahedra that fill the model.
void warn_of_fit(const TetSolid& solid, bool fills, const HexReport& report, SolveReport& whole) {
  if (!fills) return;
  for (std::optional<Warning>& warning : std::array{faces_without_quads(whole.faces, solid, report),
                                                    faces_off(whole.faces, report), poor_fit(report)})
    if (warning) whole.warnings.push_back(std::move(*warning));
}

/// What kept better hexahedra from being tried.
struct EarlyEnd {
  bool is_stopped;
  std::optional<Error> limit;
};

/// The best of a queue, fitted to the features if it is complete: tells in the report. Throws at a stop
/// unless the monitor allows it.
HexCandidate fitted_best(const AttemptQueue& queue, HexReport& report, EarlyEnd& end) {
  HexCandidate best = *queue.best();
  if (!best.fit && best.made->are_complete()) {
    const WatchedLoops watched(queue.monitor(), Stops::kHeeded);
    fit(best);
    if (best.fit && best.fit->is_stopped && !queue.may_be_stopped()) watched.check();
  } else if (!best.fit) {
    add_tags(best);
  }
  if (best.fit) {
    record(*best.fit, report);
    end.is_stopped |= best.fit->is_stopped;
    if (!end.limit) end.limit = best.fit->limit;
  }
  return best;
}

void record_attempts(const AttemptQueue& queue, HexReport& report) {
  report.attempts = queue.attempts();
  report.best_attempt = queue.best_attempt();
  const HexSeconds& seconds = queue.seconds();
  report.repair_seconds = seconds.repair;
  report.map_seconds = seconds.map;
  report.extraction_seconds = seconds.extraction;
  report.smoothing_seconds = seconds.smoothing;
}

/// The best of the maps that were tried, or null.
const HexCandidate* best_map(const AttemptQueue& queue) {
  const HexCandidate* best = nullptr;
  for (const auto& one : queue.best_of_rounds())
    if (one && one->followed && (!best || is_better(*one, *best, queue.least_quality()))) best = one.get();
  return best;
}

/// The tet that holds a point, or else one near to it.
std::uint32_t tet_near(const Vector3& point, double reach, const TetWalk& walk, const TetMesh& mesh) {
  const std::uint32_t tet = walk.tet_at(point);
  if (tet != kNoTet) return tet;
  std::uint32_t nearest = 0;
  for (double least = -1; least < 0; reach *= 2) {
    const Vector3 around{reach, reach, reach};
    walk.finder().for_near({point - around, point + around}, [&](std::uint32_t one) {
      const Vector3 way = centroid_of_tet(mesh, one) - point;
      if (least >= 0 && dot(way, way) >= least) return;
      least = dot(way, way);
      nearest = one;
    });
  }
  return nearest;
}

/// The tets that hold the centres of hexahedra.
std::vector<std::uint32_t> centre_tets(const HexMesh& mesh, double size, const TetSolid& solid) {
  const TetWalk walk(solid);
  std::vector<std::uint32_t> tets(mesh.hexahedra.size());
  parallel_for(tets.size(), [&](std::size_t h) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : mesh.hexahedra[h]) centre += 0.125 * mesh.vertices[v];
    tets[h] = tet_near(centre, size, walk, solid.mesh);
  });
  return tets;
}

/// What to know of a field that no hexahedra follow.
bool is_of_field(const Warning& warning) {
  switch (warning.kind) {
    case WarningKind::kRefusedSplits:
    case WarningKind::kCrowdedCorners:
    case WarningKind::kKnifeEdges:
    case WarningKind::kThinWalls:
    case WarningKind::kExcludedSurface:
    case WarningKind::kNotSettled:
    case WarningKind::kTetsNotSettled:
      return true;
    default:
      return false;
  }
}

/// The same where the best is of a lattice.
Hexahedra best_lattice(const AttemptQueue& queue) {
  HexCandidate best = *queue.best();
  HexMesh& mesh = best.made->mesh;
  HexReport report = best.lattice->report;
  report.expected = queue.expected_hexahedra();
  report.is_stopped |= queue.is_stopped();
  record_attempts(queue, report);
  choose_remedy_of_lattices(report, best.lattice->has_joined);
  const HexCandidate* const map = best_map(queue);
  if (map && map->made && map->made->are_complete())
    report.map_fault =
        fmt::format("its {} would {}", counted(map->made->mesh.hexahedra.size(), "hexahedron", "hexahedra"),
                    map->made->is_faithful
                        ? fmt::format("have a worst scaled Jacobian of {:.2g}", map->made->quality.least)
                        : "not keep all of the model");
  else if (map)
    report.map_fault = end_of(*map, queue.least_quality()).text;
  const TetFrameField& field = map ? map->followed->field() : queue.start()->field;
  const TetSolid& solid = field.domain().data().solid;
  SolveReport whole = field.report();
  const std::vector<std::uint32_t> tets = centre_tets(mesh, report.used_size, solid);
  if (!solid.mesh.regions.empty()) {
    mesh.regions.clear();
    for (const std::uint32_t tet : tets) mesh.regions.push_back(solid.mesh.regions[tet]);
  }
  judge_solids(mesh, {tets, solid}, field.domain(), body_contacts(solid), report, whole);
  judge_interfaces(whole, report);
  mesh.is_partial = is_partial(report.outcome);
  count_quads(mesh, whole.faces);
  choose_size(whole.faces, solid, report);
  std::erase_if(whole.warnings, is_of_field);
  whole.warnings.insert(whole.warnings.end(), best.lattice->warnings.begin(), best.lattice->warnings.end());
  if (queue.limit() && report.outcome != HexOutcome::kAllHex)
    whole.warnings.push_back(ended_at(*queue.limit()));
  for (const auto& warning :
       {faces_without_quads(whole.faces, solid, report), faces_off(whole.faces, report)})
    if (warning) whole.warnings.push_back(*warning);
  whole.hexahedra = std::move(report);
  whole.answer.is_meshed = true;
  return {std::move(mesh), field.with_report(std::move(whole)), {}};
}

/// Returns the best of a queue that has a mesh, which follows a map, with the report of all attempts.
Hexahedra best_of_maps(const AttemptQueue& queue) {
  Stopwatch stopwatch;
  HexReport report;
  EarlyEnd end{queue.is_stopped(), queue.limit()};
  HexCandidate best = fitted_best(queue, report, end);
  const FollowedField& followed = *best.followed;
  const TetFrameField& field = followed.field();
  const ExtractedHexahedra& extracted = best.following->extracted;
  report.size = best.asked_size;
  report.used_size = best.attempt.size;
  report.expected = queue.expected_hexahedra();
  report.quality_before = quality_of(extracted.mesh);
  HexMesh& mesh = best.made->mesh;
  report.left_out = extracted.left_out.size();
  if (report.left_out > 0)
    report.left_out_place = centroid_of_tet(followed.solid().mesh, extracted.left_out.front());
  const std::vector<BodyContact> contacts = body_contacts(followed.solid());
  const bool has_inner_boundary = !contacts.empty() && contacts.front().is_of_areas();
  measure(mesh, followed.solid(), has_inner_boundary ? FitTo::kEachSolid : FitTo::kCommonSurface, report);
  report.outcome = best.made->are_complete() ? HexOutcome::kAllHex : best.made->outcome();
  report.is_coarse = report.outcome == HexOutcome::kAllHex && best.made->is_coarse;
  explain(best, report);
  SolveReport whole = field.report();
  judge_solids(mesh, {extracted.centre_tets, followed.solid()}, field.domain(), contacts, report, whole);
  if (report.outcome == HexOutcome::kAllHex) {
    if (!report.features && contacts.empty())
      report.features = features_kept(mesh, features_of_model(field.domain()), report.size);
    judge_features(mesh, report);
    explain_shapes(queue.least_quality(), report);
  } else {
    report.features.reset();
  }
  judge_interfaces(whole, report);
  mesh.is_partial = is_partial(report.outcome);
  count_quads(mesh, whole.faces);
  record_attempts(queue, report);
  choose_size(whole.faces, followed.solid(), report);
  const bool is_up_to_solids = is_partial(report.outcome) && best.made->are_complete();
  if (end.is_stopped && !is_up_to_solids) report.remedy = Remedy::kLetFinish;
  report.is_stopped = end.is_stopped;
  report.analysis_seconds = stopwatch.restart();
  warn_of_fit(followed.solid(), best.made->fills, report, whole);
  if (end.limit && report.outcome != HexOutcome::kAllHex) whole.warnings.push_back(ended_at(*end.limit));
  HexMap map = hex_map_of(followed.unknowns(), best.following->map, report.used_size);
  whole.hexahedra = std::move(report);
  whole.answer.is_meshed = true;
  return {std::move(mesh), field.with_report(std::move(whole)), std::move(map)};
}

}  // namespace

void check_options(const HexOptions& options) {
  const auto demand = [](bool holds, const char* what) {
    if (!holds) throw Error(ErrorKind::kUsage, {"", "hexahedra", what});
  };
  demand(options.size >= 0 && std::isfinite(options.size), "their size must be a number from 0");
  demand(options.size > 0 || (options.cells > 0 && std::isfinite(options.cells)),
         "there must be a positive number of them along the longest side");
}

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
  if (options.preference == HexPreference::kMap || options.preference == HexPreference::kMapOnly)
    queue.end_at_approximate();
  queue.add(repaired_fields(tuning));
  queue.add(part_of_model(tuning));
  queue.add(smaller_hexahedra(options, tuning));
  queue.add(lattice_attempt(options));
  if (options.preference == HexPreference::kLattice)
    queue.limit_maps_beside_lattice(tuning.map_work, 0);
  else if (!options.thorough)
    queue.limit_maps_beside_lattice(tuning.map_work, tuning.map_work_beside_good);
  begin(queue);
  {
    const WatchedLoops watched(queue.monitor(), Stops::kHeeded);
    queue.run();
  }
  return queue.best()->lattice ? best_lattice(queue) : best_of_maps(queue);
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

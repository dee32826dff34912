// SPDX-License-Identifier: Apache-2.0
#include "hex/hex_search.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "hex/hex_report.hpp"
#include "measure/hex_faces.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

std::vector<Foot> feet_of(const MapSurface& surface, const std::vector<Carrier>& carriers) {
  std::vector<Foot> feet;
  for (const Carrier& carrier : carriers) feet.push_back(surface.foot_of(carrier));
  return feet;
}

/// Whether hexahedra close up to a surface, and all vertices of that belong on the surface of the model.
bool close_on_the_surface(const ExtractedHexahedra& hexahedra, const HexTopology& topology,
                          const std::vector<Foot>& feet) {
  if (!hexahedra.is_complete() || hexahedra.mesh.hexahedra.empty() || !topology.is_closed()) return false;
  return std::all_of(topology.boundary.begin(), topology.boundary.end(), [&](const HexSide& side) {
    return std::all_of(side.vertices.begin(), side.vertices.end(),
                       [&](std::uint32_t v) { return feet[v].kind != Foot::Kind::kInside; });
  });
}

/// For a field that has no map, of which only a part is to be had.
HexEffort little_effort() {
  HexEffort effort;
  effort.map.untangling.rounds = 2;
  effort.map.quantisation.breakouts = 20;
  effort.smoothing.rounds = 5;
  effort.smoothing.powers = {1};
  effort.smoothing.slack = 0;
  return effort;
}

}  // namespace

HexSearch::HexSearch(const TetFrameField& given, const HexOptions& options, const Monitor& monitor)
    : given_(given), options_(options), monitor_(monitor) {
  const double longest = longest_side(given.domain().data().box);
  report_.size = options.size > 0 ? options.size : longest / options.cells;
}

/// What can be made of a field. Arcs without length say that there is no map.
HexCandidate HexSearch::candidate(TetFrameField field) const {
  Stopwatch stopwatch;
  stopwatch.start();
  HexCandidate next{std::move(field), nullptr, {}, {}, {}};
  const auto& onto = next.field.report().onto;
  if (onto && onto->repair) next.attempt.faults = onto->repair->faults;
  next.followed = std::make_unique<FollowedField>(next.field);
  next.attempt.arcs_without_length = next.followed->arcs_without_length().size();
  next.seconds.map = stopwatch.restart();
  if (next.attempt.arcs_without_length == 0) map(next, report_.size);
  return next;
}

void HexSearch::map(HexCandidate& candidate, double size, const HexEffort& effort) const {
  Stopwatch stopwatch;
  stopwatch.start();
  HexAttempt& attempt = candidate.attempt;
  attempt.size = size;
  candidate.mapped.emplace();
  MappedHexahedra& mapped = *candidate.mapped;
  const MapEnergy energy(candidate.followed->unknowns(), size);
  mapped.map = integer_grid_map(energy, effort.map);
  mapped.determinants = determinants_of(energy, mapped.map.coordinates);
  candidate.seconds.map += stopwatch.restart();
  mapped.hexahedra = extracted_hexahedra(candidate.followed->unknowns(), mapped.map.coordinates);
  attempt.seamless_flips = mapped.map.untangled.tets;
  attempt.flips = mapped.hexahedra.flipped_tets;
  attempt.hexahedra = mapped.hexahedra.mesh.hexahedra.size();
  const MapSurface surface(candidate.followed->matched());
  mapped.feet = feet_of(surface, mapped.hexahedra.carriers);
  const HexTopology topology = topology_of(mapped.hexahedra.mesh);
  candidate.seconds.extraction += stopwatch.restart();
  mapped.smoothed = smoothed(mapped.hexahedra.mesh, surface, mapped.feet, size, effort.smoothing);
  for (const HexSide& side : topology.boundary) mapped.smoothed.boundary.push_back({side.vertices, 0});
  mapped.quality = quality_of(mapped.smoothed);
  const TetSolid& solid = candidate.followed->solid();
  mapped.fills = close_on_the_surface(mapped.hexahedra, topology, mapped.feet) &&
                 largest_distance_to(mapped.smoothed, {solid.mesh.vertices, solid.boundary}) <=
                     options_.largest_gap * size;
  mapped.is_coarse = static_cast<double>(attempt.hexahedra) <
                     options_.least_share * volume_of(solid.mesh) / std::pow(report_.size, 3);
  candidate.seconds.smoothing += stopwatch.restart();
}

void HexSearch::map_best(double size, const HexEffort& effort) {
  map(*best_, size, effort);
  const HexSeconds seconds = std::exchange(best_->seconds, {});
  count(seconds);
  best_->attempt.seconds += seconds.sum();
}

/// Reports an attempt, and keeps it if it is the best so far.
void HexSearch::add(HexCandidate next) {
  const HexSeconds seconds = std::exchange(next.seconds, {});
  count(seconds);
  next.attempt.repair = candidates_++;
  next.attempt.seconds = seconds.sum();
  report_.attempts.push_back(next.attempt);
  if (best_ && !(next.rank() < best_->rank())) return;
  best_ = std::move(next);
  report_.best_attempt = report_.attempts.size() - 1;
}

void HexSearch::count(const HexSeconds& seconds) {
  report_.repair_seconds += seconds.repair;
  report_.map_seconds += seconds.map;
  report_.extraction_seconds += seconds.extraction;
  report_.smoothing_seconds += seconds.smoothing;
}

/// Maps the best at smaller sizes, if only whole numbers are in the way of the map.
void HexSearch::try_finer_sizes() {
  const auto is_folded = [&] { return best_->mapped && best_->attempt.is_folded_by_rounding(); };
  double size = report_.size;
  for (int k = 0; k < options_.finer_sizes && !is_done() && is_folded(); ++k) {
    const auto rank = best_->rank();
    const HexAttempt attempt = best_->attempt;
    std::optional<MappedHexahedra> mapped = std::move(best_->mapped);
    best_->attempt.seconds = 0;
    map_best(size *= options_.finer_share);
    report_.attempts.push_back(best_->attempt);
    if (best_->rank() < rank) {
      report_.best_attempt = report_.attempts.size() - 1;
      continue;
    }
    best_->mapped = std::move(mapped);
    best_->attempt = attempt;
  }
}

/// The next tries from a place on, whose matchings were not taken before.
HexSearch::Tries HexSearch::next_of(const Tries& tries, std::size_t& at) {
  constexpr std::size_t kAtOnce = 2;
  Tries next;
  for (; at < tries.size() && next.size() < std::min({kAtOnce, maps_left_, fields_left_}); ++at) {
    const std::vector<CubeRotation>& matchings = tries[at]->tets.matchings;
    if (std::find(taken_.begin(), taken_.end(), matchings) != taken_.end()) continue;
    taken_.push_back(matchings);
    next.push_back(tries[at]);
  }
  return next;
}

/// Takes tries, two at the same time, until one fills the model.
void HexSearch::take(const RepairSearch& search, const Tries& tries) {
  std::size_t at = 0;
  while (!is_done()) {
    const Tries next = next_of(tries, at);
    if (next.empty()) return;
    monitor_.report({Phase::kHexahedra, 0, given_.domain().data().solid.mesh.vertices.size(), 0, NAN});
    std::vector<std::optional<HexCandidate>> candidates(next.size());
    parallel_for(
        next.size(),
        [&](std::size_t k) {
          Stopwatch stopwatch;
          stopwatch.start();
          TetFrameField field = search.field_of(*next[k]);
          const double seconds = stopwatch.restart();
          candidates[k] = candidate(std::move(field));
          candidates[k]->seconds.repair = seconds;
        },
        /*grain=*/1);
    fields_left_ -= next.size();
    for (std::optional<HexCandidate>& one : candidates) {
      maps_left_ -= one->mapped ? 1 : 0;
      if (!is_done()) add(*std::move(one));
    }
  }
}

/// Maps tries without faults in which all arcs have a length, the best first; then what faults become when
/// they wander. A fault may be too small to matter: the best try with some is mapped too.
void HexSearch::try_repairs() {
  RepairOptions options = options_.repair;
  options.tries.insert(options.tries.end(), options_.more_tries.begin(), options_.more_tries.end());
  if (options.most_work == 0) options.most_work = options_.repair_work;
  Stopwatch stopwatch;
  stopwatch.start();
  const std::size_t most =
      std::max<std::size_t>(1, options_.most_mapped_tets / given_.domain().mesh().tets.size());
  maps_left_ = std::min(most, options_.most_maps);
  fields_left_ = 2 * most;
  const RepairSearch search(given_, options, monitor_);
  const std::vector<RepairTry> tries = search.tries();
  report_.repair_seconds += stopwatch.restart();
  const auto has_lengths = [](const RepairTry& one) { return one.zero_lengths == 0; };
  Tries sound;
  for (const RepairTry& one : tries)
    if (one.tets.faults == 0 && has_lengths(one)) sound.push_back(&one);
  if (const auto best = std::find_if(tries.begin(), tries.end(), has_lengths); best != tries.end())
    sound.push_back(&*best);
  take(search, sound);
  if (is_done() || maps_left_ == 0) return;
  stopwatch.restart();
  const std::vector<RepairTry> wandered = search.wandered(tries, options_.wandering_faults);
  report_.repair_seconds += stopwatch.restart();
  // Arcs may get a length when vertices move.
  Tries without_faults;
  for (const std::vector<RepairTry>* some : {&wandered, &tries})
    for (const RepairTry& one : *some)
      if (one.tets.faults == 0) without_faults.push_back(&one);
  take(search, without_faults);
  if (!best_) take(search, {&tries.front()});
}

HexCandidate HexSearch::best() {
  if (given_.data().is_repaired())
    add(candidate(given_));
  else
    try_repairs();
  try_finer_sizes();
  if (!best_->mapped) {
    map_best(report_.size, little_effort());
    report_.attempts[report_.best_attempt] = best_->attempt;
  }
  return std::move(*best_);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hexahedra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <tuple>
#include <utility>

#include "base/names.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex/followed_field.hpp"
#include "hex/hex_extraction.hpp"
#include "hex/hex_map.hpp"
#include "hex/hex_options.hpp"
#include "hex/hex_report.hpp"
#include "hex/hex_smoothing.hpp"
#include "hex/surface_feet.hpp"
#include "map/integer_grid_map.hpp"
#include "measure/hex_faces.hpp"
#include "solve/repair_search.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

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

/// A map with the hexahedra in it.
struct Mapped {
  IntegerGridMap map;
  std::vector<double> determinants;  ///< of its Jacobians
  ExtractedHexahedra hexahedra;
  std::vector<Foot> feet;  ///< of their vertices
  HexMesh smoothed;
  HexReport::Quality quality;
  bool fills = false;

  bool is_complete() const { return fills && quality.inverted == 0; }
};

/// A field that an attempt was made on.
struct Candidate {
  TetFrameField field;
  std::unique_ptr<FollowedField> followed;
  HexAttempt attempt;
  std::optional<Mapped> mapped;

  /// Less is better.
  auto rank() const {
    constexpr std::size_t kMany = SIZE_MAX;
    const bool fills = mapped && mapped->fills;
    return std::tuple(!mapped || !mapped->is_complete(), !fills,
                      mapped ? mapped->hexahedra.left_out + mapped->quality.inverted : kMany, attempt.faults,
                      attempt.arcs_without_length);
  }
};

/// How a map and its hexahedra are made.
struct Effort {
  GridMapOptions map;
  HexSmoothingOptions smoothing;
};

/// For a field that has no map, of which only a part is to be had.
Effort little_effort() {
  Effort effort;
  effort.map.untangling.rounds = 2;
  effort.map.quantisation.breakouts = 20;
  effort.smoothing.rounds = 5;
  effort.smoothing.powers = {1};
  effort.smoothing.slack = 0;
  return effort;
}

/// Finds the repair that a map can follow.
class Search {
 public:
  Search(const TetFrameField& given, const HexOptions& options, const Monitor& monitor)
      : given_(given), options_(options), monitor_(monitor) {
    const double longest = longest_side(given.domain().data().box);
    report_.size = options.size > 0 ? options.size : longest / options.cells;
  }

  /// The best candidate, with a map.
  Candidate best();

  HexReport& report() { return report_; }

 private:
  void take(TetFrameField field, double repair_seconds);
  void try_finer_sizes();
  void map(Candidate& candidate, double size, const Effort& effort = {});
  void take(const RepairSearch& search, const RepairTry& one);
  void try_repairs();
  bool is_complete() const { return best_ && best_->mapped && best_->mapped->is_complete(); }

  const TetFrameField& given_;
  const HexOptions& options_;
  const Monitor& monitor_;
  HexReport report_;
  std::optional<Candidate> best_;
  std::size_t candidates_ = 0, maps_left_ = 1, fields_left_ = 1;
  std::vector<std::vector<CubeRotation>> taken_;
};

/// Makes hexahedra of a field, and keeps them if they are the best so far.
void Search::take(TetFrameField field, double repair_seconds) {
  Stopwatch stopwatch;
  stopwatch.start();
  monitor_.report({Phase::kHexahedra, 0, field.domain().data().solid.mesh.vertices.size(), 0, NAN});
  Candidate next{std::move(field), nullptr, {}, {}};
  next.attempt.repair = candidates_++;
  const auto& onto = next.field.report().onto;
  if (onto && onto->repair) next.attempt.faults = onto->repair->faults;
  next.followed = std::make_unique<FollowedField>(next.field);
  next.attempt.arcs_without_length = next.followed->arcs_without_length().size();
  const double seconds = stopwatch.restart();
  next.attempt.seconds = repair_seconds + seconds;
  report_.repair_seconds += repair_seconds;
  report_.map_seconds += seconds;
  // Arcs without length say that there is no map.
  if (next.attempt.arcs_without_length == 0 && maps_left_ > 0) {
    --maps_left_;
    map(next, report_.size);
  }
  report_.attempts.push_back(next.attempt);
  if (best_ && !(next.rank() < best_->rank())) return;
  best_ = std::move(next);
  report_.best_attempt = report_.attempts.size() - 1;
}

void Search::map(Candidate& candidate, double size, const Effort& effort) {
  Stopwatch stopwatch;
  stopwatch.start();
  HexAttempt& attempt = candidate.attempt;
  attempt.size = size;
  candidate.mapped.emplace();
  Mapped& mapped = *candidate.mapped;
  const MapEnergy energy(candidate.followed->unknowns(), size);
  mapped.map = integer_grid_map(energy, effort.map);
  mapped.determinants = determinants_of(energy, mapped.map.coordinates);
  double seconds = stopwatch.restart();
  report_.map_seconds += seconds;
  attempt.seconds += seconds;
  mapped.hexahedra = extracted_hexahedra(candidate.followed->unknowns(), mapped.map.coordinates);
  attempt.seamless_flips = mapped.map.untangled.tets;
  attempt.flips = mapped.hexahedra.flipped_tets;
  attempt.hexahedra = mapped.hexahedra.mesh.hexahedra.size();
  const MapSurface surface(candidate.followed->matched());
  mapped.feet = feet_of(surface, mapped.hexahedra.carriers);
  const HexTopology topology = topology_of(mapped.hexahedra.mesh);
  seconds = stopwatch.restart();
  report_.extraction_seconds += seconds;
  attempt.seconds += seconds;
  mapped.smoothed = smoothed(mapped.hexahedra.mesh, surface, mapped.feet, size, effort.smoothing);
  for (const HexSide& side : topology.boundary) mapped.smoothed.boundary.push_back({side.vertices, 0});
  mapped.quality = quality_of(mapped.smoothed);
  const TetSolid& solid = candidate.followed->solid();
  mapped.fills = close_on_the_surface(mapped.hexahedra, topology, mapped.feet) &&
                 largest_distance_to(mapped.smoothed, {solid.mesh.vertices, solid.boundary}) <=
                     options_.largest_gap * size;
  seconds = stopwatch.restart();
  report_.smoothing_seconds += seconds;
  attempt.seconds += seconds;
}

/// Maps the best at smaller sizes, if only whole numbers are in the way of the map.
void Search::try_finer_sizes() {
  const auto only_rounding_folds = [&] {
    return best_->mapped && best_->attempt.seamless_flips == std::size_t{0} &&
           best_->attempt.flips != std::size_t{0};
  };
  double size = report_.size;
  for (int k = 0; k < options_.finer_sizes && !is_complete() && only_rounding_folds(); ++k) {
    const auto rank = best_->rank();
    const HexAttempt attempt = best_->attempt;
    std::optional<Mapped> mapped = std::move(best_->mapped);
    map(*best_, size *= options_.finer_share);
    report_.attempts.push_back(best_->attempt);
    if (best_->rank() < rank) {
      report_.best_attempt = report_.attempts.size() - 1;
      continue;
    }
    best_->mapped = std::move(mapped);
    best_->attempt = attempt;
  }
}

/// Takes a try, unless its matchings were taken before.
void Search::take(const RepairSearch& search, const RepairTry& one) {
  if (is_complete() || maps_left_ == 0 || fields_left_ == 0) return;
  if (std::find(taken_.begin(), taken_.end(), one.tets.matchings) != taken_.end()) return;
  taken_.push_back(one.tets.matchings);
  --fields_left_;
  Stopwatch stopwatch;
  stopwatch.start();
  TetFrameField field = search.field_of(one);
  take(std::move(field), stopwatch.restart());
}

/// Maps tries without faults in which all arcs have a length, the best first; then what faults become when
/// they wander. A fault may be too small to matter: the best try with some is mapped too.
void Search::try_repairs() {
  RepairOptions options = options_.repair;
  options.tries.insert(options.tries.end(), options_.more_tries.begin(), options_.more_tries.end());
  Stopwatch stopwatch;
  stopwatch.start();
  const std::size_t most =
      std::max<std::size_t>(1, options_.search_tets / given_.domain().mesh().tets.size());
  maps_left_ = std::min(most, options_.most_maps);
  fields_left_ = 2 * most;
  const RepairSearch search(given_, options, monitor_);
  const std::vector<RepairTry> tries = search.tries();
  report_.repair_seconds += stopwatch.restart();
  const auto has_lengths = [](const RepairTry& one) { return one.zero_lengths == 0; };
  for (const RepairTry& one : tries)
    if (one.tets.faults == 0 && has_lengths(one)) take(search, one);
  if (const auto best = std::find_if(tries.begin(), tries.end(), has_lengths); best != tries.end())
    take(search, *best);
  if (is_complete() || maps_left_ == 0) return;
  stopwatch.restart();
  const std::vector<RepairTry> wandered = search.wandered(tries, options_.wandering_faults);
  report_.repair_seconds += stopwatch.restart();
  // Arcs may get a length when vertices move.
  for (const std::vector<RepairTry>* some : {&wandered, &tries})
    for (const RepairTry& one : *some)
      if (one.tets.faults == 0) take(search, one);
  if (!best_) take(search, tries.front());
}

Candidate Search::best() {
  if (given_.data().is_repaired())
    take(given_, 0);
  else
    try_repairs();
  try_finer_sizes();
  if (!best_->mapped) {
    map(*best_, report_.size, little_effort());
    report_.attempts[report_.best_attempt] = best_->attempt;
  }
  return std::move(*best_);
}

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

std::vector<Vector3> places_of_faults(const SolveReport::Singularity& graph) {
  std::vector<Vector3> places;
  for (const auto& corner : graph.corner_list)
    if (corner.verdict == Verdict::kNotMeshable) places.push_back(corner.place);
  for (const auto& node : graph.node_list)
    if (node.verdict == Verdict::kNotMeshable) places.push_back(node.place);
  for (const auto& arc : graph.arc_list)
    if (arc.verdict == Verdict::kNotMeshable) places.push_back(arc.place);
  return places;
}

/// Centres of the tets that a map flips, the most inverted first.
std::vector<Vector3> places_of_flips(const TetSolid& solid, const std::vector<double>& determinants) {
  std::vector<std::pair<double, std::size_t>> flipped;
  for (std::size_t t = 0; t < determinants.size(); ++t)
    if (!(determinants[t] > 0)) flipped.emplace_back(determinants[t], t);
  std::sort(flipped.begin(), flipped.end());
  std::vector<Vector3> places;
  for (const auto& [determinant, t] : flipped) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : solid.mesh.tets[t]) centre += 0.25 * solid.mesh.vertices[v];
    places.push_back(centre);
  }
  return places;
}

/// Says why the result is not whole, where, and what to try.
void explain(const Candidate& best, HexReport& report) {
  if (report.outcome == HexOutcome::kAllHex) return;
  const HexAttempt& attempt = best.attempt;
  const std::size_t flips = attempt.flips.value_or(0);
  if (attempt.faults > 0) {
    report.places = places_of_faults(best.field.report().onto->singularity);
    report.reason = fmt::format("no map: no hexahedra can meet at {}",
                                counted(attempt.faults, "edge or vertex", "edges and vertices"));
    report.remedy = "tets of another size, or a model without its sharpest corners";
  } else if (attempt.arcs_without_length > 0) {
    report.places = best.followed->arcs_without_length();
    report.reason =
        fmt::format("no map: {} would have no length, since both ends are on one layer of hexahedra",
                    counted(attempt.arcs_without_length, "singular arc"));
    report.remedy = "tets of another size";
  } else if (attempt.seamless_flips.value_or(0) > 0 || flips > 0) {
    report.places = places_of_flips(best.followed->solid(), best.mapped->determinants);
    const bool by_rounding = attempt.seamless_flips == std::size_t{0};
    report.reason = fmt::format("no map: {} stay inverted{}", counted(flips, "tet"),
                                by_rounding ? " with whole numbers of hexahedra" : "");
    report.remedy = by_rounding ? "a smaller size of hexahedra" : "tets of another size";
  } else if (report.quality.inverted > 0) {
    report.places = {report.quality.worst_place};
    report.reason =
        fmt::format("{} inverted", counted(report.quality.inverted, "hexahedron is", "hexahedra are"));
    report.remedy = "a smaller size of hexahedra";
  } else {
    report.reason = "the hexahedra do not close up";
    report.remedy = "another size of hexahedra";
  }
  if (report.places.size() > HexReport::kMostPlaces) report.places.resize(HexReport::kMostPlaces);
  if (report.places.empty()) return;
  const Vector3& at = report.places.front();
  report.reason += fmt::format("{} at {:.4g} {:.4g} {:.4g}", report.places.size() > 1 ? ", the first" : ",",
                               at[0], at[1], at[2]);
}

}  // namespace

Hexahedra hexahedra(const TetFrameField& field, const HexOptions& options, const Monitor& monitor) {
  check_options(options);
  check_repairable(field.domain());
  const ThreadLimit limit(options.threads);
  const WatchedLoops watched(monitor, Stops::kHeeded);
  Search search(field, options, monitor);
  Candidate best = search.best();
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
  explain(best, report);
  report.analysis_seconds = stopwatch.restart();
  SolveReport whole = best.field.report();
  whole.hexahedra = report;
  HexMap map = hex_map_of(followed.unknowns(), best.mapped->map, report.used_size);
  return {std::move(mesh), std::move(report), best.field.with_report(std::move(whole)), std::move(map)};
}

}  // namespace crossgrain

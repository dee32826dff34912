// SPDX-License-Identifier: Apache-2.0
#include "hex/field_mapping.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "hex/candidate_fitting.hpp"
#include "hex/hex_memory.hpp"
#include "hex/hex_report.hpp"
#include "hex/hex_smoothing.hpp"
#include "hex/model_fit.hpp"
#include "hex/work.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"
#include "reduction/arc_lengths.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Hexahedra are coarse if they are fewer than this share of what would fill the model: the map has
/// collapsed, and they are far larger than asked for.
constexpr double kLeastShare = 0.2;

std::vector<Foot> feet_of(const MapSurface& surface, const std::vector<Carrier>& carriers) {
  std::vector<Foot> feet;
  Checkpoint checkpoint;
  for (const Carrier& carrier : carriers) {
    checkpoint.pass();
    feet.push_back(surface.foot_of(carrier));
  }
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

/// How many cells of the grid the tets of a map cover.
double covered_cells(const MapEnergy& energy, const std::vector<double>& determinants) {
  double volume = 0;
  for (std::size_t t = 0; t < determinants.size(); ++t)
    volume += energy.volume(t) * std::abs(determinants[t]);
  return volume / raised(energy.size(), 3);
}

/// Smooths hexahedra and judges them.
MadeHexahedra made_of(const FollowedField& followed, const FollowingMap& following, double size,
                      double asked_size, const HexTopology& topology, const HexTuning& tuning,
                      const HexSmoothingOptions& smoothing) {
  MadeHexahedra made;
  const HexMesh& mesh = following.extracted.mesh;
  made.mesh = smoothed(mesh, MapSurface(followed.matched()), following.feet, size, smoothing);
  for (const HexSide& side : topology.boundary) made.mesh.boundary.push_back({side.vertices, 0});
  made.quality = quality_of(made.mesh);
  const TetSolid& solid = followed.solid();
  made.fills = close_on_the_surface(following.extracted, topology, following.feet) &&
               farthest_from(made.mesh, points_on(solid.mesh.vertices, solid.boundary)).distance <=
                   tuning.largest_gap * size;
  const double model_volume = volume_of(solid.mesh);
  made.is_coarse =
      static_cast<double>(mesh.hexahedra.size()) < kLeastShare * model_volume / raised(asked_size, 3);
  made.left_out = following.extracted.left_out.size();
  const std::vector<double> volumes = volumes_of(made.mesh);
  made.volume_missed = std::abs(std::accumulate(volumes.begin(), volumes.end(), 0.0) / model_volume - 1);
  return made;
}

}  // namespace

FollowedField::FollowedField(TetFrameField repaired) : field_(std::move(repaired)) {
  const TetSolid& solid = field_.domain().data().solid;
  const TetComplex complex(solid);
  const MatchedField matched(complex, field_.data().tet_frames, matchings_of(solid, field_.data()));
  const SingularityGraph& graph = field_.singularities();
  for (const std::size_t arc : arcs_of_length_zero(matched, graph)) {
    const auto& vertices = graph.arcs[arc].vertices;
    arcs_without_length_.push_back(
        solid.mesh.vertices[static_cast<std::size_t>(vertices[vertices.size() / 2])]);
  }
  split_ = split_for_map(matched);
  cut_ = std::make_unique<CutSolid>(*split_.field);
  unknowns_ = std::make_unique<MapUnknowns>(*cut_);
}

HexCandidate followed_candidate(TetFrameField field, double asked_size, std::size_t round) {
  Stopwatch stopwatch;
  HexCandidate candidate;
  candidate.asked_size = asked_size;
  HexAttempt& attempt = candidate.attempt;
  attempt.round = round;
  attempt.tets = field.domain().mesh().tets.size();
  attempt.work = kFieldWork * static_cast<double>(attempt.tets);
  const auto& onto = field.report().onto;
  if (onto && onto->repair) attempt.faults = onto->repair->faults;
  candidate.followed = std::make_shared<const FollowedField>(std::move(field));
  attempt.arcs_without_length = candidate.followed->arcs_without_length().size();
  candidate.seconds.map = stopwatch.restart();
  return candidate;
}

HexCandidate mapped_candidate(const HexCandidate& of, double size, const HexTuning& tuning,
                              MappingEffort effort) {
  Stopwatch stopwatch;
  tell_watched(Phase::kMap, 0);
  GridMapOptions map_options;
  HexSmoothingOptions smoothing;
  if (effort == MappingEffort::kLittle) {
    map_options.untangling.rounds = 2;
    map_options.breakouts = 20;
    smoothing = {.powers = {1}, .rounds = 5, .slack = 0};
  }
  HexCandidate candidate = of;
  candidate.seconds = {};
  candidate.attempt.seconds = 0;
  const FollowedField& followed = *of.followed;
  auto following = std::make_shared<FollowingMap>();
  const MapEnergy energy(followed.unknowns(), size);
  following->map = integer_grid_map(energy, map_options);
  following->determinants = determinants_of(energy, following->map.coordinates);
  candidate.seconds.map = stopwatch.restart();
  tell_watched(Phase::kHexahedra, 0);
  require_memory_of_hexahedra(covered_cells(energy, following->determinants));
  following->extracted = extracted_hexahedra(followed.unknowns(), following->map.coordinates);
  following->feet = feet_of(MapSurface(followed.matched()), following->extracted.carriers);
  const HexTopology topology = topology_of(following->extracted.mesh);
  candidate.seconds.extraction = stopwatch.restart();
  candidate.made = made_of(followed, *following, size, of.asked_size, topology, tuning, smoothing);
  candidate.seconds.smoothing = stopwatch.restart();

  HexAttempt& attempt = candidate.attempt;
  attempt.size = size;
  attempt.seamless_flips = following->map.untangled.tets;
  attempt.flips = following->extracted.flipped_tets;
  attempt.hexahedra = following->extracted.mesh.hexahedra.size();
  attempt.work =
      kMapWork * static_cast<double>(attempt.tets) + kHexahedronWork * static_cast<double>(attempt.hexahedra);
  candidate.following = std::move(following);
  if (effort == MappingEffort::kFull) mend_by_fitting(candidate);
  return candidate;
}

}  // namespace crossgrain

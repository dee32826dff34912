// SPDX-License-Identifier: Apache-2.0
#include "singularity/smooth_places.hpp"

#include <cstddef>
#include <cstdint>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

struct Position {
  Vector3 place{0, 0, 0};
  double most_shift = 0;
};

/// Mean of each place's points, and the largest distance from it that smoothing may reach.
std::vector<Position> means_of(const SingularEdges& singular, const MergedNetwork& network) {
  std::vector<Position> means;
  for (const MergedNetwork::Place& place : network.places) {
    Position mean;
    const double share = 1 / static_cast<double>(place.points.size());
    for (const std::uint32_t p : place.points) {
      mean.place = mean.place + share * singular.points[p].place;
      mean.most_shift += share * kShiftCells * singular.points[p].cell_size;
    }
    means.push_back(mean);
  }
  return means;
}

/// Weights of the other places whose weighted mean is the target of a place.
using Pulls = std::vector<std::pair<std::uint32_t, double>>;

/// Target of the end of an arc at the surface of a grid: the linear continuation of the two places before it.
Pulls continued(const SingularEdges& singular, const std::vector<Pulls>& pulls,
                const MergedNetwork::Place& place, std::uint32_t end) {
  const bool on_grid = singular.points[place.points.front()].name < 0;
  if (!on_grid || pulls[end].size() != 1) return {};
  const std::uint32_t next = pulls[end][0].first;
  if (pulls[next].size() != 2) return {};
  const std::uint32_t second = pulls[next][pulls[next][0].first == end ? 1 : 0].first;
  return {{next, 2}, {second, -1}};
}

std::vector<Pulls> pulls_on(const SingularEdges& singular, const MergedNetwork& network) {
  std::vector<Pulls> pulls(network.places.size());
  for (const MergedNetwork::Arc& arc : network.arcs) {
    for (std::size_t k = 1; k < arc.places.size(); ++k) {
      pulls[arc.places[k - 1]].push_back({arc.places[k], 1});
      pulls[arc.places[k]].push_back({arc.places[k - 1], 1});
    }
  }
  const std::vector<Pulls> neighbours = pulls;
  for (std::uint32_t k = 0; k < pulls.size(); ++k) {
    const MergedNetwork::Place& place = network.places[k];
    if (place.on_boundary) pulls[k] = continued(singular, neighbours, place, k);
  }
  for (Pulls& on_one : pulls) {
    double sum = 0;
    for (const auto& [place, weight] : on_one) sum += weight;
    for (auto& [place, weight] : on_one) weight /= sum;
  }
  return pulls;
}

}  // namespace

std::vector<Vector3> smooth_places(const SingularEdges& singular, const MergedNetwork& network,
                                   const SingularityTuning& options) {
  const std::vector<Position> means = means_of(singular, network);
  const std::vector<Pulls> pulls = pulls_on(singular, network);
  std::vector<Vector3> now, next;
  for (const Position& mean : means) now.push_back(mean.place);
  next = now;
  for (int round = 0; round < options.smoothing_rounds; ++round) {
    check_watched();
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (pulls[k].empty()) continue;
      Vector3 target{0, 0, 0};
      for (const auto& [place, weight] : pulls[k]) target = target + weight * now[place];
      const Vector3 shift = 0.5 * (now[k] + target) - means[k].place;
      const double length = norm(shift), most = means[k].most_shift;
      next[k] = means[k].place + (length > most ? most / length : 1.0) * shift;
    }
    now.swap(next);
  }
  return now;
}

}  // namespace crossgrain

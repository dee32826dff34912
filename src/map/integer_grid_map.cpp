// SPDX-License-Identifier: Apache-2.0
#include "map/integer_grid_map.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "map/poisson_map.hpp"
#include "map/separations.hpp"

namespace crossgrain {
namespace {

/// All columns but the pinned integers.
std::vector<std::uint32_t> free_columns(const PoissonMap& poisson) {
  std::vector<std::uint32_t> free = poisson.continuous();
  for (std::size_t k = 0; k < poisson.integers().size(); ++k)
    if (!poisson.is_pinned()[k]) free.push_back(poisson.integers()[k]);
  std::sort(free.begin(), free.end());
  return free;
}

}  // namespace

IntegerGridMap integer_grid_map(const MapEnergy& energy, const GridMapOptions& options) {
  const PoissonMap poisson(energy);
  IntegerGridMap map;
  map.integers = poisson.integers().size();
  map.columns = poisson.columns_for(poisson.relaxed());
  map.seamless = flips_of(energy, energy.basis() * map.columns);
  // Integers stay in the first pass: free ones let a tangled map collapse.
  map.columns = untangled(energy, std::move(map.columns), poisson.continuous(), options.untangling).columns;
  Untangled seamless = untangled(energy, std::move(map.columns), free_columns(poisson), options.untangling);
  map.untangled = seamless.flips;
  map.seamless_coordinates = energy.basis() * seamless.columns;

  const Separations separations =
      separations_of(energy.unknowns(), seamless.columns, map.seamless_coordinates);
  map.separations = separations.size();
  Eigen::VectorXd relaxed(static_cast<Eigen::Index>(poisson.integers().size()));
  for (std::size_t k = 0; k < poisson.integers().size(); ++k)
    relaxed[static_cast<Eigen::Index>(k)] = seamless.columns[poisson.integers()[k]];
  const Quantised rounded = quantised(poisson, relaxed, separations, options.quantisation);
  map.missing = rounded.missing;

  map.columns = poisson.moved(seamless.columns, rounded.integers);
  map.rounded = flips_of(energy, energy.basis() * map.columns);
  Untangled last = untangled(energy, std::move(map.columns), poisson.continuous(), options.untangling);
  map.columns = std::move(last.columns);
  map.flips = last.flips;
  map.coordinates = energy.basis() * map.columns;
  return map;
}

}  // namespace crossgrain

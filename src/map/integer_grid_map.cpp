// SPDX-License-Identifier: Apache-2.0
#include "map/integer_grid_map.hpp"

#include <utility>

#include "base/parallel.hpp"
#include "map/poisson_map.hpp"
#include "map/separations.hpp"

namespace crossgrain {
namespace {

/// About the shares of the time of a map that its steps end at; for display.
constexpr double kFactored = 0.1, kHeld = 0.3, kSeamless = 0.5, kRounded = 0.7;

}  // namespace

IntegerGridMap integer_grid_map(const MapEnergy& energy, const GridMapOptions& options) {
  const PoissonMap poisson(energy);
  IntegerGridMap map;
  tell_watched(Phase::kMap, kFactored);
  map.integers = poisson.integers().size();
  Eigen::VectorXd columns = poisson.columns_for(poisson.relaxed());
  map.seamless = flips_of(energy, energy.basis() * columns);
  // Integers stay in the first pass: free ones let a tangled map collapse.
  columns = untangled(poisson, std::move(columns), IntegerColumns::kHeld, options.untangling).columns;
  tell_watched(Phase::kMap, kHeld);
  Untangled seamless = untangled(poisson, std::move(columns), IntegerColumns::kFree, options.untangling);
  tell_watched(Phase::kMap, kSeamless);
  map.untangled = seamless.flips;
  map.seamless_coordinates = energy.basis() * seamless.columns;

  const Separations separations =
      separations_of(energy.unknowns(), seamless.columns, map.seamless_coordinates);
  Eigen::VectorXd relaxed(static_cast<Eigen::Index>(poisson.integers().size()));
  for (std::size_t k = 0; k < poisson.integers().size(); ++k)
    relaxed[static_cast<Eigen::Index>(k)] = seamless.columns[poisson.integers()[k]];
  const Quantised rounded = quantised(poisson, relaxed, separations, options.breakouts);
  tell_watched(Phase::kMap, kRounded);
  map.missing = rounded.missing;

  columns = poisson.moved(seamless.columns, rounded.integers);
  map.rounded = flips_of(energy, energy.basis() * columns);
  Untangled last = untangled(poisson, std::move(columns), IntegerColumns::kHeld, options.untangling);
  map.flips = last.flips;
  map.coordinates = energy.basis() * last.columns;
  return map;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Hexahedra of lattices put onto a model: the sizes that are tried.
#pragma once

#include <functional>
#include <vector>

#include "crossgrain/hexahedra.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/warning.hpp"
#include "hex/model_fitting.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns the surface that a lattice is cut to: that of the features, on which all solids are one.
Surface outer_surface(const FeatureComplex& features);

struct LatticeHexahedra {
  HexMesh mesh;      ///< with boundary and tags
  HexReport report;  ///< with an attempt for each lattice
  std::vector<Warning> warnings;
};

/// Returns hexahedra of about `size` that fill a model: cells of a lattice (lattice_of), fitted to its
/// features. Where something is lacking, the planes are made finer there (places_to_refine), kMostRefinements
/// times; then smaller sizes follow (kSmallerLattice), until all is kept with good shapes, or their cells
/// would be more than kMostOfLattice times those of the size; lattices of another topology than the model are
/// left out if there is one of the same. The best is all-hex; then the one that lacks less; then the better
/// shaped, by classes and then by the number of poor ones; then the one with fewer hexahedra.
///
/// Throws Error(kLimit); Error(kInterrupted) by the monitor, and by a stop before there is a mesh: else a
/// stop returns the best so far.
LatticeHexahedra lattice_hexahedra(const FittingModel& model, double size, const Monitor& monitor,
                                   const std::function<void(const HexAttemptEnd&)>& on_end = {});

/// Each lattice's size, as a share of the one before.
inline constexpr double kSmallerLattice = 0.7;

/// How often a lattice is made again with planes nearer to each other where the last one fails.
inline constexpr int kMostRefinements = 2;

/// Most hexahedra that are fitted, in all lattices, once there is one of the model's topology: half a minute
/// of two cores.
inline constexpr double kMostFitted = 40000;

/// Most cells beside those that fill the model at the size asked for.
inline constexpr double kMostOfLattice = 12;

}  // namespace crossgrain

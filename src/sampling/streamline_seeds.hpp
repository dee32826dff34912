// SPDX-License-Identifier: Apache-2.0
// Seeds of streamlines, evenly spread: in the solid, on its surface or on a cut.
//
// Each set is the beginning of an endless sequence without those that miss the solid or lie at a singular
// edge: multiples of the powers of a number g modulo 1 (M. Roberts 2018), which are as badly approximated by
// fractions as one, two or three numbers can be.
#pragma once

#include <optional>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "sampling/line_space.hpp"

namespace crossgrain {

/// As StreamlineTracer::spread_seeds.
std::vector<Vector3> seeds_in_volume(const LineSpace& space, std::size_t count, const Monitor& monitor);

/// As StreamlineTracer::surface_seeds.
std::vector<StreamlineSeed> seeds_on_surface(const LineSpace& space, std::size_t count,
                                             const Monitor& monitor);

/// As StreamlineTracer::cut_seeds.
std::vector<StreamlineSeed> seeds_on_cut(const LineSpace& space, int axis, std::optional<double> position,
                                         std::size_t count, const Monitor& monitor);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Small solids that mark places, as facets.
#pragma once

#include <vector>

#include "picture/drawing.hpp"

namespace crossgrain {

/// A flat round disc across a unit vector, of `thickness` in all.
void add_disc(const Vector3& centre, const Vector3& across, double radius, double thickness,
              const Colour& colour, std::vector<Facet>& facets);

/// Two pyramids of four faces on a common square: `length` from tip to tip along a unit vector.
void add_double_pyramid(const Vector3& centre, const Vector3& along, double radius, double length,
                        const Colour& colour, std::vector<Facet>& facets);

/// A cube along the coordinate axes.
void add_cube(const Vector3& centre, double side, const Colour& colour, std::vector<Facet>& facets);

}  // namespace crossgrain

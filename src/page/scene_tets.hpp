// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "crossgrain/monitor.hpp"
#include "display/shown_field.hpp"
#include "page/drawn_surface.hpp"
#include "page/scene_writer.hpp"

namespace crossgrain {

/// Largest number of tets in a page.
inline constexpr std::size_t kMostShownTets = 300000;

/// Adds the tets of a field on tets with their frames and numbers, or, if there are more than `most_tets`,
/// cubic cells with the frames of the tets at their centres, at most `most_cells`. Returns whether they are
/// tets. Errors: kInterrupted.
bool add_tets(const ShownField& field, const Vector3& origin, std::size_t most_tets, std::size_t most_cells,
              const Monitor& monitor, SceneWriter& scene);

/// Adds alignment and energy density at the vertices of the drawn boundary of the tets.
void add_boundary_numbers(const ShownField& field, const DrawnSurface& drawn, SceneWriter& scene);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "page/drawn_surface.hpp"
#include "page/scene_writer.hpp"

namespace crossgrain {

/// Adds streamlines (arrays streamline_*) in two sets: from seeds on the plane through the middle of the box
/// across `axis`, and from seeds on the surface. Independent of the number of threads. Errors: kInterrupted.
void add_streamlines(const FrameField& shown, const DrawnSurface& surface, const Box& box, std::size_t axis,
                     const Monitor& monitor, SceneWriter& scene);

}  // namespace crossgrain

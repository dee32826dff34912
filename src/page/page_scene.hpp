// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"

namespace crossgrain {

/// What a page shows of a field, thinned to what a browser draws at once, in the layout of viewer/README.md:
/// the surface and its creases, singular arcs, at most kMostShownCells cells, forms of some of them,
/// streamlines. The same bytes for any number of threads. Throws Error(kInterrupted).
std::string page_scene(const FrameField& field, const Monitor& monitor = {});

}  // namespace crossgrain

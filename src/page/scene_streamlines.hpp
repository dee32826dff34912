// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/monitor.hpp"
#include "crossgrain/streamlines.hpp"
#include "page/scene_writer.hpp"

namespace crossgrain {

/// How streamlines of a page are traced: few enough to see through.
StreamlineOptions page_streamlines();

/// Adds streamlines (arrays streamline_*) in two sets: along the plane through the middle of the part across
/// `axis`, and along the surface. Independent of the number of threads. Errors: kInterrupted.
void add_streamlines(const StreamlineTracer& tracer, const Vector3& origin, int axis, const Monitor& monitor,
                     SceneWriter& scene);

}  // namespace crossgrain

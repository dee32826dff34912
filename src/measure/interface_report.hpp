// SPDX-License-Identifier: Apache-2.0
// Alignment of a field with faces inside a solid.
#pragma once

#include <optional>

#include "crossgrain/report.hpp"
#include "crossgrain/types.hpp"
#include "sampling/places.hpp"

namespace crossgrain {

/// Angles between the normals of triangles inside and the nearest axes of the interpolated frames, at the
/// centroids of parts with edges no longer than `step`, weighted by area. `inner` has corner normals; the
/// result is empty if it has no triangle.
std::optional<SolveReport::Interfaces> interface_report(const TriangleMesh& inner,
                                                        const PlaceSampler& sampler, double step);

}  // namespace crossgrain

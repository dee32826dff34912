// SPDX-License-Identifier: Apache-2.0
// How well a field follows faces inside a solid.
#pragma once

#include <optional>

#include "crossgrain/report.hpp"
#include "crossgrain/types.hpp"
#include "sampling/sampling.hpp"

namespace crossgrain {

/// Angles between the normals of triangles inside and the nearest axes of the interpolated frames there, at
/// the centroids of parts with edges no longer than `step`, by area. `inner` has corner normals; none
/// where it has no triangle.
std::optional<SolveReport::Interfaces> interface_report(const TriangleMesh& inner, const Sampler& sampler,
                                                        double step);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// What may be wrong with the parts of a constraint: one sentence each, or an empty text where nothing is.
#pragma once

#include <span>
#include <string>

#include "crossgrain/constraints.hpp"

namespace crossgrain {

std::string fault_of_place(const Vector3& place);
std::string fault_of_weight(double weight);
std::string fault_of_direction(const Vector3& direction);

/// Of axes, at least one.
std::string fault_of_axes(std::span<const Vector3> axes);

/// Of the points of a polyline; their coordinates are those of places.
std::string fault_of_polyline(std::span<const Vector3> points);

std::string fault_of_tensor(const std::array<double, 6>& tensor);

/// "FILE:LINE: " where a constraint comes from; "constraints: " where it comes from no file.
std::string origin_of(const Constraints& constraints, std::size_t line);

}  // namespace crossgrain

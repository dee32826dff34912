// SPDX-License-Identifier: Apache-2.0
// Checks of the parts of a constraint: each returns the fault in one sentence, or an empty text.
#pragma once

#include <span>
#include <string>

#include "crossgrain/constraints.hpp"
#include "crossgrain/message.hpp"

namespace crossgrain {

std::string fault_of_place(const Vector3& place);
std::string fault_of_weight(double weight);
std::string fault_of_direction(const Vector3& direction);

/// Checks one or more axes.
std::string fault_of_axes(std::span<const Vector3> axes);

/// Checks the points of a polyline, except their coordinates, which are those of places.
std::string fault_of_polyline(std::span<const Vector3> points);

std::string fault_of_tensor(const std::array<double, 6>& tensor);

/// Returns a message about a constraint of `constraints`. Its place is the line of the file, or `item` if
/// `line` is 0.
Message message_on(const Constraints& constraints, std::size_t line, const std::string& item,
                   const std::string& text, Remedy remedy = Remedy::kNone);

}  // namespace crossgrain

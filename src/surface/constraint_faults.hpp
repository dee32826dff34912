// SPDX-License-Identifier: Apache-2.0
// What may be wrong with the parts of a constraint: one sentence each, or an empty text where nothing is.
#pragma once

#include <span>
#include <string>

#include "crossgrain/constraints.hpp"
#include "crossgrain/message.hpp"

namespace crossgrain {

std::string fault_of_place(const Vector3& place);
std::string fault_of_weight(double weight);
std::string fault_of_direction(const Vector3& direction);

/// Of axes, at least one.
std::string fault_of_axes(std::span<const Vector3> axes);

/// Of the points of a polyline; their coordinates are those of places.
std::string fault_of_polyline(std::span<const Vector3> points);

std::string fault_of_tensor(const std::array<double, 6>& tensor);

/// What is wrong with a constraint of `line` of its file, or with all of them where that is 0. `item` is the
/// place where constraints come from no file.
Message message_on(const Constraints& constraints, std::size_t line, const std::string& item,
                   const std::string& text, Remedy remedy = Remedy::kNone);

}  // namespace crossgrain

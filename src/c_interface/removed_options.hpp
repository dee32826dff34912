// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "crossgrain/c.h"

namespace crossgrain {

/// Returns what became of an option that earlier versions had, such as "use crease_angle_deg"; empty if there
/// was none of this name. The name of an inner struct stands for all its members.
std::string_view replacement_of(crossgrain_options_kind kind, std::string_view name);

}  // namespace crossgrain

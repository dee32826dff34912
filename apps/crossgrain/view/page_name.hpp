// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain::app {

/// The page of a field in its folder.
inline constexpr const char* kPageName = "report.html";

}  // namespace crossgrain::app

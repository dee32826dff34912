// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain::app {

/// Name of a field's page in its folder.
inline constexpr const char* kPageName = "report.html";

}  // namespace crossgrain::app

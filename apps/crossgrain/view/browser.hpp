// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace crossgrain::app {

/// Starts $BROWSER, or else xdg-open, with an address, without waiting for it. Returns false if there is no
/// display or nothing could be started.
bool open_in_browser(const std::string& address);

}  // namespace crossgrain::app

// SPDX-License-Identifier: Apache-2.0
#include "terminal_width.hpp"

#include <sys/ioctl.h>

namespace crossgrain::app {

std::size_t terminal_width(int descriptor) {
  constexpr std::size_t kUsual = 80;
  winsize size{};
  const bool is_known = ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return is_known ? size.ws_col : kUsual;
}

}  // namespace crossgrain::app

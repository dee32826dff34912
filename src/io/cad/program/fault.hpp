// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace crossgrain {

/// What is wrong with a CAD file, and the mend. It does not leave the program.
class Fault : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

#include "crossgrain/message.hpp"

namespace crossgrain {

/// Error in a CAD file. It is not thrown out of the program.
class Fault : public std::runtime_error {
 public:
  explicit Fault(const std::string& text, Remedy remedy = Remedy::kRepairFile)
      : std::runtime_error(text), remedy_(remedy) {}
  Remedy remedy() const noexcept { return remedy_; }

 private:
  Remedy remedy_;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// Base of a class of virtual functions: not copied, and destroyed through a pointer to it.
class Interface {
 public:
  Interface() = default;
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;
  virtual ~Interface() = default;
};

}  // namespace crossgrain

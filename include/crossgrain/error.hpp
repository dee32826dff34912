// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace crossgrain {

/// What went wrong, as the exit code that the command line program answers with.
enum class ErrorKind : int {
  kUsage = 2,         ///< an option or argument that makes no sense
  kInput = 3,         ///< an input file or mesh that cannot be used
  kOutput = 4,        ///< a result that cannot be written
  kLimit = 5,         ///< out of a stated limit, memory too
  kInterrupted = 130  ///< cancelled through a Monitor
};

/// The only exception the library throws for what a user can cause. `what()` is one line that names the file
/// (or object), the place in it, what is wrong, and the mend.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

}  // namespace crossgrain

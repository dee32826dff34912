// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "crossgrain/message.hpp"

namespace crossgrain {

/// \addtogroup errors Errors and messages
/// @{

/// What went wrong.
enum class ErrorKind : int {
  kUsage,       ///< an invalid option or argument
  kInput,       ///< an input file or mesh that cannot be used
  kOutput,      ///< a result that cannot be written
  kLimit,       ///< a stated limit or the memory is exceeded
  kInterrupted  ///< stopped or cancelled through a Monitor
};

/// The only exception the library throws for what a user can cause. `what()` is the sentence of its message:
/// one line with the file if there is one, the place in it, what is wrong, and what to do.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, Message message)
      : std::runtime_error(sentence_of(message)), kind_(kind), message_(std::move(message)) {}

  /// An error without file and place.
  Error(ErrorKind kind, std::string text, Remedy remedy = Remedy::kNone)
      : Error(kind, Message{{}, {}, std::move(text), remedy}) {}

  ErrorKind kind() const noexcept { return kind_; }
  const Message& message() const noexcept { return message_; }
  const std::string& file() const noexcept { return message_.file; }
  const std::string& place() const noexcept { return message_.place; }
  const std::string& text() const noexcept { return message_.text; }
  Remedy remedy() const noexcept { return message_.remedy; }

  /// Returns the error with the name of the file that the mesh or field came from, which the library does not
  /// know for objects in memory.
  Error with_file(std::string file) const;

 private:
  ErrorKind kind_;
  Message message_;
};

/// Thrown in a process that waits for another one, which has failed (crossgrain/processes.hpp).
class OtherProcessFailed : public std::runtime_error {
 public:
  OtherProcessFailed() : std::runtime_error("another process has failed") {}
};

/// @}

}  // namespace crossgrain

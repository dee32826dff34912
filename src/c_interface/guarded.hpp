// SPDX-License-Identifier: Apache-2.0
// What every function of the C interface does: exceptions become a status and an error, arguments are
// checked.
#pragma once

#include <cstddef>
#include <exception>
#include <span>
#include <string>

#include "crossgrain/c.h"

namespace crossgrain {

/// Returns the status of an exception and, unless `error` is null, sets it to the error, or to null if there
/// is no memory for it.
crossgrain_status status_of(const std::exception_ptr& exception, crossgrain_error** error) noexcept;

/// Calls work() and returns the status. Nothing leaves it.
template <class Work>
crossgrain_status guarded(crossgrain_error** error, const Work& work) noexcept {
  if (error != nullptr) *error = nullptr;
  try {
    work();
    return CROSSGRAIN_OK;
  } catch (...) {
    return status_of(std::current_exception(), error);
  }
}

/// Throws Error(kUsage) that an argument is NULL.
[[noreturn]] void throw_missing(const char* name);

/// Returns what an argument points to. Throws Error(kUsage) naming it if it is NULL.
template <class T>
T& given(T* argument, const char* name) {
  if (argument == nullptr) throw_missing(name);
  return *argument;
}

/// Returns `count` times `each` elements of an argument, which may be NULL if they are none. Throws
/// Error(kUsage) naming it, also for numbers beyond the memory.
template <class T>
std::span<T> elements(T* argument, std::size_t count, std::size_t each, const char* name) {
  if (count == 0) return {};
  if (argument == nullptr || count > SIZE_MAX / sizeof(T) / each) throw_missing(name);
  return {argument, count * each};
}

/// Returns a copy of a text that crossgrain_text_free releases.
char* copy_of(const std::string& text);

}  // namespace crossgrain

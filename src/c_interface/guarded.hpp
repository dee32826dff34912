// SPDX-License-Identifier: Apache-2.0
// What every function of the C interface does: exceptions become a status and an error, arguments are
// checked.
#pragma once

#include <cxxabi.h>

#include <algorithm>
#include <cstddef>
#include <exception>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "crossgrain/c.h"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// Returns the status of an exception and, unless `error` is null, sets it to the error, or to null if there
/// is no memory for it.
crossgrain_status status_of(const std::exception_ptr& exception, crossgrain_error** error) noexcept;

/// Calls work() and returns the status. No exception leaves it.
template <class Work>
crossgrain_status guarded(crossgrain_error** error, const Work& work) {
  if (error != nullptr) *error = nullptr;
  try {
    work();
    return CROSSGRAIN_OK;
  } catch (const abi::__forced_unwind&) {
    throw;  // the thread ends: pthread_exit in a callback
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

/// Sets *out to make() and returns the status. Does not call it if `out` is NULL.
template <class T, class Make>
crossgrain_status made(T* out, crossgrain_error** error, const Make& make) {
  return guarded(error, [&] {
    T& place = given(out, "out");
    place = make();
  });
}

/// Returns value(), or `otherwise` if it throws: for functions without a status.
template <class T, class Value>
T value_or(T otherwise, const Value& value) {
  guarded(nullptr, [&] { otherwise = value(); });
  return otherwise;
}

/// Returns `count` times `each` elements of an argument, which may be NULL if they are none. Throws
/// Error(kUsage) naming it, also for numbers beyond the memory.
template <class T>
std::span<T> elements(T* argument, std::size_t count, std::size_t each, const char* name) {
  if (count == 0) return {};
  if (argument == nullptr || count > SIZE_MAX / sizeof(T) / each) throw_missing(name);
  return {argument, count * each};
}

/// Returns `count` rows of an array as objects of as many numbers each, such as Vector3. Errors as above.
template <class Row, class T>
std::vector<Row> rows_of(const T* values, std::size_t count, const char* name) {
  constexpr std::size_t kEach = std::tuple_size_v<Row>;
  const std::span<const T> all = elements(values, count, kEach, name);
  std::vector<Row> rows(count);
  for (std::size_t i = 0; i < count; ++i) std::copy_n(all.data() + i * kEach, kEach, rows[i].begin());
  return rows;
}

/// Throws Error(kUsage) unless it is 3 or 4.
Degree degree_of(int degree);

/// Throws Error(kUsage) for a number of threads below 0.
int checked_threads(int threads);

/// Returns a copy of a text that crossgrain_text_free releases.
char* copy_of(const std::string& text);

}  // namespace crossgrain

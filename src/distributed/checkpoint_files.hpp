// SPDX-License-Identifier: Apache-2.0
// The files of a checkpoint as bytes at offsets.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "crossgrain/message.hpp"

namespace crossgrain {

/// Files that all processes write together.
class SharedFiles : public Interface {
 public:
  struct Part {
    std::uint64_t offset;
    std::span<const std::byte> bytes;
  };

  /// Writes the parts of this process. Returns whether all are on disk. The file exists already, empty.
  virtual bool write(const std::string& path, std::span<const Part> parts) = 0;
};

template <class T>
SharedFiles::Part part_at(std::uint64_t offset, std::span<T> values) {
  return {offset, std::as_bytes(values)};
}

/// Throws Error(kInput).
[[noreturn]] void refuse_checkpoint(const std::string& path, std::string text,
                                    Remedy remedy = Remedy::kSolveAnew);

/// Throws Error(kOutput) for an errno.
[[noreturn]] void fail_to_keep(const std::string& path, int error);

/// Fills `bytes` from an offset on. Throws Error(kInput) if the file is shorter or cannot be read.
void read_bytes(const std::string& path, std::uint64_t offset, std::span<std::byte> bytes);

template <class T>
std::vector<T> read_at(const std::string& path, std::uint64_t offset, std::uint64_t count) {
  std::vector<T> values(count);
  read_bytes(path, offset, std::as_writable_bytes(std::span(values)));
  return values;
}

/// Returns the numbers of the files "NAMEnumber" in a folder, ascending. Throws Error(kInput) if it cannot be
/// read.
std::vector<int> numbers_of_files(const std::string& folder, const std::string& name);

/// Makes an empty file. Returns 0 or an errno.
int made_empty(const std::string& path);

/// Writes all parts to a file that exists, and waits for the disk. Returns 0 or an errno.
int written(const std::string& path, std::span<const SharedFiles::Part> parts);

}  // namespace crossgrain

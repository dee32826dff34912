// SPDX-License-Identifier: Apache-2.0
#include "files/crc32.hpp"

#include <fmt/format.h>
#include <zlib.h>

#include <cassert>

namespace crossgrain {
namespace {

/// Returns the sum of bytes behind others, of which it is known.
std::uint32_t sum_of(std::uint32_t before, std::string_view bytes) {
  // zlib begins anew at a null pointer, which a view of nothing may have.
  if (bytes.empty()) return before;
  return static_cast<std::uint32_t>(
      crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

void Crc32::add(std::string_view bytes) {
  value_ = sum_of(value_, bytes);
}

// Sums of as many bytes differ by a linear function of what the bytes differ by.
void Crc32::replace(std::string_view old_bytes, std::string_view new_bytes, std::uint64_t behind) {
  assert(old_bytes.size() == new_bytes.size());
  const std::uint32_t difference = sum_of(0, old_bytes) ^ sum_of(0, new_bytes);
  value_ ^= static_cast<std::uint32_t>(crc32_combine(difference, 0, static_cast<z_off_t>(behind)));
}

std::string Crc32::text_of(std::uint32_t value) {
  return fmt::format("{:08x}", value);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "sampling/point_order.hpp"

#include <array>
#include <cstddef>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// Number of leading bits of an address that points are sorted by: cells of 1/1024 of the cube, within which
/// points keep their order.
constexpr int kBits = 30;

/// Bits per pass: the table fits into the nearest cache.
constexpr int kDigitBits = 10;
constexpr std::size_t kDigits = std::size_t{1} << kDigitBits;

struct Keyed {
  std::uint32_t key, point;
};

std::uint32_t key_of(const RootCube& root, const Vector3& point) {
  // The highest bit of an address is the 62nd.
  const auto address = root.locate(point);
  return address ? static_cast<std::uint32_t>(address->packed() >> (62 - kBits)) : (1u << kBits) - 1;
}

}  // namespace

std::vector<std::uint32_t> morton_order(const RootCube& root, std::span<const Vector3> points) {
  auto keyed = sized_vector<Keyed>(points.size()), sorted = sized_vector<Keyed>(points.size());
  parallel_for(points.size(), [&](std::size_t k) {
    keyed[k] = {key_of(root, points[k]), static_cast<std::uint32_t>(k)};
  });
  for (int shift = 0; shift < kBits; shift += kDigitBits) {
    const auto digit = [shift](const Keyed& k) { return k.key >> shift & (kDigits - 1); };
    std::array<std::uint32_t, kDigits + 1> begin{};
    for (const Keyed& k : keyed) ++begin[digit(k) + 1];
    for (std::size_t d = 0; d < kDigits; ++d) begin[d + 1] += begin[d];
    for (const Keyed& k : keyed) sorted[begin[digit(k)]++] = k;
    keyed.swap(sorted);
  }
  std::vector<std::uint32_t> order(points.size());
  for (std::size_t k = 0; k < points.size(); ++k) order[k] = keyed[k].point;
  return order;
}

}  // namespace crossgrain

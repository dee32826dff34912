// SPDX-License-Identifier: Apache-2.0
#include "tets/tet_faces.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

#include "base/parallel.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// The lowest vertex of a face, and the rest of its use.
struct LowestAndUse {
  std::uint32_t lowest;
  FaceUse use;
};

LowestAndUse face_of(const std::array<std::uint32_t, 4>& tet, std::uint32_t index, std::uint8_t corner) {
  std::uint32_t a = tet[kFaceCorners[corner][0]], b = tet[kFaceCorners[corner][1]],
                c = tet[kFaceCorners[corner][2]];
  bool even = true;
  const auto order = [&even](std::uint32_t& low, std::uint32_t& high) {
    if (low <= high) return;
    std::swap(low, high);
    even = !even;
  };
  order(a, b);
  order(b, c);
  order(a, b);
  return {a, {std::uint64_t{b} << 32 | c, index, corner, even}};
}

}  // namespace

TetFaces::TetFaces(std::size_t vertex_count, const std::vector<std::array<std::uint32_t, 4>>& tets,
                   const std::vector<std::uint8_t>& take)
    : begins_(vertex_count + 1, 0) {
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (!take[t]) continue;
    // Three of the four faces have the lowest of the four vertices, the other has the second lowest.
    auto [a, b, c, d] = tets[t];
    const std::uint32_t low_ab = std::min(a, b), low_cd = std::min(c, d);
    const std::uint32_t lowest = std::min(low_ab, low_cd);
    const std::uint32_t second =
        lowest == low_ab ? std::min(std::max(a, b), low_cd) : std::min(std::max(c, d), low_ab);
    begins_[lowest + 1] += 3;
    begins_[second + 1] += 1;
  }
  for (std::size_t v = 0; v < vertex_count; ++v) begins_[v + 1] += begins_[v];
  uses_.resize(begins_.back());

  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (std::size_t t = 0; t < tets.size(); ++t) {
    if (!take[t]) continue;
    for (std::uint8_t corner = 0; corner < 4; ++corner) {
      const LowestAndUse face = face_of(tets[t], static_cast<std::uint32_t>(t), corner);
      uses_[next[face.lowest]++] = face.use;
    }
  }
  parallel_for(vertex_count, [&](std::size_t v) {
    std::sort(uses_.begin() + static_cast<std::ptrdiff_t>(begins_[v]),
              uses_.begin() + static_cast<std::ptrdiff_t>(begins_[v + 1]),
              [](const FaceUse& a, const FaceUse& b) {
                return std::tie(a.other_vertices, a.tet) < std::tie(b.other_vertices, b.tet);
              });
  });
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// The faces of tets, each with its tets.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace crossgrain {

/// One tet's use of a face; the position in the table gives the lowest vertex.
struct FaceUse {
  std::uint64_t other_vertices;  ///< the middle vertex above the highest, in 32 bits each
  std::uint32_t tet;
  std::uint8_t corner;  ///< corner of the tet opposite the face
  bool even;            ///< whether lowest, middle, highest run outward (kFaceCorners) for this tet

  std::uint32_t middle() const { return static_cast<std::uint32_t>(other_vertices >> 32); }
  std::uint32_t highest() const { return static_cast<std::uint32_t>(other_vertices); }
};

/// Table of uses of faces, sorted by the vertices of the face, then by tet. Sorting only among uses with the
/// same lowest vertex takes a fifth of the time of sorting them all.
class TetFaces {
 public:
  /// Takes the faces of the tets with a non-zero `take`. Their vertices must be distinct and below
  /// `vertex_count`.
  TetFaces(std::size_t vertex_count, const std::vector<std::array<std::uint32_t, 4>>& tets,
           const std::vector<std::uint8_t>& take);

  /// Calls visit(vertices, uses) for every face, in ascending order of its vertices: an ascending
  /// std::array<std::uint32_t, 3>, and one FaceUse for each tet that has the face.
  template <class Visit>
  void visit(const Visit& visit) const {
    for (std::size_t lowest = 0; lowest + 1 < begins_.size(); ++lowest) {
      for (std::size_t i = begins_[lowest], next = i; i < begins_[lowest + 1]; i = next) {
        while (next < begins_[lowest + 1] && uses_[next].other_vertices == uses_[i].other_vertices) ++next;
        visit(std::array{static_cast<std::uint32_t>(lowest), uses_[i].middle(), uses_[i].highest()},
              std::span<const FaceUse>(&uses_[i], next - i));
      }
    }
  }

  std::size_t use_count() const { return uses_.size(); }

 private:
  std::vector<std::size_t> begins_;  ///< start of the uses of each lowest vertex, and the end
  std::vector<FaceUse> uses_;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Walks along straight segments from tet to tet.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sampling/tet_finder.hpp"
#include "tets/tet_shape.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// The tets of a solid by place and neighbourhood. Refers to the solid. Queries are safe from any number of
/// threads.
class TetWalk {
 public:
  explicit TetWalk(const TetSolid& solid);

  const TetFinder& finder() const { return finder_; }

  /// The tet that holds a point, the lowest of several; kNoTet for points outside.
  std::uint32_t tet_at(const Vector3& point) const;

  /// The weights of the four corners at a point, with sum 1; negative for corners whose opposite face the
  /// point is beyond.
  std::array<double, 4> weights(std::uint32_t tet, const Vector3& point) const;

  struct End {
    std::uint32_t tet;  ///< last tet reached
    double share;       ///< share of the segment: 1 at its end, less at the boundary
  };

  /// Walks from a point of a tet to another point, calling enter(tet) for each further tet.
  template <class Enter>
  End walk(std::uint32_t tet, const Vector3& from, const Vector3& to, const Enter& enter) const {
    double share = 0;
    // Rounding at vertices might lead around in a circle.
    for (int k = 0; k < kMostTets; ++k) {
      const Exit exit = exit_of(tet, from, to);
      if (exit.face < 0) return {tet, 1};
      share = std::max(share, exit.share);
      const std::uint32_t next = behind(tet, exit.face, from, to, share);
      if (next == kNoTet) break;
      tet = next;
      enter(tet);
    }
    return {tet, share};
  }

 private:
  static constexpr int kMostTets = 10000;
  static constexpr std::uint32_t kFlatTet = kNoTet - 1;

  struct Exit {
    int face = -1;  ///< that opposite this corner; -1 if the segment ends in the tet
    double share = 1;
  };

  /// Six volumes of the tet of a point and a face, positive inside. Exactly opposite from the tet behind.
  double height(std::uint32_t tet, int face, const Vector3& point) const;
  Exit exit_of(std::uint32_t tet, const Vector3& from, const Vector3& to) const;
  std::uint32_t behind(std::uint32_t tet, int face, const Vector3& from, const Vector3& to,
                       double share) const;

  const TetSolid& solid_;
  TetFinder finder_;

  /// Tet across each face; kNoTet for the boundary, kFlatTet for a tet without volume.
  std::vector<std::array<std::uint32_t, 4>> across_;
};

}  // namespace crossgrain

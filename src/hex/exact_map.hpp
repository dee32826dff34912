// SPDX-License-Identifier: Apache-2.0
// A map in exact numbers, and what each tet has of the grid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "map/map_energy.hpp"

namespace crossgrain {

__extension__ using Int128 = __int128;

/// Coordinates of a map as whole numbers of 2^-20, so that transitions across sheets (rotations of the cube
/// and whole translations) are exact, and all signs below as well: with coordinates below 2^32 none of them
/// leaves 128 bits.
using ExactPoint = std::array<std::int64_t, 3>;

inline constexpr std::int64_t kGridUnit = std::int64_t{1} << 20;

/// Largest coordinate, in units of the grid.
inline constexpr double kLargestCoordinate = 4000;

/// Six volumes of the tet a b c d, in units of 2^-60: positive where (b - a) x (c - a) . (d - a) is.
inline Int128 six_volumes(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c,
                          const ExactPoint& d) {
  std::array<std::array<Int128, 3>, 3> e{};
  for (std::size_t k = 0; k < 3; ++k) e[0][k] = b[k] - a[k], e[1][k] = c[k] - a[k], e[2][k] = d[k] - a[k];
  return e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
         e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
         e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
}

/// Whether a triangle has a point in common with the open unit cube from `low` on. Exact: by the separating
/// axis theorem, with equality for triangles that only touch the cube's boundary.
bool meets_open_cell(const std::array<ExactPoint, 3>& triangle, const ExactPoint& low);

/// A map with coordinates that are rounded to 2^-20 in one copy of each vertex and carried to its other
/// copies: so it stays continuous across the cut, and every later decision is exact.
class ExactMap {
 public:
  /// Translations across sheets must be whole but for rounding. `unknowns` must outlive it. Throws
  /// Error(kLimit) if the map is larger than kLargestCoordinate.
  ExactMap(const MapUnknowns& unknowns, const MapCoordinates& map);

  const CutSolid& cut() const { return cut_; }
  const TetSolid& solid() const { return solid_; }

  std::array<ExactPoint, 4> corners(std::uint32_t tet) const;

  /// A point in the names beyond a face.
  ExactPoint carried(const ExactPoint& point, const Crossing& crossing) const;

  /// The same for a cell, by its lowest corner.
  ExactPoint carried_cell(const ExactPoint& low, const Crossing& crossing) const;

  /// From the names before a face to those beyond.
  std::uint8_t rotation_across(const Crossing& crossing) const;

 private:
  ExactPoint step(const ExactPoint& point, SheetStep step) const;
  void find_translations(const MapCoordinates& map);
  void round_points(const MapCoordinates& map);

  const CutSolid& cut_;
  const TetSolid& solid_;
  std::vector<ExactPoint> translations_, points_;
};

/// What a tet has of the grid.
struct TetPart {
  struct Cell {
    ExactPoint low;                  ///< the corner with the least coordinates
    std::array<bool, 4> meets_face;  ///< opposite each corner of the tet
    bool operator<(const Cell& other) const { return low < other.low; }
  };
  struct Vertex {
    ExactPoint at;
    std::array<Int128, 4> weights;  ///< six volumes, by corner of the tet
    bool operator<(const Vertex& other) const { return at < other.at; }
  };
  Int128 volume = 0;             ///< six times, of the image; negative where the tet is flipped
  std::vector<Cell> cells;       ///< open cells of the grid that meet the closed tet, ascending
  std::vector<Vertex> vertices;  ///< of the grid in the closed tet, ascending; none in a flat one
};

TetPart part_of(const std::array<ExactPoint, 4>& corners);

/// Six volumes of the tets that a point makes with the faces opposite each corner.
std::array<Int128, 4> weights_of(const std::array<ExactPoint, 4>& corners, const ExactPoint& point);

}  // namespace crossgrain

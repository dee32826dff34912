// SPDX-License-Identifier: Apache-2.0
// A map in exact numbers, and what each tet has of the grid.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hex/exact_point.hpp"
#include "map/map_energy.hpp"

namespace crossgrain {

/// Returns a point after a rotation of the axes.
ExactPoint turned(std::uint8_t rotation, const ExactPoint& p);

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

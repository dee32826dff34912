// SPDX-License-Identifier: Apache-2.0
// A layer of new hexahedra around a set of others, which shrinks to make room (a pillow):
//
//     old       old                a        a: vertices, which stay     +---+---+---+
//      a---------a                 | \      b: their twins              |  new      |
//      |         |      becomes    |  b     a chosen side of the        |  +---+-   |
//      |   set   |                 |  |     boundary is covered; at     | b| set     outside
//                                           others the set stays at it  +--+---+---+ of the set
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "crossgrain/hex_mesh.hpp"

namespace crossgrain {

struct HexSheet {
  std::vector<std::uint8_t> is_shrunk;  ///< of each hexahedron, whether it is in the set

  /// Sides of the set, as in fit/hex_sides.hpp, on which a hexahedron is put: all towards hexahedra outside
  /// the set; of sides on the boundary and of pairs between two in the set any. Ascending.
  std::vector<std::uint32_t> sides;

  /// Whether several quads of the layer would be one: `insert_sheet` is not to be called.
  bool is_crowded = false;
};

/// Returns the sheet around a set, which also covers those sides on the boundary, or of pairs within the set,
/// for which `is_covered(side)`. A pair is covered if one of the two is, but for those around an edge of
/// which the set closes up, on which two hexahedra would share two faces. `opposite`: `opposite_sides(mesh)`.
/// Where the set touches itself in an edge whose two ends have one twin each, it takes in all hexahedra
/// there, since several quads of the layer would be one.
HexSheet sheet_around(const HexMesh& mesh, std::vector<std::uint8_t> is_shrunk,
                      const std::vector<std::uint32_t>& opposite,
                      const std::function<bool(std::uint32_t side)>& is_covered);

/// What a sheet has added to a mesh. New vertices and hexahedra follow the old ones, which keep their
/// numbers.
struct InsertedSheet {
  /// A quad that has other vertices now, or is new: on the boundary, or between two regions. `is_new` ones
  /// lie where the layer ends at the boundary or at an interface, beside the quad of the set that had the
  /// vertices `before`.
  struct Quad {
    std::array<std::uint32_t, 4> vertices, before;
    bool is_new;
  };

  std::size_t first_vertex = 0, first_hexahedron = 0;
  std::vector<std::uint32_t> original;  ///< of each new vertex that of which it is a twin
  std::vector<std::uint32_t> base;      ///< of each new hexahedron the side that it lies on
  std::vector<Quad> quads;
  std::vector<std::uint32_t> inverted;  ///< of the set and the layer, ascending
};

/// Puts a hexahedron on each side of a sheet (`sheet_around`). A vertex there gets one twin for each part of
/// the set that is connected around it over sides not in the sheet, so that the mesh stays conforming.
/// (Mitchell, Tautges 1995, Pillowing doublets: refining a mesh to ensure that faces share at most one edge.)
///
/// Old vertices do not move; twins lie `depth` of the edges inside, less where hexahedra would be inverted.
/// New hexahedra have the region of those that they lie on; quads of the boundary keep their tags, new ones
/// have that of the quad beside. At most two regions may meet at an edge where the layer ends.
InsertedSheet insert_sheet(HexMesh& mesh, const HexSheet& sheet, double depth = 0.3);

}  // namespace crossgrain

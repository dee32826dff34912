// SPDX-License-Identifier: Apache-2.0
// Hexahedra, and quads on their surface, from the cells of a file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "mesh_files/cells/cell_builder.hpp"

namespace crossgrain {

class HexBuilder : public CellBuilder {
 public:
  explicit HexBuilder(const InputFile& file);

  /// Returns the mesh: without vertices of no hexahedron, turned right-handed (`turn_right_handed`), with its
  /// boundary and the tags of the quads on it. Tags that are all 0 are no regions. Throws Error(kInput) if
  /// there are no hexahedra, naming `end`, the place where reading ended; if there are solids of other
  /// shapes, naming the first; if hexahedra have a corner twice; and if coordinates are out of range.
  HexMesh finish(const Place& end);

 protected:
  void reserve(std::size_t more_hexahedra) override;
  void take(CellShape shape, const Corners& corners, std::optional<std::int32_t> tag,
            bool is_stated) override;

 private:
  struct Quad {
    std::array<std::uint32_t, 4> sorted;
    std::int32_t tag;
  };

  void check_corners() const;
  void check_lengths() const;
  void drop_unused_vertices();
  void find_boundary();

  HexMesh mesh_;  ///< without vertices and warnings until the end
  std::vector<Quad> quads_;
};

}  // namespace crossgrain

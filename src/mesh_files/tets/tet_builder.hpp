// SPDX-License-Identifier: Apache-2.0
// Tets, and edges and triangles as features of them, from the cells of a file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "crossgrain/types.hpp"
#include "mesh_files/cells/cell_builder.hpp"

namespace crossgrain {

class TetBuilder : public CellBuilder {
 public:
  explicit TetBuilder(const InputFile& file);

  /// Keeps these edges alone, as stated ones (TetMesh::Edge).
  void choose_edges(const std::vector<std::int64_t>& numbers, const Place& place) override;

  /// Returns the mesh. Throws Error(kInput) if there are no tets, naming `end`, the place where reading
  /// ended, and if there are solids of other shapes, naming the first.
  TetMesh finish(const Place& end);

 protected:
  void reserve(std::size_t more_tets) override;
  void take(CellShape shape, const Corners& corners, std::optional<std::int32_t> tag,
            bool is_stated) override;

 private:
  TetMesh mesh_;  ///< without vertices and warnings
};

}  // namespace crossgrain

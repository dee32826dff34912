// SPDX-License-Identifier: Apache-2.0
// Common parts of all readers of tet meshes: checks of coordinates and indices, and the handling of cells of
// every shape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/types.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// Role of a cell in a tet mesh.
enum class CellShape : std::uint8_t {
  kPassedOver,  ///< points and polygons
  kEdge,
  kTriangle,
  kTet,
  kOtherSolid  ///< part of the solid, so that the tets alone do not fill it
};

constexpr std::size_t corners_of(CellShape shape) {
  switch (shape) {
    case CellShape::kEdge:
      return 2;
    case CellShape::kTriangle:
      return 3;
    case CellShape::kTet:
      return 4;
    default:
      return 0;
  }
}

/// A cell type of a format. Nodes beyond the corners are those of curved cells; all formats put the corners
/// first.
struct CellType {
  int code;  ///< its number in the format
  CellShape shape;
  std::uint8_t nodes;       ///< 0 for any number
  std::string_view plural;  ///< "tets"
};

class TetBuilder {
 public:
  /// `first_index` is the format's number of the first vertex, for error messages.
  explicit TetBuilder(const InputFile& file, int first_index = 0) : file_(&file), first_index_(first_index) {}

  /// Reserves memory; the caller must have checked that the file is long enough.
  void reserve_vertices(std::size_t more);
  void reserve_tets(std::size_t more);

  /// Throws Error(kInput) naming `place` if a coordinate is NaN or infinite.
  void add_vertex(const Vector3& position, const Place& place);

  /// Adds a tet, or a feature of lower dimension; solids of other shapes are counted, and `finish` refuses
  /// them. `nodes` are at least the corners, 0-based whatever the format; solids of other shapes may lack
  /// them. `tag`: all cells have one, or none. `is_stated`: of an edge, as in TetMesh::Edge. Throws
  /// Error(kInput) naming `place` if a corner is out of range or the tag has more than 32 bits.
  void add_cell(const CellType& type, std::span<const std::int64_t> nodes, std::optional<std::int64_t> tag,
                const Place& place, bool is_stated = true);

  /// Counts solids of another shape, without their nodes.
  void count_other_solids(const CellType& type, std::uint64_t count, const Place& place);

  std::size_t vertex_count() const { return mesh_.vertices.size(); }

  /// Adds to TetMesh::warnings.
  void warn(WarningKind kind, const Place& place, std::string text) {
    mesh_.warnings.emplace_back(kind, Message{file_->name(), in_words(place), std::move(text)});
  }

  /// Returns the mesh. Throws Error(kInput) if there are no tets, naming `end`, the place where reading
  /// ended, and if there are solids of other shapes, naming the first.
  TetMesh finish(const Place& end);

 private:
  std::uint32_t checked_index(std::int64_t node, CellShape shape, const Place& place) const;
  std::int32_t checked_tag(std::int64_t tag, const Place& place) const;
  [[noreturn]] void fail_other_solids() const;

  const InputFile* file_;
  int first_index_;
  Checkpoint checkpoint_;
  TetMesh mesh_;
  std::size_t curved_tets_ = 0;
  std::vector<std::pair<const CellType*, std::uint64_t>> other_solids_;
  Place first_other_solid_;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// What all readers of tet meshes share: checks of coordinates and indices, and what becomes of cells of every
// shape.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "crossgrain/types.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// What a cell of a file is to a tet mesh.
enum class CellShape : std::uint8_t {
  kPassedOver,  ///< points and polygons
  kEdge,
  kTriangle,
  kTet,
  kOtherSolid  ///< fills a part of the solid, so that the tets alone are not all of it
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

/// A kind of cell that a format has. Nodes beyond the corners are those of curved cells; all formats put the
/// corners first.
struct CellType {
  int code;  ///< its number in the format
  CellShape shape;
  std::uint8_t nodes;       ///< 0 for any number
  std::string_view plural;  ///< "tets"
};

class TetBuilder {
 public:
  /// `first_index`: the number that the format gives to the first vertex, for error messages.
  explicit TetBuilder(const InputFile& file, int first_index = 0) : file_(&file), first_index_(first_index) {}

  /// Makes room for more; the caller has checked that the file is long enough to hold as many.
  void reserve_vertices(std::size_t more);
  void reserve_tets(std::size_t more);

  /// Throws Error(kInput) naming `place` where a coordinate is NaN or infinite.
  void add_vertex(const Vector3& position, const Place& place);

  /// A tet, or a feature of fewer dimensions; solids of other shapes are counted for `finish` to refuse, with
  /// or without their nodes. `nodes`: at least the corners, numbered from 0 whatever the format does. `tag`:
  /// where there are any, all cells have one. Throws Error(kInput) naming `place` where a corner is out of
  /// range or the tag has more than 32 bits. `is_stated`: of an edge, as TetMesh::Edge has it.
  void add_cell(const CellType& type, std::span<const std::int64_t> nodes, std::optional<std::int64_t> tag,
                const Place& place, bool is_stated = true);

  /// Solids of another shape, without looking at their nodes.
  void count_other_solids(const CellType& type, std::uint64_t count, const Place& place);

  std::size_t vertex_count() const { return mesh_.vertices.size(); }

  /// Adds to TetMesh::warnings.
  void warn(WarningKind kind, const Place& place, std::string text) {
    mesh_.warnings.emplace_back(kind, Message{file_->name(), in_words(place), std::move(text)});
  }

  /// The mesh. Throws Error(kInput) where there are no tets, naming `end`, the place up to which the file was
  /// read, and where there are solids of other shapes, naming the first.
  TetMesh finish(const Place& end);

 private:
  std::uint32_t checked_index(std::int64_t node, CellShape shape, const Place& place) const;
  std::int32_t checked_tag(std::int64_t tag, const Place& place) const;
  [[noreturn]] void fail_other_solids() const;

  const InputFile* file_;
  int first_index_;
  TetMesh mesh_;
  std::size_t curved_tets_ = 0;
  std::vector<std::pair<const CellType*, std::uint64_t>> other_solids_;
  Place first_other_solid_;
};

}  // namespace crossgrain

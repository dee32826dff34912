// SPDX-License-Identifier: Apache-2.0
// What Medit meshes in text and in binary have in common: their sections, and what becomes of the rows.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "io/tets/tet_builder.hpp"
#include "io/text/number_stream.hpp"

namespace crossgrain {

enum class MeditContent : std::uint8_t { kPassedOver, kVertices, kCells, kRidges };

/// A section with a count and as many rows of as many numbers (libMeshb's list of keywords, for meshes in
/// three dimensions). Rows of cells are their nodes, numbered from 1, and a reference number.
struct MeditSection {
  std::string_view keyword;
  int code;  ///< of the keyword in binary; 0 where only text is read with it
  int columns;
  MeditContent content = MeditContent::kPassedOver;
  CellType cell = {0, CellShape::kPassedOver, 0, ""};
};

/// Null where the name or number is none of a section that is known.
const MeditSection* medit_section_named(std::string_view keyword);
const MeditSection* medit_section_coded(std::int64_t code);

/// The types of the numbers of a binary file.
struct MeditNumbers {
  NumberType real = NumberType::kFloat64;
  NumberType integer = NumberType::kInt32;
};

class MeditMesh {
 public:
  explicit MeditMesh(const InputFile& file, MeditNumbers numbers = {})
      : file_(&file), numbers_(numbers), builder_(file, /*first_index=*/1) {}

  /// Whether rows of a section can be read now: those of cells only once the vertices are known.
  bool is_ready_for(const MeditSection& section) const {
    return section.content != MeditContent::kCells || has_vertices_;
  }

  /// The rows of a section, `count` of them, which the rest of the file can hold. What is passed over is left
  /// to the caller.
  void read_rows(NumberStream& rows, const MeditSection& section, std::uint64_t count);

  bool has_vertices() const { return has_vertices_; }

  /// Feature edges are those that a section Ridges names. Where there is none, all Edges are, without being
  /// stated: Gmsh writes every curve of its model, seams too.
  TetMesh finish(const Place& end);

 private:
  void read_vertices(NumberStream& rows, std::uint64_t count);
  void read_cells(NumberStream& rows, const MeditSection& section, std::uint64_t count);
  void keep_ridges(TetMesh& mesh) const;

  const InputFile* file_;
  MeditNumbers numbers_;
  TetBuilder builder_;
  bool has_vertices_ = false;
  std::vector<std::int64_t> ridges_;  ///< numbers of edges, from 1
  Place ridges_place_;
};

}  // namespace crossgrain

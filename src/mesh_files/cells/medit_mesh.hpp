// SPDX-License-Identifier: Apache-2.0
// Common parts of Medit meshes in text and in binary: sections, and how their rows are interpreted.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "mesh_files/cells/cell_builder.hpp"
#include "text/number_stream.hpp"

namespace crossgrain {

enum class MeditContent : std::uint8_t { kPassedOver, kVertices, kCells, kRidges };

/// A section: a count, then that many rows of numbers (libMeshb's list of keywords, for meshes in three
/// dimensions). Rows of cells are their 1-based nodes and a reference number.
struct MeditSection {
  std::string_view keyword;
  int code;  ///< of the keyword in binary; 0 if read in text only
  int columns;
  MeditContent content = MeditContent::kPassedOver;
  CellType cell = {0, CellShape::kPassedOver, 0, ""};
};

/// Return null if no known section has that name or number.
const MeditSection* medit_section_named(std::string_view keyword);
const MeditSection* medit_section_coded(std::int64_t code);

/// Types of the numbers of a binary file.
struct MeditNumbers {
  NumberType real = NumberType::kFloat64;
  NumberType integer = NumberType::kInt32;
};

class MeditMesh {
 public:
  explicit MeditMesh(const InputFile& file, CellBuilder& builder, MeditNumbers numbers = {})
      : file_(&file), numbers_(numbers), builder_(builder) {
    builder_.number_vertices_from(1);
  }

  /// Returns whether rows of a section can be read now: cells need the vertices first.
  bool is_ready_for(const MeditSection& section) const {
    return section.content != MeditContent::kCells || has_vertices_;
  }

  /// Reads `count` rows of a section; the rest of the file must be long enough. The caller skips sections
  /// that are not used.
  void read_rows(NumberStream& rows, const MeditSection& section, std::uint64_t count);

  bool has_vertices() const { return has_vertices_; }

  /// Call when all sections are read. If there is a section Ridges, only its edges are features, and stated
  /// ones. Otherwise all Edges are, not stated: Gmsh writes every curve of its model, even seams.
  void finish();

 private:
  void read_vertices(NumberStream& rows, std::uint64_t count);
  void read_cells(NumberStream& rows, const MeditSection& section, std::uint64_t count);

  const InputFile* file_;
  MeditNumbers numbers_;
  CellBuilder& builder_;
  bool has_vertices_ = false;
  std::vector<std::int64_t> ridges_;  ///< 1-based numbers of edges
  Place ridges_place_;
};

}  // namespace crossgrain

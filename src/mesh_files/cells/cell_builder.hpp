// SPDX-License-Identifier: Apache-2.0
// Common parts of all readers of solid meshes: checks of coordinates and indices, and the handling of cells
// of every shape.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/types.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

enum class CellShape : std::uint8_t {
  kPassedOver,  ///< points and polygons
  kEdge,
  kTriangle,
  kQuad,
  kTet,
  kHexahedron,
  kOtherSolid
};

constexpr std::size_t corners_of(CellShape shape) {
  switch (shape) {
    case CellShape::kEdge:
      return 2;
    case CellShape::kTriangle:
      return 3;
    case CellShape::kQuad:
    case CellShape::kTet:
      return 4;
    case CellShape::kHexahedron:
      return 8;
    default:
      return 0;
  }
}

constexpr bool is_solid(CellShape shape) {
  return shape == CellShape::kTet || shape == CellShape::kHexahedron || shape == CellShape::kOtherSolid;
}

/// A cell type of a format. Nodes beyond the corners are those of curved cells; all formats put the corners
/// first.
struct CellType {
  int code;  ///< its number in the format
  CellShape shape;
  std::uint8_t nodes;       ///< 0 for any number
  std::string_view plural;  ///< "tets"
};

/// Takes the vertices and cells of a file in their order, and keeps those of the shapes that a kind of mesh
/// is made of. Other solids are counted, since what is kept does not fill the model without them; all else is
/// passed over.
class CellBuilder {
 public:
  virtual ~CellBuilder() = default;
  CellBuilder(const CellBuilder&) = delete;
  CellBuilder& operator=(const CellBuilder&) = delete;

  /// The format's number of the first vertex, for error messages; 0 unless this is called.
  void number_vertices_from(int first) { first_index_ = first; }

  /// Reserves memory; the caller must have checked that the file is long enough.
  void reserve_vertices(std::size_t more);
  void reserve_solids(std::size_t more);

  /// Whether cells are kept.
  bool takes(CellShape shape) const;
  CellShape solid() const { return use_.solid; }

  /// Number of the nodes of a cell that `add_cell` needs.
  std::size_t nodes_needed(const CellType& type) const {
    return takes(type.shape) ? corners_of(type.shape) : 0;
  }

  /// Throws Error(kInput) naming `place` if a coordinate is NaN or infinite.
  void add_vertex(const Vector3& position, const Place& place);

  /// Adds a cell. `nodes` are at least `nodes_needed`, 0-based whatever the format. `tag`: all cells have
  /// one, or none. `is_stated`: of an edge, as in TetMesh::Edge. Throws Error(kInput) naming `place` if a
  /// corner is out of range or the tag has more than 32 bits.
  void add_cell(const CellType& type, std::span<const std::int64_t> nodes, std::optional<std::int64_t> tag,
                const Place& place, bool is_stated = true);

  /// Counts solids of another shape, without their nodes.
  void count_other_solids(const CellType& type, std::uint64_t count, const Place& place);

  /// Says that of the edges only some are features, by their numbers from 1 (Ridges of Medit).
  virtual void choose_edges(const std::vector<std::int64_t>&, const Place&) {}

  std::size_t vertex_count() const { return vertices_.size(); }

  void warn(WarningKind kind, const Place& place, std::string text) {
    warnings_.emplace_back(kind, Message{file_->name(), in_words(place), std::move(text)});
  }

 protected:
  using Corners = std::array<std::uint32_t, 8>;

  /// What a mesh is made of.
  struct Use {
    CellShape solid, side;
    bool has_edges;
    std::size_t most_solids;
  };

  CellBuilder(const InputFile& file, const Use& use) : file_(&file), use_(use) {}

  virtual void reserve(std::size_t more_solids) = 0;
  virtual void take(CellShape shape, const Corners& corners, std::optional<std::int32_t> tag,
                    bool is_stated) = 0;

  /// Throws Error(kInput) if there are solids of other shapes, naming the first: "prisms (12), but only
  /// <words> can be used".
  void refuse_other_solids(const char* words, Remedy remedy) const;

  /// Whether there are solids of this other shape and of no other one.
  bool has_only_others_of(CellShape shape) const;

  const InputFile& file() const { return *file_; }
  std::vector<Vector3>& vertices() { return vertices_; }
  std::vector<Warning>& warnings() { return warnings_; }
  std::size_t curved_solids() const { return curved_; }

 private:
  std::uint32_t checked_index(std::int64_t node, CellShape shape, const Place& place) const;
  std::int32_t checked_tag(std::int64_t tag, const Place& place) const;

  const InputFile* file_;
  Use use_;
  int first_index_ = 0;
  Checkpoint checkpoint_;
  std::vector<Vector3> vertices_;
  std::vector<Warning> warnings_;
  std::size_t solids_ = 0, curved_ = 0;
  std::vector<std::pair<const CellType*, std::uint64_t>> other_solids_;
  Place first_other_solid_;
};

}  // namespace crossgrain

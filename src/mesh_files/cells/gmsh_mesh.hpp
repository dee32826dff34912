// SPDX-License-Identifier: Apache-2.0
// Reads the sections of a Gmsh mesh with nodes, elements, and the entities they belong to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>

#include "mesh_files/cells/cell_builder.hpp"
#include "mesh_files/cells/node_numbers.hpp"
#include "text/number_stream.hpp"

namespace crossgrain {

/// Each `read_` function reads the contents of a section, from the first number to the last. Elements must
/// come after the nodes, and in version 4.1 after the entities.
class GmshMesh {
 public:
  /// `size_type` is the type of counts and numbers in the binary form of version 4.1.
  GmshMesh(const InputFile& file, NumberType size_type, CellBuilder& builder)
      : file_(&file), size_type_(size_type), builder_(builder) {}

  void read_entities_4(NumberStream& in);
  void read_nodes_4(NumberStream& in);
  void read_elements_4(NumberStream& in);

  /// In version 2 the count is text in either encoding, so it is not in the stream.
  void read_nodes_2(NumberStream& in, std::int64_t count);
  void read_elements_2(NumberStream& in, std::int64_t count);

  bool has_nodes() const { return has_nodes_; }

 private:
  /// From dimension and tag of an entity to its physical group, as in $Entities.
  using PhysicalTags = std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t>;

  std::uint64_t count(NumberStream& in, NumberType type, std::uint64_t least, NumberType least_type,
                      const char* what) const;
  void read_entity(NumberStream& in, int dimension);
  void reserve_nodes(std::uint64_t nodes);
  void read_node(NumberStream& in);
  void finish_nodes(NumberStream& in);
  const CellType& element_type(NumberStream& in) const;

  /// Number of a physical group, which the user assigned; without one, the number of the model's entity.
  struct Tag {
    std::int64_t number;
    bool is_physical;
  };
  void read_element_nodes(NumberStream& in, NumberType type, const CellType& element, const Tag& tag);
  void read_elements_2_text(NumberStream& in, std::uint64_t elements);
  void read_elements_2_binary(NumberStream& in, std::uint64_t elements);
  Tag read_tags_2(NumberStream& in, std::uint64_t tags) const;

  const InputFile* file_;
  NumberType size_type_;
  CellBuilder& builder_;
  NodeNumbers numbers_;
  PhysicalTags physical_tags_;
  bool has_nodes_ = false;
  std::size_t elements_ = 0;  ///< number read so far
};

}  // namespace crossgrain

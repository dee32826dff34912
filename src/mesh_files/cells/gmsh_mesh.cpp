// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/cells/gmsh_mesh.hpp"

#include <fmt/format.h>

#include <span>

#include "files/read_memory.hpp"
#include "mesh_files/cells/gmsh_elements.hpp"

namespace crossgrain {
namespace {

constexpr NumberType kInt = NumberType::kInt32;
constexpr NumberType kDouble = NumberType::kFloat64;

/// Groups have positive numbers; the sign is the orientation of an entity.
std::int64_t group_of(std::int64_t physical_tag) {
  // Unsigned, so that the least number of 64 bits wraps instead of overflowing.
  return physical_tag < 0 ? static_cast<std::int64_t>(-static_cast<std::uint64_t>(physical_tag))
                          : physical_tag;
}

}  // namespace

std::uint64_t GmshMesh::count(NumberStream& in, NumberType type, std::uint64_t least, NumberType least_type,
                              const char* what) const {
  const std::int64_t stated = in.integer(type, what);
  return in.checked_count(stated, least, least_type, what);
}

void GmshMesh::read_entities_4(NumberStream& in) {
  std::array<std::uint64_t, 4> counts;
  for (std::uint64_t& entities : counts) entities = count(in, size_type_, 4, kInt, "the number of entities");
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::uint64_t i = 0; i < counts[static_cast<std::size_t>(dimension)]; ++i)
      read_entity(in, dimension);
  }
}

/// Tag, a point or a box, physical tags, and bounding entities.
void GmshMesh::read_entity(NumberStream& in, int dimension) {
  const std::int64_t tag = in.integer(kInt, "the tag of an entity");
  in.skip(kDouble, dimension == 0 ? 3 : 6);
  const std::uint64_t groups = count(in, size_type_, 1, kInt, "the number of physical tags");
  for (std::uint64_t i = 0; i < groups; ++i) {
    const std::int64_t group = group_of(in.integer(kInt, "a physical tag"));
    if (group != 0) physical_tags_.try_emplace({dimension, tag}, group);
  }
  if (dimension > 0) in.skip(kInt, count(in, size_type_, 1, kInt, "the number of bounding entities"));
}

void GmshMesh::reserve_nodes(std::uint64_t nodes) {
  // The table of numbers may be needed too.
  require_read_memory(file_->name(),
                      static_cast<double>(nodes) * (sizeof(Vector3) + NodeNumbers::kMostBytesANode));
  builder_.reserve_vertices(nodes);
}

void GmshMesh::read_node(NumberStream& in) {
  const Place place = in.place("node", builder_.vertex_count());
  Vector3 position;
  for (double& coordinate : position) coordinate = in.real(kDouble, "a coordinate");
  builder_.add_vertex(position, place);
}

void GmshMesh::finish_nodes(NumberStream& in) {
  has_nodes_ = true;
  if (const auto twice = numbers_.finish()) in.fail(fmt::format("two nodes have the number {}", *twice));
}

void GmshMesh::read_nodes_4(NumberStream& in) {
  const std::uint64_t blocks = count(in, size_type_, 4, kInt, "the number of blocks of nodes");
  const std::uint64_t nodes = count(in, size_type_, 4, kInt, "the number of nodes");
  in.skip(size_type_, 2);  // least and largest number
  reserve_nodes(nodes);
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::int64_t dimension = in.integer(kInt, "the dimension of an entity");
    in.skip(kInt, 1);  // tag
    const bool parametric = in.integer(kInt, "whether nodes have parameters") != 0;
    if (dimension < 0 || dimension > 3) in.fail(fmt::format("an entity of {} dimensions", dimension));
    const std::uint64_t rows = count(in, size_type_, 4, kInt, "the number of nodes of an entity");
    for (std::uint64_t i = 0; i < rows; ++i) numbers_.add(in.integer(size_type_, "the number of a node"));
    for (std::uint64_t i = 0; i < rows; ++i) {
      read_node(in);
      if (parametric) in.skip(kDouble, static_cast<std::uint64_t>(dimension));
    }
  }
  if (builder_.vertex_count() != nodes)
    in.fail(fmt::format("nodes: {} announced and {} here", nodes, builder_.vertex_count()));
  finish_nodes(in);
}

void GmshMesh::read_nodes_2(NumberStream& in, std::int64_t count) {
  const std::uint64_t nodes = in.checked_count(count, 4, kInt, "the number of nodes");
  reserve_nodes(nodes);
  for (std::uint64_t i = 0; i < nodes; ++i) {
    numbers_.add(in.integer(kInt, "the number of a node"));
    read_node(in);
  }
  finish_nodes(in);
}

const CellType& GmshMesh::element_type(NumberStream& in) const {
  const std::int64_t code = in.integer(kInt, "the type of an element");
  const CellType* type = gmsh_element(code);
  if (type == nullptr) in.fail(fmt::format("elements of unknown type {}", code));
  return *type;
}

void GmshMesh::read_element_nodes(NumberStream& in, NumberType type, const CellType& element,
                                  const Tag& tag) {
  const Place place = in.place("element", elements_++);
  const std::size_t corners = builder_.nodes_needed(element);
  std::array<std::int64_t, 8> nodes;
  for (std::size_t k = 0; k < corners; ++k) {
    const std::int64_t number = in.integer(type, "the number of a node");
    const auto node = numbers_.index_of(number);
    if (!node)
      fail_input(*file_, place, fmt::format("refers to node {}, which the file does not have", number));
    nodes[k] = *node;
  }
  if (element.nodes > corners) in.skip(type, element.nodes - corners);
  builder_.add_cell(element, std::span(nodes).first(corners), tag.number, place, tag.is_physical);
}

void GmshMesh::read_elements_4(NumberStream& in) {
  const std::uint64_t blocks = count(in, size_type_, 4, kInt, "the number of blocks of elements");
  const std::uint64_t elements = count(in, size_type_, 2, size_type_, "the number of elements");
  in.skip(size_type_, 2);  // least and largest number
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const std::int64_t dimension = in.integer(kInt, "the dimension of an entity");
    const std::int64_t entity = in.integer(kInt, "the tag of an entity");
    const CellType& type = element_type(in);
    const std::uint64_t rows = count(in, size_type_, 1 + std::uint64_t{type.nodes}, size_type_,
                                     "the number of elements of an entity");
    const auto found = physical_tags_.find({dimension, entity});
    const Tag tag = found == physical_tags_.end() ? Tag{entity, false} : Tag{found->second, true};
    if (type.shape == builder_.solid()) builder_.reserve_solids(rows);
    for (std::uint64_t i = 0; i < rows; ++i) {
      in.skip(size_type_, 1);  // number of the element
      read_element_nodes(in, size_type_, type, tag);
    }
  }
  if (elements_ != elements) in.fail(fmt::format("elements: {} announced and {} here", elements, elements_));
}

/// Physical group and entity come first; partitions and others follow.
GmshMesh::Tag GmshMesh::read_tags_2(NumberStream& in, std::uint64_t tags) const {
  std::array<std::int64_t, 2> first{};
  for (std::uint64_t i = 0; i < tags && i < first.size(); ++i) first[i] = in.integer(kInt, "a tag");
  if (tags > first.size()) in.skip(kInt, tags - first.size());
  return first[0] != 0 ? Tag{group_of(first[0]), true} : Tag{first[1], false};
}

void GmshMesh::read_elements_2(NumberStream& in, std::int64_t count) {
  const std::uint64_t elements = in.checked_count(count, 2, kInt, "the number of elements");
  if (in.is_text()) {
    read_elements_2_text(in, elements);
  } else {
    read_elements_2_binary(in, elements);
  }
}

void GmshMesh::read_elements_2_text(NumberStream& in, std::uint64_t elements) {
  for (std::uint64_t i = 0; i < elements; ++i) {
    in.skip(kInt, 1);  // number of the element
    const CellType& type = element_type(in);
    const std::uint64_t tags = count(in, kInt, 1, kInt, "the number of tags");
    const Tag tag = read_tags_2(in, tags);
    read_element_nodes(in, kInt, type, tag);
  }
}

/// In binary, elements of one type and number of tags share a header.
void GmshMesh::read_elements_2_binary(NumberStream& in, std::uint64_t elements) {
  while (elements_ < elements) {
    const CellType& type = element_type(in);
    const std::uint64_t rows = count(in, kInt, 1 + std::uint64_t{type.nodes}, kInt, "the number of elements");
    const std::uint64_t tags = count(in, kInt, 1, kInt, "the number of tags");
    if (rows == 0 || rows > elements - elements_)
      in.fail(fmt::format("elements: {} here and {} expected", rows, elements - elements_));
    if (type.shape == builder_.solid()) builder_.reserve_solids(rows);
    for (std::uint64_t i = 0; i < rows; ++i) {
      in.skip(kInt, 1);  // number of the element
      const Tag tag = read_tags_2(in, tags);
      read_element_nodes(in, kInt, type, tag);
    }
  }
}

}  // namespace crossgrain

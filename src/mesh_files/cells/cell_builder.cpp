// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/cells/cell_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

const char* singular_of(CellShape shape) {
  switch (shape) {
    case CellShape::kEdge:
      return "an edge";
    case CellShape::kTriangle:
      return "a triangle";
    case CellShape::kQuad:
      return "a quad";
    case CellShape::kTet:
      return "a tet";
    default:
      return "a hexahedron";
  }
}

const char* plural_of(CellShape solid) {
  return solid == CellShape::kTet ? "tets" : "hexahedra";
}

}  // namespace

void CellBuilder::reserve_vertices(std::size_t more) {
  reserve_more(file_->name(), vertices_, more);
}

void CellBuilder::reserve_solids(std::size_t more) {
  if (more > use_.most_solids - std::min(use_.most_solids, solids_))
    fail_input(*file_, {}, fmt::format("more than {} {}", use_.most_solids, plural_of(use_.solid)),
               Remedy::kSimplify);
  reserve(more);
}

bool CellBuilder::takes(CellShape shape) const {
  return shape == use_.solid || shape == use_.side || (shape == CellShape::kEdge && use_.has_edges);
}

void CellBuilder::add_vertex(const Vector3& position, const Place& place) {
  for (const double coordinate : position) {
    if (!std::isfinite(coordinate)) fail_input(*file_, place, fmt::format("a coordinate is {}", coordinate));
  }
  if (vertices_.size() >= std::numeric_limits<std::uint32_t>::max())
    fail_input(*file_, place, "more than 4294967295 vertices", Remedy::kSimplify);
  checkpoint_.pass();
  append_within_memory(file_->name(), vertices_, position);
}

std::uint32_t CellBuilder::checked_index(std::int64_t node, CellShape shape, const Place& place) const {
  if (node < 0 || static_cast<std::uint64_t>(node) >= vertices_.size()) {
    // Unsigned, so that an index at the end of the 64-bit range wraps instead of overflowing.
    const auto shown = static_cast<std::int64_t>(static_cast<std::uint64_t>(node) +
                                                 static_cast<std::uint64_t>(first_index_));
    fail_input(
        *file_, place,
        fmt::format("{} refers to vertex {}, but they are numbered from {} to {}", singular_of(shape), shown,
                    first_index_, static_cast<std::int64_t>(vertices_.size()) - 1 + first_index_));
  }
  return static_cast<std::uint32_t>(node);
}

std::int32_t CellBuilder::checked_tag(std::int64_t tag, const Place& place) const {
  if (tag < std::numeric_limits<std::int32_t>::min() || tag > std::numeric_limits<std::int32_t>::max())
    fail_input(*file_, place, fmt::format("the tag {} does not fit into 32 bits", tag));
  return static_cast<std::int32_t>(tag);
}

void CellBuilder::add_cell(const CellType& type, std::span<const std::int64_t> nodes,
                           std::optional<std::int64_t> tag, const Place& place, bool is_stated) {
  checkpoint_.pass();
  if (!takes(type.shape)) {
    if (is_solid(type.shape)) count_other_solids(type, 1, place);
    return;
  }
  Corners corners{};
  for (std::size_t k = 0; k < corners_of(type.shape); ++k)
    corners[k] = checked_index(nodes[k], type.shape, place);
  if (type.shape == use_.solid) {
    if (solids_ >= use_.most_solids) reserve_solids(1);
    ++solids_;
    if (type.nodes != corners_of(type.shape)) ++curved_;
  }
  take(type.shape, corners, tag ? std::optional(checked_tag(*tag, place)) : std::nullopt, is_stated);
}

void CellBuilder::count_other_solids(const CellType& type, std::uint64_t count, const Place& place) {
  if (count == 0) return;
  if (other_solids_.empty()) first_other_solid_ = place;
  const auto found = std::find_if(other_solids_.begin(), other_solids_.end(),
                                  [&](const auto& entry) { return entry.first == &type; });
  if (found == other_solids_.end()) {
    other_solids_.emplace_back(&type, count);
  } else {
    found->second += count;
  }
}

bool CellBuilder::has_only_others_of(CellShape shape) const {
  return !other_solids_.empty() &&
         std::ranges::all_of(other_solids_, [&](const auto& entry) { return entry.first->shape == shape; });
}

void CellBuilder::refuse_other_solids(const char* words, Remedy remedy) const {
  if (other_solids_.empty()) return;
  std::string list;
  for (std::size_t i = 0; i < other_solids_.size(); ++i) {
    const char* const between = i == 0 ? "" : i + 1 < other_solids_.size() ? ", " : " and ";
    list += fmt::format("{}{} ({})", between, other_solids_[i].first->plural, other_solids_[i].second);
  }
  fail_input(*file_, first_other_solid_, fmt::format("{}, but only {} can be used", list, words), remedy);
}

}  // namespace crossgrain

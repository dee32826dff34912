// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/tets/tet_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

/// The six edges of each tet have 32-bit numbers (tets/stiffness.cpp).
constexpr std::size_t kMostTets = UINT32_MAX / 6;

const char* singular_of(CellShape shape) {
  return shape == CellShape::kEdge ? "an edge" : shape == CellShape::kTriangle ? "a triangle" : "a tet";
}

}  // namespace

void TetBuilder::reserve_vertices(std::size_t more) {
  reserve_more(file_->name(), mesh_.vertices, more);
}

void TetBuilder::reserve_tets(std::size_t more) {
  if (more > kMostTets - std::min(kMostTets, mesh_.tets.size()))
    fail_input(*file_, {}, fmt::format("more than {} tets", kMostTets), Remedy::kSimplify);
  reserve_more(file_->name(), mesh_.tets, more);
}

void TetBuilder::add_vertex(const Vector3& position, const Place& place) {
  for (const double coordinate : position) {
    if (!std::isfinite(coordinate)) fail_input(*file_, place, fmt::format("a coordinate is {}", coordinate));
  }
  if (mesh_.vertices.size() >= std::numeric_limits<std::uint32_t>::max())
    fail_input(*file_, place, "more than 4294967295 vertices", Remedy::kSimplify);
  checkpoint_.pass();
  append_within_memory(file_->name(), mesh_.vertices, position);
}

std::uint32_t TetBuilder::checked_index(std::int64_t node, CellShape shape, const Place& place) const {
  if (node < 0 || static_cast<std::uint64_t>(node) >= mesh_.vertices.size()) {
    // Unsigned, so that an index at the end of the 64-bit range wraps instead of overflowing.
    const auto shown = static_cast<std::int64_t>(static_cast<std::uint64_t>(node) +
                                                 static_cast<std::uint64_t>(first_index_));
    fail_input(
        *file_, place,
        fmt::format("{} refers to vertex {}, but they are numbered from {} to {}", singular_of(shape), shown,
                    first_index_, static_cast<std::int64_t>(mesh_.vertices.size()) - 1 + first_index_));
  }
  return static_cast<std::uint32_t>(node);
}

std::int32_t TetBuilder::checked_tag(std::int64_t tag, const Place& place) const {
  if (tag < std::numeric_limits<std::int32_t>::min() || tag > std::numeric_limits<std::int32_t>::max())
    fail_input(*file_, place, fmt::format("the tag {} does not fit into 32 bits", tag));
  return static_cast<std::int32_t>(tag);
}

void TetBuilder::add_cell(const CellType& type, std::span<const std::int64_t> nodes,
                          std::optional<std::int64_t> tag, const Place& place, bool is_stated) {
  checkpoint_.pass();
  const auto index = [&](std::size_t corner) { return checked_index(nodes[corner], type.shape, place); };
  switch (type.shape) {
    case CellShape::kPassedOver:
      return;
    case CellShape::kOtherSolid:
      return count_other_solids(type, 1, place);
    case CellShape::kEdge:
      append_within_memory(file_->name(), mesh_.feature_edges,
                           {{index(0), index(1)}, checked_tag(tag.value_or(0), place), is_stated});
      return;
    case CellShape::kTriangle:
      append_within_memory(file_->name(), mesh_.feature_faces,
                           {{index(0), index(1), index(2)}, checked_tag(tag.value_or(0), place)});
      return;
    case CellShape::kTet:
      if (mesh_.tets.size() >= kMostTets) reserve_tets(1);
      append_within_memory(file_->name(), mesh_.tets, {index(0), index(1), index(2), index(3)});
      if (tag) append_within_memory(file_->name(), mesh_.regions, checked_tag(*tag, place));
      if (type.nodes != corners_of(type.shape)) ++curved_tets_;
      return;
  }
}

void TetBuilder::count_other_solids(const CellType& type, std::uint64_t count, const Place& place) {
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

void TetBuilder::fail_other_solids() const {
  std::string list;
  for (std::size_t i = 0; i < other_solids_.size(); ++i) {
    const char* const between = i == 0 ? "" : i + 1 < other_solids_.size() ? ", " : " and ";
    list += fmt::format("{}{} ({})", between, other_solids_[i].first->plural, other_solids_[i].second);
  }
  fail_input(*file_, first_other_solid_, list + ", but only tets can be used", Remedy::kCutIntoTets);
}

TetMesh TetBuilder::finish(const Place& end) {
  if (!other_solids_.empty()) fail_other_solids();
  if (mesh_.tets.empty() && !mesh_.feature_faces.empty())
    fail_input(*file_, end,
               fmt::format("{} but no tets (for surfaces use STL, OBJ, PLY, OFF or 3MF)",
                           counted(mesh_.feature_faces.size(), "triangle")),
               Remedy::kCutIntoTets);
  if (mesh_.tets.empty()) fail_input(*file_, end, "the file has no tets", Remedy::kExportAgain);
  if (curved_tets_ > 0)
    warn(WarningKind::kCurvedTets, {},
         fmt::format("tets of higher order: {}; only their corners are used, as if they were straight",
                     curved_tets_));
  return std::move(mesh_);
}

}  // namespace crossgrain

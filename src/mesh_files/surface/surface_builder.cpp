// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/surface/surface_builder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "files/read_memory.hpp"

namespace crossgrain {

void SurfaceBuilder::reserve(std::size_t vertices, std::size_t triangles) {
  reserve_more(file_->name(), mesh_.vertices, vertices - std::min(vertices, mesh_.vertices.size()));
  reserve_more(file_->name(), mesh_.triangles, triangles);
}

void SurfaceBuilder::add_vertex(const Vector3& position, const Place& place) {
  for (const double coordinate : position) {
    if (!std::isfinite(coordinate)) fail_input(*file_, place, fmt::format("a coordinate is {}", coordinate));
  }
  if (mesh_.vertices.size() >= std::numeric_limits<std::uint32_t>::max())
    fail_input(*file_, place, "more than 4294967295 vertices", Remedy::kSimplify);
  checkpoint_.pass();
  append_within_memory(file_->name(), mesh_.vertices, position);
}

void SurfaceBuilder::add_polygon(std::span<const std::int64_t> corners, const Place& place) {
  checkpoint_.pass();
  corners_.clear();
  for (const std::int64_t corner : corners) {
    if (corner < 0 || static_cast<std::size_t>(corner) >= mesh_.vertices.size())
      fail_out_of_range(corner, place);
    append_within_memory(file_->name(), corners_, static_cast<std::uint32_t>(corner));
  }
  if (corners_.size() > 3) {
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    while (corners_.size() > 3 && corners_.front() == corners_.back()) corners_.pop_back();
  }
  if (corners_.size() < 3) return;
  reserve_more(file_->name(), mesh_.triangles, corners_.size() - 2);
  if (!triangulator_.triangulate(corners_, mesh_.vertices, mesh_.triangles))
    fail_input(
        *file_, place,
        fmt::format("this polygon of {} corners takes too long to cut into triangles", corners_.size()),
        Remedy::kTriangulate);
}

void SurfaceBuilder::fail_out_of_range(std::int64_t corner, const Place& place) const {
  if (mesh_.vertices.empty()) fail_input(*file_, place, "a face but no vertices");
  // Unsigned, so that a corner at the end of the 64-bit range wraps instead of overflowing.
  const auto shown = static_cast<std::int64_t>(static_cast<std::uint64_t>(corner) +
                                               static_cast<std::uint64_t>(first_index_));
  fail_input(*file_, place,
             fmt::format("a face refers to vertex {}, but vertices are numbered {} to {}", shown,
                         first_index_, static_cast<std::int64_t>(mesh_.vertices.size()) - 1 + first_index_));
}

TriangleMesh SurfaceBuilder::finish() {
  if (mesh_.triangles.empty()) fail_input(*file_, {}, "holds no triangles or polygons", Remedy::kExportAgain);
  return std::move(mesh_);
}

}  // namespace crossgrain

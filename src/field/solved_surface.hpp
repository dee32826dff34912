// SPDX-License-Identifier: Apache-2.0
// The surface that a field was solved for, for display.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// The mended triangles that the solve used.
struct SolvedSurface {
  std::vector<Vector3> vertices;                        ///< model units; some may be unused
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< the outer surface, oriented outwards
  std::vector<std::vector<Vector3>> creases;  ///< polylines of 2 or more points; closed ones repeat the first

  /// Faces between solids, each once, outward from the first of its two solids.
  std::vector<std::array<std::uint32_t, 3>> interfaces = {};

  /// The solid of each triangle and the two of each interface (TriangleMesh::solids); `regions` is empty if
  /// there is only one solid or earlier versions wrote the file.
  std::vector<std::int32_t> regions = {};
  std::vector<std::array<std::int32_t, 2>> interface_regions = {};
};

/// The outer surface, for searching. Throws Error(kInput) if no triangle has an area.
std::shared_ptr<const SearchableSurface> searchable(const SolvedSurface& surface);

/// A surface in memory, or one that is read from a file when it is first needed: most users of a field do not
/// need it, and it may be larger than the field. Thread-safe.
class SurfaceSource {
 public:
  /// Holds no surface.
  SurfaceSource() = default;

  /// `searched` is the surface for searching, or null if that is to be made when it is first needed.
  explicit SurfaceSource(SolvedSurface surface, std::shared_ptr<const SearchableSurface> searched = nullptr);

  explicit SurfaceSource(std::function<SolvedSurface()> read);

  /// Returns the surface, or null if there is none. Throws what reading it throws, at every call.
  std::shared_ptr<const SolvedSurface> get() const { return surface_.valid() ? surface_.get() : nullptr; }

  /// Returns the surface for searching, or null if there is none or it has no triangles. Throws as get() and
  /// crossgrain::searchable do.
  std::shared_ptr<const SearchableSurface> searchable() const {
    return searchable_.valid() ? searchable_.get() : nullptr;
  }

 private:
  template <class T>
  using Shared = std::shared_future<std::shared_ptr<const T>>;

  Shared<SolvedSurface> surface_;
  Shared<SearchableSurface> searchable_;
};

}  // namespace crossgrain

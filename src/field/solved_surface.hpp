// SPDX-License-Identifier: Apache-2.0
// The surface that a field was solved for, for display.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include "crossgrain/types.hpp"
#include "surface/searchable_surface.hpp"

namespace crossgrain {

/// The mended triangles that the solve used.
struct SolvedSurface {
  std::vector<Vector3> vertices;                        ///< model units; some may be unused
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< the outer surface, oriented outwards
  std::vector<std::vector<Vector3>> creases;  ///< polylines of 2 or more points; closed ones repeat the first

  /// For each triangle the number of its face (SolveReport::faces), 0 for none; empty if earlier versions
  /// wrote the file.
  std::vector<std::int32_t> faces = {};

  /// Faces between solids, each once, outward from the first of its two solids.
  std::vector<std::array<std::uint32_t, 3>> interfaces = {};

  /// The solid of each triangle and the two of each interface (TriangleMesh::solids); `regions` is empty if
  /// there is only one solid or earlier versions wrote the file.
  std::vector<std::int32_t> regions = {};
  std::vector<std::array<std::int32_t, 2>> interface_regions = {};
};

/// The outer surface, for searching. Throws Error(kInput) if no triangle has an area.
std::shared_ptr<const SearchableSurface> searchable(const SolvedSurface& surface);

/// A value that is made when it is first asked for, and after a failure when it is asked for again.
/// Thread-safe.
template <class T>
class MadeOnDemand {
 public:
  using Pointer = std::shared_ptr<const T>;

  explicit MadeOnDemand(Pointer value) : value_(std::move(value)) {}
  explicit MadeOnDemand(std::function<Pointer()> make) : make_(std::move(make)) {}

  /// Throws what making it throws.
  Pointer get() {
    const std::lock_guard lock(mutex_);
    if (make_) {
      value_ = make_();
      make_ = {};
    }
    return value_;
  }

 private:
  std::mutex mutex_;
  Pointer value_;
  std::function<Pointer()> make_;  ///< none once it is made
};

/// A surface in memory, or one that is read from a file when it is first needed: most users of a field do not
/// need it, and it may be larger than the field. Thread-safe.
class SurfaceSource {
 public:
  /// Holds no surface.
  SurfaceSource() = default;

  /// `searched` is the surface for searching, or null if that is to be made when it is first needed.
  explicit SurfaceSource(SolvedSurface surface, std::shared_ptr<const SearchableSurface> searched = nullptr);

  explicit SurfaceSource(std::function<SolvedSurface()> read);

  /// Returns the surface, or null if there is none. Throws what reading it throws.
  std::shared_ptr<const SolvedSurface> get() const { return surface_ ? surface_->get() : nullptr; }

  /// Returns the surface for searching, or null if there is none or it has no triangles. Throws as get() and
  /// crossgrain::searchable do.
  std::shared_ptr<const SearchableSurface> searchable() const {
    return searchable_ ? searchable_->get() : nullptr;
  }

 private:
  void search_surface();

  std::shared_ptr<MadeOnDemand<SolvedSurface>> surface_;
  std::shared_ptr<MadeOnDemand<SearchableSurface>> searchable_;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// The surface that a field was solved for, for display.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <future>
#include <memory>
#include <utility>
#include <vector>

#include "crossgrain/types.hpp"

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

/// A surface in memory, or one that is read from a file when it is first needed: most users of a field do not
/// need it, and it may be larger than the field.
class SurfaceSource {
 public:
  /// Holds no surface.
  SurfaceSource() = default;

  explicit SurfaceSource(SolvedSurface surface) {
    std::promise<std::shared_ptr<const SolvedSurface>> now;
    now.set_value(std::make_shared<const SolvedSurface>(std::move(surface)));
    surface_ = now.get_future().share();
  }

  explicit SurfaceSource(std::function<SolvedSurface()> read)
      : surface_(std::async(std::launch::deferred, [read = std::move(read)] {
                   return std::make_shared<const SolvedSurface>(read());
                 }).share()) {}

  /// Returns the surface, or null if there is none. Throws what reading it throws, at every call.
  /// Thread-safe.
  std::shared_ptr<const SolvedSurface> get() const { return surface_.valid() ? surface_.get() : nullptr; }

 private:
  std::shared_future<std::shared_ptr<const SolvedSurface>> surface_;
};

}  // namespace crossgrain

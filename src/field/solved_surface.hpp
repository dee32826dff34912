// SPDX-License-Identifier: Apache-2.0
// The surface that a field was solved with, for what is drawn of it.
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

/// Mended: the triangles that the solve saw, looking out of the solid. Faces between solids are not among
/// them.
struct SolvedSurface {
  std::vector<Vector3> vertices;  ///< model units; some may be of no triangle
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::vector<Vector3>> creases;  ///< polylines of two points at least; closed ones repeat one
};

/// A surface at hand, or one that is read from a file when it is first asked for: most of what reads a field
/// has no use for it, and it may be larger than the field.
class SurfaceSource {
 public:
  /// None.
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

  /// Null where there is none; throws what reading it throws, every time. From any number of threads.
  std::shared_ptr<const SolvedSurface> get() const { return surface_.valid() ? surface_.get() : nullptr; }

 private:
  std::shared_future<std::shared_ptr<const SolvedSurface>> surface_;
};

}  // namespace crossgrain

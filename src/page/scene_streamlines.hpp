// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "crossgrain/monitor.hpp"
#include "crossgrain/streamlines.hpp"
#include "page/scene_parts.hpp"
#include "page/scene_writer.hpp"

namespace crossgrain {

/// Traces the streamlines of a page: few enough to see through.
StreamlineTracer page_tracer(const FrameField& field);
StreamlineTracer page_tracer(const TetFrameField& field);

/// Streamlines in two sets: along the plane through the middle of the part across `axis`, and along the
/// surface; relative to `origin`. Independent of the number of threads.
class PageStreamlines {
 public:
  /// Errors: kInterrupted.
  PageStreamlines(const StreamlineTracer& tracer, const Vector3& origin, int axis, const Monitor& monitor);

  /// Adds the arrays streamline_*.
  void write(SceneWriter& scene) const;

 private:
  void add(const std::vector<Streamline>& traced, std::uint8_t set);

  Polylines lines_;
  std::vector<std::uint8_t> axes_, sets_;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/monitor.hpp"
#include "picture/camera.hpp"
#include "picture/drawing.hpp"
#include "picture/image.hpp"

namespace crossgrain {

struct RenderOptions {
  /// Colour into which distant things fade, and its share in the farthest.
  Colour haze = {1, 1, 1};
  float haze_share = 0.3f;

  /// Smallest part of a solid rod that stays visible through any number of translucent faces.
  float least_seen_through = 0.58f;

  /// The same behind the face of a cut: enough to see where lines run, and that they do so behind it.
  float least_seen_through_cut = 0.2f;
};

/// Casts rays at a drawing and composites the result over the image: one ray per pixel, and many where the
/// picture changes between pixels. Bitwise identical for any number of threads. Throws Error(kInterrupted).
void render(const Drawing& drawing, const Camera& camera, const RenderOptions& options, Image& image,
            const Monitor& monitor);

}  // namespace crossgrain

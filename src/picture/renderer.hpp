// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "crossgrain/monitor.hpp"
#include "picture/camera.hpp"
#include "picture/drawing.hpp"
#include "picture/image.hpp"

namespace crossgrain {

struct RenderOptions {
  /// What far-off things fade into, and how much of it the farthest have.
  Colour haze = {1, 1, 1};
  float haze_share = 0.3f;

  /// The least of a solid rod that is seen through however many translucent faces.
  float least_seen_through = 0.58f;
};

/// Casts rays at a drawing and lays what they meet over the image: one a pixel, and many where it changes
/// from pixel to pixel. The same image to the bit for any number of threads. Throws Error(kInterrupted).
void render(const Drawing& drawing, const Camera& camera, const RenderOptions& options, Image& image,
            const Monitor& monitor);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "analysis/tet_field.hpp"

#include <cassert>
#include <cmath>

#include "base/parallel.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {
namespace {

/// The product of the mean and the most central frame above which the maximum uphill from that frame is the
/// global one: of 20000 random quadruples, 18 missed it, all of them below 0.25.
constexpr double kCertain = 0.5;

}  // namespace

std::vector<Quaternion> tet_frames_of(const TetMesh& mesh, std::span<const Quaternion> vertex_frames) {
  assert(vertex_frames.size() == mesh.vertices.size());
  std::vector<Coefficients<4>> h(vertex_frames.size());
  parallel_for(h.size(), [&](std::size_t v) { h[v] = frame_coefficients<4>(vertex_frames[v]); });

  std::vector<Quaternion> frames(mesh.tets.size());
  parallel_for(frames.size(), [&](std::size_t t) {
    Coefficients<4> mean{};
    for (const std::uint32_t v : mesh.tets[t]) add_scaled(mean, 0.25, h[v]);
    std::uint32_t central = mesh.tets[t][0];
    double closest = dot(mean, h[central]);
    for (const std::uint32_t v : mesh.tets[t]) {
      const double product = dot(mean, h[v]);
      if (product > closest) {
        closest = product;
        central = v;
      }
    }
    frames[t] = closest > kCertain ? refine_frame<4>(mean, vertex_frames[central]) : nearest_frame<4>(mean);
  });
  return frames;
}

}  // namespace crossgrain

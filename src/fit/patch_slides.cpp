// SPDX-License-Identifier: Apache-2.0
#include "fit/patch_slides.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;
using Kind = HexCarrier::Kind;

/// In poorness for a way of a size. From 0.03 to 1 the worst of two parts of three is the same.
constexpr double kReachWeight = 0.1;

}  // namespace

PatchSlides::PatchSlides(const HexPatch& patch, const FittingTargets& targets,
                         std::span<const Vector3> normals, std::span<const std::uint8_t> blocked)
    : size_(targets.size()) {
  for (std::uint32_t v = 0; v < patch.vertices.size(); ++v) {
    const std::uint32_t vertex = patch.vertices[v];
    const Kind kind = targets.carriers().of_vertex[vertex].kind;
    if (!patch.is_free[v] || kind == Kind::kHeld) continue;
    const bool is_inside = kind == Kind::kInside;
    const int freedom = (patch.off[v] > 0 ? 2 : 1) - blocked[v];
    if (is_inside || freedom == 2) {
      for (const Vector3& axis : {Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}) add(v, axis, is_inside);
    } else if (kind != Kind::kCorner && freedom == 1) {
      const Vector3 direction = targets.nearest(vertex, patch.mesh.vertices[v], normals[vertex]).direction;
      const Vector3 across = orthogonal_unit(direction);
      if (kind == Kind::kCurve) {
        add(v, direction);
      } else {
        add(v, across);
        add(v, cross(direction, across));
      }
    }
  }
}

void PatchSlides::move(const Eigen::VectorXd& x, std::vector<Vector3>& places) const {
  for (std::size_t k = 0; k < slides_.size(); ++k)
    places[slides_[k].vertex] += size_ * x[static_cast<Index>(k)] * slides_[k].direction;
}

void PatchSlides::put_gradient(std::span<const Vector3> by_place, Eigen::VectorXd& gradient) const {
  gradient.resize(size());
  for (std::size_t k = 0; k < slides_.size(); ++k)
    gradient[static_cast<Index>(k)] = size_ * dot(by_place[slides_[k].vertex], slides_[k].direction);
}

double PatchSlides::add_reach(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
  double sum = 0;
  for (std::size_t k = 0; k < slides_.size(); ++k) {
    if (slides_[k].is_inside) continue;
    const auto at = static_cast<Index>(k);
    sum += kReachWeight * x[at] * x[at];
    gradient[at] += 2 * kReachWeight * x[at];
  }
  return sum;
}

}  // namespace crossgrain

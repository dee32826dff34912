// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/frame_field.hpp"

#include <cassert>
#include <mutex>
#include <optional>
#include <utility>

#include "analysis/field_data.hpp"
#include "analysis/sampling.hpp"

namespace crossgrain {
namespace {

/// Of unit length to two units in the last place, for a vector that is nearly so: one Newton step for 1 /
/// |v|.
Vector3 rounded_to_unit(const Vector3& v) {
  return (1.5 - 0.5 * dot(v, v)) * v;
}

/// The axes of a unit quaternion, orthonormal to 1e-15: as they come they are off by several times the
/// rounding.
Frame orthonormal_frame(const Quaternion& q) {
  const auto axes = axes_of(q);
  const Vector3 x = rounded_to_unit(axes[0]);
  const Vector3 y = rounded_to_unit(axes[1] + -dot(x, axes[1]) * x);
  return {{x, y, rounded_to_unit(cross(x, y))}};
}

}  // namespace

struct FrameField::LazySampler {
  std::once_flag once;
  std::optional<Sampler> sampler;
};

FrameField::FrameField(std::shared_ptr<const FieldData> data)
    : data_(std::move(data)), sampler_(std::make_shared<LazySampler>()) {}

std::size_t FrameField::size() const {
  return data_->tree.size();
}

FrameField::Cell FrameField::cell(std::size_t index) const {
  assert(index < size());
  const auto i = static_cast<CellIndex>(index);
  const Octree& tree = data_->tree;
  return {tree.centre(i), tree.cell_size(i), tree[i].depth(), data_->on_boundary[i] != 0,
          orthonormal_frame(from_stored(data_->frames[i]))};
}

FrameField::Sample FrameField::sample(const Vector3& point) const {
  std::call_once(sampler_->once,
                 [&] { sampler_->sampler.emplace(data_->tree, data_->frames, data_->open_faces); });
  const Sampler::Result result = sampler_->sampler->at(point);
  return {orthonormal_frame(result.frame), result.in_active_cell};
}

const SolveReport& FrameField::report() const {
  return data_->report;
}

}  // namespace crossgrain

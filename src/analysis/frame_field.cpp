// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/frame_field.hpp"

#include <cassert>
#include <mutex>
#include <optional>
#include <utility>

#include "analysis/field_data.hpp"
#include "analysis/orthonormal_frame.hpp"
#include "analysis/sampling.hpp"

namespace crossgrain {

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

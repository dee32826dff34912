// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/frame_field.hpp"

#include <cassert>
#include <mutex>
#include <optional>
#include <utility>

#include "analysis/field_data.hpp"
#include "analysis/orthonormal_frame.hpp"
#include "analysis/sampling.hpp"
#include "analysis/singular_edges.hpp"
#include "analysis/singularity_graph.hpp"

namespace crossgrain {

/// What is made when it is first asked for.
struct FrameField::Lazy {
  std::once_flag sampler_once, singularities_once;
  std::optional<Sampler> sampler;
  std::shared_ptr<const SingularityGraph> singularities;
};

FrameField::FrameField(std::shared_ptr<const FieldData> data)
    : data_(std::move(data)), lazy_(std::make_shared<Lazy>()) {}

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
  std::call_once(lazy_->sampler_once,
                 [&] { lazy_->sampler.emplace(data_->tree, data_->frames, data_->open_faces); });
  const Sampler::Result result = lazy_->sampler->at(point);
  return {orthonormal_frame(result.frame), result.in_active_cell};
}

const SingularityGraph& FrameField::singularities() const {
  std::call_once(lazy_->singularities_once, [&] {
    lazy_->singularities = data_->singularities;
    if (!lazy_->singularities)
      lazy_->singularities = std::make_shared<const SingularityGraph>(singularities(SingularityOptions{}));
  });
  return *lazy_->singularities;
}

SingularityGraph FrameField::singularities(const SingularityOptions& options) const {
  return singularity_graph(singular_grid_edges(data_->tree, data_->frames, data_->open_faces), options);
}

const SolveReport& FrameField::report() const {
  return data_->report;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/tet_frame_field.hpp"

#include <cassert>

#include "sampling/orthonormal_frame.hpp"
#include "singularity/singularity_graph.hpp"
#include "singularity/tet_matchings.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {

TetFrameField::TetFrameField(FrameField grid, TetDomain domain, std::shared_ptr<const TetField> field,
                             SolveReport report)
    : grid_(std::move(grid)),
      domain_(std::move(domain)),
      field_(std::move(field)),
      report_(std::make_shared<const SolveReport>(std::move(report))) {}

Frame TetFrameField::vertex_frame(std::size_t index) const {
  assert(index < field_->vertex_frames.size());
  return orthonormal_frame(field_->vertex_frames[index]);
}

Frame TetFrameField::tet_frame(std::size_t index) const {
  assert(index < field_->tet_frames.size());
  return orthonormal_frame(field_->tet_frames[index]);
}

const SingularityGraph& TetFrameField::singularities() const {
  return field_->singularities;
}

SingularityGraph TetFrameField::singularities(const SingularityOptions& options) const {
  return singularity_graph(singular_tet_edges(domain_.data().solid, field_->tet_frames), options);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/tet_frame_field.hpp"

#include <mutex>

#include "sampling/index_arrays.hpp"
#include "sampling/orthonormal_frame.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {
namespace {

std::vector<Frame> frames_of(const std::vector<Quaternion>& quaternions) {
  return for_each_index(quaternions.size(), [&](std::size_t i) { return orthonormal_frame(quaternions[i]); });
}

std::vector<std::array<double, 4>> numbers_of(const std::vector<Quaternion>& quaternions) {
  return for_each_index(quaternions.size(), [&](std::size_t i) {
    const Quaternion& q = quaternions[i];
    return std::array{q.w, q.x, q.y, q.z};
  });
}

}  // namespace

/// The singular graph, computed on first use.
struct TetFrameField::Lines {
  std::once_flag once;
  std::shared_ptr<const SingularityGraph> graph;
};

TetFrameField::TetFrameField(FrameField grid, TetDomain domain, std::shared_ptr<const TetField> field,
                             SolveReport report, std::shared_ptr<const SingularityGraph> lines)
    : grid_(std::move(grid)),
      domain_(std::move(domain)),
      field_(std::move(field)),
      report_(std::make_shared<const SolveReport>(std::move(report))),
      lines_(std::make_shared<Lines>()) {
  lines_->graph = std::move(lines);
}

TetFrameField TetFrameField::with_report(SolveReport report) const {
  TetFrameField result = *this;
  result.report_ = std::make_shared<const SolveReport>(std::move(report));
  return result;
}

Frame TetFrameField::vertex_frame(std::size_t index) const {
  check_index(index, field_->vertex_frames.size(), "vertex");
  return orthonormal_frame(field_->vertex_frames[index]);
}

Frame TetFrameField::tet_frame(std::size_t index) const {
  check_index(index, field_->tet_frames.size(), "tet");
  return orthonormal_frame(field_->tet_frames[index]);
}

std::vector<Frame> TetFrameField::vertex_frames() const {
  return frames_of(field_->vertex_frames);
}

std::vector<Frame> TetFrameField::tet_frames() const {
  return frames_of(field_->tet_frames);
}

std::vector<std::array<double, 4>> TetFrameField::vertex_quaternions() const {
  return numbers_of(field_->vertex_frames);
}

std::vector<std::array<double, 4>> TetFrameField::tet_quaternions() const {
  return numbers_of(field_->tet_frames);
}

std::vector<FaceMatching> TetFrameField::matchings() const {
  const TetSolid& solid = domain_.data().solid;
  const std::vector<CubeRotation> rotations = matchings_of(solid, *field_);
  std::vector<FaceMatching> result;
  result.reserve(rotations.size());
  for (std::size_t f = 0; f < rotations.size(); ++f) {
    const auto& [vertices, tets] = solid.inner_faces[f];
    if (tets[1] != kNoTet) result.push_back({vertices, tets, signed_axes(rotations[f])});
  }
  return result;
}

const SingularityGraph& TetFrameField::singularities() const {
  std::call_once(lines_->once, [&] {
    if (!lines_->graph)
      lines_->graph = std::make_shared<const SingularityGraph>(graph_of(domain_.data().solid, *field_));
  });
  return *lines_->graph;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

struct FieldData;

/// A solved frame field: one octahedral frame per active cell of an octree, and a frame for any point by
/// interpolation. Immutable and cheap to copy; all members are safe to call from any number of threads.
class FrameField {
 public:
  /// One cell. Which of the 24 equivalent frames stands for it carries no meaning; neighbouring cells may
  /// differ.
  struct Cell {
    Vector3 centre;    ///< model units
    double size;       ///< side, model units
    int depth;         ///< of the octree; the root cube has 0
    bool on_boundary;  ///< whether it holds surface
    Frame frame;
  };

  struct Sample {
    Frame frame;
    bool in_active_cell;  ///< false: the frame is that of the nearest active cell

    /// How little the cells around agree: E_sym of the degree-4 coefficients that were blended, scaled to
    /// unit length. 0 where frames agree, up to 200/3 on a line that they turn about; 0 outside active cells.
    double deviation;

    /// To the nearest point of the arcs of singularities(), model units, inside and outside alike; infinity
    /// where there are no arcs.
    double singular_distance;
  };

  explicit FrameField(std::shared_ptr<const FieldData> data);

  /// Number of active cells, in Morton order.
  std::size_t size() const;

  /// Cell `index` < size().
  Cell cell(std::size_t index) const;

  /// The frame at a point of finite coordinates: inside an active cell, the coefficients of the cells around
  /// are blended and projected to the nearest frame (cells across an outside gap take no part); elsewhere the
  /// nearest cell's frame.
  Sample sample(const Vector3& point) const;

  /// The same of many points, to the bit and in their order, from several threads and several times as fast.
  /// It does not matter whether points that follow each other are near each other.
  std::vector<Sample> sample(std::span<const Vector3> points) const;

  /// The same into `samples`, as many as points.
  void sample(std::span<const Vector3> points, std::span<Sample> samples) const;

  /// The lines around which the frames turn. Of the cells alone: arcs end up to a cell short of the surface.
  const SingularityGraph& singularities() const;
  SingularityGraph singularities(const SingularityOptions& options) const;

  const SolveReport& report() const;

  /// The representation behind the field, for the library itself.
  const FieldData& data() const { return *data_; }

 private:
  struct Lazy;
  const Lazy& ready_to_sample() const;
  std::shared_ptr<const FieldData> data_;
  std::shared_ptr<Lazy> lazy_;
};

}  // namespace crossgrain

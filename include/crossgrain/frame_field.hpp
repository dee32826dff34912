// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>

#include "crossgrain/report.hpp"
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

  const SolveReport& report() const;

  /// The representation behind the field, for the library itself.
  const FieldData& data() const { return *data_; }

 private:
  struct LazySampler;
  std::shared_ptr<const FieldData> data_;
  std::shared_ptr<LazySampler> sampler_;  // made by the first call of `sample`
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Names of axes that are consistent over a whole field.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sampling/leaf_turn.hpp"
#include "singularity/axis_names.hpp"

namespace crossgrain {

/// Names of the axes of some frames of a field, from which all others take theirs.
class CellNames {
 public:
  /// Names the axes of `frames` from the one that is deepest inside: furthest along links from those with a
  /// non-zero `is_outer`. `named_by` has for each cell the frame that gives it its names.
  CellNames(std::vector<Quaternion> frames, std::span<const FrameLink> links,
            std::span<const std::uint8_t> is_outer, std::vector<std::uint32_t> named_by = {});

  /// The names of the axes of a frame in a cell; or, without `named_by`, near frame `cell`.
  AxisNames at(std::uint32_t cell, const Quaternion& frame) const {
    const std::uint32_t k = named_by_.empty() ? cell : named_by_[cell];
    return names_through(names_[k], frames_[k], frame);
  }

 private:
  std::vector<Quaternion> frames_;
  std::vector<AxisNames> names_;
  std::vector<std::uint32_t> named_by_;
};

/// Names for the leaves of a grid. Of many leaves, one in each of up to 20,000 larger cells is named and
/// gives its names to the others there.
CellNames cell_names(const LeafField& field, std::span<const std::uint8_t> on_boundary);

/// The index furthest from those with a non-zero `is_outer` along links, the lowest of several; 0 if none is
/// outer. Requires at least one index.
std::uint32_t deepest_inside(std::span<const FrameLink> links, std::span<const std::uint8_t> is_outer);

}  // namespace crossgrain

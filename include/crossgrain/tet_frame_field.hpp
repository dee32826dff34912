// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/report.hpp"
#include "crossgrain/singularity_graph.hpp"
#include "crossgrain/tet_domain.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup fields Fields
/// @{

struct TetField;

/// How the axes of the frames of two neighbouring tets go on in each other.
struct FaceMatching {
  std::array<std::uint32_t, 3> vertices;  ///< of their common face, ascending
  std::array<std::uint32_t, 2> tets;

  /// Axis k of the frame of tets[0] goes on in that of tets[1] as its axis |axes[k]|, counted from 1, with
  /// the sign of axes[k]: the naming of axes that brings the two frames nearest, or the one that a repair
  /// chose (crossgrain/repair.hpp). From the second tet to the first, the inverse.
  std::array<std::int8_t, 3> axes;
};

/// A frame field on the vertices and tets of a mesh, with the field on the grid from which it started.
/// Immutable and cheap to copy; all members are safe to call from any number of threads.
class TetFrameField {
 public:
  /// Lines that are null are computed on demand.
  TetFrameField(FrameField grid, TetDomain domain, std::shared_ptr<const TetField> field, SolveReport report,
                std::shared_ptr<const SingularityGraph> lines = nullptr);

  const FrameField& grid() const { return grid_; }
  const TetDomain& domain() const { return domain_; }

  /// The frame of vertex `index` of domain().mesh(). At a smooth boundary vertex one axis is the
  /// area-weighted normal of its faces, to rounding. Vertices that no tet uses have frames too. Errors:
  /// kUsage for an index out of range.
  Frame vertex_frame(std::size_t index) const;

  /// The frame of tet `index` of domain().mesh(): nearest to the mean of the degree-4 coefficients of its
  /// four vertices, or as a repair has smoothed it. Errors: kUsage for an index out of range.
  Frame tet_frame(std::size_t index) const;

  /// The frames of all vertices or tets, in the order of domain().mesh().
  std::vector<Frame> vertex_frames() const;
  std::vector<Frame> tet_frames() const;

  /// The same as unit quaternions (w, x, y, z), exactly as they are stored: v -> q v q* takes the coordinate
  /// axes to those of the frame.
  std::vector<std::array<double, 4>> vertex_quaternions() const;
  std::vector<std::array<double, 4>> tet_quaternions() const;

  /// The matching across each face between two tets, ascending by its vertices; those of domain().mesh().
  std::vector<FaceMatching> matchings() const;

  /// The singular graph of the frames of tets, along edges of the mesh.
  const SingularityGraph& singularities() const;

  /// The report of grid() with the section `onto`, the warnings of the domain and the time for the tets. The
  /// grid only provides a starting field, so its resolution warnings are left out.
  const SolveReport& report() const { return *report_; }

  /// The same field with another report.
  TetFrameField with_report(SolveReport report) const;

  /// The representation behind the field, for the library itself.
  const TetField& data() const { return *field_; }

 private:
  FrameField grid_;
  TetDomain domain_;
  std::shared_ptr<const TetField> field_;
  std::shared_ptr<const SolveReport> report_;

  struct Lines;
  std::shared_ptr<Lines> lines_;
};

/// @}

}  // namespace crossgrain

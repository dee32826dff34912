// SPDX-License-Identifier: Apache-2.0
// The drawing of a cut: the plane, its outline, and the frames on it.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "crossgrain/picture.hpp"
#include "display/cut_mesh.hpp"
#include "picture/camera.hpp"
#include "picture/cut_outline.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

struct PictureSubject;

/// Where a picture is cut open.
struct PictureCut {
  CutPlane plane;
  double asked_position;  ///< that of the plane but for a rounding
  Vector3 normal;         ///< unit, towards the removed part

  /// Whether a point belongs to the part that stays.
  bool keeps(const Vector3& point) const {
    return normal[plane.axis] * (point[plane.axis] - plane.position) <= 0;
  }
};

/// The cut that the options ask for, seen from a direction. Throws Error(kUsage) if it is beside the part or
/// seen edge-on.
std::optional<PictureCut> picture_cut(const PictureOptions& options, const SolvedSurface& surface,
                                      const Vector3& towards);

/// What a cut shows of a field.
class CutDrawing {
 public:
  CutDrawing(const PictureSubject& subject, const PictureOptions& options, const PictureCut& cut);

  /// Adds the section, the outline and the frames. The first rods of the drawing are the singular lines.
  void add_to(Drawing& drawing, const Camera& camera);

  /// Legend of the frames on the cut; none without frames. Before `add_to` with all axes: no smaller than
  /// that of what is drawn then.
  std::optional<LegendBlock> legend() const;

 private:
  bool is_inside(const Vector3& point) const;
  void add_outline(Drawing& drawing, Section& section, double unit) const;
  void add_seams(Drawing& drawing, double unit);
  void add_glyphs(Drawing& drawing, double unit, double towards) const;
  void add_lines(Drawing& drawing, double unit);
  void add_edges(Drawing& drawing, double unit) const;

  const PictureSubject& subject_;
  const PictureOptions& options_;
  PictureCut cut_;
  CutOutline outline_;
  CutMesh mesh_;
  std::vector<AxisNames> names_;

  // What the frames on the cut are drawn with.
  std::array<bool, 3> has_axis_{true, true, true};
  bool has_seam_ = true;
};

}  // namespace crossgrain

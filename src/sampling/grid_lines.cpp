// SPDX-License-Identifier: Apache-2.0
#include "sampling/grid_lines.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "sampling/leaf_walk.hpp"
#include "singularity/singular_edges.hpp"

namespace crossgrain {
namespace {

Box bounds_of(const Octree& tree) {
  Box bounds = empty_box();
  for (const CellAddress leaf : tree.leaves()) {
    const Box box = tree.root().box(leaf);
    include(bounds, box.low);
    include(bounds, box.high);
  }
  return bounds;
}

/// Throws unless the surface is where the field is: every active cell holds surface or lies inside, and so
/// meets the surface's box; a field that was read also has the box of its model.
void check_place(const ModelBoundary& boundary, const FieldData& data) {
  const Box& box = boundary.box();
  bool fits = true;
  for (CellIndex i = 0; i < data.tree.size() && fits; ++i)
    fits = boxes_meet(data.tree.root().box(data.tree[i]), box);
  if (data.report.model.triangles > 0 && data.tree.size() > 0) {
    const Box& known = data.report.model.bounding_box;
    const double slack = data.tree.cell_size(0);
    for (int axis = 0; axis < 3; ++axis) {
      fits = fits && std::abs(known.low[axis] - box.low[axis]) <= slack &&
             std::abs(known.high[axis] - box.high[axis]) <= slack;
    }
  }
  if (fits) return;
  throw Error(ErrorKind::kInput, "the surface does not match the field", Remedy::kGiveSolvedSurface);
}

}  // namespace

GridLines::GridLines(const FieldData& field, const TriangleMesh* surface, double arc_distance_cells)
    : field_(field),
      leaves_{field.tree, field.frames, field.open_faces},
      sampler_(field.tree, field.frames, field.open_faces),
      tubes_(leaves_.finder, singular_edges(field.tree, field.frames, field.open_faces), arc_distance_cells),
      bounds_(bounds_of(field.tree)) {
  if (surface) {
    boundary_.emplace(*surface);
    check_place(*boundary_, field);
  } else if (auto solved = field.surface.searchable()) {
    boundary_.emplace(std::move(solved));
  }
}

double GridLines::volume() const {
  double sum = 0;
  for (CellIndex i = 0; i < field_.tree.size(); ++i) sum += std::pow(field_.tree.cell_size(i), 3);
  return sum;
}

Box GridLines::box_of_seeds() const {
  Box box = bounds_;
  if (!boundary_) return box;
  for (int axis = 0; axis < 3; ++axis) {
    box.low[axis] = std::max(box.low[axis], boundary_->box().low[axis]);
    box.high[axis] = std::min(box.high[axis], boundary_->box().high[axis]);
  }
  return box;
}

LineSurface GridLines::surface() const {
  if (!boundary_) return {};
  const TriangleMesh& mesh = boundary_->surface().mesh;
  return {mesh.vertices, mesh.triangles};
}

Vector3 GridLines::in_units(const Vector3& point) const {
  const RootCube& root = field_.tree.root();
  return 1 / root.unit() * (point - root.origin);
}

LineCell GridLines::cell_at(const Vector3& point) const {
  const auto address = field_.tree.root().locate(point);
  const CellIndex leaf = address ? leaves_.finder.containing(*address) : kNoCell;
  if (leaf == kNoCell) return kNoLineCell;
  if (!boundary_ || !field_.on_boundary[leaf]) return leaf;
  return boundary_->inside(point) ? leaf : kNoLineCell;
}

bool GridLines::is_at_arc(const LinePlace& place) const {
  return tubes_.holds(place.cell, in_units(place.point));
}

Quaternion GridLines::frame_at(const LinePlace& from, const Vector3& to, LineCell& end) const {
  const WalkEnd way = walk_open(leaves_, from.cell, in_units(from.point), in_units(to));
  end = way.leaf;
  return sampler_.in_leaf(way.leaf, way.share < 1 ? from.point + way.share * (to - from.point) : to);
}

LineStop GridLines::first_stop(const LinePlace& from, const Vector3& to) const {
  const Vector3 begin = in_units(from.point), end = in_units(to);
  LineStop stop;
  bool is_near_surface = false;
  const auto enter = [&](CellIndex leaf) {
    is_near_surface = is_near_surface || field_.on_boundary[leaf];
    stop.at(tubes_.share_to(leaf, begin, end), StreamlineEnd::kSingularArc);
  };
  enter(from.cell);
  const WalkEnd way =
      walk(leaves_, from.cell, begin, end, [&](const PlacedLeaf& leaf, const PlacedLeaf& next) {
        // Closed faces represent an unknown surface. If the surface is known, they are no end: little of the
        // solid can be beside it on such a face.
        if (!boundary_ && !joined(leaf, next)) return false;
        enter(next.index);
        return true;
      });
  stop.at(way.share, StreamlineEnd::kBoundary);
  if (boundary_ && is_near_surface) stop.at(boundary_->share_to(from.point, to), StreamlineEnd::kBoundary);
  stop.cell = way.leaf;
  return stop;
}

AxisNames GridLines::names_at(const LinePlace& place, const Quaternion& frame) const {
  std::call_once(names_once_, [&] { names_.emplace(cell_names(leaves_, field_.on_boundary)); });
  return names_->at(place.cell, frame);
}

}  // namespace crossgrain

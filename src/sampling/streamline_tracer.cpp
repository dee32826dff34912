// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/streamlines.hpp"
#include "field/field_data.hpp"
#include "sampling/axis_integrator.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

constexpr int kAxes = 3;

/// Number of lines per task: lines take some hundred samples each, with large differences.
constexpr std::size_t kLineGrain = 4;

void check(const StreamlineOptions& options) {
  const auto demand = [](bool holds, const char* what) {
    if (!holds) throw Error(ErrorKind::kUsage, {"", "streamlines", what});
  };
  const auto is_positive = [](double value) { return value > 0 && std::isfinite(value); };
  demand(is_positive(options.tolerance), "the tolerance must be a positive number");
  demand(options.largest_step_cells > 0 && options.largest_step_cells <= 4,
         "the largest step must be above 0 and at most 4 cells");
  demand(options.smallest_step_cells > 0 && options.smallest_step_cells <= options.largest_step_cells,
         "the smallest step must be above 0 and at most the largest");
  demand(options.arc_distance_cells >= 0 && options.arc_distance_cells <= 1,
         "the distance from arcs must be from 0 to 1 cell");
  demand(options.closing_cells >= 0 && options.closing_cells <= 1,
         "the distance at which lines close must be from 0 to 1 cell");
  demand(is_positive(options.end_tolerance_cells), "the tolerance of ends must be a positive number");
  demand(is_positive(options.longest_sides), "the largest length must be a positive number");
  demand(options.most_points >= 2, "the largest number of points must be at least 2");
}

/// The equivalent frame nearest to the coordinate axes: at most 63 degrees from them, so that axis k has a
/// positive coordinate k.
Quaternion nearest_to_coordinate_axes(const Quaternion& frame) {
  return frame * conjugate(to_quaternion(nearest_cube_rotation(frame)));
}

/// The bounding box of all leaves.
Box bounds_of(const Octree& tree) {
  Box bounds = empty_box();
  for (const CellAddress leaf : tree.leaves()) {
    const Box box = tree.root().box(leaf);
    include(bounds, box.low);
    include(bounds, box.high);
  }
  return bounds;
}

double volume_of(const Octree& tree) {
  double sum = 0;
  for (CellIndex i = 0; i < tree.size(); ++i) sum += std::pow(tree.cell_size(i), 3);
  return sum;
}

double volume_of(const Box& box) {
  const Vector3 sides = box.high - box.low;
  return sides[0] * sides[1] * sides[2];
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

/// The two halves joined to one line, from the end of the second to the end of the first.
Streamline put_together(HalfLine forward, HalfLine backward) {
  Streamline line;
  line.length = forward.length + backward.length;
  line.seed_point = backward.points.size() - 1;
  line.first_end = backward.end;
  line.last_end = forward.end;
  line.points.assign(backward.points.rbegin(), backward.points.rend());
  for (auto tangent = backward.tangents.rbegin(); tangent != backward.tangents.rend(); ++tangent)
    line.tangents.push_back(-*tangent);
  line.points.insert(line.points.end(), forward.points.begin() + 1, forward.points.end());
  line.tangents.insert(line.tangents.end(), forward.tangents.begin() + 1, forward.tangents.end());
  return line;
}

}  // namespace

/// The data of a tracer. Refers to itself.
struct StreamlineTracer::Parts {
  Parts(const FrameField& of, const StreamlineOptions& with, const TriangleMesh* surface)
      : field(of),
        options(with),
        leaves{of.data().tree, of.data().frames, of.data().open_faces},
        sampler(of.data().tree, of.data().frames, of.data().open_faces),
        tubes(leaves.finder, singular_edges(of.data().tree, of.data().frames, of.data().open_faces),
              with.arc_distance_cells),
        bounds(bounds_of(of.data().tree)) {
    if (!surface) return;
    boundary.emplace(*surface);
    check_place(*boundary, of.data());
  }

  LineField line_field() const {
    return {leaves,
            sampler,
            tubes,
            boundary ? &*boundary : nullptr,
            field.data().on_boundary,
            longest_side(bounds)};
  }

  bool is_at_arc(const Vector3& point, CellIndex leaf) const {
    const RootCube& root = leaves.tree.root();
    return tubes.holds(leaf, 1 / root.unit() * (point - root.origin));
  }

  /// The leaf that holds a point of the solid; kNoCell for a point outside.
  CellIndex leaf_inside(const Vector3& point) const {
    const auto address = leaves.tree.root().locate(point);
    const CellIndex leaf = address ? leaves.finder.containing(*address) : kNoCell;
    if (leaf == kNoCell || !boundary || !field.data().on_boundary[leaf]) return leaf;
    return boundary->inside(point) ? leaf : kNoCell;
  }

  Streamline line(const Vector3& seed, CellIndex leaf, int axis, const Monitor& monitor) const {
    const AxisIntegrator integrator(line_field(), options);
    const Quaternion frame = nearest_to_coordinate_axes(sampler.in_leaf(leaf, seed));
    const Vector3 direction = axes_of(frame)[static_cast<std::size_t>(axis)];
    HalfLine forward = integrator.follow({seed, direction, leaf}, monitor);
    HalfLine backward{{seed}, {-direction}, 0, StreamlineEnd::kClosed};
    if (forward.end != StreamlineEnd::kClosed)
      backward = integrator.follow({seed, -direction, leaf}, monitor);
    return put_together(std::move(forward), std::move(backward));
  }

  FrameField field;
  StreamlineOptions options;
  LeafField leaves;
  Sampler sampler;
  ArcTubes tubes;
  Box bounds;
  std::optional<ModelBoundary> boundary;
};

StreamlineTracer::StreamlineTracer(const FrameField& field, const StreamlineOptions& options,
                                   const TriangleMesh* surface) {
  check(options);
  parts_ = std::make_shared<const Parts>(field, options, surface);
}

std::vector<Vector3> StreamlineTracer::spread_seeds(std::size_t count, const Monitor& monitor) const {
  // The real root of g^4 = g + 1; its powers are as badly approximated by fractions as three numbers can be.
  constexpr double kGenerator = 1.2207440846057594754;
  // Extra draws, as a factor, for a solid much smaller than its active cells.
  constexpr double kPatience = 100;
  Box box = parts_->bounds;
  if (parts_->boundary) {
    for (int axis = 0; axis < 3; ++axis) {
      box.low[axis] = std::max(box.low[axis], parts_->boundary->box().low[axis]);
      box.high[axis] = std::min(box.high[axis], parts_->boundary->box().high[axis]);
    }
  }
  std::vector<Vector3> seeds;
  const double share =
      volume_of(parts_->leaves.tree) / std::max(volume_of(box), std::numeric_limits<double>::min());
  if (!(share > 0)) return seeds;
  const double most_draws = kPatience * static_cast<double>(count) / std::min(share, 1.0);
  for (std::uint64_t draw = 1; seeds.size() < count && static_cast<double>(draw) <= most_draws; ++draw) {
    if (draw % 1024 == 0) monitor.check();
    Vector3 point;
    double power = 1;
    for (int axis = 0; axis < 3; ++axis) {
      power /= kGenerator;
      const double along = std::fmod(0.5 + power * static_cast<double>(draw), 1.0);
      point[axis] = box.low[axis] + along * (box.high[axis] - box.low[axis]);
    }
    const CellIndex leaf = parts_->leaf_inside(point);
    if (leaf != kNoCell && !parts_->is_at_arc(point, leaf)) seeds.push_back(point);
  }
  return seeds;
}

Streamlines StreamlineTracer::trace(std::span<const Vector3> seeds, const Monitor& monitor) const {
  monitor.check();
  std::vector<CellIndex> leaf_of(seeds.size());
  parallel_for(seeds.size(), [&](std::size_t i) { leaf_of[i] = parts_->leaf_inside(seeds[i]); });
  Streamlines result;
  std::vector<std::uint8_t> begins(seeds.size());
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const bool is_outside = leaf_of[i] == kNoCell;
    const bool is_at_arc = !is_outside && parts_->is_at_arc(seeds[i], leaf_of[i]);
    result.outside_seeds += is_outside;
    result.arc_seeds += is_at_arc;
    begins[i] = !is_outside && !is_at_arc;
  }
  std::vector<Streamline> lines(kAxes * seeds.size());
  parallel_for(
      lines.size(),
      [&](std::size_t k) {
        const std::size_t i = k / kAxes;
        const int axis = static_cast<int>(k % kAxes);
        if (!begins[i] || !parts_->options.axes[static_cast<std::size_t>(axis)]) return;
        lines[k] = parts_->line(seeds[i], leaf_of[i], axis, monitor);
        lines[k].seed = i;
        lines[k].axis = axis;
      },
      kLineGrain);
  for (Streamline& line : lines) {
    if (line.points.size() >= 2) result.lines.push_back(std::move(line));
  }
  return result;
}

}  // namespace crossgrain

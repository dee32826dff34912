// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/streamlines.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <variant>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "sampling/axis_integrator.hpp"
#include "sampling/grid_lines.hpp"
#include "sampling/line_spacing.hpp"
#include "sampling/streamline_seeds.hpp"
#include "sampling/tet_lines.hpp"
#include "singularity/matching.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"
#include "solve/tuned_tracer.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kAxes = 3;

/// Number of seeds per task: lines take some hundred samples each, with large differences.
constexpr std::size_t kSeedGrain = 1;

/// Number of seeds whose lines are traced before it is known which of them have room: a fixed number, so that
/// results do not depend on that of threads.
constexpr std::size_t kSeedBatch = 16;

/// Smallest spacing other than 0: lines are sampled at a fraction of it.
constexpr double kLeastSpacing = 1e-4;

void check(const StreamlineOptions& options) {
  const double spacing = options.spacing_sides;
  if (!(spacing == 0 || (spacing >= kLeastSpacing && spacing <= 1)))
    throw Error(ErrorKind::kUsage,
                {"", "streamlines", "the spacing must be 0, or from 0.0001 to 1 longest side"});
}

/// The equivalent frame nearest to the coordinate axes: at most 63 degrees from them, so that axis k has a
/// positive coordinate k.
Quaternion nearest_to_coordinate_axes(const Quaternion& frame) {
  return frame * conjugate(to_quaternion(nearest_cube_rotation(frame)));
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

/// The data of a tracer. Refers to the field, which it holds.
struct StreamlineTracer::Parts {
  std::variant<FrameField, TetFrameField> field;
  StreamlineOptions options;
  StreamlineTuning tuning;
  std::unique_ptr<const LineSpace> space;

  /// A seed in the solid.
  struct Start {
    LinePlace place;
    std::array<Vector3, kAxes> directions;  ///< by the names of the axes
    std::array<bool, kAxes> is_followed;
  };

  Start start_at(const StreamlineSeed& seed, LineCell cell) const {
    Start start{{seed.point, cell}, {}, options.axes};
    const Quaternion frame = nearest_to_coordinate_axes(space->frame_at(start.place, seed.point, cell));
    const auto axes = axes_of(frame);
    const AxisNames names = space->names_at(start.place, frame);
    for (std::size_t k = 0; k < kAxes; ++k) start.directions[names[k]] = axes[k];
    if (seed.across == Vector3{0, 0, 0}) return start;
    std::size_t nearest = 0;
    for (std::size_t k = 1; k < kAxes; ++k)
      if (std::abs(dot(start.directions[k], seed.across)) >
          std::abs(dot(start.directions[nearest], seed.across)))
        nearest = k;
    start.is_followed[nearest] = false;
    return start;
  }

  Streamline line(const LinePlace& place, const Vector3& direction, const Monitor& monitor) const {
    const AxisIntegrator integrator(*space, tuning);
    HalfLine forward = integrator.follow({place, direction}, monitor);
    HalfLine backward{{place.point}, {-direction}, 0, StreamlineEnd::kClosed};
    if (forward.end != StreamlineEnd::kClosed) backward = integrator.follow({place, -direction}, monitor);
    return put_together(std::move(forward), std::move(backward));
  }
};

StreamlineTracer::StreamlineTracer(const FrameField& field, const StreamlineOptions& options,
                                   const TriangleMesh* surface)
    : StreamlineTracer(TunedTracer(field, options, {}, surface)) {}

StreamlineTracer::StreamlineTracer(const TetFrameField& field, const StreamlineOptions& options)
    : StreamlineTracer(TunedTracer(field, options, {})) {}

TunedTracer::TunedTracer(const FrameField& field, const StreamlineOptions& options,
                         const StreamlineTuning& tuning, const TriangleMesh* surface) {
  check(options);
  parts_ = std::make_shared<const Parts>(
      field, options, tuning, std::make_unique<GridLines>(field.data(), surface, tuning.arc_distance_cells));
}

TunedTracer::TunedTracer(const TetFrameField& field, const StreamlineOptions& options,
                         const StreamlineTuning& tuning) {
  check(options);
  const TetDomainData& tets = field.domain().data();
  const FramesOnTets frames{tets.solid, tets.edges, field.data().vertex_frames, field.data().tet_frames,
                            matchings_of(tets.solid, field.data())};
  parts_ = std::make_shared<const Parts>(field, options, tuning,
                                         std::make_unique<TetLines>(frames, tuning.arc_distance_cells));
}

std::vector<Vector3> StreamlineTracer::spread_seeds(std::size_t count, const Monitor& monitor) const {
  return seeds_in_volume(*parts_->space, count, monitor);
}

std::vector<StreamlineSeed> StreamlineTracer::surface_seeds(std::size_t count, const Monitor& monitor) const {
  return seeds_on_surface(*parts_->space, count, monitor);
}

std::vector<StreamlineSeed> StreamlineTracer::cut_seeds(int axis, std::optional<double> position,
                                                        std::size_t count, const Monitor& monitor) const {
  return seeds_on_cut(*parts_->space, axis, position, count, monitor);
}

Streamlines StreamlineTracer::trace(std::span<const Vector3> points, const Monitor& monitor) const {
  std::vector<StreamlineSeed> seeds;
  for (const Vector3& point : points) seeds.push_back({point});
  return trace(seeds, monitor);
}

Streamlines StreamlineTracer::trace(std::span<const StreamlineSeed> seeds, const Monitor& monitor) const {
  monitor.check();
  const LineSpace& space = *parts_->space;
  Streamlines result;
  std::vector<LineCell> cells(seeds.size());
  parallel_for(seeds.size(), [&](std::size_t i) { cells[i] = space.cell_at(seeds[i].point); });
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const bool is_outside = cells[i] == kNoLineCell;
    const bool is_at_arc = !is_outside && space.is_at_arc({seeds[i].point, cells[i]});
    result.outside_seeds += is_outside;
    result.arc_seeds += is_at_arc;
    if (is_at_arc) cells[i] = kNoLineCell;
  }
  const double spacing = parts_->options.spacing_sides * longest_side(space.bounds());
  LineSpacing taken(spacing);
  // Without a spacing all at once.
  const std::size_t batch = spacing > 0 ? kSeedBatch : std::max<std::size_t>(seeds.size(), 1);
  std::vector<Streamline> lines(kAxes * std::min(batch, seeds.size()));
  for (std::size_t first = 0; first < seeds.size(); first += batch) {
    monitor.check();
    const std::size_t count = std::min(batch, seeds.size() - first);
    parallel_for(
        count,
        [&](std::size_t k) {
          const std::size_t i = first + k;
          for (std::size_t axis = 0; axis < kAxes; ++axis) lines[kAxes * k + axis] = {};
          if (cells[i] == kNoLineCell) return;
          const Parts::Start start = parts_->start_at(seeds[i], cells[i]);
          for (std::size_t axis = 0; axis < kAxes; ++axis) {
            const Vector3& direction = start.directions[axis];
            if (!start.is_followed[axis]) continue;
            if (spacing > 0 && !taken.has_room(seeds[i].point, direction)) continue;
            Streamline& line = lines[kAxes * k + axis];
            line = parts_->line(start.place, direction, monitor);
            line.seed = i;
            line.axis = static_cast<int>(axis);
          }
        },
        kSeedGrain);
    for (std::size_t k = 0; k < kAxes * count; ++k) {
      Streamline& line = lines[k];
      if (line.points.size() >= 2 && (spacing == 0 || taken.take(line)))
        result.lines.push_back(std::move(line));
    }
  }
  return result;
}

}  // namespace crossgrain

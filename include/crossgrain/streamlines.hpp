// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup lines Singular lines, answers and streamlines
/// @{

/// Which streamlines are traced.
struct StreamlineOptions {
  /// Axes of the frame at a seed to follow, each in both directions, by their names (Streamline::axis).
  std::array<bool, 3> axes{true, true, true};

  /// Least distance between lines along like axes, in longest sides of the field's bounding box; 0 for any.
  /// A line is left out if an earlier one in nearly its direction passes its seed within this distance, and
  /// ends where it comes within half of it of an earlier one or of itself.
  double spacing_sides = 0;
};

/// Why a streamline ends.
enum class StreamlineEnd : std::uint8_t {
  kBoundary = 0,     ///< at the surface, or at the end of the active cells if no surface is known
  kSingularArc = 1,  ///< half a cell from a singular edge; on tets a cell is a mean edge
  kClosed = 2,       ///< back at its seed; both ends have this value
  kLongest = 3,      ///< at 4 longest sides of the field's bounding box, or 100,000 points, from its seed
  kAmbiguous = 4,    ///< no axis within 45 degrees of its direction, even with the smallest step
  kCrowded = 5       ///< near another line or itself (StreamlineOptions::spacing_sides)
};

/// Where lines start.
struct StreamlineSeed {
  Vector3 point;

  /// If not zero, no line follows the axis nearest to it: a normal of the surface or cut on which lines run.
  Vector3 across{0, 0, 0};
};

/// A curve along an axis of the field, as points on it. From point to point it follows the axis nearest to
/// its direction.
struct Streamline {
  std::vector<Vector3> points;    ///< at least two; a closed line ends with its first point
  std::vector<Vector3> tangents;  ///< unit vectors, one per point, from the first point towards the last
  double length = 0;              ///< sum of the segments between the points
  std::size_t seed = 0;           ///< index of the seed

  /// Name of the axis at the seed: 0 x, 1 y, 2 z. Deep inside the field each axis is named by the coordinate
  /// axis that it is nearest to, from there on through the matchings, so that lines side by side along the
  /// same axis have the same name. Across a seam, which ends at singular lines, names change.
  int axis = 0;

  std::size_t seed_point = 0;  ///< index of the seed in `points`
  StreamlineEnd first_end = StreamlineEnd::kBoundary;
  StreamlineEnd last_end = StreamlineEnd::kBoundary;
};

struct Streamlines {
  /// Sorted by seed, then by axis. Lines without length are left out.
  std::vector<Streamline> lines;
  std::size_t outside_seeds = 0;  ///< seeds outside the solid or with coordinates that are not finite
  std::size_t arc_seeds = 0;      ///< seeds at a singular arc, where no line starts
};

/// A curve along an axis, for drawing.
struct AxisCurve {
  std::vector<Vector3> points;  ///< at least two, model units
  int axis = 0;                 ///< as Streamline::axis
};

/// Traces streamlines of a field. Immutable and cheap to copy; all members are safe to call from any number
/// of threads.
class StreamlineTracer {
 public:
  /// Lines end exactly on `surface`, the model that the field was solved for; if it is null, on the surface
  /// that the field has; if it has none, at the end of the active cells, which extend beyond the solid by up
  /// to their size. The surface is not referred to afterwards. Takes about 45 bytes per cell. Errors: kUsage
  /// for options out of range; kInput for a surface that bounds nothing or lies elsewhere than the field.
  explicit StreamlineTracer(const FrameField& field, const StreamlineOptions& options = {},
                            const TriangleMesh* surface = nullptr);

  /// Lines follow the axes of the frames of vertices, interpolated linearly in their coefficients of degree 4
  /// in each tet, and end exactly on the boundary of the tets. Takes about 150 bytes per tet. Errors: kUsage
  /// for options out of range.
  explicit StreamlineTracer(const TetFrameField& field, const StreamlineOptions& options = {});

  /// Returns `count` points evenly spread inside the solid: the points 1/2 + n (1/g, 1/g^2, 1/g^3) modulo 1
  /// with g^4 = g + 1, n = 1, 2, ... (M. Roberts 2018, sequence R3), scaled to the bounding box, without
  /// those outside and at singular arcs. More points extend the same sequence, and no two lie on one line
  /// along an axis. Returns fewer if the solid is much smaller than its cells. Errors: kInterrupted.
  std::vector<Vector3> spread_seeds(std::size_t count, const Monitor& monitor = {}) const;

  /// Returns `count` seeds evenly spread over the surface by area, slightly inside, for lines along the two
  /// axes that are tangent to it. More seeds begin with the same. Returns fewer if the solid is thinner than
  /// its cells. Errors: kUsage for a field without a surface; kInterrupted.
  std::vector<StreamlineSeed> surface_seeds(std::size_t count, const Monitor& monitor = {}) const;

  /// Returns `count` seeds evenly spread over the part of the plane across an axis (0 x, 1 y, 2 z) that is in
  /// the solid, for lines along the two axes that are nearest to the plane. `position` is a coordinate along
  /// the axis; the middle of the part by default. More seeds begin with the same. Errors: kUsage for a plane
  /// that misses the bounding box; kInterrupted.
  std::vector<StreamlineSeed> cut_seeds(int axis, std::optional<double> position, std::size_t count,
                                        const Monitor& monitor = {}) const;

  /// Traces the lines through all seeds. Results do not depend on the number of threads. Errors:
  /// kInterrupted.
  Streamlines trace(std::span<const Vector3> seeds, const Monitor& monitor = {}) const;
  Streamlines trace(std::span<const StreamlineSeed> seeds, const Monitor& monitor = {}) const;

 private:
  friend class TunedTracer;  // of the library itself
  struct Parts;
  StreamlineTracer() = default;
  std::shared_ptr<const Parts> parts_;
};

/// @}

}  // namespace crossgrain

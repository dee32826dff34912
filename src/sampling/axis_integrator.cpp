// SPDX-License-Identifier: Apache-2.0
//
// Notation: x a point, h the length of a step from it, k_i the directions at its stages, the first at x.
// Stage i + 1 is at x + h sum_j a_ij k_j; the last stage is the result, and its direction the first of the
// next step.
#include "sampling/axis_integrator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/vector3.hpp"
#include "sampling/leaf_walk.hpp"

namespace crossgrain {
namespace {

/// The pair of orders 3 and 2 of P. Bogacki and L. F. Shampine (1989), Appl. Math. Lett. 2(4), 321-325. The
/// interpolated field has kinks in planes half a cell apart, over which a higher order neither gains nor
/// knows its error: docs/streamlines.md has the comparison with orders 5 and 4.
constexpr std::size_t kStages = 4;
constexpr std::array<std::array<double, kStages - 1>, kStages - 1> kStageWeights = {
    {{1.0 / 2, 0, 0}, {0, 3.0 / 4, 0}, {2.0 / 9, 1.0 / 3, 4.0 / 9}}};

/// Of the directions in the difference of the two results, over h.
constexpr std::array<double, kStages> kErrorWeights = {-5.0 / 72, 1.0 / 12, 1.0 / 9, -1.0 / 8};
constexpr double kLowerOrder = 2;

/// Beyond 45 degrees from the direction before, another axis may be as near.
constexpr double kLeastCosine = 0.7071067811865476;

/// Steps aim at a little less than the tolerance, so that few are taken twice, and change by factors at most.
constexpr double kSafety = 0.9, kLeastFactor = 0.2, kMostFactor = 4;

/// A line is back at its seed only if it points there as it did: this is the cosine of 25 degrees.
constexpr double kSameDirection = 0.9;

/// The point of the cubic through two points with these tangents, at `share` of the way.
Vector3 on_cubic(const LineFront& from, const Vector3& to, const Vector3& direction, double h, double share) {
  const double t = share, s = 1 - share;
  return (s * s * (1 + 2 * t)) * from.point + (t * t * (1 + 2 * s)) * to +
         (h * t * s) * (s * from.direction - t * direction);
}

}  // namespace

struct AxisIntegrator::Step {
  LineFront front;  ///< at the end
  double h;
  double error;       ///< per length
  bool is_ambiguous;  ///< some stage has no axis within 45 degrees of the first
};

/// The first thing that keeps a step from its end.
struct AxisIntegrator::Stop {
  double share = 1;  ///< of the straight way; 1 for nothing
  StreamlineEnd reason = StreamlineEnd::kBoundary;
  CellIndex leaf = kNoCell;  ///< where the way ends

  void at(double other_share, StreamlineEnd other_reason) {
    if (!(other_share < share)) return;
    share = other_share;
    reason = other_reason;
  }
};

Vector3 AxisIntegrator::in_units(const Vector3& point) const {
  const RootCube& root = field_.leaves.tree.root();
  return 1 / root.unit() * (point - root.origin);
}

Vector3 AxisIntegrator::direction_at(const LineFront& from, const Vector3& point, CellIndex& leaf) const {
  const WalkEnd end = walk_open(field_.leaves, from.leaf, in_units(from.point), in_units(point));
  leaf = end.leaf;
  const Quaternion frame =
      field_.sampler.in_leaf(leaf, end.share < 1 ? from.point + end.share * (point - from.point) : point);
  Vector3 best = from.direction;
  double best_cosine = -1;
  for (const Vector3& axis : axes_of(frame)) {
    const double cosine = dot(axis, from.direction);
    if (std::abs(cosine) <= best_cosine) continue;
    best_cosine = std::abs(cosine);
    best = cosine < 0 ? -axis : axis;
  }
  return best;
}

AxisIntegrator::Step AxisIntegrator::step(const LineFront& from, double h) const {
  std::array<Vector3, kStages> k;
  k[0] = from.direction;
  Step step{from, h, 0, false};
  for (std::size_t stage = 1; stage < kStages; ++stage) {
    Vector3 slope{0, 0, 0};
    for (std::size_t i = 0; i < stage; ++i) slope += kStageWeights[stage - 1][i] * k[i];
    step.front.point = from.point + h * slope;
    k[stage] = direction_at(from, step.front.point, step.front.leaf);
    if (!(dot(k[stage], k[0]) >= kLeastCosine)) {
      step.is_ambiguous = true;
      return step;
    }
  }
  Vector3 difference{0, 0, 0};
  for (std::size_t i = 0; i < kStages; ++i) difference += kErrorWeights[i] * k[i];
  step.error = norm(difference);
  step.front.direction = k[kStages - 1];
  return step;
}

AxisIntegrator::Stop AxisIntegrator::first_stop(const LineFront& from, const Step& step, double room) const {
  const Vector3 &to = step.front.point, begin = in_units(from.point), end = in_units(to);
  Stop stop;
  bool is_near_surface = false;
  const auto enter = [&](CellIndex leaf) {
    is_near_surface = is_near_surface || field_.on_boundary[leaf];
    stop.at(field_.tubes.share_to(leaf, begin, end), StreamlineEnd::kSingularArc);
  };
  enter(from.leaf);
  const WalkEnd way =
      walk(field_.leaves, from.leaf, begin, end, [&](const PlacedLeaf& leaf, const PlacedLeaf& next) {
        // Closed faces stand for a surface that is not known. Where it is, what little of the solid there may
        // be beside it on such a face is no end.
        if (!field_.boundary && !joined(leaf, next)) return false;
        enter(next.index);
        return true;
      });
  stop.at(way.share, StreamlineEnd::kBoundary);
  if (field_.boundary && is_near_surface)
    stop.at(field_.boundary->share_to(from.point, to), StreamlineEnd::kBoundary);
  stop.at(room / norm(to - from.point), StreamlineEnd::kLongest);
  stop.leaf = way.leaf;
  return stop;
}

/// A line while it grows.
class AxisIntegrator::Way {
 public:
  Way(const AxisIntegrator& integrator, const LineFront& seed)
      : of_(integrator),
        options_(integrator.options_),
        seed_(seed),
        front_(seed),
        room_(options_.longest_sides * integrator.field_.longest_side) {
    line_.points = {seed.point};
    line_.tangents = {seed.direction};
    h_ = options_.largest_step_cells * cell();
  }

  HalfLine take() { return std::move(line_); }

  /// Tries one step; whether the line may go on.
  bool advance() {
    h_ = std::clamp(h_, smallest_h(), options_.largest_step_cells * cell());
    const Step step = of_.step(front_, h_);
    if (step.is_ambiguous) return shortened(kLeastFactor) || ended(StreamlineEnd::kAmbiguous);
    const double factor = std::clamp(kSafety * std::pow(options_.tolerance / step.error, 1.0 / kLowerOrder),
                                     kLeastFactor, kMostFactor);
    if (step.error > options_.tolerance && shortened(std::min(factor, kSafety))) return true;
    const Stop stop = of_.first_stop(front_, step, room_ - line_.length);
    if (stop.share < 1) return stopped(step, stop);
    if (is_closed_by(step)) return ended(StreamlineEnd::kClosed);
    front_ = step.front;
    if (stop.leaf != front_.leaf) enter(stop.leaf);
    append(front_.point, front_.direction);
    h_ *= factor;
    return line_.points.size() < options_.most_points || ended(StreamlineEnd::kLongest);
  }

 private:
  double cell() const { return of_.field_.leaves.tree.cell_size(front_.leaf); }
  double smallest_h() const { return options_.smallest_step_cells * cell(); }

  bool shortened(double factor) {
    if (h_ <= smallest_h()) return false;
    h_ *= factor;
    return true;
  }

  bool ended(StreamlineEnd reason) {
    line_.end = reason;
    return false;
  }

  /// Of a leaf across a closed face the step knows nothing.
  void enter(CellIndex leaf) {
    front_.leaf = leaf;
    front_.direction = of_.direction_at(front_, front_.point, front_.leaf);
  }

  void append(const Vector3& point, const Vector3& direction) {
    const double length = norm(point - line_.points.back());
    if (!(length > 0)) return;
    line_.length += length;
    line_.points.push_back(point);
    line_.tangents.push_back(direction);
  }

  /// Steps that are stopped are made shorter until the straight way, on which the stop is, is near to the
  /// line there: off by half of h |k_4 - k_1| t (1 - t) at share t of a step that bends evenly.
  bool stopped(const Step& step, const Stop& stop) {
    const Vector3 bend = step.front.direction - front_.direction;
    const double off = 0.5 * h_ * norm(bend) * stop.share * (1 - stop.share);
    if (off > options_.end_tolerance_cells * cell() && shortened(std::max(stop.share, kLeastFactor)))
      return true;
    const Vector3 end = front_.point + stop.share * (step.front.point - front_.point);
    CellIndex leaf = front_.leaf;
    append(end, of_.direction_at(front_, end, leaf));
    return ended(stop.reason);
  }

  /// Whether the step passes by the seed; the line ends there then.
  bool is_closed_by(const Step& step) {
    const double before = dot(front_.point - seed_.point, seed_.direction);
    const double after = dot(step.front.point - seed_.point, seed_.direction);
    if (!(before < 0 && after >= 0) || !(dot(step.front.direction, seed_.direction) > kSameDirection))
      return false;
    const Vector3 off =
        on_cubic(front_, step.front.point, step.front.direction, h_, before / (before - after)) - seed_.point;
    const Vector3 beside = off - dot(off, seed_.direction) * seed_.direction;
    if (!(norm(beside) <= options_.closing_cells * cell())) return false;
    append(seed_.point, seed_.direction);
    return true;
  }

  const AxisIntegrator& of_;
  const StreamlineOptions& options_;
  LineFront seed_, front_;
  double room_;
  double h_;
  HalfLine line_;
};

HalfLine AxisIntegrator::follow(const LineFront& seed, const Monitor& monitor) const {
  Way way(*this, seed);
  do {
    monitor.check();
  } while (way.advance());
  return way.take();
}

}  // namespace crossgrain

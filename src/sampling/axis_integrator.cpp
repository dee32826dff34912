// SPDX-License-Identifier: Apache-2.0
//
// Notation: x a point, h the length of a step from it, k_i the directions at its stages, the first at x.
// Stage i + 1 is at x + h sum_j a_ij k_j; the last stage is the result, and its direction the first of the
// next step.
#include "sampling/axis_integrator.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// The pair of orders 3 and 2 of P. Bogacki and L. F. Shampine (1989), Appl. Math. Lett. 2(4), 321-325. The
/// interpolated field has kinks in planes half a cell apart, across which a higher order gains nothing and
/// cannot estimate its error: docs/notes/streamlines.md has the comparison with orders 5 and 4.
constexpr std::size_t kStages = 4;
constexpr std::array<std::array<double, kStages - 1>, kStages - 1> kStageWeights = {
    {{1.0 / 2, 0, 0}, {0, 3.0 / 4, 0}, {2.0 / 9, 1.0 / 3, 4.0 / 9}}};

/// Weights of the directions in the difference of the two results, over h.
constexpr std::array<double, kStages> kErrorWeights = {-5.0 / 72, 1.0 / 12, 1.0 / 9, -1.0 / 8};

/// Cosine of 45 degrees: beyond that angle from the previous direction, another axis may be as near.
constexpr double kLeastCosine = 0.7071067811865476;

/// Steps aim at slightly less than the tolerance, so that few are repeated, and change by limited factors.
constexpr double kSafety = 0.9, kLeastFactor = 0.2, kMostFactor = 4;

/// Smallest cosine between the directions at the seed and on return to it, of 25 degrees.
constexpr double kSameDirection = 0.9;

/// Largest distance between the curve and the last segment, on which the line meets the boundary or an arc.
constexpr double kEndToleranceCells = 1e-3;

/// Point at `share` on the cubic through two points with these tangents.
Vector3 on_cubic(const LineFront& from, const Vector3& to, const Vector3& direction, double h, double share) {
  const double t = share, s = 1 - share;
  return (s * s * (1 + 2 * t)) * from.place.point + (t * t * (1 + 2 * s)) * to +
         (h * t * s) * (s * from.direction - t * direction);
}

}  // namespace

struct AxisIntegrator::Step {
  LineFront front;  ///< front at the end of the step
  double h;
  double error;       ///< per length
  bool is_ambiguous;  ///< a stage has no axis within 45 degrees of the first direction
};

AxisIntegrator::AxisIntegrator(const LineSpace& space, const StreamlineTuning& tuning)
    : space_(space), tuning_(tuning), longest_(tuning.longest_sides * longest_side(space.bounds())) {}

Vector3 AxisIntegrator::direction_at(const LineFront& from, const Vector3& point, LineCell& cell) const {
  const Quaternion frame = space_.frame_at(from.place, point, cell);
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
    step.front.place.point = from.place.point + h * slope;
    k[stage] = direction_at(from, step.front.place.point, step.front.place.cell);
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

/// A line under construction.
class AxisIntegrator::Way {
 public:
  Way(const AxisIntegrator& integrator, const LineFront& seed)
      : of_(integrator), tuning_(integrator.tuning_), seed_(seed), front_(seed), room_(integrator.longest_) {
    line_.points = {seed.place.point};
    line_.tangents = {seed.direction};
    h_ = tuning_.largest_step_cells * cell();
  }

  HalfLine take() { return std::move(line_); }

  /// Tries one step. Returns whether the line may continue.
  bool advance() {
    h_ = std::clamp(h_, smallest_h(), tuning_.largest_step_cells * cell());
    const Step step = of_.step(front_, h_);
    if (step.is_ambiguous) return shortened(kLeastFactor) || ended(StreamlineEnd::kAmbiguous);
    // The root of the lower order, two; it is exact, unlike pow, which differs between processors.
    const double factor =
        std::clamp(kSafety * std::sqrt(tuning_.tolerance / step.error), kLeastFactor, kMostFactor);
    if (step.error > tuning_.tolerance && shortened(std::min(factor, kSafety))) return true;
    const Vector3 &from = front_.place.point, &to = step.front.place.point;
    LineStop stop = of_.space_.first_stop(front_.place, to);
    stop.at((room_ - line_.length) / norm(to - from), StreamlineEnd::kLongest);
    if (stop.share < 1) return stopped(step, stop);
    if (is_closed_by(step)) return ended(StreamlineEnd::kClosed);
    front_ = step.front;
    if (stop.cell != front_.place.cell) enter(stop.cell);
    append(front_.place.point, front_.direction);
    h_ *= factor;
    return line_.points.size() < tuning_.most_points || ended(StreamlineEnd::kLongest);
  }

 private:
  double cell() const { return of_.space_.cell_size(front_.place.cell); }
  double smallest_h() const { return tuning_.smallest_step_cells * cell(); }

  bool shortened(double factor) {
    if (h_ <= smallest_h()) return false;
    h_ *= factor;
    return true;
  }

  bool ended(StreamlineEnd reason) {
    line_.end = reason;
    return false;
  }

  /// Enters a cell behind a closed face, which the step has not seen.
  void enter(LineCell cell) {
    front_.place.cell = cell;
    front_.direction = of_.direction_at(front_, front_.place.point, front_.place.cell);
  }

  void append(const Vector3& point, const Vector3& direction) {
    const double length = norm(point - line_.points.back());
    if (!(length > 0)) return;
    line_.length += length;
    line_.points.push_back(point);
    line_.tangents.push_back(direction);
  }

  /// Shortens a step that is stopped until the straight segment, on which the stop is, is near the line
  /// there: off by half of h |k_4 - k_1| t (1 - t) at share t of a step that bends evenly.
  bool stopped(const Step& step, const LineStop& stop) {
    const Vector3 bend = step.front.direction - front_.direction;
    const double off = 0.5 * h_ * norm(bend) * stop.share * (1 - stop.share);
    if (off > kEndToleranceCells * cell() && shortened(std::max(stop.share, kLeastFactor))) return true;
    const Vector3& from = front_.place.point;
    const Vector3 end = from + stop.share * (step.front.place.point - from);
    LineCell cell = front_.place.cell;
    append(end, of_.direction_at(front_, end, cell));
    return ended(stop.reason);
  }

  /// Whether the step passes the seed; if so, ends the line there.
  bool is_closed_by(const Step& step) {
    const Vector3 &seed = seed_.place.point, &to = step.front.place.point;
    const double before = dot(front_.place.point - seed, seed_.direction);
    const double after = dot(to - seed, seed_.direction);
    if (!(before < 0 && after >= 0) || !(dot(step.front.direction, seed_.direction) > kSameDirection))
      return false;
    const Vector3 off = on_cubic(front_, to, step.front.direction, h_, before / (before - after)) - seed;
    const Vector3 beside = off - dot(off, seed_.direction) * seed_.direction;
    if (!(norm(beside) <= tuning_.closing_cells * cell())) return false;
    append(seed, seed_.direction);
    return true;
  }

  const AxisIntegrator& of_;
  const StreamlineTuning& tuning_;
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

// SPDX-License-Identifier: Apache-2.0
#include "field/field_state.hpp"

#include <cmath>
#include <numbers>
#include <utility>

namespace crossgrain {
namespace {

/// SplitMix64 (Steele, Lea, Flood 2014). A fixed generator gives the same numbers everywhere; the
/// distributions of the standard library differ between implementations.
class SplitMix64 {
 public:
  /// The seed is mixed too: streams whose states differ by a multiple of the step are shifts of each other.
  explicit SplitMix64(std::uint64_t seed) : state_(mixed(seed)) {}
  std::uint64_t next() { return mixed(state_ += 0x9e3779b97f4a7c15); }
  /// Returns a number uniform in [0, 1).
  double next_double() { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  static std::uint64_t mixed(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

}  // namespace

template <int D>
FieldState<D> state_of(std::vector<StoredQuaternion> frames) {
  FieldState<D> state;
  state.coefficients = coefficients_of<D>(frames);
  state.frames = std::move(frames);
  return state;
}

template FieldState<3> state_of<3>(std::vector<StoredQuaternion>);
template FieldState<4> state_of<4>(std::vector<StoredQuaternion>);

std::vector<StoredQuaternion> random_frames(std::size_t count, std::uint64_t seed) {
  std::vector<StoredQuaternion> frames(count);
  SplitMix64 random(seed);
  for (StoredQuaternion& frame : frames) {
    // Shoemake, "Uniform random rotations", Graphics Gems III (1992).
    const double u = random.next_double();
    const double a = 2 * std::numbers::pi * random.next_double(),
                 b = 2 * std::numbers::pi * random.next_double();
    const double r = std::sqrt(1 - u), s = std::sqrt(u);
    // Cosine and sine are those of a rotation by twice the angle: equal on all processors.
    const Quaternion of_a = from_rotation_vector({2 * a, 0, 0}), of_b = from_rotation_vector({2 * b, 0, 0});
    frame = to_stored(Quaternion{r * of_a.x, r * of_a.w, s * of_b.x, s * of_b.w});
  }
  return frames;
}

}  // namespace crossgrain

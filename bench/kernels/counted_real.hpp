// SPDX-License-Identifier: Apache-2.0
// A double that counts operations. The library's formulas work for any Real, so they can count their own
// arithmetic.
#pragma once

#include <cmath>
#include <cstddef>

#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {

class CountedReal {
 public:
  CountedReal() = default;
  CountedReal(double value) : value_(value) {}  // NOLINT: replaces a double

  CountedReal& operator+=(const CountedReal& other) { return *this = *this + other; }
  CountedReal& operator-=(const CountedReal& other) { return *this = *this - other; }
  CountedReal& operator*=(const CountedReal& other) { return *this = *this * other; }
  CountedReal& operator/=(const CountedReal& other) { return *this = *this / other; }
  friend CountedReal operator+(const CountedReal& a, const CountedReal& b) {
    return done(a.value_ + b.value_);
  }
  friend CountedReal operator-(const CountedReal& a, const CountedReal& b) {
    return done(a.value_ - b.value_);
  }
  friend CountedReal operator*(const CountedReal& a, const CountedReal& b) {
    return done(a.value_ * b.value_);
  }
  friend CountedReal operator/(const CountedReal& a, const CountedReal& b) {
    return done(a.value_ / b.value_);
  }
  friend CountedReal operator-(const CountedReal& a) { return {-a.value_}; }
  friend CountedReal sqrt(const CountedReal& a) { return done(std::sqrt(a.value_)); }
  friend CountedReal abs(const CountedReal& a) { return {std::abs(a.value_)}; }
  friend CountedReal copysign(const CountedReal& magnitude, const CountedReal& sign) {
    return {std::copysign(magnitude.value_, sign.value_)};
  }
  friend bool operator<(const CountedReal& a, const CountedReal& b) { return a.value_ < b.value_; }
  friend bool operator>(const CountedReal& a, const CountedReal& b) { return a.value_ > b.value_; }
  friend bool operator>=(const CountedReal& a, const CountedReal& b) { return a.value_ >= b.value_; }
  friend CountedReal select(bool mask, const CountedReal& a, const CountedReal& b) { return mask ? a : b; }

  /// Returns the additions, multiplications, divisions and roots in run().
  template <class Run>
  static double operations_in(const Run& run) {
    const std::size_t before = operations_;
    run();
    return static_cast<double>(operations_ - before);
  }

 private:
  static CountedReal done(double value) {
    ++operations_;
    return {value};
  }

  static inline std::size_t operations_ = 0;
  double value_ = 0;
};

/// Returns the plain Newton step, which the guarded one almost always equals.
inline BasicVector3<CountedReal> guarded_newton_step(const BasicSymmetricMatrix3<CountedReal>& hessian,
                                                     const BasicVector3<CountedReal>& gradient,
                                                     double max_angle_rad) {
  return PlainNewtonStep<CountedReal>(hessian, gradient, max_angle_rad, kHessianFloor).step;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Several numbers side by side with the arithmetic of one, so that code written for any Real can process
// several cells at once. Each lane gets the same bits as a single number would, for any number of lanes and
// any instruction set.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

namespace crossgrain {

/// Vector types of the compiler. They are listed one by one because GCC 12 accepts no size that depends on W
/// and does not vectorise a loop that fills them.
template <class Number, int W>
struct NativeLanes;
template <>
struct NativeLanes<double, 2> {
  using Vector = double __attribute__((vector_size(16)));
  using Single = float __attribute__((vector_size(8)));
  using Mask = std::int64_t __attribute__((vector_size(16)));
  static void fill(Vector& lanes, double x) { lanes = Vector{x, x}; }
};
template <>
struct NativeLanes<double, 4> {
  using Vector = double __attribute__((vector_size(32)));
  using Single = float __attribute__((vector_size(16)));
  using Mask = std::int64_t __attribute__((vector_size(32)));
  static void fill(Vector& lanes, double x) { lanes = Vector{x, x, x, x}; }
};
template <>
struct NativeLanes<double, 8> {
  using Vector = double __attribute__((vector_size(64)));
  using Single = float __attribute__((vector_size(32)));
  using Mask = std::int64_t __attribute__((vector_size(64)));
  static void fill(Vector& lanes, double x) { lanes = Vector{x, x, x, x, x, x, x, x}; }
};
template <>
struct NativeLanes<float, 4> {
  using Vector = float __attribute__((vector_size(16)));
  using Single = Vector;
  using Mask = std::int32_t __attribute__((vector_size(16)));
  static void fill(Vector& lanes, float x) { lanes = Vector{x, x, x, x}; }
};
template <>
struct NativeLanes<float, 8> {
  using Vector = float __attribute__((vector_size(32)));
  using Single = Vector;
  using Mask = std::int32_t __attribute__((vector_size(32)));
  static void fill(Vector& lanes, float x) { lanes = Vector{x, x, x, x, x, x, x, x}; }
};
template <>
struct NativeLanes<float, 16> {
  using Vector = float __attribute__((vector_size(64)));
  using Single = Vector;
  using Mask = std::int32_t __attribute__((vector_size(64)));
  static void fill(Vector& lanes, float x) { lanes = Vector{x, x, x, x, x, x, x, x, x, x, x, x, x, x, x, x}; }
};

/// 16-bit numbers, and the integers that they are widened to before conversion to lanes.
template <int W>
struct LaneWords;
template <>
struct LaneWords<2> {
  using Words = std::uint16_t __attribute__((vector_size(4)));
  using Integers = std::int32_t __attribute__((vector_size(8)));
};
template <>
struct LaneWords<4> {
  using Words = std::uint16_t __attribute__((vector_size(8)));
  using Integers = std::int32_t __attribute__((vector_size(16)));
};
template <>
struct LaneWords<8> {
  using Words = std::uint16_t __attribute__((vector_size(16)));
  using Integers = std::int32_t __attribute__((vector_size(32)));
};

/// True or false in each lane.
template <class Number, int W>
struct LaneMask {
  using Native = typename NativeLanes<Number, W>::Mask;

  Native native{};  ///< -1 for true, 0 for false

  LaneMask() = default;
  explicit LaneMask(const Native& lanes) : native(lanes) {}
  LaneMask(const LaneMask& other) : native(other.native) {}  // as in BasicLanes
  LaneMask& operator=(const LaneMask& other) {
    native = other.native;
    return *this;
  }
  ~LaneMask() = default;

  bool operator[](int lane) const { return native[lane] != 0; }
  void set(int lane, bool value) { native[lane] = value ? -1 : 0; }
  friend bool any(const LaneMask& a) {
    std::int64_t all = 0;
    for (int lane = 0; lane < W; ++lane) all |= a.native[lane];
    return all != 0;
  }
  friend LaneMask operator&(const LaneMask& a, const LaneMask& b) { return LaneMask(a.native & b.native); }
  friend LaneMask operator|(const LaneMask& a, const LaneMask& b) { return LaneMask(a.native | b.native); }
  friend LaneMask operator!(const LaneMask& a) { return LaneMask(~a.native); }
  friend bool all(const LaneMask& a) { return !any(!a); }
};

template <class Number, int W>
struct BasicLanes {
  using Native = typename NativeLanes<Number, W>::Vector;
  using Mask = LaneMask<Number, W>;
  using Single = typename NativeLanes<Number, W>::Single;
  static constexpr int kCount = W;

  Native native{};

  BasicLanes() = default;
  /// The same number in every lane.
  BasicLanes(double value) { NativeLanes<Number, W>::fill(native, static_cast<Number>(value)); }  // NOLINT
  BasicLanes(const Native& lanes) : native(lanes) {}                                              // NOLINT
  // User-provided so that the type is non-trivial and passed by address: functions compiled for different
  // instruction sets pass vectors in different registers.
  BasicLanes(const BasicLanes& other) : native(other.native) {}
  BasicLanes& operator=(const BasicLanes& other) {
    native = other.native;
    return *this;
  }
  ~BasicLanes() = default;

  Number operator[](int lane) const { return native[lane]; }
  void set(int lane, double value) { native[lane] = static_cast<Number>(value); }

  BasicLanes& operator+=(const BasicLanes& other) {
    native += other.native;
    return *this;
  }
  BasicLanes& operator-=(const BasicLanes& other) {
    native -= other.native;
    return *this;
  }
  BasicLanes& operator*=(const BasicLanes& other) {
    native *= other.native;
    return *this;
  }
  BasicLanes& operator/=(const BasicLanes& other) {
    native /= other.native;
    return *this;
  }
  friend BasicLanes operator+(BasicLanes a, const BasicLanes& b) { return a += b; }
  friend BasicLanes operator-(BasicLanes a, const BasicLanes& b) { return a -= b; }
  friend BasicLanes operator*(BasicLanes a, const BasicLanes& b) { return a *= b; }
  friend BasicLanes operator/(BasicLanes a, const BasicLanes& b) { return a /= b; }
  friend BasicLanes operator-(const BasicLanes& a) { return BasicLanes(-a.native); }

  friend BasicLanes sqrt(const BasicLanes& a) {
    BasicLanes result;
    for (int lane = 0; lane < W; ++lane) result.native[lane] = std::sqrt(a.native[lane]);
    return result;
  }
  friend BasicLanes abs(const BasicLanes& a) { return select(a > 0.0, a, 0.0 - a); }
  friend BasicLanes copysign(const BasicLanes& magnitude, const BasicLanes& sign) {
    BasicLanes result;
    for (int lane = 0; lane < W; ++lane)
      result.native[lane] = std::copysign(magnitude.native[lane], sign.native[lane]);
    return result;
  }

  friend Mask operator<(const BasicLanes& a, const BasicLanes& b) { return Mask(a.native < b.native); }
  friend Mask operator>(const BasicLanes& a, const BasicLanes& b) { return Mask(a.native > b.native); }
  friend Mask operator>=(const BasicLanes& a, const BasicLanes& b) { return Mask(a.native >= b.native); }

  /// Returns a in lanes where `mask` is true, else b.
  friend BasicLanes select(const Mask& mask, const BasicLanes& a, const BasicLanes& b) {
    return BasicLanes(mask.native ? a.native : b.native);
  }

  /// Returns the value rounded to single precision.
  friend BasicLanes to_single(const BasicLanes& a) {
    return BasicLanes(__builtin_convertvector(__builtin_convertvector(a.native, Single), Native));
  }
};

template <int W>
using Lanes = BasicLanes<double, W>;
template <int W>
using SingleLanes = BasicLanes<float, W>;

/// Loads W consecutive numbers. Doubles are written out one by one, since GCC 12 finds no single instruction
/// for a loop or for __builtin_convertvector.
template <class Real>
Real lanes_of(const float* x) {
  constexpr int W = Real::kCount;
  using Native = typename Real::Native;
  Native native;
  if constexpr (sizeof(Native) == W * sizeof(float)) {
    std::memcpy(&native, x, sizeof native);
  } else if constexpr (W == 2) {
    native = Native{x[0], x[1]};
  } else if constexpr (W == 4) {
    native = Native{x[0], x[1], x[2], x[3]};
  } else {
    native = Native{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]};
  }
  return Real(native);
}

/// Loads W consecutive floats or 16-bit numbers that begin anywhere in an array of words.
template <class Real>
Real lanes_of_floats(const std::uint16_t* words) {
  std::array<float, Real::kCount> numbers;
  std::memcpy(numbers.data(), words, sizeof numbers);
  return lanes_of<Real>(numbers.data());
}
template <class Real>
Real lanes_of_words(const std::uint16_t* words) {
  constexpr int W = Real::kCount;
  using Native = typename Real::Native;
  typename LaneWords<W>::Words native;
  std::memcpy(&native, words, sizeof native);
  return Real(
      __builtin_convertvector(__builtin_convertvector(native, typename LaneWords<W>::Integers), Native));
}

/// Loads W consecutive doubles.
template <class Real>
Real lanes_at(const double* x) {
  typename Real::Native native;
  std::memcpy(&native, x, sizeof native);
  return Real(native);
}

/// Returns the number in lane `Lane` of `a`, in all lanes. This is faster than filling lanes with a scalar,
/// which takes one instruction per lane.
template <int Lane, class Number, int W>
BasicLanes<Number, W> repeated(const BasicLanes<Number, W>& a) {
  return [&]<int... L>(std::integer_sequence<int, L...>) {
    return BasicLanes<Number, W>(__builtin_shufflevector(a.native, a.native, (0 * L + Lane)...));
  }
  (std::make_integer_sequence<int, W>());
}

/// Returns b[l - Half] + b[l] in lanes l whose number has the bit `Half`, and a[l] + a[l + Half] in the
/// others.
template <int Half, class Number, int W>
BasicLanes<Number, W> folded(const BasicLanes<Number, W>& a, const BasicLanes<Number, W>& b) {
  return [&]<int... L>(std::integer_sequence<int, L...>) {
    return BasicLanes<Number, W>(
        __builtin_shufflevector(a.native, b.native, (L & Half ? W + L - Half : L)...) +
        __builtin_shufflevector(a.native, b.native, (L & Half ? W + L : L + Half)...));
  }
  (std::make_integer_sequence<int, W>());
}

/// Returns in lane k the sum of all lanes of x[k], added pairwise, halves first.
template <class Real, std::size_t W>
Real sums_over_lanes(std::array<Real, W> x) {
  static_assert(W == Real::kCount);
  const auto fold = [&]<int Half>(const auto& self, std::integral_constant<int, Half>) {
    [&]<int... K>(std::integer_sequence<int, K...>) {
      ((x[K] = folded<Half>(x[K], x[K + Half])), ...);
    }
    (std::make_integer_sequence<int, Half>());
    if constexpr (Half > 1) self(self, std::integral_constant<int, Half / 2>());
  };
  fold(fold, std::integral_constant<int, W / 2>());
  return x[0];
}

/// Returns *x in all lanes. Precondition: as many doubles as there are lanes can be read at x.
template <class Real>
Real in_every_lane(const double* x) {
  if constexpr (std::is_same_v<Real, double>) {
    return *x;
  } else {
    return repeated<0>(lanes_at<Real>(x));
  }
}

/// Returns the numbers in one lane.
template <class Number, int W, std::size_t N>
std::array<double, N> in_lane(const std::array<BasicLanes<Number, W>, N>& numbers, int lane) {
  std::array<double, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = numbers[i][lane];
  return result;
}

template <class Number, int W, std::size_t N>
void set_lane(std::array<BasicLanes<Number, W>, N>& numbers, int lane, const std::array<double, N>& values) {
  for (std::size_t i = 0; i < N; ++i) numbers[i].set(lane, values[i]);
}

/// Returns the numbers of a in lanes where `mask` is true, else those of b.
template <class Number, int W, std::size_t N>
std::array<BasicLanes<Number, W>, N> select(const LaneMask<Number, W>& mask,
                                            const std::array<BasicLanes<Number, W>, N>& a,
                                            const std::array<BasicLanes<Number, W>, N>& b) {
  std::array<BasicLanes<Number, W>, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = select(mask, a[i], b[i]);
  return result;
}

/// What select, any and all are for lanes.
inline double select(bool mask, double a, double b) {
  return mask ? a : b;
}
inline bool any(bool mask) {
  return mask;
}
inline bool all(bool mask) {
  return mask;
}

}  // namespace crossgrain

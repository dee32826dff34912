// SPDX-License-Identifier: Apache-2.0
// Several doubles side by side with the arithmetic of one: what is written for any Real then works on several
// cells at once. Each lane gets the very bits that a double would get, whatever their number and whatever
// instructions the processor has.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace crossgrain {

/// The compiler's own vectors of W numbers. One by one, since GCC 12 takes no size that depends on W,
/// and a loop that fills them remains one.
template <int W>
struct NativeLanes;
template <>
struct NativeLanes<2> {
  using Double = double __attribute__((vector_size(16)));
  using Single = float __attribute__((vector_size(8)));
  using Mask = std::int64_t __attribute__((vector_size(16)));
  static void fill(Double& lanes, double x) { lanes = Double{x, x}; }
};
template <>
struct NativeLanes<4> {
  using Double = double __attribute__((vector_size(32)));
  using Single = float __attribute__((vector_size(16)));
  using Mask = std::int64_t __attribute__((vector_size(32)));
  static void fill(Double& lanes, double x) { lanes = Double{x, x, x, x}; }
};
template <>
struct NativeLanes<8> {
  using Double = double __attribute__((vector_size(64)));
  using Single = float __attribute__((vector_size(32)));
  using Mask = std::int64_t __attribute__((vector_size(64)));
  static void fill(Double& lanes, double x) { lanes = Double{x, x, x, x, x, x, x, x}; }
};

/// True or false in each lane.
template <int W>
struct LaneMask {
  using Native = typename NativeLanes<W>::Mask;

  Native native{};  ///< -1 for true, 0 for false

  LaneMask() = default;
  explicit LaneMask(const Native& lanes) : native(lanes) {}
  LaneMask(const LaneMask& other) : native(other.native) {}  // as in Lanes
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
};

template <int W>
struct Lanes {
  using Native = typename NativeLanes<W>::Double;
  using Mask = LaneMask<W>;
  using Single = typename NativeLanes<W>::Single;

  Native native{};

  Lanes() = default;
  /// The same number in every lane.
  Lanes(double value) { NativeLanes<W>::fill(native, value); }  // NOLINT
  Lanes(const Native& lanes) : native(lanes) {}                 // NOLINT
  // Not left to the compiler, since trivial ones would let it pass lanes in registers, which functions
  // compiled for different processors would look for in different ones.
  Lanes(const Lanes& other) : native(other.native) {}
  Lanes& operator=(const Lanes& other) {
    native = other.native;
    return *this;
  }
  ~Lanes() = default;

  double operator[](int lane) const { return native[lane]; }
  void set(int lane, double value) { native[lane] = value; }

  Lanes& operator+=(const Lanes& other) {
    native += other.native;
    return *this;
  }
  Lanes& operator-=(const Lanes& other) {
    native -= other.native;
    return *this;
  }
  Lanes& operator*=(const Lanes& other) {
    native *= other.native;
    return *this;
  }
  Lanes& operator/=(const Lanes& other) {
    native /= other.native;
    return *this;
  }
  friend Lanes operator+(Lanes a, const Lanes& b) { return a += b; }
  friend Lanes operator-(Lanes a, const Lanes& b) { return a -= b; }
  friend Lanes operator*(Lanes a, const Lanes& b) { return a *= b; }
  friend Lanes operator/(Lanes a, const Lanes& b) { return a /= b; }
  friend Lanes operator-(const Lanes& a) { return Lanes(-a.native); }

  friend Lanes sqrt(const Lanes& a) {
    Lanes result;
    for (int lane = 0; lane < W; ++lane) result.native[lane] = std::sqrt(a.native[lane]);
    return result;
  }
  friend Lanes abs(const Lanes& a) { return select(a > 0.0, a, 0.0 - a); }
  friend Lanes copysign(const Lanes& magnitude, const Lanes& sign) {
    Lanes result;
    for (int lane = 0; lane < W; ++lane)
      result.native[lane] = std::copysign(magnitude.native[lane], sign.native[lane]);
    return result;
  }

  friend Mask operator<(const Lanes& a, const Lanes& b) { return Mask(a.native < b.native); }
  friend Mask operator>(const Lanes& a, const Lanes& b) { return Mask(a.native > b.native); }

  friend Mask operator>=(const Lanes& a, const Lanes& b) { return Mask(a.native >= b.native); }

  /// In each lane a where `mask` is true, else b.
  friend Lanes select(const Mask& mask, const Lanes& a, const Lanes& b) {
    return Lanes(mask.native ? a.native : b.native);
  }

  /// Rounded to single precision.
  friend Lanes to_single(const Lanes& a) {
    return Lanes(__builtin_convertvector(__builtin_convertvector(a.native, Single), Native));
  }
};

/// W numbers that stand one after the other. Spelled out, since for loops and for __builtin_convertvector GCC
/// 12 finds no single instruction.
template <int W>
Lanes<W> lanes_of(const float* x) {
  using Double = typename NativeLanes<W>::Double;
  if constexpr (W == 2) return Lanes<W>(Double{x[0], x[1]});
  if constexpr (W == 4) return Lanes<W>(Double{x[0], x[1], x[2], x[3]});
  if constexpr (W == 8) return Lanes<W>(Double{x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]});
}

/// The number in lane `Lane` of `a`, in all lanes. Where the number is known as a double only, filling lanes
/// with it takes one instruction per lane.
template <int Lane, int W>
Lanes<W> repeated(const Lanes<W>& a) {
  using Index = typename NativeLanes<W>::Mask;
  if constexpr (W == 2) return Lanes<W>(__builtin_shuffle(a.native, Index{Lane, Lane}));
  if constexpr (W == 4) return Lanes<W>(__builtin_shuffle(a.native, Index{Lane, Lane, Lane, Lane}));
  if constexpr (W == 8)
    return Lanes<W>(__builtin_shuffle(a.native, Index{Lane, Lane, Lane, Lane, Lane, Lane, Lane, Lane}));
}

/// The numbers in one lane.
template <int W, std::size_t N>
std::array<double, N> in_lane(const std::array<Lanes<W>, N>& numbers, int lane) {
  std::array<double, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = numbers[i][lane];
  return result;
}

template <int W, std::size_t N>
void set_lane(std::array<Lanes<W>, N>& numbers, int lane, const std::array<double, N>& values) {
  for (std::size_t i = 0; i < N; ++i) numbers[i].set(lane, values[i]);
}

/// In each lane the numbers of a where `mask` is true, else those of b.
template <int W, std::size_t N>
std::array<Lanes<W>, N> select(const LaneMask<W>& mask, const std::array<Lanes<W>, N>& a,
                               const std::array<Lanes<W>, N>& b) {
  std::array<Lanes<W>, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = select(mask, a[i], b[i]);
  return result;
}

/// What select and any are for lanes.
inline double select(bool mask, double a, double b) {
  return mask ? a : b;
}
inline bool any(bool mask) {
  return mask;
}

}  // namespace crossgrain

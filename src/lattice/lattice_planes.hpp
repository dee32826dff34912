// SPDX-License-Identifier: Apache-2.0
// Planes that a lattice is cut by.
#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "base/vector3.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Coordinates of the planes normal to each axis, ascending.
struct LatticePlanes {
  std::array<std::vector<double>, 3> at;

  std::size_t cells(std::size_t axis) const { return at[axis].size() - 1; }
  std::size_t cells() const { return cells(0) * cells(1) * cells(2); }
};

/// A place around which planes are nearer to each other than elsewhere.
struct FinePlace {
  Vector3 at{};
  double size = 0;  ///< distance of the planes there

  /// Of the surface there: planes along which it lies stay as they are, such as those across a rod. Zero: all
  /// are nearer.
  Vector3 normal{};
};

/// A hole, or a boss, along the axes.
struct HoleBox {
  Box box;
  bool is_boss = false;
};

/// What gets planes besides large faces that are apart.
struct NarrowPlanes {
  bool walls = false;  ///< both sides of walls and gaps, however thin; but beside holes see kThinnestAtHole
  std::vector<HoleBox> holes = {};  ///< beside which such walls are found
  std::vector<Box> boxes =
      {};  ///< with planes on both sides if narrower than two sizes, unless others are near
  std::vector<FinePlace> fine = {};
  std::vector<Box> lines = {};  ///< long ones get planes across their thin sides, unless others are near
};

/// The distance of planes along an axis: a size, but smaller ones near to places, from which it grows by
/// kGrowth of the way.
class PlaneDistance {
 public:
  PlaneDistance(double size, const std::vector<FinePlace>& fine, std::size_t axis);

  double at(double coordinate) const;

  /// How many fit between two coordinates: the integral of 1 / at().
  double between(double low, double high) const;

  /// The coordinate from which so many fit above `low`; `high` at most.
  double after(double low, double high, double count) const;

 private:
  std::vector<double> steps(double low, double high) const;

  double size_;
  std::vector<std::pair<double, double>> places_;  ///< coordinate and size, ascending
};

/// Returns planes about `size` apart around a surface: those of its large faces normal to an axis first,
/// where these are not too near to each other (kLeastGap); then those of what is narrow; the same number of
/// others between two of them as fit best; and on either side one that the surface does not reach.
LatticePlanes lattice_planes(const Surface& surface, double size, const NarrowPlanes& narrow = {});

/// Returns the share of a surface's area that is normal to no axis.
double slanted_share(const Surface& surface);

/// By how much planes may be farther apart for each length away from a finer place: less than a half leaves
/// neighbours in a ratio of 1.6 at most.
inline constexpr double kGrowth = 0.5;

/// Least component of a normal along an axis for which a place is finer along that.
inline constexpr double kLeastAcross = 0.25;

/// Least distance of planes on faces, in sizes.
inline constexpr double kLeastGap = 0.45;

/// Least distance of planes at holes from others, in sizes.
inline constexpr double kHoleGap = 0.15;

/// A wall between a hole and a face, or two holes, in sizes: a thicker one has more than half of its cells,
/// and of a thinner one no cells are made.
inline constexpr double kThickestAtHole = 0.8, kThinnestAtHole = 0.02;

/// Least distance of planes at lines from others, in sizes. With them the L-bracket, the wedge and i02o of
/// the everyday parts and models keep all borders of their fillets, with 6, 2 and 41 % fewer hexahedra.
inline constexpr double kLineGap = 0.6;

/// Least area of faces in a plane that gets one, in squared sizes.
inline constexpr double kPlaneArea = 0.7;

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "analysis/leaf_turn.hpp"

#include <algorithm>
#include <cmath>

#include "analysis/matching.hpp"
#include "base/vector3.hpp"
#include "harmonics/symmetric_matrix3.hpp"

namespace crossgrain {
namespace {

/// Neighbours that turn by more than 34 degrees say nothing of a gradient: beyond 45 it is not even known
/// which way they turn, and around a singular line the four cells next to it turn by 22.5 each.
constexpr double kLargestTurn_rad = 0.6;

/// Directions in which the squared distances to the neighbours, added up, stay below this share of those in
/// the best direction have no neighbour. Four cells of half the size behind one face alone reach 0.11 along
/// that face.
constexpr double kSmallestSpread = 0.02;

/// The smallest turn, as a rotation vector, that takes frame p to frame q.
Vector3 turn_between(const Quaternion& p, const Quaternion& q) {
  const Quaternion named = q * to_quaternion(nearest_cube_rotation(conjugate(q) * p));
  const Quaternion turn = named * conjugate(p);
  const Vector3 axis{turn.x, turn.y, turn.z};
  const double sine = norm(axis);
  if (sine == 0) return {0, 0, 0};
  const double angle = 2 * std::atan2(sine, std::abs(turn.w));
  return (std::copysign(angle, turn.w) / sine) * axis;
}

/// The sums of a least-squares fit of w = W d.
class TurnFit {
 public:
  void add(const Vector3& d, const Vector3& turn, double weight) {
    normal_[0] += weight * d[0] * d[0];
    normal_[1] += weight * d[0] * d[1];
    normal_[2] += weight * d[0] * d[2];
    normal_[3] += weight * d[1] * d[1];
    normal_[4] += weight * d[1] * d[2];
    normal_[5] += weight * d[2] * d[2];
    for (int row = 0; row < 3; ++row) right_[row] += weight * turn[row] * d;
  }

  /// W, zero in directions that no d has a part in.
  std::array<Vector3, 3> solve() const {
    const Eigensystem3 system = eigensystem(normal_);
    std::array<Vector3, 3> rows{};
    for (int k = 0; k < 3; ++k) {
      const double value = system.values[k];
      if (!(value > kSmallestSpread * system.values[2])) continue;
      const Vector3& v = system.vectors[k];
      for (int row = 0; row < 3; ++row) rows[row] += dot(right_[row], v) / value * v;
    }
    return rows;
  }

 private:
  SymmetricMatrix3 normal_{};
  std::array<Vector3, 3> right_{};
};

}  // namespace

bool joined(const PlacedLeaf& a, const PlacedLeaf& b) {
  const PlacedLeaf &small = a.width <= b.width ? a : b, &large = a.width <= b.width ? b : a;
  int face = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const std::int32_t off = small.corner[axis] - large.corner[axis];
    if (off >= 0 && off < large.width) continue;
    if (face >= 0 || (off != -small.width && off != large.width)) return false;
    face = 2 * axis + (off < 0 ? 1 : 0);
  }
  if (face < 0) return false;
  if (small.open_faces >> face & 1) return true;
  return small.width == large.width && (large.open_faces >> opposite_face(face) & 1);
}

LeafTurn leaf_turn(const LeafField& field, CellIndex i) {
  const PlacedLeaf leaf = placed(field, i);
  const Quaternion frame = from_stored(field.frames[i]);
  LeafTurn result;
  TurnFit fit;
  for (int number = 0; number < 27; ++number) {
    const std::array<int, 3> offset{number % 3 - 1, number / 3 % 3 - 1, number / 9 - 1};
    const int steps = std::abs(offset[0]) + std::abs(offset[1]) + std::abs(offset[2]);
    // Leaves at edges and corners only matter for how even the surroundings are.
    if (steps == 0 || (steps > 1 && !result.even_surroundings)) continue;
    const auto across = moved(field.tree[i], offset);
    const auto [first, last] = across ? field.finder.over(*across) : std::pair<CellIndex, CellIndex>{0, 0};
    if (first < last && field.tree[first] != *across) result.even_surroundings = false;
    if (steps > 1) continue;
    if (first == last) result.open_all_around = false;
    for (CellIndex j = first; j < last; ++j) {
      const PlacedLeaf other = placed(field, j);
      if (!joined(leaf, other)) {
        // Of several smaller leaves those away from the face are not joined either: counting them errs on the
        // safe side.
        result.open_all_around = false;
        continue;
      }
      const Vector3 turn = turn_between(frame, from_stored(field.frames[j]));
      if (norm(turn) > kLargestTurn_rad) continue;
      const Vector3 d = leaf.offset_of(other.centre());
      const double side = std::min(1.0, static_cast<double>(other.width) / leaf.width);
      fit.add(d, turn, side * side / norm(d));
    }
  }
  const auto rows = fit.solve();
  for (int entry = 0; entry < 9; ++entry)
    result.per_cell[entry] = static_cast<float>(rows[entry / 3][entry % 3]);
  return result;
}

}  // namespace crossgrain

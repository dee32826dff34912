// SPDX-License-Identifier: Apache-2.0
#include "sampling/leaf_turn.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/vector3.hpp"
#include "harmonics/symmetric_matrix3.hpp"
#include "singularity/matching.hpp"

namespace crossgrain {
namespace {

/// Neighbours that turn by more than 34 degrees say nothing of a gradient: beyond 45 it is not even known
/// which way they turn, and around a singular line the four cells next to it turn by 22.5 each.
constexpr double kLargestTurn_rad = 0.6;

/// Directions in which the squared distances to the neighbours, added up, stay below this share of those in
/// the best direction have no neighbour. Four cells of half the size behind one face alone reach 0.11 along
/// that face.
constexpr double kSmallestSpread = 0.02;

/// The square of cos(22.5 deg), and a little. Where two frames as they are named turn by less than 45
/// degrees, no other names bring them nearer.
constexpr double kSurelyAlike = 0.86;

/// 2 atan(t) / t by its series, in t^2; good to 1e-8 for turns up to kLargestTurn_rad, which are stored in
/// single precision.
double twice_arc_tangent_over(double tt) {
  double sum = 0;
  for (int order = 13; order >= 1; order -= 2) sum = 2.0 / order - tt * sum;
  return sum;
}

/// The smallest turn that takes frame p to frame q, as a rotation vector in the axes of p; nothing where it
/// is beyond kLargestTurn_rad. The norms of p and q do not matter.
std::optional<Vector3> turn_in_axes(const Quaternion& p, const Quaternion& q) {
  static const double kLargestSquaredTangent = std::pow(std::tan(kLargestTurn_rad / 2), 2);
  Quaternion turn = conjugate(p) * q;
  const double squared_norm = turn.w * turn.w + turn.x * turn.x + turn.y * turn.y + turn.z * turn.z;
  if (turn.w * turn.w < kSurelyAlike * squared_norm)
    turn = turn * to_quaternion(nearest_cube_rotation(conjugate(turn)));
  const Vector3 tangent = 1 / turn.w * Vector3{turn.x, turn.y, turn.z};  // of half the angle, along the axis
  const double tt = dot(tangent, tangent);
  if (!(tt <= kLargestSquaredTangent)) return std::nullopt;
  return twice_arc_tangent_over(tt) * tangent;
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
    const auto& [xx, xy, xz, yy, yz, zz] = normal_;
    const SymmetricMatrix3 adjugate{yy * zz - yz * yz, xz * yz - xy * zz, xy * yz - xz * yy,
                                    xx * zz - xz * xz, xy * xz - xx * yz, xx * yy - xy * xy};
    const double determinant = xx * adjugate[0] + xy * adjugate[1] + xz * adjugate[2];
    const double trace = xx + yy + zz;
    std::array<Vector3, 3> rows{};
    // No eigenvalue is below 4 determinant / trace^2: as a rule there are neighbours in all directions.
    if (4 * determinant > kSmallestSpread * trace * trace * trace) {
      for (int row = 0; row < 3; ++row) rows[row] = 1 / determinant * apply(adjugate, right_[row]);
      return rows;
    }
    const Eigensystem3 system = eigensystem(normal_);
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

/// Fits the turn of one leaf, in the axes of its own frame.
class LeafTurnFit {
 public:
  LeafTurnFit(const LeafField& field, const LeafSurroundings& around)
      : field_(field), around_(around), own_(placed(field, around.leaf())) {}

  LeafTurn turn() {
    for (int face = 0; face < kFaceCount; ++face) add_across(face);
    const std::array<Vector3, 3> in_axes = fit_.solve();
    const auto axes = axes_of(from_stored(field_.frames[own_.index]));
    LeafTurn result;
    for (int row = 0; row < 3; ++row) {
      const Vector3 turned =
          axes[0][row] * in_axes[0] + axes[1][row] * in_axes[1] + axes[2][row] * in_axes[2];
      for (int column = 0; column < 3; ++column)
        result.per_cell[3 * row + column] = static_cast<float>(turned[column]);
    }
    return result;
  }

 private:
  /// Adds the leaves across a face that are joined to this one.
  void add_across(int face) {
    LeafSurroundings::Step step{};
    step[face_axis(face)] = face_sign(face);
    const LeafRange& across = around_.over(step);
    if (around_.is_equal(step)) {
      const CellIndex j = across.first;
      if (!(own_.open_faces >> face & 1 || field_.open_faces[j] >> opposite_face(face) & 1)) return;
      Vector3 d{0, 0, 0};
      d[face_axis(face)] = face_sign(face);
      add(j, d, 1);
      return;
    }
    // Of several smaller leaves those away from the face are not joined.
    for (CellIndex j = across.first; j < across.last; ++j) {
      const PlacedLeaf other = placed(field_, j);
      if (!joined(own_, other)) continue;
      const Vector3 d = own_.offset_of(other.centre());
      const double side = std::min(1.0, static_cast<double>(other.width) / own_.width);
      add(j, d, side * side / norm(d));
    }
  }

  void add(CellIndex j, const Vector3& d, double weight) {
    const StoredQuaternion &p = field_.frames[own_.index], &q = field_.frames[j];
    const auto turn = turn_in_axes({p.w, p.x, p.y, p.z}, {q.w, q.x, q.y, q.z});
    if (turn) fit_.add(d, *turn, weight);
  }

  const LeafField& field_;
  const LeafSurroundings& around_;
  PlacedLeaf own_;
  TurnFit fit_;
};

}  // namespace

LeafTurn leaf_turn(const LeafField& field, const LeafSurroundings& around) {
  return LeafTurnFit(field, around).turn();
}

}  // namespace crossgrain

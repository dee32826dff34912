// SPDX-License-Identifier: Apache-2.0
#include "solve/face_frames.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "field/tet_finish.hpp"
#include "harmonics/frame.hpp"

namespace crossgrain {
namespace {

/// Cosine of the angle up to which faces share an axis. Beyond it another axis of a frame is nearer.
constexpr double kOneAxis = std::numbers::sqrt2 / 2;

/// Least determinant of three unit directions that are taken for three axes; of flatter ones the third has no
/// axis of its own.
constexpr double kLeastDeterminant = 0.3;

using Columns = std::array<Vector3, 3>;

double determinant(const Columns& m) {
  return dot(m[0], cross(m[1], m[2]));
}

/// The nearest orthogonal matrix, by Newton's iteration for the polar decomposition, X -> (X + X^-T) / 2.
Columns nearest_orthogonal(Columns m) {
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    const double scale = 1 / determinant(m);
    const Columns inverse_transposed{scale * cross(m[1], m[2]), scale * cross(m[2], m[0]),
                                     scale * cross(m[0], m[1])};
    for (std::size_t k = 0; k < 3; ++k) m[k] = 0.5 * (m[k] + inverse_transposed[k]);
  }
  return m;
}

/// Sums of the normals of each group, the largest normal first.
std::vector<Vector3> groups_of(std::span<const Vector3> normals) {
  std::vector<Vector3> sorted(normals.begin(), normals.end());
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const Vector3& a, const Vector3& b) { return norm(a) > norm(b); });
  std::vector<Vector3> firsts, sums;
  for (const Vector3& normal : sorted) {
    const auto is_of = [&](const Vector3& first) {
      return std::abs(dot(first, normal)) >= kOneAxis * norm(normal);
    };
    const auto group =
        static_cast<std::size_t>(std::find_if(firsts.begin(), firsts.end(), is_of) - firsts.begin());
    if (group == firsts.size()) {
      firsts.push_back(normalised(normal));
      sums.push_back(normal);
    } else {
      sums[group] += dot(firsts[group], normal) < 0 ? -normal : normal;
    }
  }
  return sums;
}

/// The frame nearest to two or three directions.
Quaternion frame_near(const std::vector<Vector3>& directions) {
  const Vector3 x = normalised(directions[0]), y = normalised(directions[1]);
  Columns columns{x, y, normalised(cross(x, y))};
  if (directions.size() > 2) {
    const Columns all{x, y, normalised(directions[2])};
    if (std::abs(determinant(all)) >= kLeastDeterminant) columns = all;
  }
  if (determinant(columns) < 0) columns[2] = -columns[2];
  return normalised(quaternion_of(nearest_orthogonal(columns)));
}

}  // namespace

std::vector<TetFaceNormals> followed_normals(const TetSolid& solid,
                                             std::span<const std::array<std::uint32_t, 3>> walls) {
  std::vector<std::pair<std::uint32_t, Vector3>> all;
  const auto add = [&](std::uint32_t tet, const std::array<std::uint32_t, 3>& face) {
    const auto& [a, b, c] = face;
    const std::vector<Vector3>& v = solid.mesh.vertices;
    const Vector3 normal = cross(v[b] - v[a], v[c] - v[a]);
    if (tet != kNoTet && norm(normal) > 0) all.emplace_back(tet, normal);
  };
  for (std::size_t f = 0; f < solid.boundary.size(); ++f) add(solid.boundary_tets[f], solid.boundary[f]);
  for (auto face : walls) {
    std::sort(face.begin(), face.end());
    const auto found = std::lower_bound(
        solid.inner_faces.begin(), solid.inner_faces.end(), face,
        [](const TetSolid::InnerFace& inner, const auto& wanted) { return inner.vertices < wanted; });
    if (found == solid.inner_faces.end() || found->vertices != face) continue;
    for (const std::uint32_t tet : found->tets) add(tet, face);
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<TetFaceNormals> followed;
  for (const auto& [tet, normal] : all) {
    if (followed.empty() || followed.back().tet != tet) followed.push_back({tet, {}});
    followed.back().normals.push_back(normal);
  }
  return followed;
}

Quaternion frame_on_faces(std::span<const Vector3> normals, const Coefficients<4>& target,
                          const Quaternion& start) {
  const std::vector<Vector3> groups = groups_of(normals);
  if (groups.size() == 1) return best_about_axis(normalised(groups[0]), target, start);
  return frame_near(groups);
}

Quaternion best_about_axis(const Vector3& axis, const Coefficients<4>& target, const Quaternion& start) {
  const Quaternion on_axis = with_axis_along(start, axis);
  const auto turned = [&](double angle) { return normalised(from_rotation_vector(angle * axis) * on_axis); };
  const auto score = [&](double angle) { return dot(target, frame_coefficients<4>(turned(angle))); };
  constexpr double kEighth = std::numbers::pi / 4;
  const double at_zero = score(0), at_half = score(kEighth / 2), at_eighth = score(kEighth);
  const double a = 0.5 * (at_zero - at_eighth), b = at_half - 0.5 * (at_zero + at_eighth);
  return turned(std::atan2(b, a) / 4);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "repair/frozen_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

/// A neighbour of a tet: `turn` names the axes of its frame as those of the tet.
struct Neighbour {
  std::uint32_t tet = UINT32_MAX;
  std::uint8_t turn = CubeGroup::kIdentity;
  double weight = 0;
};

Vector3 centroid(const TetMesh& mesh, std::uint32_t tet) {
  const auto& [a, b, c, d] = mesh.tets[tet];
  return 0.25 * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c] + mesh.vertices[d]);
}

std::vector<std::array<Neighbour, 4>> neighbours_of(const MatchedField& field) {
  const TetSolid& solid = field.complex().solid();
  const CubeGroup& group = CubeGroup::instance();
  std::vector<std::array<Neighbour, 4>> neighbours(solid.mesh.tets.size());
  const auto add = [&](std::uint32_t tet, const Neighbour& neighbour) {
    auto& all = neighbours[tet];
    *std::find_if(all.begin(), all.end(), [](const Neighbour& n) { return n.tet == UINT32_MAX; }) = neighbour;
  };
  for (std::uint32_t f = 0; f < solid.inner_faces.size(); ++f) {
    const auto& [vertices, tets] = solid.inner_faces[f];
    const std::vector<Vector3>& v = solid.mesh.vertices;
    const double twice_area = norm(cross(v[vertices[1]] - v[vertices[0]], v[vertices[2]] - v[vertices[0]]));
    const double distance = norm(centroid(solid.mesh, tets[0]) - centroid(solid.mesh, tets[1]));
    const double weight = distance > 0 ? twice_area / (2 * distance) : 0;
    // R_from and R_to g have the same names of axes.
    const std::uint8_t matching = field.matching(f);
    add(tets[0], {tets[1], matching, weight});
    add(tets[1], {tets[0], group.inverse_of(matching), weight});
  }
  return neighbours;
}

/// Directions that axes of a tet's frame must have.
struct Held {
  std::uint32_t tet;
  std::array<Vector3, 3> sums{};  ///< of area normals and edges, by axis; {0, 0, 0} for a free axis

  int count() const {
    return static_cast<int>(
        std::count_if(sums.begin(), sums.end(), [](const Vector3& v) { return norm(v) > 0; }));
  }
};

std::vector<Held> held_axes(const MatchedField& field) {
  const TetSolid& solid = field.complex().solid();
  std::vector<Held> held;
  std::vector<std::uint32_t> place(solid.mesh.tets.size(), UINT32_MAX);
  const auto hold = [&](std::uint32_t tet, SignedAxis axis, const Vector3& normal) {
    if (place[tet] == UINT32_MAX) {
      place[tet] = static_cast<std::uint32_t>(held.size());
      held.push_back({tet});
    }
    held[place[tet]].sums[axis % 3] += axis < 3 ? normal : -normal;
  };
  const auto normal_of = [&](const std::array<std::uint32_t, 3>& face) {
    const auto& [a, b, c] = face;
    const std::vector<Vector3>& v = solid.mesh.vertices;
    return cross(v[b] - v[a], v[c] - v[a]);
  };
  for (std::uint32_t f = 0; f < solid.boundary.size(); ++f)
    if (solid.boundary_tets[f] != kNoTet)
      hold(solid.boundary_tets[f], field.normal_axis(f), normal_of(solid.boundary[f]));
  for (const std::uint32_t f : field.complex().wall_faces()) {
    const Vector3 normal = normal_of(solid.inner_faces[f].vertices);
    for (const std::uint32_t tet : solid.inner_faces[f].tets)
      hold(tet, nearest_axis(field.frames()[tet], normal), normal);
  }
  for (const std::uint32_t e : field.complex().feature_edges()) {
    const TetComplex::Edge& edge = field.complex().edges()[e];
    const Vector3 along = solid.mesh.vertices[edge.ends[1]] - solid.mesh.vertices[edge.ends[0]];
    const auto hold_along = [&](std::uint32_t tet) {
      hold(tet, nearest_axis(field.frames()[tet], along), edge.length * along);
    };
    hold_along(edge.first_tet);
    for (const Crossing& crossing : field.complex().around(e)) {
      const std::uint32_t tet = solid.inner_faces[crossing.face].tets[!crossing.reversed];
      if (tet != edge.first_tet) hold_along(tet);
    }
  }
  return held;
}

/// The frame turned by the shortest way so that an axis gets a direction.
Quaternion with_axis(const Quaternion& frame, std::size_t axis, const Vector3& direction) {
  const Vector3 now = axes_of(frame)[axis];
  const Vector3 turn = cross(now, direction);
  const double cosine = dot(now, direction);
  if (norm(turn) == 0 && cosine > 0) return frame;
  if (cosine < -1 + 1e-12) {
    // Half a turn about another axis.
    const Vector3 other = axes_of(frame)[(axis + 1) % 3];
    return normalised(Quaternion{0, other[0], other[1], other[2]} * frame);
  }
  return normalised(Quaternion{1 + cosine, turn[0], turn[1], turn[2]} * frame);
}

/// The frame whose axes are nearest to two or three directions, by the polar decomposition.
std::optional<Quaternion> frame_along(const Held& held) {
  std::array<Vector3, 3> columns = held.sums;
  for (Vector3& column : columns) column = normalised(column);
  for (std::size_t k = 0; k < 3; ++k)
    if (columns[k] == Vector3{0, 0, 0})
      columns[k] = normalised(cross(columns[(k + 1) % 3], columns[(k + 2) % 3]));
  constexpr double kLeastDeterminant = 0.1;
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    const double determinant = dot(columns[0], cross(columns[1], columns[2]));
    if (!(determinant > kLeastDeterminant)) return std::nullopt;
    const std::array<Vector3, 3> inverse{(1 / determinant) * cross(columns[1], columns[2]),
                                         (1 / determinant) * cross(columns[2], columns[0]),
                                         (1 / determinant) * cross(columns[0], columns[1])};
    for (std::size_t k = 0; k < 3; ++k) columns[k] = 0.5 * (columns[k] + inverse[k]);
  }
  return quaternion_of(columns);
}

Quaternion on_faces(const Quaternion& frame, const Held& held) {
  if (held.count() > 1)
    if (const auto along = frame_along(held)) return *along;
  std::size_t largest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (norm(held.sums[k]) > norm(held.sums[largest])) largest = k;
  return norm(held.sums[largest]) > 0 ? with_axis(frame, largest, normalised(held.sums[largest])) : frame;
}

}  // namespace

std::vector<Quaternion> smoothed_frames(const MatchedField& field, std::vector<Quaternion> frames) {
  constexpr int kMostSmoothings = 100;
  constexpr double kToleranceRad = 1e-3;
  const CubeGroup& group = CubeGroup::instance();
  const auto neighbours = neighbours_of(field);
  const std::vector<Held> held = held_axes(field);
  std::vector<std::uint32_t> place(frames.size(), UINT32_MAX);
  for (std::uint32_t k = 0; k < held.size(); ++k) place[held[k].tet] = k;
  std::array<Quaternion, CubeGroup::kCount> turns;
  for (std::uint8_t a = 0; a < CubeGroup::kCount; ++a) turns[a] = to_quaternion(group[a]);
  std::vector<Quaternion> next(frames.size());
  std::vector<double> cosines(frames.size());  // of half the angle by which each turned
  const double least_cosine = std::cos(0.5 * kToleranceRad);
  for (int sweep = 0; sweep < kMostSmoothings; ++sweep) {
    check_watched();
    parallel_for(frames.size(), [&](std::size_t t) {
      const Quaternion& own = frames[t];
      double weights = 0;
      Quaternion sum{0, 0, 0, 0};
      const auto add = [&](const Quaternion& q, double weight) {
        const double sign = q.w * own.w + q.x * own.x + q.y * own.y + q.z * own.z < 0 ? -weight : weight;
        sum = {sum.w + sign * q.w, sum.x + sign * q.x, sum.y + sign * q.y, sum.z + sign * q.z};
      };
      for (const Neighbour& neighbour : neighbours[t]) {
        if (neighbour.tet == UINT32_MAX) continue;
        add(frames[neighbour.tet] * turns[neighbour.turn], neighbour.weight);
        weights += neighbour.weight;
      }
      // Without itself the sweeps could swing between two fields.
      constexpr double kOwn = 0.5;
      add(own, weights > 0 ? kOwn * weights : 1);
      next[t] = normalised(sum);
      if (place[t] != UINT32_MAX) next[t] = on_faces(next[t], held[place[t]]);
      const double cosine = next[t].w * own.w + next[t].x * own.x + next[t].y * own.y + next[t].z * own.z;
      cosines[t] = std::abs(cosine);
    });
    frames.swap(next);
    if (*std::min_element(cosines.begin(), cosines.end()) > least_cosine) break;
  }
  return frames;
}

}  // namespace crossgrain

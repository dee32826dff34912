// SPDX-License-Identifier: Apache-2.0
#include "sampling/tet_walk.hpp"

#include <algorithm>
#include <utility>

namespace crossgrain {
namespace {

/// Step over a tet without volume, as a share of the segment and then ever larger by this factor.
constexpr double kFirstStep = 1e-12, kStepGrowth = 100, kLargestStep = 1e-3;

int face_without(const std::array<std::uint32_t, 4>& tet, const std::array<std::uint32_t, 3>& face) {
  for (int k = 0; k < 4; ++k)
    if (std::find(face.begin(), face.end(), tet[static_cast<std::size_t>(k)]) == face.end()) return k;
  return 0;
}

}  // namespace

TetWalk::TetWalk(const TetSolid& solid)
    : solid_(solid),
      finder_(solid.mesh.vertices, solid.mesh.tets),
      across_(solid.mesh.tets.size(), {kNoTet, kNoTet, kNoTet, kNoTet}) {
  for (const TetSolid::InnerFace& face : solid.inner_faces) {
    for (std::size_t side = 0; side < 2; ++side) {
      const std::uint32_t tet = face.tets[side], other = face.tets[1 - side];
      if (tet == kNoTet) continue;
      const int corner = face_without(solid.mesh.tets[tet], face.vertices);
      across_[tet][static_cast<std::size_t>(corner)] = other == kNoTet ? kFlatTet : other;
    }
  }
}

double TetWalk::height(std::uint32_t tet, int face, const Vector3& point) const {
  const auto& corners = kFaceCorners[static_cast<std::size_t>(face)];
  std::array<std::uint32_t, 3> v;
  for (std::size_t k = 0; k < 3; ++k) v[k] = solid_.mesh.tets[tet][corners[k]];
  // In ascending order, both tets at a face compute the same numbers.
  double sign = -1;
  const auto order = [&](std::size_t a, std::size_t b) {
    if (v[a] <= v[b]) return;
    std::swap(v[a], v[b]);
    sign = -sign;
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  const auto& vertices = solid_.mesh.vertices;
  const Vector3& a = vertices[v[0]];
  return sign * dot(cross(vertices[v[1]] - a, vertices[v[2]] - a), point - a);
}

std::uint32_t TetWalk::tet_at(const Vector3& point) const {
  for (const std::uint32_t tet : finder_.near(point)) {
    bool holds = true;
    for (int face = 0; face < 4 && holds; ++face) holds = height(tet, face, point) >= 0;
    if (holds) return tet;
  }
  return kNoTet;
}

std::array<double, 4> TetWalk::weights(std::uint32_t tet, const Vector3& point) const {
  std::array<double, 4> weights;
  double sum = 0;
  for (int face = 0; face < 4; ++face)
    sum += weights[static_cast<std::size_t>(face)] = height(tet, face, point);
  for (double& weight : weights) weight /= sum;
  return weights;
}

TetWalk::Exit TetWalk::exit_of(std::uint32_t tet, const Vector3& from, const Vector3& to) const {
  Exit exit;
  for (int face = 0; face < 4; ++face) {
    const double after = height(tet, face, to);
    if (!(after < 0)) continue;
    const double before = height(tet, face, from);
    const double share = before > 0 ? before / (before - after) : 0;
    if (exit.face < 0 || share < exit.share) exit = {face, share};
  }
  return exit;
}

std::uint32_t TetWalk::behind(std::uint32_t tet, int face, const Vector3& from, const Vector3& to,
                              double share) const {
  const std::uint32_t next = across_[tet][static_cast<std::size_t>(face)];
  if (next != kFlatTet) return next;
  for (double step = kFirstStep; step < kLargestStep; step *= kStepGrowth) {
    const std::uint32_t beyond = tet_at(from + std::min(1.0, share + step) * (to - from));
    if (beyond != tet && beyond != kNoTet) return beyond;
  }
  return kNoTet;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "fit/curve_wedges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>

#include "base/ascending.hpp"
#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

/// An edge of a triangle on a curve.
struct CurveSegment {
  std::array<std::uint32_t, 2> ends;  ///< ascending
  std::uint32_t curve, place;
};

std::vector<CurveSegment> segments_of(const FeatureComplex& features) {
  std::vector<CurveSegment> segments;
  for (std::uint32_t c = 0; c < features.curves.size(); ++c) {
    const auto& vertices = features.curves[c].vertices;
    for (std::uint32_t k = 0; k + 1 < vertices.size(); ++k)
      segments.push_back({ascending<2>({vertices[k], vertices[k + 1]}), c, k});
  }
  std::ranges::stable_sort(segments, {}, &CurveSegment::ends);
  return segments;
}

/// Of each side of a curve, at each of its segments, the direction of the face away from the curve.
using Directions = std::vector<std::vector<std::optional<Vector3>>>;

std::vector<Directions> directions_of(const FeatureComplex& features) {
  std::vector<Directions> directions(features.curves.size());
  for (std::size_t c = 0; c < directions.size(); ++c)
    directions[c].assign(features.curves[c].sides.size(),
                         std::vector<std::optional<Vector3>>(features.curves[c].vertices.size() - 1));
  const std::vector<CurveSegment> segments = segments_of(features);
  Checkpoint checkpoint;
  for (std::size_t t = 0; t < features.triangles.size(); ++t) {
    checkpoint.pass();
    const auto& triangle = features.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = triangle[k], b = triangle[(k + 1) % 3], other = triangle[(k + 2) % 3];
      const auto [first, last] =
          std::ranges::equal_range(segments, ascending<2>({a, b}), {}, &CurveSegment::ends);
      for (auto segment = first; segment != last; ++segment) {
        const FeatureComplex::Curve& curve = features.curves[segment->curve];
        const bool is_left = curve.vertices[segment->place] == a;
        const auto side = std::ranges::find(curve.sides, FeatureComplex::Side{features.face_of[t], is_left});
        if (side == curve.sides.end()) continue;
        const Vector3 along = normalised(features.vertices[b] - features.vertices[a]);
        const Vector3 away = features.vertices[other] - features.vertices[a];
        directions[segment->curve][static_cast<std::size_t>(side - curve.sides.begin())][segment->place] =
            away - dot(away, along) * along;
      }
    }
  }
  return directions;
}

/// From 0 to 2 pi, counter-clockwise around an axis of length 1.
double angle_around(const Vector3& axis, const Vector3& from, const Vector3& to) {
  const double angle = arc_tangent(dot(axis, cross(from, to)), dot(from, to));
  return angle > 0 ? angle : angle + 2 * std::numbers::pi;
}

/// Adds what the segments of a curve say.
void measure_wedge(const FeatureComplex& features, const FeatureComplex::Curve& curve,
                   const Directions& directions, CurveWedge& wedge) {
  double length = 0;
  for (std::size_t k = 0; k + 1 < curve.vertices.size(); ++k) {
    const auto &from = directions[wedge.from][k], &to = directions[wedge.to][k];
    if (!from || !to) continue;
    const Vector3 along = features.vertices[curve.vertices[k + 1]] - features.vertices[curve.vertices[k]];
    const double angle = angle_around(normalised(along), *from, *to);
    wedge.mean_rad += norm(along) * angle;
    wedge.most_rad = std::max(wedge.most_rad, angle);
    length += norm(along);
  }
  if (length > 0) wedge.mean_rad /= length;
}

}  // namespace

std::vector<std::vector<CurveWedge>> wedges_of_curves(const FeatureComplex& features) {
  const std::vector<Directions> directions = directions_of(features);
  std::vector<std::vector<CurveWedge>> wedges(features.curves.size());
  for (std::size_t c = 0; c < wedges.size(); ++c) {
    const FeatureComplex::Curve& curve = features.curves[c];
    const auto sides = static_cast<std::uint32_t>(curve.sides.size());
    for (std::uint32_t k = 0; sides > 1 && k < sides; ++k) {
      const auto& [face, is_left] = curve.sides[k];
      const std::int32_t solid = is_left ? features.faces[face].above : features.faces[face].below;
      if (solid == 0) continue;
      CurveWedge wedge{k, (k + 1) % sides, solid, 0, 0};
      measure_wedge(features, curve, directions[c], wedge);
      if (wedge.most_rad > 0) wedges[c].push_back(wedge);
    }
  }
  return wedges;
}

}  // namespace crossgrain

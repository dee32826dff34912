// SPDX-License-Identifier: Apache-2.0
#include "measure/feature_resolution.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/near_points.hpp"

namespace crossgrain {
namespace {

/// Samples along a curve in a size; their number bounds the memory where sizes are far below the model.
constexpr double kSamplesInSize = 8;
constexpr std::size_t kMostSamples = 4096;

/// Two places of one curve are crowded if they are this much farther apart along it.
constexpr double kOwnDetour = 1.5;

/// Pieces of a face's triangles along an edge, in a size.
constexpr double kPiecesInSize = 4;
constexpr int kMostPieces = 64;

struct CurveSample {
  std::uint32_t curve;
  double place;
};

class ResolutionFinder {
 public:
  ResolutionFinder(const FeatureComplex& complex, const std::vector<MeasuredCurve>& lines, double size)
      : complex_(complex), lines_(lines), size_(size), counts_(lines.size()) {
    for (std::uint32_t c = 0; c < lines.size(); ++c) {
      const double wanted = std::ceil(kSamplesInSize * lines[c].length() / size);
      counts_[c] = static_cast<std::size_t>(std::clamp(wanted, 1.0, 1.0 * kMostSamples));
      first_.push_back(samples_.size());
      for (std::size_t k = 0; k < counts_[c]; ++k) {
        const double place =
            (static_cast<double>(k) + 0.5) / static_cast<double>(counts_[c]) * lines[c].length();
        samples_.push_back({c, place});
        points_.push_back(lines[c].at(place));
      }
    }
    is_hard_corner_.assign(complex.corners.size(), 0);
    for (std::size_t k = 0; k < complex.corners.size(); ++k) {
      const auto& ends = complex.corners[k].ends;
      is_hard_corner_[k] = ends.empty() || std::ranges::any_of(ends, [&](const auto& end) {
                             return !complex.curves[end.curve].is_soft;
                           });
    }
  }

  FeatureResolution find() const {
    FeatureResolution result;
    const NearPoints near(points_, size_);
    result.curves.resize(lines_.size());
    parallel_for(
        lines_.size(), [&](std::size_t c) { result.curves[c] = of_curve(c, near); }, 1);
    std::vector<Vector3> corners;
    for (const auto& corner : complex_.corners) corners.push_back(corner.point);
    const NearPoints near_corners(corners, size_);
    result.corners.resize(corners.size());
    parallel_for(
        corners.size(), [&](std::size_t k) { result.corners[k] = of_corner(k, near, near_corners); }, 16);
    result.faces.resize(complex_.faces.size());
    parallel_for(
        complex_.faces.size(), [&](std::size_t f) { result.faces[f] = of_face(f); }, 1);
    return result;
  }

 private:
  /// Distance along a curve from a place to a corner at its ends; infinite if it does not end there.
  double way_to(const CurveSample& sample, std::uint32_t corner) const {
    const auto& corners = complex_.curves[sample.curve].corners;
    double way = INFINITY;
    if (corners[0] == corner) way = sample.place;
    if (corners[1] == corner) way = std::min(way, lines_[sample.curve].length() - sample.place);
    return way;
  }

  bool is_joined(const CurveSample& a, const CurveSample& b) const {
    for (const std::uint32_t corner : complex_.curves[a.curve].corners) {
      if (corner != FeatureComplex::kNone && way_to(a, corner) <= kCornerReach * size_ &&
          way_to(b, corner) <= kCornerReach * size_)
        return true;
    }
    return false;
  }

  bool is_crowded_by(const CurveSample& a, const CurveSample& b, double distance) const {
    if (complex_.curves[b.curve].is_soft) return false;
    if (a.curve != b.curve) return !is_joined(a, b);
    double along = std::abs(a.place - b.place);
    const MeasuredCurve& line = lines_[a.curve];
    if (line.is_closed()) along = std::min(along, line.length() - along);
    return along > size_ && along > kOwnDetour * distance && !is_joined(a, b);
  }

  /// Distance of the nearest curve that crowds a sample; infinite without.
  double nearest_crowding(std::size_t s, const NearPoints& near) const {
    double least = INFINITY;
    near.for_each_near(points_[s], [&](std::uint32_t other, double square) {
      if (square < least * least && is_crowded_by(samples_[s], samples_[other], std::sqrt(square)))
        least = std::sqrt(square);
    });
    return least;
  }

  Resolution of_curve(std::size_t c, const NearPoints& near) const {
    const MeasuredCurve& line = lines_[c];
    Resolution result;
    result.place = line.at(line.length() / 2);
    const double least = (line.is_closed() ? kLeastLengthAround : kLeastLength);
    if (line.length() < least * size_) {
      result.is_resolved = false;
      result.size_to_show = line.length() / least;
    }
    const double step = line.length() / static_cast<double>(counts_[c]);
    double stretch = 0, longest = 0, all = 0, nearest = INFINITY;
    Vector3 place = result.place;
    for (std::size_t k = 0; k < counts_[c]; ++k) {
      const double distance = nearest_crowding(first_[c] + k, near);
      stretch = distance < INFINITY ? stretch + step : 0;
      longest = std::max(longest, stretch);
      if (distance == INFINITY) continue;
      all += step;
      if (distance >= nearest) continue;
      nearest = distance;
      place = points_[first_[c] + k];
    }
    if (longest < size_ && all < 0.5 * line.length()) return result;
    result.place = place;
    result.size_to_show = result.is_resolved ? nearest : std::min(result.size_to_show, nearest);
    result.is_resolved = false;
    return result;
  }

  Resolution of_corner(std::size_t k, const NearPoints& near, const NearPoints& near_corners) const {
    const FeatureComplex::Corner& corner = complex_.corners[k];
    double square_of_nearest = INFINITY;
    near_corners.for_each_near(corner.point, [&](std::uint32_t other, double square) {
      if (other != k && is_hard_corner_[other]) square_of_nearest = std::min(square_of_nearest, square);
    });
    near.for_each_near(corner.point, [&](std::uint32_t s, double square) {
      const FeatureComplex::Curve& curve = complex_.curves[samples_[s].curve];
      const bool ends_here = std::ranges::find(curve.corners, k) != curve.corners.end();
      if (!curve.is_soft && !ends_here) square_of_nearest = std::min(square_of_nearest, square);
    });
    if (square_of_nearest == INFINITY) return {true, 0, corner.point};
    return {false, std::sqrt(square_of_nearest), corner.point};
  }

  double distance_to_curves(const Vector3& point, std::span<const std::uint32_t> curves) const {
    double least = INFINITY;
    for (const std::uint32_t c : curves) least = std::min(least, lines_[c].nearest(point, least).distance);
    return least;
  }

  Resolution of_face(std::size_t f) const {
    const FeatureComplex::Face& face = complex_.faces[f];
    std::vector<std::uint32_t> curves;
    for (std::uint32_t c = 0; c < complex_.curves.size(); ++c) {
      if (std::ranges::any_of(complex_.curves[c].sides, [&](const auto& side) { return side.face == f; }))
        curves.push_back(c);
    }
    Box box = empty_box();
    for (const std::uint32_t t : face.triangles)
      for (const Vector3& point : complex_.points_of(t)) include(box, point);
    const double extent = norm(box.high - box.low);
    double widest = 0;
    Vector3 place = complex_.vertices[complex_.triangles[face.triangles[0]][0]];
    for (const std::uint32_t t : face.triangles) {
      if (widest >= 0.5 * size_) break;
      const auto [a, b, c] = complex_.points_of(t);
      const double edge = std::sqrt(std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)}));
      const int pieces =
          static_cast<int>(std::clamp(std::ceil(kPiecesInSize * edge / size_), 2.0, 1.0 * kMostPieces));
      for (int i = 0; i <= pieces; ++i) {
        for (int j = 0; i + j <= pieces; ++j) {
          const Vector3 point = a + (1.0 * i / pieces) * (b - a) + (1.0 * j / pieces) * (c - a);
          const double distance = curves.empty() ? extent : distance_to_curves(point, curves);
          if (distance <= widest) continue;
          widest = distance;
          place = point;
        }
      }
    }
    if (widest >= 0.5 * size_ && extent >= kLeastLength * size_) return {true, 0, place};
    return {false, std::min(2 * widest, extent / kLeastLength), place};
  }

  const FeatureComplex& complex_;
  const std::vector<MeasuredCurve>& lines_;
  const double size_;
  std::vector<std::size_t> counts_, first_;  ///< of the samples of each curve
  std::vector<CurveSample> samples_;
  std::vector<Vector3> points_;
  std::vector<std::uint8_t> is_hard_corner_;
};

}  // namespace

FeatureResolution feature_resolution(const FeatureComplex& complex, const std::vector<MeasuredCurve>& lines,
                                     double size) {
  return ResolutionFinder(complex, lines, size).find();
}

}  // namespace crossgrain

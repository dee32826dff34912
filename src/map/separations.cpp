// SPDX-License-Identifier: Apache-2.0
#include "map/separations.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "base/parallel.hpp"
#include "map/line_separations.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using Index = Eigen::Index;

/// A ray and the plane of the grid that it left, in the names of the tet where it is.
struct Ray {
  std::uint32_t tet;
  Eigen::Vector3d at;
  std::size_t axis;
  int sign;          ///< along the axis or against it
  LinearForm start;  ///< coordinate along the axis
};

/// How far beside its start a ray begins, towards the inside of its first tet: on an edge it has none.
constexpr double kInside = 1e-4;

class RayWalk {
 public:
  RayWalk(const MapUnknowns& unknowns, const Eigen::VectorXd& columns, const MapCoordinates& map)
      : unknowns_(unknowns),
        cut_(unknowns.cut()),
        columns_(columns),
        map_(map),
        beside_(crossings_of(cut_.field().complex().solid())) {
    const TetSolid& solid = cut_.field().complex().solid();
    surface_.resize(solid.mesh.tets.size());
    for (auto& faces : surface_) faces.fill(kNoFace);
    for (std::uint32_t f = 0; f < solid.boundary.size(); ++f)
      surface_[solid.boundary_tets[f]][opposite(solid.boundary_tets[f], solid.boundary[f])] = f;
  }

  Eigen::Vector3d corner(std::uint32_t tet, std::size_t corner) const {
    return map_.segment<3>(static_cast<Index>(3 * cut_.copy_of(tet, corner)));
  }

  std::size_t opposite(std::uint32_t tet, const std::array<std::uint32_t, 3>& face) const {
    return corner_opposite(cut_.field().complex().solid().mesh.tets[tet], face);
  }

  /// The distance to the face of the surface that a ray reaches; none if it is lost.
  std::optional<LinearForm> distance(Ray ray) const {
    constexpr int kMostTets = 4000;
    std::size_t entered = 4;  // corner opposite the face through which it came
    for (int k = 0; k < kMostTets; ++k) {
      const std::size_t leaving = exit(ray, entered);
      if (leaving == 4) return std::nullopt;
      const Crossing crossing = beside_[ray.tet][leaving];
      if (crossing.face == kNoFace) return distance_to_surface(ray, leaving);
      const std::uint32_t next =
          cut_.field().complex().solid().inner_faces[crossing.face].tets[crossing.reversed ? 0 : 1];
      cross_sheet(ray, cut_.step_across(crossing));
      ray.tet = next;
      entered = opposite(next, cut_.field().complex().solid().inner_faces[crossing.face].vertices);
    }
    return std::nullopt;
  }

 private:
  /// Takes a ray to the face through which it leaves its tet, and returns the corner opposite; 4 if the tet
  /// is flipped.
  std::size_t exit(Ray& ray, std::size_t entered) const {
    Eigen::Matrix3d edges;
    for (std::size_t k = 0; k < 3; ++k)
      edges.col(static_cast<Index>(k)) = corner(ray.tet, k + 1) - corner(ray.tet, 0);
    if (edges.determinant() <= 0) return 4;
    const Eigen::Matrix3d inverse = edges.inverse();
    const Eigen::Vector3d inner = inverse * (ray.at - corner(ray.tet, 0));
    const Eigen::Vector3d change = ray.sign * inverse.col(static_cast<Index>(ray.axis));
    const std::array<double, 4> weights{1 - inner.sum(), inner[0], inner[1], inner[2]};
    const std::array<double, 4> changes{-change.sum(), change[0], change[1], change[2]};
    double least = INFINITY;
    std::size_t leaving = 4;
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == entered || changes[k] >= 0) continue;
      const double length = std::max(0.0, weights[k]) / -changes[k];
      if (length < least) least = length, leaving = k;
    }
    if (leaving < 4) ray.at[static_cast<Index>(ray.axis)] += ray.sign * least;
    return leaving;
  }

  std::optional<LinearForm> distance_to_surface(const Ray& ray, std::size_t leaving) const {
    const std::uint32_t face = surface_[ray.tet][leaving];
    if (face == kNoFace || unknowns_.normal_axis(face) % 3 != ray.axis) return std::nullopt;
    const LinearForm& there = unknowns_.point(cut_.copy_of(ray.tet, (leaving + 1) % 4))[ray.axis];
    return multiplied(added(there, ray.start, -1), ray.sign);
  }

  /// u' = R u + T along the direction of a sheet, u' = R^-1 (u - T) against it.
  void cross_sheet(Ray& ray, SheetStep step) const {
    if (step == 0) return;
    const auto sheet = static_cast<std::size_t>(std::abs(step) - 1);
    const CubeGroup& group = CubeGroup::instance();
    const MapPoint& translation = unknowns_.translation(sheet);
    Eigen::Vector3d shift;
    for (std::size_t k = 0; k < 3; ++k) shift[static_cast<Index>(k)] = value_of(translation[k], columns_);
    const bool along = step > 0;
    const std::uint8_t rotation = along ? cut_.rotation(sheet) : group.inverse_of(cut_.rotation(sheet));
    if (!along) {
      ray.at -= shift;
      ray.start = added(ray.start, translation[ray.axis], -1);
    }
    ray.at = turned(rotation, ray.at);
    const SignedAxis image = group.image(rotation, static_cast<SignedAxis>(ray.axis));
    if (image >= 3) {
      ray.sign = -ray.sign;
      ray.start = -ray.start;
    }
    ray.axis = image % 3;
    if (along) {
      ray.at += shift;
      ray.start = added(ray.start, translation[ray.axis]);
    }
  }

  const MapUnknowns& unknowns_;
  const CutSolid& cut_;
  const Eigen::VectorXd& columns_;
  const MapCoordinates& map_;
  std::vector<std::array<Crossing, 4>> beside_;        ///< the face opposite each corner of a tet
  std::vector<std::array<std::uint32_t, 4>> surface_;  ///< the same on the surface
};

std::vector<Ray> rays_from_surface(const MapUnknowns& unknowns, const RayWalk& walk) {
  const CutSolid& cut = unknowns.cut();
  const TetSolid& solid = cut.field().complex().solid();
  std::vector<Ray> rays;
  for (std::uint32_t f = 0; f < solid.boundary.size(); ++f) {
    const std::uint32_t tet = solid.boundary_tets[f];
    const std::size_t apex = walk.opposite(tet, solid.boundary[f]), axis = unknowns.normal_axis(f) % 3;
    Eigen::Vector3d middle{0, 0, 0};
    for (std::size_t k = 1; k < 4; ++k) middle += walk.corner(tet, (apex + k) % 4) / 3;
    const Eigen::Vector3d inwards = walk.corner(tet, apex) - middle;
    rays.push_back({tet, middle + kInside * inwards, axis, inwards[static_cast<Index>(axis)] > 0 ? 1 : -1,
                    unknowns.point(cut.copy_of(tet, (apex + 1) % 4))[axis]});
  }
  return rays;
}

/// In all tets around singular edges, both ways along the two axes across.
std::vector<Ray> rays_from_arcs(const MapUnknowns& unknowns, const RayWalk& walk) {
  const CutSolid& cut = unknowns.cut();
  const TetComplex& complex = cut.field().complex();
  const TetSolid& solid = complex.solid();
  std::vector<Ray> rays;
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    if (!cut.is_singular(e)) continue;
    for (const Crossing& crossing : complex.around(e)) {
      const std::uint32_t tet = solid.inner_faces[crossing.face].tets[crossing.reversed ? 1 : 0];
      std::array<std::size_t, 2> ends{};
      for (std::size_t k = 0; k < 2; ++k)
        ends[k] = corner_of(solid.mesh.tets[tet], complex.edges()[e].ends[k]);
      Eigen::Vector3d centre{0, 0, 0};
      for (std::size_t k = 0; k < 4; ++k) centre += walk.corner(tet, k) / 4;
      const Eigen::Vector3d middle = 0.5 * (walk.corner(tet, ends[0]) + walk.corner(tet, ends[1]));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const LinearForm& one = unknowns.point(cut.copy_of(tet, ends[0]))[axis];
        if (!unknowns.is_integer(one) || one != unknowns.point(cut.copy_of(tet, ends[1]))[axis]) continue;
        for (const int sign : {-1, 1})
          rays.push_back({tet, middle + kInside * (centre - middle), axis, sign, one});
      }
    }
  }
  return rays;
}

}  // namespace

Separations separations_of(const MapUnknowns& unknowns, const Eigen::VectorXd& columns,
                           const MapCoordinates& map) {
  const RayWalk walk(unknowns, columns, map);
  std::vector<Ray> rays = rays_from_surface(unknowns, walk);
  for (Ray& ray : rays_from_arcs(unknowns, walk)) rays.push_back(std::move(ray));
  std::vector<std::optional<LinearForm>> distances(rays.size());
  parallel_for(rays.size(), [&](std::size_t k) { distances[k] = walk.distance(rays[k]); });
  const auto less = [](const LinearForm& a, const LinearForm& b) {
    return std::lexicographical_compare(
        a.terms.begin(), a.terms.end(), b.terms.begin(), b.terms.end(), [](const auto& s, const auto& t) {
          return std::pair(s.unknown, s.factor) < std::pair(t.unknown, t.factor);
        });
  };
  std::set<LinearForm, decltype(less)> known(less);
  Separations separations;
  const auto add = [&](const LinearForm& distance) {
    if (!distance.is_zero() && unknowns.is_integer(distance) && known.insert(distance).second)
      separations.push_back(distance);
  };
  for (const std::optional<LinearForm>& distance : distances)
    if (distance) add(*distance);
  for (const LinearForm& length : line_lengths(unknowns, columns)) add(length);
  for (const LinearForm& gap : line_gaps(unknowns, columns, map)) add(gap);
  return separations;
}

}  // namespace crossgrain

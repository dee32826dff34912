// SPDX-License-Identifier: Apache-2.0
#include "hex/lattice_faults.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/feature_fit.hpp"
#include "hex/model_fit.hpp"
#include "measure/hex_quality.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {
namespace {

/// A place, and the normal of the model's surface there; zero of edges and inside.
struct Fault {
  Vector3 place, normal{};
};

Fault nearest_on(const Surface& model, const TriangleBvh& tree, const Vector3& point) {
  return {point, model.normals[tree.nearest(point).triangle]};
}

/// Adds the points of a list that are farther from a surface than a distance.
void add_far_points(const TriangleBvh& surface, const std::vector<Vector3>& points, double distance,
                    std::vector<Vector3>& far) {
  std::vector<std::uint8_t> is_far(points.size());
  parallel_for(points.size(), [&](std::size_t k) {
    is_far[k] = surface.nearest(points[k]).squared_distance > distance * distance;
  });
  for (std::size_t k = 0; k < points.size(); ++k)
    if (is_far[k]) far.push_back(points[k]);
}

std::vector<Fault> faults_of(const HexMesh& mesh, const HexFeatures& features, const Surface& model,
                             double size) {
  std::vector<Fault> faults;
  const std::vector<double> shapes = scaled_jacobians(mesh);
  for (std::size_t h = 0; h < shapes.size(); ++h)
    if (shapes[h] < kGoodShape) faults.push_back({centre_of(mesh, h)});
  const std::vector<Vector3> of_model = points_on(model.mesh.vertices, model.mesh.triangles);
  std::vector<Vector3> far;
  for (const HexFeatures::Lack& lack : features.lacking)
    if (lack.kind < HexLackKind::kOffModel) faults.push_back({lack.place});
  TriangleMesh skin = surface_triangles(mesh);
  const TriangleBvh tree(model);
  add_far_points(tree, points_on(skin.vertices, skin.triangles), kFarOff * size, far);
  const Surface surface = prepare_surface(CheckedMesh::derived(std::move(skin)));
  add_far_points(TriangleBvh(surface), of_model, kFarOff * size, far);
  for (const Vector3& point : far) faults.push_back(nearest_on(model, tree, point));
  return faults;
}

}  // namespace

std::vector<FinePlace> places_to_refine(const HexMesh& mesh, const HexReport& report, const Surface& model,
                                        double size, const std::vector<FinePlace>& earlier) {
  if (!report.features) return {};
  const std::vector<Fault> faults = faults_of(mesh, *report.features, model, report.size);
  if (faults.empty()) return {};
  // Without the earlier ones their faults would come back.
  std::vector<FinePlace> fine = earlier;
  for (const Fault& fault : faults) {
    double here = size;
    for (const FinePlace& other : earlier)
      if (norm(other.at - fault.place) < 2 * other.size) here = std::min(here, other.size);
    const double finer = kFinerSize * here;
    // One of several places that are near to each other, and have the same normal, is enough.
    const auto is_like = [&](const FinePlace& other) {
      return other.size <= finer && norm(other.at - fault.place) < 0.5 * finer &&
             norm(other.normal - fault.normal) < kLeastAcross;
    };
    if (std::ranges::none_of(fine, is_like)) fine.push_back({fault.place, finer, fault.normal});
  }
  return fine;
}

}  // namespace crossgrain

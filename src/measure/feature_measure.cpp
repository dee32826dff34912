// SPDX-License-Identifier: Apache-2.0
#include "measure/feature_measure.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "measure/hex_quality.hpp"
#include "measure/surface_quads.hpp"
#include "surface/shells.hpp"

namespace crossgrain {
namespace {

/// Volumes of the solids of a complex by their numbers; none if an open curve leaves some open.
std::map<std::int32_t, double> volumes_of_solids(const FeatureComplex& complex) {
  std::map<std::int32_t, double> volumes;
  for (const auto& curve : complex.curves)
    if (curve.sides.size() == 1) return volumes;
  if (complex.triangles.empty()) return volumes;
  const Vector3& origin = complex.vertices[complex.triangles[0][0]];
  for (std::size_t t = 0; t < complex.triangles.size(); ++t) {
    const auto [a, b, c] = complex.points_of(t);
    const double volume = dot(a - origin, cross(b - origin, c - origin)) / 6;
    const FeatureComplex::Face& face = complex.faces[complex.face_of[t]];
    volumes[face.below] += volume;
    if (face.above != 0) volumes[face.above] -= volume;
  }
  return volumes;
}

class FeatureMeasurer {
 public:
  FeatureMeasurer(const HexMesh& mesh, const FeatureComplex& complex, double size)
      : mesh_(mesh),
        complex_(complex),
        solids_(solids_in(mesh, complex)),
        quads_(surface_quads(mesh, solids_)),
        edges_(edges_of_quads(quads_)),
        tolerance_(kKeptWithin * size) {
    result_.size = size;
    for (const auto& curve : complex.curves) lines_.emplace_back(complex, curve);
  }

  FeatureMeasure measure(const FeaturePlaces* given) {
    const FeatureTrees trees(complex_);
    result_.resolution = feature_resolution(complex_, lines_, result_.size);
    FeaturePlaces found;
    std::vector<CurveShare> loose_shares;
    if (given == nullptr) {
      found = found_places(mesh_, quads_, complex_, lines_, tolerance_, loose_shares);
      found.face_of_quad = faces_near(trees);
    }
    const FeaturePlaces& places = given ? *given : found;
    const std::vector<std::uint32_t> nearest_faces = given ? faces_near(trees) : found.face_of_quad;
    measure_corners(places);
    measure_curves(places, loose_shares);
    measure_faces(places, nearest_faces);
    const std::vector<double> cut_off = cut_off_by_quads(mesh_, quads_, nearest_faces, trees);
    result_.distances = surface_distances(mesh_, quads_, cut_off, complex_, trees, result_.size);
    judge_distances(result_.distances.of_mesh, FeatureMeasure::Kind::kOffModel);
    judge_distances(result_.distances.of_model, FeatureMeasure::Kind::kOffMesh);
    measure_volumes();
    measure_shells();
    return std::move(result_);
  }

 private:
  using Kind = FeatureMeasure::Kind;
  using Lack = FeatureMeasure::Lack;

  /// Counts a feature as kept or not, and lists it.
  void judge(const Resolution& resolution, bool is_kept, FeatureMeasure::Kept& kept, Lack lack) {
    if (!resolution.is_resolved) {
      lack.size_to_show = resolution.size_to_show;
      ++result_.small[static_cast<std::size_t>(lack.kind)];
      if (!is_kept) result_.too_small.push_back(lack);
      return;
    }
    kept.all += 1;
    kept.kept += is_kept;
    if (!is_kept) result_.lacking.push_back(lack);
  }

  void measure_corners(const FeaturePlaces& places) {
    for (std::uint32_t k = 0; k < complex_.corners.size(); ++k) {
      const FeatureComplex::Corner& corner = complex_.corners[k];
      const std::uint32_t vertex = places.vertex_of_corner[k];
      const double distance = vertex == FeatureComplex::kNone
                                  ? INFINITY
                                  : norm(mesh_.vertices[vertex] - corner.point) / result_.size;
      result_.corner_distances.push_back(distance);
      const bool is_soft = !corner.ends.empty() && std::ranges::all_of(corner.ends, [&](const auto& end) {
        return complex_.curves[end.curve].is_soft;
      });
      if (is_soft) continue;
      judge(result_.resolution.corners[k], distance <= kKeptWithin, result_.corners,
            {Kind::kCorner, k, 0, corner.point, distance, 0, 0});
    }
  }

  void measure_curves(const FeaturePlaces& places, const std::vector<CurveShare>& loose_shares) {
    std::vector<CurveShare>& shares = result_.curve_shares;
    shares.resize(lines_.size());
    parallel_for(
        lines_.size(),
        [&](std::size_t c) {
          const std::vector<std::uint32_t>& path = places.path_of_curve[c];
          shares[c] = path.empty() && !loose_shares.empty()
                          ? loose_shares[c]
                          : share_kept(lines_[c], path, edges_, mesh_.vertices, tolerance_);
        },
        1);
    for (std::uint32_t c = 0; c < lines_.size(); ++c) {
      const FeatureComplex::Curve& curve = complex_.curves[c];
      const double share = lines_[c].length() > 0 ? shares[c].kept / lines_[c].length() : 1;
      const bool is_kept = shares[c].is_whole && share >= kWhole;
      if (curve.is_soft) {
        ++result_.soft_curves;
        result_.soft_curves_kept += is_kept;
        continue;
      }
      if (result_.resolution.curves[c].is_resolved) {
        result_.curve_length.all += lines_[c].length();
        result_.curve_length.kept += shares[c].kept;
      }
      judge(result_.resolution.curves[c], is_kept, result_.curves,
            {Kind::kCurve, c, curve.tag, shares[c].place, shares[c].farthest / result_.size, share, 0});
    }
  }

  std::vector<std::uint32_t> faces_near(const FeatureTrees& trees) const {
    std::vector<std::uint32_t> faces(quads_.size());
    parallel_for(quads_.size(), [&](std::size_t q) {
      Vector3 centre{0, 0, 0};
      for (const std::uint32_t v : quads_[q].vertices) centre += 0.25 * mesh_.vertices[v];
      faces[q] = trees.nearest_face(centre, quads_[q].below, quads_[q].above);
    });
    return faces;
  }

  /// Faces that are one on the mesh, since soft curves between them have no path.
  DisjointSets united_faces(const FeaturePlaces& places) const {
    DisjointSets united(complex_.faces.size());
    for (std::size_t c = 0; c < lines_.size(); ++c) {
      if (!complex_.curves[c].is_soft || !places.path_of_curve[c].empty()) continue;
      for (const auto& side : complex_.curves[c].sides)
        united.join(complex_.curves[c].sides[0].face, side.face);
    }
    return united;
  }

  void measure_faces(const FeaturePlaces& places, const std::vector<std::uint32_t>& nearest_faces) {
    DisjointSets united = united_faces(places);
    result_.quads_of_faces.assign(complex_.faces.size(), 0);
    for (std::size_t q = 0; q < quads_.size(); ++q) {
      const std::uint32_t f = places.face_of_quad[q], nearest = nearest_faces[q];
      if (f != FeatureComplex::kNone)
        ++result_.quads_of_faces[united.root(f) == united.root(nearest) ? nearest : f];
    }
    for (std::uint32_t f = 0; f < complex_.faces.size(); ++f) {
      const Resolution& resolution = result_.resolution.faces[f];
      judge(resolution, result_.quads_of_faces[f] > 0, result_.faces,
            {Kind::kFace, f, complex_.faces[f].number, resolution.place, 0, 0, 0});
    }
  }

  void judge_distances(const DistanceFigures& figures, Kind kind) {
    if (figures.percentile_99 <= kMostOff99 && figures.largest <= kMostOff &&
        figures.largest_in_all <= kMostOffInAll)
      return;
    result_.lacking.push_back({kind, 0, 0, figures.place_in_all, figures.largest_in_all, 0, 0});
  }

  void measure_volumes() {
    std::map<std::int32_t, double> meshed;
    std::map<std::int32_t, Vector3> places;
    const std::vector<double> volumes = volumes_of(mesh_);
    for (std::size_t h = 0; h < volumes.size(); ++h) {
      meshed[solids_[h]] += volumes[h];
      places.try_emplace(solids_[h], centre_of(mesh_, h));
    }
    for (const auto& [solid, volume] : volumes_of_solids(complex_)) {
      if (!(volume > 0)) continue;
      const double ratio = meshed[solid] / volume;
      if (std::abs(ratio - 1) > std::abs(result_.volume_ratio - 1)) result_.volume_ratio = ratio;
      if (std::abs(ratio - 1) > kMostVolumeOff)
        result_.lacking.push_back(
            {Kind::kVolume, static_cast<std::uint32_t>(solid), 0, places[solid], ratio, 0, 0});
    }
  }

  void measure_shells() {
    std::vector<std::array<std::uint32_t, 3>> of_mesh, of_model;
    for (const SurfaceQuad& quad : quads_) {
      const auto& [a, b, c, d] = quad.vertices;
      if (quad.above == 0) of_mesh.insert(of_mesh.end(), {{a, b, c}, {a, c, d}});
    }
    for (std::size_t t = 0; t < complex_.triangles.size(); ++t)
      if (complex_.faces[complex_.face_of[t]].above == 0) of_model.push_back(complex_.triangles[t]);
    result_.shells = euler_numbers_of_shells(of_mesh);
    result_.model_shells = euler_numbers_of_shells(of_model);
  }

  const HexMesh& mesh_;
  const FeatureComplex& complex_;
  const std::vector<std::int32_t> solids_;
  const std::vector<SurfaceQuad> quads_;
  const std::vector<std::array<std::uint32_t, 2>> edges_;
  const double tolerance_;
  std::vector<MeasuredCurve> lines_;
  FeatureMeasure result_;
};

}  // namespace

std::vector<std::int32_t> solids_in(const HexMesh& mesh, const FeatureComplex& complex) {
  std::vector<std::int32_t> solids(mesh.hexahedra.size(), complex.faces.empty() ? 1 : complex.faces[0].below);
  const bool is_one = std::ranges::all_of(complex.faces, [&](const FeatureComplex::Face& face) {
    return face.above == 0 && face.below == complex.faces[0].below;
  });
  if (is_one || mesh.regions.empty()) return solids;
  for (std::size_t h = 0; h < solids.size(); ++h) solids[h] = mesh.regions[h] + 1;
  return solids;
}

FeatureMeasure feature_measure(const HexMesh& mesh, const FeatureComplex& complex, double size,
                               const FeaturePlaces* places) {
  if (complex.triangles.empty()) {
    FeatureMeasure nothing;
    nothing.size = size;
    return nothing;
  }
  return FeatureMeasurer(mesh, complex, size).measure(places);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "hex/candidate_fitting.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "hex/feature_judgement.hpp"
#include "hex/field_mapping.hpp"
#include "hex/hex_report.hpp"
#include "hex/solid_judgement.hpp"
#include "hex/surface_feet.hpp"
#include "hex/work.hpp"
#include "surface/model_faces.hpp"

namespace crossgrain {
namespace {

/// Fitting does not untangle meshes of which a larger share is inverted: their map is folded there.
constexpr double kMostInvertedShare = 0.05;

bool is_one_region(const HexMesh& mesh) {
  return std::ranges::all_of(mesh.regions, [&](std::int32_t region) { return region == mesh.regions[0]; });
}

}  // namespace

void add_tags(HexCandidate& candidate) {
  const FollowedField& followed = *candidate.followed;
  const TetSolid& solid = followed.solid();
  const std::vector<Foot>& feet = candidate.following->feet;
  HexMesh& mesh = candidate.made->mesh;
  mesh.unit = followed.field().domain().mesh().unit;
  mesh.regions.clear();
  if (!solid.mesh.regions.empty())
    for (const std::uint32_t tet : candidate.following->extracted.centre_tets)
      mesh.regions.push_back(solid.mesh.regions[tet]);
  const std::vector<std::int32_t> tags = tags_of_faces(solid.mesh, solid.boundary);
  if (tags.empty()) return;
  const MapSurface surface(followed.matched());
  for (HexMesh::Face& face : mesh.boundary) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : face.vertices) centre += 0.25 * mesh.vertices[v];
    const auto of_face = std::find_if(face.vertices.begin(), face.vertices.end(),
                                      [&](std::uint32_t v) { return feet[v].kind == Foot::Kind::kFace; });
    const MapSurface::Place place = of_face == face.vertices.end() ? surface.nearest_of_all(centre)
                                                                   : surface.nearest(feet[*of_face], centre);
    face.tag = tags[place.face];
  }
}

void fit(HexCandidate& candidate) {
  const FollowedField& followed = *candidate.followed;
  add_tags(candidate);
  HexMesh& mesh = candidate.made->mesh;
  if (!is_one_region(mesh) || !body_contacts(followed.solid()).empty()) return;
  const FeatureComplex features = features_of_model(followed.field().domain());
  if (features.faces.size() > kMostListedFaces) return;
  FeatureFit fitted = fitted_to_features(mesh, features, {candidate.attempt.size, candidate.asked_size});
  mesh = std::move(fitted.best.mesh);
  fitted.best.mesh = {};
  candidate.made->quality = quality_of(mesh);
  candidate.made->is_faithful = fitted.best.measure.is_faithful();
  candidate.attempt.hexahedra = mesh.hexahedra.size();
  candidate.fit = std::make_shared<const FeatureFit>(std::move(fitted));
}

void fit_if_complete(HexCandidate& candidate) {
  if (!candidate.made || !candidate.made->are_complete() || candidate.fit) return;
  Stopwatch stopwatch;
  const auto all = static_cast<double>(candidate.made->mesh.hexahedra.size());
  fit(candidate);
  if (candidate.fit) candidate.attempt.work += kFittingWork * all;
  candidate.seconds.smoothing += stopwatch.restart();
}

void mend_by_fitting(HexCandidate& candidate) {
  Stopwatch stopwatch;
  const MadeHexahedra& as_mapped = *candidate.made;
  const auto all = static_cast<double>(as_mapped.mesh.hexahedra.size());
  const auto inverted = static_cast<double>(as_mapped.quality.inverted);
  if (!as_mapped.fills || inverted == 0 || inverted > kMostInvertedShare * all) return;
  HexCandidate fitted = candidate;
  fit(fitted);
  if (fitted.fit) candidate.attempt.work += kFittingWork * all;
  if (fitted.fit && fitted.fit->best.invalid == 0) {
    candidate.made = std::move(fitted.made);
    candidate.fit = std::move(fitted.fit);
  }
  candidate.attempt.hexahedra = candidate.made->mesh.hexahedra.size();
  candidate.seconds.smoothing += stopwatch.restart();
}

}  // namespace crossgrain

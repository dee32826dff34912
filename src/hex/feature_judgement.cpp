// SPDX-License-Identifier: Apache-2.0
#include "hex/feature_judgement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "hex/hex_report.hpp"
#include "hex/model_fit.hpp"
#include "solve/tet_domain_data.hpp"
#include "surface/model_faces.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// Figure of what has nothing near it.
constexpr double kNowhere = -1;

HexLackKind kind_of(FeatureMeasure::Kind kind) {
  switch (kind) {
    case FeatureMeasure::Kind::kCorner:
      return HexLackKind::kCorner;
    case FeatureMeasure::Kind::kCurve:
      return HexLackKind::kCrease;
    case FeatureMeasure::Kind::kFace:
      return HexLackKind::kFace;
    case FeatureMeasure::Kind::kOffModel:
      return HexLackKind::kOffModel;
    case FeatureMeasure::Kind::kOffMesh:
      return HexLackKind::kOffMesh;
    default:
      return HexLackKind::kVolume;
  }
}

/// Without volumes: the report has those of the model as given, which are exact for CAD models.
std::vector<HexFeatures::Lack> lacks_in(const std::vector<FeatureMeasure::Lack>& measured) {
  std::vector<HexFeatures::Lack> lacks;
  for (const FeatureMeasure::Lack& lack : measured) {
    if (lack.kind == FeatureMeasure::Kind::kVolume) continue;
    const double figure = std::isfinite(lack.figure) ? lack.figure : kNowhere;
    lacks.push_back({kind_of(lack.kind), lack.number, lack.place, figure, lack.share, lack.size_to_show});
  }
  return lacks;
}

HexFeatures::Distances distances_in(const DistanceFigures& figures) {
  return {figures.percentile_99, figures.largest, figures.place, figures.largest_in_all,
          figures.place_in_all};
}

bool is_of_surface(const HexFeatures::Lack& lack) {
  return lack.kind == HexLackKind::kOffModel || lack.kind == HexLackKind::kOffMesh;
}

}  // namespace

FeatureComplex features_of_model(const TetDomain& domain) {
  const GivenModel* const given = domain.mesh().given.get();
  CreaseAngles angles;
  if (given) angles.least_deg = given->crease_angle_deg;
  return features_of_surface(given ? given->surface : domain.boundary(), angles);
}

FeatureComplex features_of_surface(TriangleMesh surface, const CreaseAngles& angles) {
  return feature_complex(prepare_surface(CheckedMesh::derived(weld(std::move(surface)))),
                         {.angles = angles, .unite_solids = true});
}

HexFeatures features_kept(const HexMesh& mesh, const FeatureComplex& features, double size) {
  if (features.faces.size() > kMostListedFaces) return {};
  // Hexahedra of several solids are one here: what is between them is judged apart (judge_solids).
  HexMesh united = mesh;
  united.regions.clear();
  return features_kept(sharp_feature_measure(united, features, size));
}

HexFeatures features_kept(const FeatureMeasure& measured) {
  HexFeatures kept;
  const auto kept_of = [](const FeatureMeasure::Kept& all) { return HexFeatures::Kept{all.all, all.kept}; };
  kept.corners = kept_of(measured.corners);
  kept.creases = kept_of(measured.curves);
  kept.crease_length = kept_of(measured.curve_length);
  kept.faces = kept_of(measured.faces);
  kept.of_mesh = distances_in(measured.distances.of_mesh);
  kept.of_model = distances_in(measured.distances.of_model);
  kept.lacking = lacks_in(measured.lacking);
  kept.too_small = lacks_in(measured.too_small);
  kept.small = std::accumulate(measured.small.begin(), measured.small.end(), std::size_t{0});
  kept.shells = measured.shells;
  kept.model_shells = measured.model_shells;
  return kept;
}

void record(const FeatureFit& fit, HexReport& report) {
  if (!fit.tries.empty()) report.features = features_kept(fit.best.measure);
  report.fit_tries = fit.tries;
  report.best_fit = fit.best_try;
}

void judge_features(const HexMesh& mesh, HexReport& report) {
  if (!report.features) report.features.emplace();
  HexFeatures& features = *report.features;
  features.volume_ratio = report.volume / report.model_volume;
  if (std::string reason = topology_of(features); !reason.empty()) {
    report.outcome = HexOutcome::kPartial;
    report.reason = std::move(reason);
    advise_smaller(report);
    return;
  }
  const std::optional<double> size = size_for_volume(report, mesh.boundary.size());
  if (size)
    features.lacking.push_back(
        {HexLackKind::kVolume, 0, report.largest_distance_of_model_place, features.volume_ratio});
  if (features.lacking.empty()) return;
  report.outcome = HexOutcome::kApproximate;
  report.reason = lacks_of(features, report.size);
  for (const HexFeatures::Lack& lack : features.lacking)
    if (report.places.size() < HexReport::kMostPlaces) report.places.push_back(lack.place);
  if (size) {
    report.remedy = Remedy::kUseHexSize;
    report.remedy_number = *size;
  } else if (std::ranges::any_of(features.lacking, is_of_surface)) {
    advise_smaller(report);
  }
}

}  // namespace crossgrain

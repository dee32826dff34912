// SPDX-License-Identifier: Apache-2.0
#include "hex/model_fitting.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "fit/feature_fit.hpp"
#include "hex/feature_judgement.hpp"
#include "hex/hex_report.hpp"
#include "hex/hex_tuning.hpp"
#include "hex/model_fit.hpp"
#include "measure/hex_faces.hpp"
#include "surface/bvh.hpp"
#include "surface/model_faces.hpp"

namespace crossgrain {
namespace {

/// How far a side of the box around hexahedra may be from that of the model's, relative to its longest side.
/// Hexahedra that leave out a thin flange, or are four along the part and half of one off it, are within;
/// another unit, and a part drawn elsewhere, are not.
constexpr double kMostBoxesApart = 0.25;

/// Half of the edges of hexahedra are longer than this, relative to the longest side of the box around them.
constexpr double kLeastMedianEdge = 1e-9;

/// Tags quads by the faces of the model that are nearest to their centres.
void tag_by_nearest_faces(const FeatureComplex& features, HexMesh& mesh) {
  TriangleMesh triangles{features.vertices, features.triangles};
  for (const std::uint32_t face : features.face_of) triangles.faces.push_back(features.faces[face].number);
  const Surface surface = prepare_surface(CheckedMesh::derived(std::move(triangles)));
  const TriangleBvh tree(surface);
  parallel_for(mesh.boundary.size(), [&](std::size_t k) {
    Vector3 centre{0, 0, 0};
    for (const std::uint32_t v : mesh.boundary[k].vertices) centre += 0.25 * mesh.vertices[v];
    mesh.boundary[k].tag = surface.mesh.faces[tree.nearest(centre).triangle];
  });
}

/// Tags of a mesh that the fit has not embedded, or has in part, are those of the nearest faces.
/// Returns the limit that kept ways from being tried.
std::optional<Error> fit(const FittingModel& model, FitWays ways, const Monitor& monitor, HexMesh& mesh,
                         HexReport& report) {
  tag_by_nearest_faces(model.features, mesh);
  if (model.features.faces.size() > kMostListedFaces) return std::nullopt;
  const WatchedLoops watched(monitor, Stops::kHeeded);
  FeatureFit fitted = fitted_to_features(mesh, model.features, {report.used_size, report.size}, ways);
  if (fitted.is_stopped && fitted.tries.empty()) throw Error(ErrorKind::kInterrupted, "interrupted");
  mesh = std::move(fitted.best.mesh);
  record(fitted, report);
  report.is_stopped = fitted.is_stopped;
  return std::move(fitted.limit);
}

/// Sets HexOutcome::kPartial, with the reason, if hexahedra are inverted.
void judge_validity(const HexMesh& mesh, HexReport& report) {
  report.outcome = HexOutcome::kAllHex;
  if (report.quality.inverted == 0) return;
  report.outcome = HexOutcome::kPartial;
  report.reason =
      fmt::format("{} turned inside out",
                  report.quality.inverted == 1 ? "one is" : fmt::format("{} are", report.quality.inverted));
  report.places = places_of_inverted(mesh);
  if (report.places.size() > HexReport::kMostPlaces) report.places.resize(HexReport::kMostPlaces);
}

}  // namespace

FittingModel fitting_model(GivenModel given) {
  FittingModel model;
  model.features = features_of_surface(given.surface, {.least_deg = given.crease_angle_deg});
  TetMesh& mesh = model.solid.mesh;
  mesh.vertices = given.surface.vertices;
  mesh.unit = given.surface.unit;
  model.solid.boundary = given.surface.triangles;
  mesh.given = std::make_shared<const GivenModel>(std::move(given));
  return model;
}

void check_fittable(const HexMesh& mesh) {
  if (mesh.hexahedra.empty()) throw Error(ErrorKind::kInput, "there are no hexahedra");
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    if (*std::ranges::max_element(mesh.hexahedra[h]) >= mesh.vertices.size())
      throw Error(ErrorKind::kUsage, {"", fmt::format("hexahedron {} (counted from 0)", h),
                                      "has a corner that is no vertex of the mesh"});
  if (!mesh.regions.empty() && mesh.regions.size() != mesh.hexahedra.size())
    throw Error(ErrorKind::kUsage, "a mesh of hexahedra must have a region for each of them, or none");
  if (!(median_edge(mesh) > kLeastMedianEdge * longest_side(box_of(mesh.vertices))))
    throw Error(ErrorKind::kInput,
                "these hexahedra are no mesh to be fitted: half of their edges have no length");
  const HexTopology topology = topology_of(mesh);
  if (topology.is_closed()) return;
  std::vector<std::string> faults;
  if (topology.crowded_faces > 0)
    faults.push_back(fmt::format("{} of three or more of them, or on one side of two",
                                 counted(topology.crowded_faces, "face")));
  if (topology.open_edges > 0)
    faults.push_back(fmt::format("{} at which their surface is not closed, or touches itself",
                                 counted(topology.open_edges, "edge")));
  throw Error(
      ErrorKind::kInput,
      fmt::format("these hexahedra are no mesh to be fitted: they have {}", fmt::join(faults, " and ")),
      Remedy::kMergeVertices);
}

void check_same_place(const HexMesh& mesh, const FittingModel& model) {
  const Box ours = box_of(mesh.vertices), theirs = box_of(model.solid.mesh.vertices);
  const double most = kMostBoxesApart * longest_side(theirs);
  bool is_near = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
    is_near &= std::abs(ours.low[axis] - theirs.low[axis]) <= most &&
               std::abs(ours.high[axis] - theirs.high[axis]) <= most;
  if (is_near) return;
  const auto words = [](const Box& box) {
    return fmt::format("from {:.4g} {:.4g} {:.4g} to {:.4g} {:.4g} {:.4g}", box.low[0], box.low[1],
                       box.low[2], box.high[0], box.high[1], box.high[2]);
  };
  throw Error(ErrorKind::kInput,
              fmt::format("the hexahedra reach {}, the model {}", words(ours), words(theirs)),
              Remedy::kMatchUnits);
}

double median_edge(const HexMesh& mesh) {
  std::vector<double> lengths;
  lengths.reserve(kHexEdges.size() * mesh.hexahedra.size());
  for (const auto& hexahedron : mesh.hexahedra)
    for (const auto& [a, b] : kHexEdges)
      lengths.push_back(norm(mesh.vertices[hexahedron[a]] - mesh.vertices[hexahedron[b]]));
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  return *middle;
}

HexReport fit_to_model(const FittingModel& model, const FitSizes& sizes, FitWays ways, const Monitor& monitor,
                       HexMesh& mesh, std::vector<Warning>& warnings) {
  HexReport report;
  report.size = sizes.judged;
  report.used_size = sizes.edge;
  report.expected = static_cast<double>(mesh.hexahedra.size());
  report.quality_before = quality_of(mesh);
  mesh.boundary.clear();
  for (const HexSide& side : boundary_of(mesh)) mesh.boundary.push_back({side.vertices, 0});
  Stopwatch stopwatch;
  const std::optional<Error> limit = fit(model, ways, monitor, mesh, report);
  report.smoothing_seconds = stopwatch.restart();
  measure(mesh, model.solid, FitTo::kCommonSurface, report);
  judge_validity(mesh, report);
  if (report.outcome == HexOutcome::kAllHex) {
    if (!report.features || !mesh.regions.empty())
      report.features = features_kept(mesh, model.features, report.size);
    judge_features(mesh, report);
    explain_shapes(HexTuning().least_quality, report);
  }
  mesh.is_partial = is_partial(report.outcome);
  if (report.is_stopped) report.remedy = Remedy::kLetFinish;
  report.analysis_seconds = stopwatch.restart();
  if (limit && report.outcome != HexOutcome::kAllHex) warnings.push_back(ended_at(*limit));
  if (auto poor = poor_fit(report)) warnings.push_back(*std::move(poor));
  return report;
}

}  // namespace crossgrain

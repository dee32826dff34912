// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/tet_domain.hpp"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "solve/tet_domain_data.hpp"
#include "tets/listed_topology.hpp"
#include "tets/map_preparation.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Returns the edge of a regular tet, whose volume is edge^3 / (6 sqrt 2), with the mean volume.
double edge_of_mean_tet(const TetMesh& mesh) {
  double six_volumes = 0;
  for (const auto& [a, b, c, d] : mesh.tets) {
    const std::vector<Vector3>& v = mesh.vertices;
    six_volumes += dot(cross(v[b] - v[a], v[c] - v[a]), v[d] - v[a]);
  }
  return std::cbrt(std::numbers::sqrt2 * six_volumes / static_cast<double>(mesh.tets.size()));
}

/// Fills in all that follows from the solid.
void complete(TetDomainData& data, std::vector<Warning>& warnings) {
  data.edges = stiffness_edges(data.solid.mesh);
  data.walls = find_inner_walls(data.solid, warnings);
  data.features = features_of(data.solid, data.walls, /*unite=*/false);
  data.boundary = classify_boundary_vertices(data.solid, {}, data.features);
  data.box = box_of(boundary_surface(data.solid).vertices);
  data.typical_edge_length = edge_of_mean_tet(data.solid.mesh);
}

/// The parents of the tets that `prepare_tets` keeps.
std::vector<std::uint32_t> parents_of_kept(const SplitTetMesh& split) {
  std::vector<std::uint32_t> parents;
  for (std::size_t t = 0; t < split.parents.size(); ++t)
    if (shape_of_tet(split.mesh.vertices, split.mesh.tets[t]) != TetShape::kFlat)
      parents.push_back(split.parents[t]);
  return parents;
}

}  // namespace

TetDomain::TetDomain(TetMesh mesh, const TetTagOptions& tags) {
  auto data = std::make_shared<TetDomainData>();
  data->warnings = std::move(mesh.warnings);
  data->solid = prepare_tets(std::move(mesh), data->warnings);
  drop_listed_topology(data->solid, tags, data->warnings);
  complete(*data, data->warnings);
  data_ = std::move(data);
}

TetDomain::TetDomain(std::shared_ptr<const TetDomainData> data) : data_(std::move(data)) {}

TetDomain TetDomain::prepared_for_map(const MapPreparationOptions& options) const {
  PreparedTets prepared = crossgrain::prepared_for_map(data_->solid, {options});
  auto data = std::make_shared<TetDomainData>();
  data->warnings = data_->warnings;
  data->preparation = prepared.counts;
  data->parents = parents_of_kept(prepared.split);
  std::vector<Warning> known;  // the faults of the tets as given
  data->solid = prepare_tets(std::move(prepared.split.mesh), known);
  data->solid.inverted_tets = data_->solid.inverted_tets;
  data->solid.left_out_tets = data_->solid.left_out_tets;
  complete(*data, known);
  if (const std::size_t refused = prepared.counts.refused_splits; refused > 0)
    data->warnings.emplace_back(
        WarningKind::kRefusedSplits,
        "splits for a map that would leave tets without volume, not made: " + std::to_string(refused));
  return TetDomain(std::move(data));
}

TetDomain TetDomain::with_vertices(std::vector<Vector3> vertices) const {
  const std::vector<std::array<std::uint32_t, 4>>& tets = mesh().tets;
  if (vertices.size() != mesh().vertices.size())
    throw Error(ErrorKind::kUsage, {"", "moved vertices", "there must be as many as before"});
  for (std::size_t t = 0; t < tets.size(); ++t)
    if (shape_of_tet(vertices, tets[t]) != TetShape::kPositive)
      throw Error(ErrorKind::kUsage, {"", "tet " + std::to_string(t), "would have no positive volume"});
  auto data = std::make_shared<TetDomainData>(*data_);
  data->solid.mesh.vertices = std::move(vertices);
  std::vector<Warning> known;
  complete(*data, known);
  return TetDomain(std::move(data));
}

const std::optional<MapPreparation>& TetDomain::preparation() const {
  return data_->preparation;
}

const std::vector<std::uint32_t>& TetDomain::parents() const {
  return data_->parents;
}

const TetMesh& TetDomain::mesh() const {
  return data_->solid.mesh;
}

TriangleMesh TetDomain::boundary() const {
  return model_surface(data_->solid, data_->walls);
}

double TetDomain::typical_edge_length() const {
  return data_->typical_edge_length;
}

const std::vector<Warning>& TetDomain::warnings() const {
  return data_->warnings;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/tet_domain.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "base/vector3.hpp"
#include "solve/tet_domain_data.hpp"
#include "tets/listed_topology.hpp"

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

}  // namespace

TetDomain::TetDomain(TetMesh mesh, const TetTagOptions& tags) {
  auto data = std::make_shared<TetDomainData>();
  data->warnings = std::move(mesh.warnings);
  data->solid = prepare_tets(std::move(mesh), data->warnings);
  drop_listed_topology(data->solid, tags, data->warnings);
  data->edges = stiffness_edges(data->solid.mesh);
  data->walls = find_inner_walls(data->solid, data->warnings);
  data->features = features_of(data->solid, data->walls, /*unite=*/false);
  data->boundary = classify_boundary_vertices(data->solid, {}, data->features);
  data->box = box_of(boundary_surface(data->solid).vertices);
  data->typical_edge_length = edge_of_mean_tet(data->solid.mesh);
  data_ = std::move(data);
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

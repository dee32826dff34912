// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/tet_domain.hpp"

#include "analysis/tet_domain_data.hpp"
#include "base/vector3.hpp"

namespace crossgrain {
namespace {

double mean_length(const TetMesh& mesh, const std::vector<StiffnessEdge>& edges) {
  double sum = 0;
  for (const StiffnessEdge& edge : edges) sum += norm(mesh.vertices[edge.i] - mesh.vertices[edge.j]);
  return sum / static_cast<double>(edges.size());
}

}  // namespace

TetDomain::TetDomain(TetMesh mesh) {
  auto data = std::make_shared<TetDomainData>();
  data->solid = prepare_tets(std::move(mesh), data->warnings);
  data->edges = stiffness_edges(data->solid.mesh);
  data->boundary = classify_boundary_vertices(data->solid);
  data->box = box_of(boundary_surface(data->solid).vertices);
  data->mean_edge_length = mean_length(data->solid.mesh, data->edges);
  data_ = std::move(data);
}

const TetMesh& TetDomain::mesh() const {
  return data_->solid.mesh;
}

TriangleMesh TetDomain::boundary() const {
  return boundary_surface(data_->solid);
}

double TetDomain::mean_edge_length() const {
  return data_->mean_edge_length;
}

const std::vector<std::string>& TetDomain::warnings() const {
  return data_->warnings;
}

}  // namespace crossgrain

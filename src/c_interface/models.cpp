// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"
#include "crossgrain/read_limits.hpp"

namespace crossgrain {
namespace {

template <class T>
std::vector<T> vector_of(const T* values, std::size_t count, const char* name) {
  const std::span<const T> all = elements(values, count, 1, name);
  return {all.begin(), all.end()};
}

std::vector<std::string> sentences_of(const std::vector<Warning>& warnings) {
  std::vector<std::string> sentences;
  for (const Warning& warning : warnings) sentences.push_back(sentence_of(warning));
  return sentences;
}

const char* text_at(const std::vector<std::string>& texts, std::size_t index) {
  return index < texts.size() ? texts[index].c_str() : nullptr;
}

/// Adds tagged features of N vertices.
template <class Feature, class T>
void add_features(std::vector<Feature>& features, const T* vertices, const std::int32_t* tags,
                  std::size_t count) {
  using Row = decltype(Feature::vertices);
  const std::vector<Row> rows = rows_of<Row>(vertices, count, "vertices");
  for (std::size_t i = 0; i < count; ++i) {
    Feature feature;
    feature.vertices = rows[i];
    feature.tag = tags == nullptr ? 0 : tags[i];
    features.push_back(feature);
  }
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_mesh::crossgrain_mesh(TriangleMesh its_mesh)
    : mesh(std::move(its_mesh)), warnings(sentences_of(mesh.warnings)) {
  renew();
}

void crossgrain_mesh::renew() {
  creases.clear();
  for (const CreaseCurve& curve : mesh.creases) {
    crossgrain_crease view{};
    view.point_count = curve.points.size();
    view.points = numbers_of(curve.points);
    view.tangents = numbers_of(curve.tangents);
    view.tag = curve.tag;
    view.is_tagged = curve.is_tagged ? 1 : 0;
    creases.push_back(view);
  }
}

crossgrain_domain::crossgrain_domain(TetDomain its_domain)
    : domain(std::move(its_domain)), warnings(sentences_of(domain.warnings())) {}

crossgrain_status crossgrain_mesh_new(const double* vertices, size_t vertex_count, const uint32_t* triangles,
                                      size_t triangle_count, crossgrain_mesh** out,
                                      crossgrain_error** error) {
  return made(out, error, [&] {
    TriangleMesh mesh;
    mesh.vertices = rows_of<Vector3>(vertices, vertex_count, "vertices");
    mesh.triangles = rows_of<std::array<std::uint32_t, 3>>(triangles, triangle_count, "triangles");
    return new crossgrain_mesh(std::move(mesh));
  });
}

crossgrain_status crossgrain_mesh_read(const char* path, const crossgrain_options* options,
                                       crossgrain_monitor* monitor, crossgrain_mesh** out,
                                       crossgrain_error** error) {
  return made(out, error, [&] {
    const ReadOptions& read = options_or_defaults<ReadOptions>(options);
    const ReadLimits limits(monitor_of(monitor), read.max_memory_bytes);
    return new crossgrain_mesh(read_surface(&given(path, "path"), read, monitor_of(monitor)));
  });
}

void crossgrain_mesh_free(crossgrain_mesh* mesh) {
  delete mesh;
}

crossgrain_status crossgrain_mesh_set_faces(crossgrain_mesh* mesh, const int32_t* faces, size_t count,
                                            crossgrain_error** error) {
  return guarded(error, [&] { given(mesh, "mesh").mesh.faces = vector_of(faces, count, "faces"); });
}

crossgrain_status crossgrain_mesh_set_solids(crossgrain_mesh* mesh, const int32_t* solids, size_t count,
                                             crossgrain_error** error) {
  return guarded(error, [&] { given(mesh, "mesh").mesh.solids = vector_of(solids, count, "solids"); });
}

crossgrain_status crossgrain_mesh_set_corner_normals(crossgrain_mesh* mesh, const double* normals,
                                                     size_t count, crossgrain_error** error) {
  return guarded(error, [&] {
    const auto all = elements(normals, count, 9, "normals");
    std::vector<std::array<Vector3, 3>> corners(count);
    for (std::size_t i = 0; i < all.size(); ++i) corners[i / 9][i % 9 / 3][i % 3] = all[i];
    given(mesh, "mesh").mesh.corner_normals = std::move(corners);
  });
}

crossgrain_status crossgrain_mesh_add_crease(crossgrain_mesh* mesh, const double* points,
                                             const double* tangents, size_t count, int32_t tag, int is_tagged,
                                             crossgrain_error** error) {
  return guarded(error, [&] {
    crossgrain_mesh& changed = given(mesh, "mesh");
    changed.mesh.creases.push_back({rows_of<Vector3>(points, count, "points"),
                                    rows_of<Vector3>(tangents, count, "tangents"), tag, is_tagged != 0});
    changed.renew();
  });
}

crossgrain_status crossgrain_mesh_add_inner_faces(crossgrain_mesh* mesh, const uint32_t* triangles,
                                                  size_t count, crossgrain_error** error) {
  return guarded(error, [&] {
    auto& faces = given(mesh, "mesh").mesh.inner_faces;
    const auto more = rows_of<std::array<std::uint32_t, 3>>(triangles, count, "triangles");
    faces.insert(faces.end(), more.begin(), more.end());
  });
}

crossgrain_status crossgrain_mesh_set_unit(crossgrain_mesh* mesh, const char* unit,
                                           crossgrain_error** error) {
  return guarded(error, [&] { given(mesh, "mesh").mesh.unit = &given(unit, "unit"); });
}

size_t crossgrain_mesh_vertex_count(const crossgrain_mesh* mesh) {
  return mesh == nullptr ? 0 : mesh->mesh.vertices.size();
}

size_t crossgrain_mesh_triangle_count(const crossgrain_mesh* mesh) {
  return mesh == nullptr ? 0 : mesh->mesh.triangles.size();
}

const double* crossgrain_mesh_vertices(const crossgrain_mesh* mesh) {
  return mesh == nullptr ? nullptr : numbers_of(mesh->mesh.vertices);
}

const uint32_t* crossgrain_mesh_triangles(const crossgrain_mesh* mesh) {
  if (mesh == nullptr) return nullptr;
  return mesh->mesh.triangles.empty() ? nullptr : mesh->mesh.triangles.front().data();
}

const int32_t* crossgrain_mesh_faces(const crossgrain_mesh* mesh) {
  return mesh == nullptr ? nullptr : data_or_null(mesh->mesh.faces);
}

const int32_t* crossgrain_mesh_solids(const crossgrain_mesh* mesh) {
  return mesh == nullptr ? nullptr : data_or_null(mesh->mesh.solids);
}

const double* crossgrain_mesh_corner_normals(const crossgrain_mesh* mesh) {
  if (mesh == nullptr) return nullptr;
  const auto& normals = mesh->mesh.corner_normals;
  return normals.empty() ? nullptr : normals.front().front().data();
}

const char* crossgrain_mesh_unit(const crossgrain_mesh* mesh) {
  return mesh == nullptr ? nullptr : mesh->mesh.unit.c_str();
}

size_t crossgrain_mesh_crease_count(const crossgrain_mesh* mesh) {
  return mesh == nullptr ? 0 : mesh->creases.size();
}

const crossgrain_crease* crossgrain_mesh_crease(const crossgrain_mesh* mesh, size_t index) {
  return mesh != nullptr && index < mesh->creases.size() ? &mesh->creases[index] : nullptr;
}

const char* crossgrain_mesh_warning(const crossgrain_mesh* mesh, size_t index) {
  return mesh == nullptr ? nullptr : text_at(mesh->warnings, index);
}

crossgrain_status crossgrain_tets_new(const double* vertices, size_t vertex_count, const uint32_t* tets,
                                      size_t tet_count, const int32_t* regions, crossgrain_tets** out,
                                      crossgrain_error** error) {
  return made(out, error, [&] {
    TetMesh mesh;
    mesh.vertices = rows_of<Vector3>(vertices, vertex_count, "vertices");
    mesh.tets = rows_of<std::array<std::uint32_t, 4>>(tets, tet_count, "tets");
    if (regions != nullptr) mesh.regions = vector_of(regions, tet_count, "regions");
    return new crossgrain_tets{std::move(mesh)};
  });
}

crossgrain_status crossgrain_tets_read(const char* path, size_t max_memory_bytes, crossgrain_monitor* monitor,
                                       crossgrain_tets** out, crossgrain_error** error) {
  return made(out, error, [&] {
    const ReadLimits limits(monitor_of(monitor), max_memory_bytes);
    return new crossgrain_tets{read_tets(&given(path, "path"))};
  });
}

crossgrain_status crossgrain_tets_set_unit(crossgrain_tets* tets, const char* unit,
                                           crossgrain_error** error) {
  return guarded(error, [&] { given(tets, "tets").mesh.unit = &given(unit, "unit"); });
}

crossgrain_status crossgrain_tets_make(const char* path, const crossgrain_options* options,
                                       crossgrain_monitor* monitor, crossgrain_tets** out,
                                       crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_tets{make_tets(std::filesystem::path(&given(path, "path")),
                                         options_or_defaults<TetMakingOptions>(options),
                                         monitor_of(monitor))};
  });
}

crossgrain_status crossgrain_tets_make_inside(const crossgrain_mesh* surface,
                                              const crossgrain_options* options, crossgrain_monitor* monitor,
                                              crossgrain_tets** out, crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_tets{make_tets(
        given(surface, "surface").mesh, options_or_defaults<TetMakingOptions>(options), monitor_of(monitor))};
  });
}

void crossgrain_tets_free(crossgrain_tets* tets) {
  delete tets;
}

crossgrain_status crossgrain_tets_add_feature_edges(crossgrain_tets* tets, const uint32_t* edges,
                                                    const int32_t* tags, size_t count, int are_stated,
                                                    crossgrain_error** error) {
  return guarded(error, [&] {
    auto& features = given(tets, "tets").mesh.feature_edges;
    const std::size_t before = features.size();
    add_features(features, edges, tags, count);
    for (std::size_t i = before; i < features.size(); ++i) features[i].is_stated = are_stated != 0;
  });
}

crossgrain_status crossgrain_tets_add_feature_faces(crossgrain_tets* tets, const uint32_t* faces,
                                                    const int32_t* tags, size_t count,
                                                    crossgrain_error** error) {
  return guarded(error, [&] { add_features(given(tets, "tets").mesh.feature_faces, faces, tags, count); });
}

crossgrain_status crossgrain_domain_new(const crossgrain_tets* tets, const crossgrain_options* options,
                                        crossgrain_monitor* monitor, crossgrain_domain** out,
                                        crossgrain_error** error) {
  return made(out, error, [&] {
    const ReadLimits limits(monitor_of(monitor));
    return new crossgrain_domain(
        TetDomain(given(tets, "tets").mesh, options_or_defaults<TetTagOptions>(options)));
  });
}

void crossgrain_domain_free(crossgrain_domain* domain) {
  delete domain;
}

crossgrain_status crossgrain_domain_prepared_for_map(const crossgrain_domain* domain,
                                                     const crossgrain_options* options,
                                                     crossgrain_domain** out, crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_domain(
        given(domain, "domain").domain.prepared_for_map(options_or_defaults<MapPreparationOptions>(options)));
  });
}

const uint32_t* crossgrain_domain_parents(const crossgrain_domain* domain) {
  return domain == nullptr ? nullptr : data_or_null(domain->domain.parents());
}

size_t crossgrain_domain_vertex_count(const crossgrain_domain* domain) {
  return domain == nullptr ? 0 : domain->domain.mesh().vertices.size();
}

size_t crossgrain_domain_tet_count(const crossgrain_domain* domain) {
  return domain == nullptr ? 0 : domain->domain.mesh().tets.size();
}

const double* crossgrain_domain_vertices(const crossgrain_domain* domain) {
  return domain == nullptr ? nullptr : numbers_of(domain->domain.mesh().vertices);
}

const uint32_t* crossgrain_domain_tets(const crossgrain_domain* domain) {
  return domain == nullptr ? nullptr : domain->domain.mesh().tets.front().data();
}

const int32_t* crossgrain_domain_regions(const crossgrain_domain* domain) {
  return domain == nullptr ? nullptr : data_or_null(domain->domain.mesh().regions);
}

size_t crossgrain_domain_face_count(const crossgrain_domain* domain) {
  return domain == nullptr ? 0 : domain->domain.mesh().feature_faces.size();
}

size_t crossgrain_domain_edge_count(const crossgrain_domain* domain) {
  return domain == nullptr ? 0 : domain->domain.mesh().feature_edges.size();
}

void crossgrain_domain_faces(const crossgrain_domain* domain, uint32_t* vertices, int32_t* tags) {
  if (domain == nullptr) return;
  for (const TetMesh::Face& face : domain->domain.mesh().feature_faces) {
    vertices = std::copy(face.vertices.begin(), face.vertices.end(), vertices);
    *tags++ = face.tag;
  }
}

void crossgrain_domain_edges(const crossgrain_domain* domain, uint32_t* vertices, int32_t* tags,
                             uint8_t* are_stated) {
  if (domain == nullptr) return;
  for (const TetMesh::Edge& edge : domain->domain.mesh().feature_edges) {
    vertices = std::copy(edge.vertices.begin(), edge.vertices.end(), vertices);
    *tags++ = edge.tag;
    *are_stated++ = edge.is_stated ? 1 : 0;
  }
}

crossgrain_status crossgrain_domain_write(const crossgrain_domain* domain, const char* path,
                                          crossgrain_monitor* monitor, crossgrain_error** error) {
  return guarded(error, [&] {
    write_tets(given(domain, "domain").domain.mesh(), &given(path, "path"), monitor_of(monitor));
  });
}

double crossgrain_domain_typical_edge_length(const crossgrain_domain* domain) {
  return domain == nullptr ? 0 : domain->domain.typical_edge_length();
}

const char* crossgrain_domain_warning(const crossgrain_domain* domain, size_t index) {
  return domain == nullptr ? nullptr : text_at(domain->warnings, index);
}

crossgrain_status crossgrain_domain_boundary(const crossgrain_domain* domain, crossgrain_mesh** out,
                                             crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_mesh(given(domain, "domain").domain.boundary()); });
}

int crossgrain_is_tet_file(const char* path) {
  return value_or(0, [&] { return is_tet_file(&given(path, "path")) ? 1 : 0; });
}

int crossgrain_is_cad_file(const char* path) {
  return value_or(0, [&] { return is_cad_file(&given(path, "path")) ? 1 : 0; });
}

/* SPDX-License-Identifier: Apache-2.0 */
/* Surfaces, tet meshes and constraints. Part of crossgrain/c.h, which has the conventions. */
#ifndef CROSSGRAIN_C_MODELS_H
#define CROSSGRAIN_C_MODELS_H

#include "crossgrain/c_base.h"

#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif
#ifdef __cplusplus
extern "C" {
#endif

/** \defgroup c_meshes Models
 * @{ */

/** Makes a surface: `vertices` holds 3 vertex_count numbers, `triangles` 3 triangle_count indices. Checked by
 * a solve. */
crossgrain_status crossgrain_mesh_new(const double* vertices, size_t vertex_count, const uint32_t* triangles,
                                      size_t triangle_count, crossgrain_mesh** out, crossgrain_error** error);

/** Reads a surface or a CAD file; `options` of kind CROSSGRAIN_READ_OPTIONS, or NULL. */
crossgrain_status crossgrain_mesh_read(const char* path, const crossgrain_options* options,
                                       crossgrain_monitor* monitor, crossgrain_mesh** out,
                                       crossgrain_error** error);

/** Sets what belongs to each triangle (TriangleMesh): numbers of faces and of solids, and nine numbers for
 * the normals at its corners. `count` is the number of triangles, or 0 for none. */
crossgrain_status crossgrain_mesh_set_faces(crossgrain_mesh* mesh, const int32_t* faces, size_t count,
                                            crossgrain_error** error);
crossgrain_status crossgrain_mesh_set_solids(crossgrain_mesh* mesh, const int32_t* solids, size_t count,
                                             crossgrain_error** error);
crossgrain_status crossgrain_mesh_set_corner_normals(crossgrain_mesh* mesh, const double* normals,
                                                     size_t count, crossgrain_error** error);

/** Adds a sharp edge: points and unit tangents, `count` of each. */
crossgrain_status crossgrain_mesh_add_crease(crossgrain_mesh* mesh, const double* points,
                                             const double* tangents, size_t count, int32_t tag, int is_tagged,
                                             crossgrain_error** error);

/** Adds triangles inside the solid whose normal frames should follow. */
crossgrain_status crossgrain_mesh_add_inner_faces(crossgrain_mesh* mesh, const uint32_t* triangles,
                                                  size_t count, crossgrain_error** error);

/** Sets the unit of the coordinates, such as "mm": a label, no number changes. */
crossgrain_status crossgrain_mesh_set_unit(crossgrain_mesh* mesh, const char* unit, crossgrain_error** error);

/** The arrays of a surface. Those that belong to triangles are NULL where the mesh has none. */
size_t crossgrain_mesh_vertex_count(const crossgrain_mesh* mesh);
size_t crossgrain_mesh_triangle_count(const crossgrain_mesh* mesh);
const double* crossgrain_mesh_vertices(const crossgrain_mesh* mesh);
const uint32_t* crossgrain_mesh_triangles(const crossgrain_mesh* mesh);
const int32_t* crossgrain_mesh_faces(const crossgrain_mesh* mesh);
const int32_t* crossgrain_mesh_solids(const crossgrain_mesh* mesh);
const double* crossgrain_mesh_corner_normals(const crossgrain_mesh* mesh);
const char* crossgrain_mesh_unit(const crossgrain_mesh* mesh);

/** The creases of a surface: how many, and one of them; NULL beyond the last. */
typedef struct crossgrain_crease {
  size_t point_count;
  const double* points;
  const double* tangents; /**< unit vectors, one per point */
  int32_t tag;
  int is_tagged;
} crossgrain_crease;
size_t crossgrain_mesh_crease_count(const crossgrain_mesh* mesh);
const crossgrain_crease* crossgrain_mesh_crease(const crossgrain_mesh* mesh, size_t index);

/** What reading found, one line each; NULL beyond the last. */
const char* crossgrain_mesh_warning(const crossgrain_mesh* mesh, size_t index);

/** Makes a tet mesh: `tets` holds 4 tet_count indices, `regions` one number per tet or is NULL. */
crossgrain_status crossgrain_tets_new(const double* vertices, size_t vertex_count, const uint32_t* tets,
                                      size_t tet_count, const int32_t* regions, crossgrain_tets** out,
                                      crossgrain_error** error);

/** Reads a tet mesh. `max_memory_bytes` limits the memory of the process, 0 for nine tenths of the machine's.
 */
crossgrain_status crossgrain_tets_read(const char* path, size_t max_memory_bytes, crossgrain_monitor* monitor,
                                       crossgrain_tets** out, crossgrain_error** error);

/** Sets the unit of the coordinates, such as "mm": a label, no number changes. */
crossgrain_status crossgrain_tets_set_unit(crossgrain_tets* tets, const char* unit, crossgrain_error** error);

/** Cuts the solids of a CAD file or of a surface, in a file or in memory, into tets (make_tets), by
 * gmsh or Netgen; `options` of kind CROSSGRAIN_TET_MAKING_OPTIONS, or NULL. */
crossgrain_status crossgrain_tets_make(const char* path, const crossgrain_options* options,
                                       crossgrain_monitor* monitor, crossgrain_tets** out,
                                       crossgrain_error** error);
crossgrain_status crossgrain_tets_make_inside(const crossgrain_mesh* surface,
                                              const crossgrain_options* options, crossgrain_monitor* monitor,
                                              crossgrain_tets** out, crossgrain_error** error);

/** Adds features: 2 or 3 indices each, and a tag each or NULL for 0. Edges that are not stated to be features
 * may be any curve of the meshed model (TetMesh::Edge): on the surface they count only where that is sharp.
 */
crossgrain_status crossgrain_tets_add_feature_edges(crossgrain_tets* tets, const uint32_t* edges,
                                                    const int32_t* tags, size_t count, int are_stated,
                                                    crossgrain_error** error);
crossgrain_status crossgrain_tets_add_feature_faces(crossgrain_tets* tets, const uint32_t* faces,
                                                    const int32_t* tags, size_t count,
                                                    crossgrain_error** error);

/** Prepares a tet mesh for a field (TetDomain): tets that are inverted are reoriented, those without volume
 * left out. `options` of kind CROSSGRAIN_TAG_OPTIONS, or NULL. */
crossgrain_status crossgrain_domain_new(const crossgrain_tets* tets, const crossgrain_options* options,
                                        crossgrain_monitor* monitor, crossgrain_domain** out,
                                        crossgrain_error** error);

/** The tets of a domain, split so that a map can take the surface to integer planes
 * (TetDomain::prepared_for_map). `options` of kind CROSSGRAIN_PREPARATION_OPTIONS, or NULL. */
crossgrain_status crossgrain_domain_prepared_for_map(const crossgrain_domain* domain,
                                                     const crossgrain_options* options,
                                                     crossgrain_domain** out, crossgrain_error** error);

/** For each tet of a prepared domain the tet that it was a part of before, UINT32_MAX if that is flat;
 * otherwise NULL. */
const uint32_t* crossgrain_domain_parents(const crossgrain_domain* domain);

/** All vertices, and the tets that have frames. Regions are NULL if there are none. */
size_t crossgrain_domain_vertex_count(const crossgrain_domain* domain);
size_t crossgrain_domain_tet_count(const crossgrain_domain* domain);
const double* crossgrain_domain_vertices(const crossgrain_domain* domain);
const uint32_t* crossgrain_domain_tets(const crossgrain_domain* domain);
const int32_t* crossgrain_domain_regions(const crossgrain_domain* domain);

/** Tagged triangles and edges of the mesh. The functions write 3 or 2 vertices and a tag each; and 1 for
 * edges that are stated to be features, otherwise 0. */
size_t crossgrain_domain_face_count(const crossgrain_domain* domain);
size_t crossgrain_domain_edge_count(const crossgrain_domain* domain);
void crossgrain_domain_faces(const crossgrain_domain* domain, uint32_t* vertices, int32_t* tags);
void crossgrain_domain_edges(const crossgrain_domain* domain, uint32_t* vertices, int32_t* tags,
                             uint8_t* are_stated);

/** Writes the mesh with regions and tags: .mesh for Medit, .msh for Gmsh (write_tets). */
crossgrain_status crossgrain_domain_write(const crossgrain_domain* domain, const char* path,
                                          crossgrain_monitor* monitor, crossgrain_error** error);
double crossgrain_domain_typical_edge_length(const crossgrain_domain* domain);

/** What was repaired or is unusual, one line each; NULL beyond the last. */
const char* crossgrain_domain_warning(const crossgrain_domain* domain, size_t index);

/** The boundary as a surface that points outward. */
crossgrain_status crossgrain_domain_boundary(const crossgrain_domain* domain, crossgrain_mesh** out,
                                             crossgrain_error** error);

/** Whether the extension of a file is one of a tet mesh, or of a CAD file. */
int crossgrain_is_tet_file(const char* path);
int crossgrain_is_cad_file(const char* path);

/** @} */
/** \defgroup c_constraints Constraints
 * Axes are three numbers each; their number is one, or three for a frame. No axes: the direction of each
 * segment, or the normal of the face. Checked by a solve.
 * @{ */

crossgrain_status crossgrain_constraints_new(crossgrain_constraints** out, crossgrain_error** error);

/** Reads and checks the constraints in a JSON file. */
crossgrain_status crossgrain_constraints_read(const char* path, crossgrain_constraints** out,
                                              crossgrain_error** error);
crossgrain_status crossgrain_constraints_add_point(crossgrain_constraints* constraints, const double at[3],
                                                   const double* axes, size_t axis_count, double weight,
                                                   crossgrain_error** error);
crossgrain_status crossgrain_constraints_add_polyline(crossgrain_constraints* constraints,
                                                      const double* points, size_t point_count,
                                                      const double* axes, size_t axis_count, double weight,
                                                      crossgrain_error** error);
crossgrain_status crossgrain_constraints_add_face(crossgrain_constraints* constraints, int32_t face,
                                                  const double* axes, size_t axis_count, double weight,
                                                  crossgrain_error** error);

/** Fails with CROSSGRAIN_INPUT for the first constraint that is invalid by itself (check_constraints). */
crossgrain_status crossgrain_constraints_check(const crossgrain_constraints* constraints,
                                               crossgrain_error** error);

/** `tensor` holds xx, yy, zz, yz, xz, xy. */
crossgrain_status crossgrain_constraints_add_stress(crossgrain_constraints* constraints, const double at[3],
                                                    const double tensor[6], double weight,
                                                    crossgrain_error** error);

/** @} */

#ifdef __cplusplus
}
#endif
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif

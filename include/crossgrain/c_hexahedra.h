/* SPDX-License-Identifier: Apache-2.0 */
/* Meshes of hexahedra. Part of crossgrain/c.h, which has the conventions. */
#ifndef CROSSGRAIN_C_HEXAHEDRA_H
#define CROSSGRAIN_C_HEXAHEDRA_H

#include "crossgrain/c_base.h"

#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif
#ifdef __cplusplus
extern "C" {
#endif

/** \defgroup c_hexahedra Hexahedra
 * Experimental: options, reports and functions change from release to release.
 * @{ */

/** Meshes a model with hexahedra (make_hexahedra): in a file (a CAD file, a closed surface or tets), inside a
 * closed surface in memory, or in given tets, which are prepared for a map unless they are so already.
 * `options` of kind CROSSGRAIN_HEX_MESHING_OPTIONS, or NULL. A mesh that does not fill the model is a result
 * too: see crossgrain_hexahedra_outcome. */
crossgrain_status crossgrain_hexahedra_make(const char* path, const crossgrain_options* options,
                                            crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                            crossgrain_error** error);
crossgrain_status crossgrain_hexahedra_make_inside(const crossgrain_mesh* surface,
                                                   const crossgrain_options* options,
                                                   crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                   crossgrain_error** error);
crossgrain_status crossgrain_hexahedra_make_in_tets(const crossgrain_domain* domain,
                                                    const crossgrain_options* options,
                                                    crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                    crossgrain_error** error);

/** Meshes a model in a file, or inside a closed surface in memory, by a lattice (lattice_hexahedra).
 * `options` of kind CROSSGRAIN_HEX_MESHING_OPTIONS, or NULL. These hexahedra have no field. */
crossgrain_status crossgrain_hexahedra_lattice(const char* path, const crossgrain_options* options,
                                               crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                               crossgrain_error** error);
crossgrain_status crossgrain_hexahedra_lattice_inside(const crossgrain_mesh* surface,
                                                      const crossgrain_options* options,
                                                      crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                      crossgrain_error** error);

/** Hexahedra that follow a field on tets (hexahedra), which were prepared for a map before. `options` of kind
 * CROSSGRAIN_HEX_OPTIONS, or NULL. */
crossgrain_status crossgrain_tet_field_hexahedra(const crossgrain_tet_field* field,
                                                 const crossgrain_options* options,
                                                 crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                 crossgrain_error** error);

/** Puts hexahedra of any mesher, which roughly fill a model in a file, onto its corners, creases and faces
 * (fit_hexahedra): those in the file `mesh`, or in the folder of a result; or arrays of `vertex_count`
 * vertices, 3 numbers each, and of `count` hexahedra, 8 vertices each in the order of VTK. `options` of kind
 * CROSSGRAIN_HEX_FIT_OPTIONS, or NULL. These hexahedra have no field. */
crossgrain_status crossgrain_hexahedra_fit(const char* mesh, const char* model,
                                           const crossgrain_options* options, crossgrain_monitor* monitor,
                                           crossgrain_hexahedra** out, crossgrain_error** error);
crossgrain_status crossgrain_hexahedra_fit_arrays(const double* vertices, size_t vertex_count,
                                                  const uint32_t* corners, size_t count, const char* model,
                                                  const crossgrain_options* options,
                                                  crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                  crossgrain_error** error);

/** What became of the hexahedra. */
crossgrain_hex_outcome crossgrain_hexahedra_outcome(const crossgrain_hexahedra* hexahedra);

/** The outcome in one line. */
const char* crossgrain_hexahedra_sentence(const crossgrain_hexahedra* hexahedra);

/** The arrays of the mesh (HexMesh): 3 numbers a vertex; 8 vertices a hexahedron, in the order of VTK, and
 * its scaled Jacobian and region; 4 vertices a face of the boundary, outward, and its tag. Regions are NULL
 * if the model has none. */
size_t crossgrain_hexahedra_vertex_count(const crossgrain_hexahedra* hexahedra);
size_t crossgrain_hexahedra_count(const crossgrain_hexahedra* hexahedra);
size_t crossgrain_hexahedra_face_count(const crossgrain_hexahedra* hexahedra);
const double* crossgrain_hexahedra_vertices(const crossgrain_hexahedra* hexahedra);
const uint32_t* crossgrain_hexahedra_corners(const crossgrain_hexahedra* hexahedra);
const double* crossgrain_hexahedra_scaled_jacobians(const crossgrain_hexahedra* hexahedra);
const int32_t* crossgrain_hexahedra_regions(const crossgrain_hexahedra* hexahedra);
const uint32_t* crossgrain_hexahedra_faces(const crossgrain_hexahedra* hexahedra);
const int32_t* crossgrain_hexahedra_face_tags(const crossgrain_hexahedra* hexahedra);
const char* crossgrain_hexahedra_unit(const crossgrain_hexahedra* hexahedra);

/** The repaired field that the hexahedra follow, on tets. CROSSGRAIN_USAGE for those without. */
crossgrain_status crossgrain_hexahedra_field(const crossgrain_hexahedra* hexahedra,
                                             crossgrain_tet_field** out, crossgrain_error** error);

/** The report of that field, or of the model, with the section "hexahedra" (docs/report.md). */
crossgrain_status crossgrain_hexahedra_report(const crossgrain_hexahedra* hexahedra, char** json,
                                              crossgrain_error** error);

/** Writes the mesh in the format of the extension: .vtu, .mesh, .msh or .inp (write_hexahedra). `inverted`:
 * not 0 if the latter three may hold inverted hexahedra. */
crossgrain_status crossgrain_hexahedra_write(const crossgrain_hexahedra* hexahedra, const char* path,
                                             int inverted, crossgrain_monitor* monitor,
                                             crossgrain_error** error);

/** Writes the folder that `crossgrain hex` writes: the field on tets and the mesh in all formats; or
 * that of `crossgrain fit`. Arguments as of crossgrain_field_write. */
crossgrain_status crossgrain_hexahedra_write_folder(const crossgrain_hexahedra* hexahedra, const char* folder,
                                                    const crossgrain_options* options, const char* model,
                                                    double read_seconds, crossgrain_monitor* monitor,
                                                    char** json, crossgrain_error** error);

/** @} */

#ifdef __cplusplus
}
#endif
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/* Fields on a grid and on tets, and their files. Part of crossgrain/c.h, which has the conventions. */
#ifndef CROSSGRAIN_C_FIELDS_H
#define CROSSGRAIN_C_FIELDS_H

#include "crossgrain/c_base.h"

#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif
#ifdef __cplusplus
extern "C" {
#endif

/** \defgroup c_fields Fields on a grid
 * @{ */

/** Solves for the frame field inside a surface, from `earlier` if that is not NULL (solve, solve_from).
 * `options` of kind CROSSGRAIN_SOLVE_OPTIONS, or NULL. */
crossgrain_status crossgrain_solve(const crossgrain_mesh* mesh, const crossgrain_field* earlier,
                                   const crossgrain_options* options, crossgrain_monitor* monitor,
                                   crossgrain_field** out, crossgrain_error** error);

/** Reads the field on the grid from a folder. */
crossgrain_status crossgrain_field_read(const char* folder, size_t max_memory_bytes,
                                        crossgrain_monitor* monitor, crossgrain_field** out,
                                        crossgrain_error** error);

/** Number of active cells. */
size_t crossgrain_field_size(const crossgrain_field* field);

/** Degree of the harmonics, 3 or 4. */
int crossgrain_field_degree(const crossgrain_field* field);

/** Writes a property of all cells to an array of the caller's: 3 numbers per cell for centers, 1 for sizes
 * and levels, 9 for frames. */
crossgrain_status crossgrain_field_centers(const crossgrain_field* field, double* centers,
                                           crossgrain_error** error);
crossgrain_status crossgrain_field_sizes(const crossgrain_field* field, double* sizes,
                                         crossgrain_error** error);
crossgrain_status crossgrain_field_levels(const crossgrain_field* field, int32_t* levels,
                                          crossgrain_error** error);
crossgrain_status crossgrain_field_frames(const crossgrain_field* field, double* frames,
                                          crossgrain_error** error);

/** Class of the constraints in a cell (CellConstraint). */
typedef enum crossgrain_cell_constraint {
  CROSSGRAIN_NO_SURFACE = 0, /**< the cell holds no surface */
  CROSSGRAIN_PLANE = 1,      /**< one axis */
  CROSSGRAIN_AXIS = 2,       /**< one axis, as a compromise between normals */
  CROSSGRAIN_FRAME = 3,      /**< all three axes */
  CROSSGRAIN_FREE = 4,       /**< nothing: all directions are alike */
  CROSSGRAIN_CONFLICTED = 5  /**< no frame meets them */
} crossgrain_cell_constraint;

/** Properties of all cells as they are stored: 4 numbers (w, x, y, z) per cell for quaternions, 1 for all
 * others. NULL where the field has none. */
const float* crossgrain_field_quaternions(const crossgrain_field* field);
const uint8_t* crossgrain_field_on_boundary(const crossgrain_field* field);
const float* crossgrain_field_energy_density(const crossgrain_field* field);
const float* crossgrain_field_alignment_deg(const crossgrain_field* field);
const uint8_t* crossgrain_field_constraint_classes(const crossgrain_field* field);
const int32_t* crossgrain_field_regions(const crossgrain_field* field);

/** Writes the coefficients of `count` frames, 9 numbers each, in real orthonormal spherical harmonics of a
 * degree (7 numbers for 3, 9 for 4), in the order m = -degree ... degree, of unit length. The axes of a frame
 * may have any of their 24 orders and signs; in degree 3 the sign of the coefficients depends on them. */
crossgrain_status crossgrain_coefficients_of_frames(const double* frames, size_t count, int degree,
                                                    double* coefficients, crossgrain_error** error);

/** Samples the field at points (FrameField::sample). Each of the four arrays may be NULL: `frames` takes 9
 * numbers per point, the others one each: whether the point is in an active cell, the disagreement of the
 * cells around it, the distance to the nearest arc. `threads` is the number of threads, 0 for all processors;
 * results do not depend on it. After a failure the arrays may be written in part. */
crossgrain_status crossgrain_field_sample(const crossgrain_field* field, const double* points, size_t count,
                                          int threads, double* frames, uint8_t* in_active_cell,
                                          double* deviation, double* singular_distance,
                                          crossgrain_monitor* monitor, crossgrain_error** error);

/** The singular graph. */
crossgrain_status crossgrain_field_singularities(const crossgrain_field* field, crossgrain_monitor* monitor,
                                                 crossgrain_graph** out, crossgrain_error** error);

/** The report as the text of report.json (docs/report.md). */
crossgrain_status crossgrain_field_report(const crossgrain_field* field, char** json,
                                          crossgrain_error** error);

/** The answer and the singular graph as JSON, as `crossgrain check --json` prints them (check_json). */
crossgrain_status crossgrain_field_check(const crossgrain_field* field, char** json,
                                         crossgrain_error** error);

/** Whether a hexahedral mesh can follow the field. */
crossgrain_status crossgrain_field_answer(const crossgrain_field* field, crossgrain_answer** out,
                                          crossgrain_error** error);

/** Writes the field to a folder (write_field). `options` of kind CROSSGRAIN_OUTPUT_OPTIONS, or NULL. `model`
 * is the path of the model for the report, and `read_seconds` the time that reading it took; NULL and 0 if
 * there is none. Returns the report as written through `json` unless that is NULL. */
crossgrain_status crossgrain_field_write(const crossgrain_field* field, const char* folder,
                                         const crossgrain_options* options, const char* model,
                                         double read_seconds, crossgrain_monitor* monitor, char** json,
                                         crossgrain_error** error);

/** Writes the page that shows the field as one HTML file. */
crossgrain_status crossgrain_field_write_page(const crossgrain_field* field, const char* path,
                                              crossgrain_monitor* monitor, crossgrain_error** error);

/** Draws the field as a PNG file. `options` of kind CROSSGRAIN_PICTURE_OPTIONS, or NULL; `singularities` NULL
 * for those of the field; `lines` NULL for none. */
crossgrain_status crossgrain_field_render(const crossgrain_field* field, const char* path,
                                          const crossgrain_options* options,
                                          const crossgrain_graph* singularities,
                                          const crossgrain_lines* lines, crossgrain_monitor* monitor,
                                          crossgrain_error** error);

/** @} */
/** \defgroup c_results Files and folders of results
 * @{ */

/** Takes `count` bytes of a file. Returns other than 0 if they cannot be written; the writer ends then. */
typedef int (*crossgrain_sink)(void* sink_state, const char* bytes, size_t count);

/** Writes the content of a file to a sink, given the report as JSON, as it is written but for this file in
 * its list. Returns other than 0 to give up: then no file of the result is written. Called once, perhaps on
 * another thread. */
typedef int (*crossgrain_companion_writer)(const char* report, crossgrain_sink sink, void* sink_state,
                                           void* state);

/** Adds a file that is written together with a field, both or none, to options of kind
 * CROSSGRAIN_OUTPUT_OPTIONS, in place of one before. Not together with the option `page`. */
crossgrain_status crossgrain_options_set_companion(crossgrain_options* options, const char* name,
                                                   crossgrain_companion_writer writer, void* state,
                                                   crossgrain_error** error);

/** Reserves the folder for a field, on a grid or `on_tets`, until the reservation and all options that have
 * it are released: fails early where a field could not be written (check_field_folder, check_onto_folder). */
crossgrain_status crossgrain_reserve_folder(const char* folder, const crossgrain_options* options,
                                            int on_tets, crossgrain_reservation** out,
                                            crossgrain_error** error);

/** Gives options of kind CROSSGRAIN_OUTPUT_OPTIONS the right to write to a folder; NULL takes it away. */
crossgrain_status crossgrain_options_set_reservation(crossgrain_options* options,
                                                     const crossgrain_reservation* reservation,
                                                     crossgrain_error** error);

/** Writes the frames at points to a text file, and the points outside to another unless `outside` is NULL
 * (write_samples). `outside_count`, their number, may be NULL. */
crossgrain_status crossgrain_field_write_samples(const crossgrain_field* field, const double* points,
                                                 size_t count, const char* frames, const char* outside,
                                                 crossgrain_monitor* monitor, size_t* outside_count,
                                                 crossgrain_error** error);

/** Reads points, 3 numbers a row, or normals and their weights, 4 numbers a row, from a text file. */
crossgrain_status crossgrain_points_read(const char* path, crossgrain_numbers** out,
                                         crossgrain_error** error);
crossgrain_status crossgrain_normals_read(const char* path, crossgrain_numbers** out,
                                          crossgrain_error** error);

/** The path of the model of the field in a folder; `*out` is NULL if there is no readable report. */
crossgrain_status crossgrain_model_of_result(const char* folder, char** out, crossgrain_error** error);

/** The name of the solve that all files in a folder name (SolveReport::solve). */
crossgrain_status crossgrain_solve_of_result(const char* folder, char** out, crossgrain_error** error);

/** Whether a folder has a field that was written with a box, and so lacks cells. */
crossgrain_status crossgrain_is_clipped_field(const char* folder, int* out, crossgrain_error** error);

/** @} */
/** \defgroup c_tet_fields Fields on tets
 * @{ */

/** Solves inside the boundary of a tet mesh and transfers the field to it (solve_onto). `options` of kind
 * CROSSGRAIN_SOLVE_OPTIONS, or NULL. */
crossgrain_status crossgrain_solve_onto(const crossgrain_domain* domain, const crossgrain_options* options,
                                        crossgrain_monitor* monitor, crossgrain_tet_field** out,
                                        crossgrain_error** error);

/** Transfers a field to a tet mesh and finishes it there (carry_onto). */
crossgrain_status crossgrain_carry_onto(const crossgrain_field* field, const crossgrain_domain* domain,
                                        const crossgrain_options* options, crossgrain_monitor* monitor,
                                        crossgrain_tet_field** out, crossgrain_error** error);

/** The field with matchings that hexahedra can follow, as far as they were found, and with frames smoothed
 * for them (repaired). It has a mesh of its own, on which vertices may have moved if it was prepared for a
 * map. `options` of kind CROSSGRAIN_REPAIR_OPTIONS, or NULL; `threads` as in crossgrain_field_sample. */
crossgrain_status crossgrain_tet_field_repaired(const crossgrain_tet_field* field,
                                                const crossgrain_options* options, int threads,
                                                crossgrain_monitor* monitor, crossgrain_tet_field** out,
                                                crossgrain_error** error);

/** Reads the field on tets from a folder; `*out` is NULL if the folder has none. */
crossgrain_status crossgrain_tet_field_read(const char* folder, size_t max_memory_bytes,
                                            crossgrain_monitor* monitor, crossgrain_tet_field** out,
                                            crossgrain_error** error);

/** The field on the grid from which it started, and its tets. */
crossgrain_status crossgrain_tet_field_grid(const crossgrain_tet_field* field, crossgrain_field** out,
                                            crossgrain_error** error);
crossgrain_status crossgrain_tet_field_domain(const crossgrain_tet_field* field, crossgrain_domain** out,
                                              crossgrain_error** error);

/** Writes the frames of all tets or vertices of the domain, 9 numbers each. */
crossgrain_status crossgrain_tet_field_frames(const crossgrain_tet_field* field, double* frames,
                                              crossgrain_error** error);
crossgrain_status crossgrain_tet_field_vertex_frames(const crossgrain_tet_field* field, double* frames,
                                                     crossgrain_error** error);

/** The same as unit quaternions (w, x, y, z), as they are stored. */
const double* crossgrain_tet_field_quaternions(const crossgrain_tet_field* field);
const double* crossgrain_tet_field_vertex_quaternions(const crossgrain_tet_field* field);

/** The matchings across all faces between two tets (TetFrameField::matchings), ascending by vertices. For
 * each face its vertices (3, ascending), its two tets, and where the axes of the first go (3): axis k of the
 * first tet continues in the second as its axis |axes[k]|, counted from 1, with the sign of axes[k]. */
crossgrain_status crossgrain_tet_field_matchings(const crossgrain_tet_field* field,
                                                 crossgrain_monitor* monitor, crossgrain_matchings** out,
                                                 crossgrain_error** error);
size_t crossgrain_matchings_count(const crossgrain_matchings* matchings);
const uint32_t* crossgrain_matchings_faces(const crossgrain_matchings* matchings);
const uint32_t* crossgrain_matchings_tets(const crossgrain_matchings* matchings);
const int8_t* crossgrain_matchings_axes(const crossgrain_matchings* matchings);

/** As for fields on a grid. */
crossgrain_status crossgrain_tet_field_singularities(const crossgrain_tet_field* field,
                                                     crossgrain_monitor* monitor, crossgrain_graph** out,
                                                     crossgrain_error** error);
crossgrain_status crossgrain_tet_field_report(const crossgrain_tet_field* field, char** json,
                                              crossgrain_error** error);
crossgrain_status crossgrain_tet_field_check(const crossgrain_tet_field* field, char** json,
                                             crossgrain_error** error);
crossgrain_status crossgrain_tet_field_answer(const crossgrain_tet_field* field, crossgrain_answer** out,
                                              crossgrain_error** error);
crossgrain_status crossgrain_tet_field_write(const crossgrain_tet_field* field, const char* folder,
                                             const crossgrain_options* options, const char* model,
                                             double read_seconds, crossgrain_monitor* monitor, char** json,
                                             crossgrain_error** error);
crossgrain_status crossgrain_tet_field_write_page(const crossgrain_tet_field* field, const char* path,
                                                  crossgrain_monitor* monitor, crossgrain_error** error);
crossgrain_status crossgrain_tet_field_render(const crossgrain_tet_field* field, const char* path,
                                              const crossgrain_options* options,
                                              const crossgrain_graph* singularities,
                                              const crossgrain_lines* lines, crossgrain_monitor* monitor,
                                              crossgrain_error** error);

/** The formats that the option "formats" of CROSSGRAIN_OUTPUT_OPTIONS names; NULL beyond the last. */
const char* crossgrain_format_name(size_t index);
const char* crossgrain_format_description(size_t index);

/** @} */

#ifdef __cplusplus
}
#endif
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif

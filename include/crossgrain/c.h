/* SPDX-License-Identifier: Apache-2.0 */
/**
 * The C interface of Crossgrain, for other languages: opaque handles, plain arrays, one error struct. It
 * offers what the C++ library offers, except solves by several processes; the headers beside this one
 * describe each computation and each option at length. In the library crossgrain-c, which exports the
 * functions of this header and nothing else.
 *
 * Conventions:
 *
 * - Functions that can fail return a status, CROSSGRAIN_OK or the kind of error, and take a place for the
 * error as their last argument, which may be NULL. On failure nothing else is written, unless a function says
 * so.
 * - Handles are made by functions that take `crossgrain_... **out` and released by the `_free` of their type,
 * which accepts NULL. Handles are independent: an object may be released while another one that was made from
 * it lives.
 * - Arrays are contiguous; points and directions are three doubles each, in model units, frames nine (the
 * three unit axes, one after the other). Arrays passed in are copied. Pointers that a function returns belong
 * to the handle and live as long as it does, unless the function says otherwise.
 * - Text is UTF-8 and ends with a zero byte. Text that is returned through `char **` is released by
 *   crossgrain_text_free.
 * - Structs are allocated by the library only. Later versions may add members at their end.
 *
 * Concurrency: any number of threads may call functions at once, also with the same handle as long as none of
 * them changes it: options, meshes, tets, constraints and the error are changed by functions that take them
 * without const. Fields, tracers and graphs never change. crossgrain_monitor_cancel and
 * crossgrain_monitor_stop may be called at any time by any thread and from a signal handler.
 */
#ifndef CROSSGRAIN_C_H
#define CROSSGRAIN_C_H

#include <stddef.h>
#include <stdint.h>

#include "crossgrain/version.h"

#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif
#ifdef __cplusplus
extern "C" {
#endif

/** \defgroup c_version Version
 * @{ */

/** Version of this interface. It increases if a function or a member goes or changes its meaning. */
#define CROSSGRAIN_C_VERSION 1

/** Returns the CROSSGRAIN_C_VERSION of the library that is loaded. */
int crossgrain_c_version(void);

/** Returns the version of the library, such as "0.1.0"; CROSSGRAIN_VERSION_NUMBER is that of the header. */
const char* crossgrain_version(void);

/** @} */
/** \defgroup c_errors Errors
 * @{ */

/** What went wrong. */
typedef enum crossgrain_status {
  CROSSGRAIN_OK = 0,
  CROSSGRAIN_USAGE = 1,       /**< an invalid argument or option */
  CROSSGRAIN_INPUT = 2,       /**< a file, mesh or field that cannot be used */
  CROSSGRAIN_OUTPUT = 3,      /**< a result that cannot be written */
  CROSSGRAIN_LIMIT = 4,       /**< a stated limit or the memory is exceeded */
  CROSSGRAIN_INTERRUPTED = 5, /**< stopped or cancelled through a monitor */
  CROSSGRAIN_INTERNAL = 6     /**< a fault of the library; please report it */
} crossgrain_status;

/** Why a function failed. All texts are there; those that do not apply are empty. */
typedef struct crossgrain_error {
  crossgrain_status status;
  const char* sentence;    /**< one line: the file, the place in it, what is wrong and what to do */
  const char* file;        /**< the file that it is about */
  const char* place;       /**< in the file or the object: "line 12", "vertex 7 (counted from 0)" */
  const char* text;        /**< what is wrong */
  const char* remedy;      /**< what to do about it, in words */
  const char* remedy_name; /**< the same as a name for scripts that does not change: "raise_resolution" */
} crossgrain_error;

void crossgrain_error_free(crossgrain_error* error);

/** Releases a text that was returned through `char **`. */
void crossgrain_text_free(char* text);

/** @} */
/** \defgroup c_handles Handles
 * @{ */

/** Options of one kind. */
typedef struct crossgrain_options crossgrain_options;
/** Progress out of a computation, cancelling into it. */
typedef struct crossgrain_monitor crossgrain_monitor;
/** Directions to follow besides the surface. */
typedef struct crossgrain_constraints crossgrain_constraints;
/** A surface of triangles. */
typedef struct crossgrain_mesh crossgrain_mesh;
/** A tet mesh as given. */
typedef struct crossgrain_tets crossgrain_tets;
/** A tet mesh prepared for a field. */
typedef struct crossgrain_domain crossgrain_domain;
/** A field on the cells of an octree. */
typedef struct crossgrain_field crossgrain_field;
/** A field on the vertices and tets of a mesh. */
typedef struct crossgrain_tet_field crossgrain_tet_field;
/** A mesh of hexahedra, with the field that it follows. */
typedef struct crossgrain_hexahedra crossgrain_hexahedra;
/** How frames of neighbouring tets go on in each other. */
typedef struct crossgrain_matchings crossgrain_matchings;
/** The singular graph of a field. */
typedef struct crossgrain_graph crossgrain_graph;
/** Whether hexahedra can follow a field. */
typedef struct crossgrain_answer crossgrain_answer;
/** Traces streamlines of a field. */
typedef struct crossgrain_tracer crossgrain_tracer;
/** Streamlines. */
typedef struct crossgrain_lines crossgrain_lines;
/** The form of a set of normals. */
typedef struct crossgrain_spectrum crossgrain_spectrum;
/** The sole right to write a field to a folder. */
typedef struct crossgrain_reservation crossgrain_reservation;
/** Rows of numbers whose count was not known before. */
typedef struct crossgrain_numbers crossgrain_numbers;

void crossgrain_options_free(crossgrain_options* options);
void crossgrain_monitor_free(crossgrain_monitor* monitor);
void crossgrain_constraints_free(crossgrain_constraints* constraints);
void crossgrain_mesh_free(crossgrain_mesh* mesh);
void crossgrain_tets_free(crossgrain_tets* tets);
void crossgrain_domain_free(crossgrain_domain* domain);
void crossgrain_field_free(crossgrain_field* field);
void crossgrain_tet_field_free(crossgrain_tet_field* field);
void crossgrain_hexahedra_free(crossgrain_hexahedra* hexahedra);
void crossgrain_matchings_free(crossgrain_matchings* matchings);
void crossgrain_graph_free(crossgrain_graph* graph);
void crossgrain_answer_free(crossgrain_answer* answer);
void crossgrain_tracer_free(crossgrain_tracer* tracer);
void crossgrain_lines_free(crossgrain_lines* lines);
void crossgrain_spectrum_free(crossgrain_spectrum* spectrum);
void crossgrain_reservation_free(crossgrain_reservation* reservation);
void crossgrain_numbers_free(crossgrain_numbers* numbers);

/** Number of rows, numbers in each, and all of them row by row. */
size_t crossgrain_numbers_rows(const crossgrain_numbers* numbers);
size_t crossgrain_numbers_columns(const crossgrain_numbers* numbers);
const double* crossgrain_numbers_data(const crossgrain_numbers* numbers);

/** @} */
/** \defgroup c_options Options
 * Options have the names of the members in C++, with a dot before those of an inner struct: "resolution",
 * "tets.maker". docs/options.md lists all.
 * @{ */

/** Which struct of options. */
typedef enum crossgrain_options_kind {
  CROSSGRAIN_SOLVE_OPTIONS = 0,        /**< SolveOptions */
  CROSSGRAIN_READ_OPTIONS = 1,         /**< ReadOptions */
  CROSSGRAIN_TAG_OPTIONS = 2,          /**< TetTagOptions */
  CROSSGRAIN_OUTPUT_OPTIONS = 3,       /**< OutputOptions, and "page": whether report.html is written too */
  CROSSGRAIN_STREAMLINE_OPTIONS = 4,   /**< StreamlineOptions */
  CROSSGRAIN_PICTURE_OPTIONS = 5,      /**< PictureOptions */
  CROSSGRAIN_PREPARATION_OPTIONS = 6,  /**< MapPreparationOptions */
  CROSSGRAIN_TET_MAKING_OPTIONS = 7,   /**< TetMakingOptions */
  CROSSGRAIN_REPAIR_OPTIONS = 8,       /**< RepairOptions */
  CROSSGRAIN_HEX_OPTIONS = 9,          /**< HexOptions */
  CROSSGRAIN_HEX_MESHING_OPTIONS = 10, /**< HexMeshingOptions */
  CROSSGRAIN_NO_OPTIONS = 2147483647 /**< none; so that a function may be asked for any int, and refuse it */
} crossgrain_options_kind;

/** What an option takes. */
typedef enum crossgrain_option_type {
  CROSSGRAIN_FLAG = 0,    /**< an integer, 0 or 1 */
  CROSSGRAIN_INTEGER = 1, /**< an integer */
  CROSSGRAIN_NUMBER = 2,  /**< a double or an integer */
  CROSSGRAIN_NUMBERS = 3, /**< several doubles; none resets an option that may be absent */
  CROSSGRAIN_TEXT = 4     /**< a name, a path, or names separated by commas */
} crossgrain_option_type;

/** Makes options with all defaults. */
crossgrain_status crossgrain_options_new(crossgrain_options_kind kind, crossgrain_options** out,
                                         crossgrain_error** error);

/** The options of a kind: how many, and the name and type of each. NULL and CROSSGRAIN_FLAG beyond the last.
 */
size_t crossgrain_options_count(crossgrain_options_kind kind);
const char* crossgrain_options_name(crossgrain_options_kind kind, size_t index);
crossgrain_option_type crossgrain_options_type(crossgrain_options_kind kind, size_t index);

/** What to do instead of setting an option of earlier versions: "use crease_angle_deg". NULL if there was
 * none of this name. */
const char* crossgrain_options_replacement(crossgrain_options_kind kind, const char* name);

/** Sets an option. CROSSGRAIN_USAGE for a name that is unknown, naming the nearest one or what replaced it,
 * and for a value of another type or that its member cannot hold. Ranges are checked where the options are
 * used. */
crossgrain_status crossgrain_options_set_integer(crossgrain_options* options, const char* name, int64_t value,
                                                 crossgrain_error** error);
crossgrain_status crossgrain_options_set_number(crossgrain_options* options, const char* name, double value,
                                                crossgrain_error** error);
crossgrain_status crossgrain_options_set_numbers(crossgrain_options* options, const char* name,
                                                 const double* values, size_t count,
                                                 crossgrain_error** error);
crossgrain_status crossgrain_options_set_text(crossgrain_options* options, const char* name,
                                              const char* value, crossgrain_error** error);

/** The value of an option that takes numbers (flags and integers too; none if it is absent), and of one that
 * takes text. */
crossgrain_status crossgrain_options_get_numbers(const crossgrain_options* options, const char* name,
                                                 crossgrain_numbers** out, crossgrain_error** error);
crossgrain_status crossgrain_options_get_text(const crossgrain_options* options, const char* name, char** out,
                                              crossgrain_error** error);

/** Copies constraints into options of a solve (SolveOptions::constraints). Here and below, options of kind
 * CROSSGRAIN_HEX_MESHING_OPTIONS have those of a solve inside. */
crossgrain_status crossgrain_options_set_constraints(crossgrain_options* options,
                                                     const crossgrain_constraints* constraints,
                                                     crossgrain_error** error);

/** Gives options of a solve the cells that suit a tet mesh, if they name none (sized_for). A solve onto tets
 * does so. */
crossgrain_status crossgrain_options_size_for(crossgrain_options* options, const crossgrain_domain* domain,
                                              crossgrain_error** error);

/** The options for reading a surface that will be solved with options of a solve. */
crossgrain_status crossgrain_options_for_reading(const crossgrain_options* solve, crossgrain_options** out,
                                                 crossgrain_error** error);

/** @} */
/** \defgroup c_monitor Progress and cancelling
 * @{ */

/** What a computation is at. */
typedef enum crossgrain_phase {
  CROSSGRAIN_READING = 0,
  CROSSGRAIN_GRID = 1,     /**< builds the octree cells of a level */
  CROSSGRAIN_SOLVING = 2,  /**< finds the frames of a level */
  CROSSGRAIN_ANALYSIS = 3, /**< measures the solved field and finds its singular lines */
  CROSSGRAIN_ON_TETS = 4,  /**< finishes the field on a tet mesh */
  CROSSGRAIN_WRITING = 5,
  CROSSGRAIN_MAKING_TETS = 6, /**< cuts a solid into tets */
  CROSSGRAIN_REPAIRING = 7,   /**< changes matchings of a field on tets until hexahedra can follow */
  CROSSGRAIN_MAPPING = 8,     /**< maps a repaired field to the grid */
  CROSSGRAIN_HEXAHEDRA = 9,   /**< takes hexahedra out of the map */
  CROSSGRAIN_SMOOTHING = 10   /**< smooths them */
} crossgrain_phase;

typedef struct crossgrain_progress {
  crossgrain_phase phase;
  int depth;     /**< octree depth of the level, 0 if there is none */
  int level;     /**< number of the level from 1, the coarsest; 0 if there is none */
  int levels;    /**< expected number of levels */
  int sweep;     /**< sweeps done on that level */
  size_t cells;  /**< active cells of that level; vertices on tets */
  double energy; /**< energy after that sweep; NaN if not known */
  double share;  /**< of the phase, 0 to 1, that is done; negative if not known */

  /** Of a search for hexahedra: number of the attempt at a mesh, from 1, 0 outside of one; how many there are
      at most, as far as known; number of hexahedra of the best mesh so far, and whether they fill the model.
   */
  size_t attempt;
  size_t attempts;
  size_t hexahedra;
  int is_whole;
} crossgrain_progress;

/** Forecast for a whole solve, once, before its expensive levels; none for small ones. */
typedef struct crossgrain_expectation {
  double resolution;        /**< finest cells along the longest side at the end */
  double seconds;           /**< wall time of the whole run */
  double after_seconds;     /**< wall time until the forecast */
  size_t cells;             /**< active cells of the finest level */
  size_t peak_memory_bytes; /**< of the whole process */
} crossgrain_expectation;

/** Listeners are called on the thread that called the computation. One that returns other than 0 cancels it.
 */
typedef int (*crossgrain_on_progress)(const crossgrain_progress* progress, void* state);
typedef int (*crossgrain_on_expectation)(const crossgrain_expectation* expectation, void* state);

/** Makes a monitor. Each listener may be NULL. Computations take a monitor that may be NULL too. */
crossgrain_status crossgrain_monitor_new(crossgrain_on_progress on_progress,
                                         crossgrain_on_expectation on_expectation, void* state,
                                         crossgrain_monitor** out, crossgrain_error** error);

/** Ends computations with this monitor soon, with CROSSGRAIN_INTERRUPTED. */
void crossgrain_monitor_cancel(crossgrain_monitor* monitor);

/** Asks a solve for which stops are allowed to return the field of its last finished level, and a search for
 * hexahedra the best mesh so far (Monitor::stop). */
void crossgrain_monitor_stop(crossgrain_monitor* monitor);

/** Allows stops; to be called before the solve. */
void crossgrain_monitor_allow_stops(crossgrain_monitor* monitor);

/** @} */
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

/** Cuts the solids of a CAD file or of a closed surface, in a file or in memory, into tets (make_tets), by
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

/** Writes the content of a file to a sink, given the report as it is written, as JSON. Returns other than 0
 * to give up: then no file of the result is written. Called once, perhaps on another thread. */
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

/** Hexahedra that follow a field on tets (hexahedra), which were prepared for a map before. `options` of kind
 * CROSSGRAIN_HEX_OPTIONS, or NULL. */
crossgrain_status crossgrain_tet_field_hexahedra(const crossgrain_tet_field* field,
                                                 const crossgrain_options* options,
                                                 crossgrain_monitor* monitor, crossgrain_hexahedra** out,
                                                 crossgrain_error** error);

/** What became of the hexahedra (HexOutcome). */
typedef enum crossgrain_hex_outcome {
  CROSSGRAIN_ALL_HEX = 0,     /**< they fill the model as it asks for, and none is inverted */
  CROSSGRAIN_FLAWED_HEX = 1,  /**< they fill the model, but are not what it asks for; the report says why */
  CROSSGRAIN_PARTIAL_HEX = 2, /**< some are left out or inverted; the report says why */
  CROSSGRAIN_NO_HEX = 3       /**< none were found */
} crossgrain_hex_outcome;
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

/** The repaired field that the hexahedra follow, on tets. */
crossgrain_status crossgrain_hexahedra_field(const crossgrain_hexahedra* hexahedra,
                                             crossgrain_tet_field** out, crossgrain_error** error);

/** The report of that field, with the section "hexahedra" (docs/report.md). */
crossgrain_status crossgrain_hexahedra_report(const crossgrain_hexahedra* hexahedra, char** json,
                                              crossgrain_error** error);

/** Writes the mesh in the format of the extension: .vtu, .mesh, .msh or .inp (write_hexahedra). `inverted`:
 * not 0 if the latter three may hold inverted hexahedra. */
crossgrain_status crossgrain_hexahedra_write(const crossgrain_hexahedra* hexahedra, const char* path,
                                             int inverted, crossgrain_monitor* monitor,
                                             crossgrain_error** error);

/** Writes the folder that `crossgrain hex` writes: the field on tets and the mesh in all formats. Arguments
 * as of crossgrain_field_write. */
crossgrain_status crossgrain_hexahedra_write_folder(const crossgrain_hexahedra* hexahedra, const char* folder,
                                                    const crossgrain_options* options, const char* model,
                                                    double read_seconds, crossgrain_monitor* monitor,
                                                    char** json, crossgrain_error** error);

/** @} */
/** \defgroup c_singularities Singular graph and answer
 * @{ */

/** Whether a hexahedral mesh can follow a field, or a part of it, locally. */
typedef enum crossgrain_verdict {
  CROSSGRAIN_MESHABLE = 0,
  CROSSGRAIN_NOT_MESHABLE = 1,
  CROSSGRAIN_UNDECIDED = 2
} crossgrain_verdict;

/** How frames rotate around an arc (SingularityGraph::ArcType). */
typedef enum crossgrain_arc_type {
  CROSSGRAIN_REGULAR = 0,
  CROSSGRAIN_CHANGING = 1,
  CROSSGRAIN_NO_AXIS = 2
} crossgrain_arc_type;

typedef struct crossgrain_arc {
  size_t point_count;
  const double* points;    /**< a closed arc ends with its first point */
  const int64_t* vertices; /**< the vertex of the tet mesh behind each point; -1 on grids and at nodes */
  const double* axes;      /**< axis of the rotation at each point; zeros where there is none */
  size_t turning_count;
  const uint32_t* turning_points; /**< points where the rotation changes its sense */
  crossgrain_arc_type type;
  crossgrain_verdict verdict;
  double index;          /**< rotation of the frames around the arc in full turns: +1/4 for valence 3 */
  double length;         /**< of the smooth curve, model units */
  double length_cells;   /**< in sizes of the cells there */
  double oblique_length; /**< of the part where the axis is more than 45 degrees off the arc */
  int is_closed;
  uint32_t nodes[2]; /**< nodes at both ends, if it is not closed */
} crossgrain_arc;

typedef struct crossgrain_node {
  double place[3];
  int on_boundary;
  crossgrain_verdict verdict;
  size_t arc_count;
  const uint32_t* arcs; /**< arcs that end here; one with both ends here is listed twice */
} crossgrain_node;

typedef struct crossgrain_graph_summary {
  crossgrain_verdict verdict; /**< of the worst arc or node */
  size_t arcs, nodes;
  size_t edges;       /**< singular edges of the grid or the tets */
  double edge_length; /**< sum of their lengths */
  size_t unresolved_loops, unresolved_stubs, crease_hooks, contacts; /**< as in SingularityGraph */
} crossgrain_graph_summary;

const crossgrain_graph_summary* crossgrain_graph_summary_of(const crossgrain_graph* graph);

/** An arc or node; NULL beyond the last. */
const crossgrain_arc* crossgrain_graph_arc(const crossgrain_graph* graph, size_t index);
const crossgrain_node* crossgrain_graph_node(const crossgrain_graph* graph, size_t index);

/** Reads the graph of a whole field from singularities.vtu or onto_singularities.vtu. */
crossgrain_status crossgrain_graph_read(const char* path, crossgrain_graph** out, crossgrain_error** error);

/** Why a field is not meshable or undecided (Answer::Reason). */
typedef struct crossgrain_reason {
  const char* kind; /**< a name, such as "knife_edge" */
  crossgrain_verdict verdict;
  size_t count;    /**< number of places with this fault; 0 if it is about no place */
  double place[3]; /**< the first or worst one, if there is one */
  const char* text;
  const char* next;     /**< what to do, in words; may be empty */
  const char* remedy;   /**< a name for it, such as "use_resolution"; "none" if there is nothing to do */
  double remedy_number; /**< the resolution or the length of edges to use; 0 for other remedies */
} crossgrain_reason;

crossgrain_verdict crossgrain_answer_verdict(const crossgrain_answer* answer);

/** The answer in one line. */
const char* crossgrain_answer_sentence(const crossgrain_answer* answer);

/** A reason; NULL beyond the last. */
const crossgrain_reason* crossgrain_answer_reason(const crossgrain_answer* answer, size_t index);

/** @} */
/** \defgroup c_streamlines Streamlines
 * @{ */

/** Prepares the tracing of a field (StreamlineTracer), inside `surface`, or the surface that the field has if
 * that is NULL. `options` of kind CROSSGRAIN_STREAMLINE_OPTIONS, or NULL. */
crossgrain_status crossgrain_tracer_new(const crossgrain_field* field, const crossgrain_options* options,
                                        const crossgrain_mesh* surface, crossgrain_monitor* monitor,
                                        crossgrain_tracer** out, crossgrain_error** error);
crossgrain_status crossgrain_tracer_new_on_tets(const crossgrain_tet_field* field,
                                                const crossgrain_options* options,
                                                crossgrain_monitor* monitor, crossgrain_tracer** out,
                                                crossgrain_error** error);

/** Seeds as rows of numbers: evenly spread points inside (3 a row); points on the surface or on the plane
 * across an axis (0 x, 1 y, 2 z), each with a direction that no line follows (6 a row). `position` is a
 * coordinate along the axis, NaN for the middle. */
crossgrain_status crossgrain_tracer_spread_seeds(const crossgrain_tracer* tracer, size_t count,
                                                 crossgrain_monitor* monitor, crossgrain_numbers** out,
                                                 crossgrain_error** error);
crossgrain_status crossgrain_tracer_surface_seeds(const crossgrain_tracer* tracer, size_t count,
                                                  crossgrain_monitor* monitor, crossgrain_numbers** out,
                                                  crossgrain_error** error);
crossgrain_status crossgrain_tracer_cut_seeds(const crossgrain_tracer* tracer, int axis, double position,
                                              size_t count, crossgrain_monitor* monitor,
                                              crossgrain_numbers** out, crossgrain_error** error);

/** Traces the lines through seeds: `count` rows of `columns` numbers, 3 or 6, as above. `threads` as in
 * crossgrain_field_sample. */
crossgrain_status crossgrain_tracer_trace(const crossgrain_tracer* tracer, const double* seeds, size_t count,
                                          size_t columns, int threads, crossgrain_monitor* monitor,
                                          crossgrain_lines** out, crossgrain_error** error);

/** Why a line ends (StreamlineEnd). */
typedef enum crossgrain_line_end {
  CROSSGRAIN_AT_BOUNDARY = 0,
  CROSSGRAIN_AT_ARC = 1,
  CROSSGRAIN_CLOSED = 2,
  CROSSGRAIN_LONGEST = 3,
  CROSSGRAIN_AMBIGUOUS = 4,
  CROSSGRAIN_CROWDED = 5
} crossgrain_line_end;

typedef struct crossgrain_line {
  size_t point_count; /**< at least two */
  const double* points;
  const double* tangents; /**< unit vectors; NULL for lines read from a file */
  double length;
  size_t seed;       /**< index of the seed */
  size_t seed_point; /**< index of the seed in `points` */
  int axis;          /**< name of the axis at the seed: 0 x, 1 y, 2 z */
  crossgrain_line_end first_end, last_end;
} crossgrain_line;

size_t crossgrain_lines_count(const crossgrain_lines* lines);

/** Seeds outside the solid, and at a singular arc, where no line starts. */
size_t crossgrain_lines_outside_seeds(const crossgrain_lines* lines);
size_t crossgrain_lines_arc_seeds(const crossgrain_lines* lines);

/** A line; NULL beyond the last. */
const crossgrain_line* crossgrain_lines_line(const crossgrain_lines* lines, size_t index);

/** Writes lines to a .vtu, .vtp or .obj file. `solve` names the solve of their field, or is NULL
 * (SolveReport::solve). */
crossgrain_status crossgrain_lines_write(const crossgrain_lines* lines, const char* path, const char* solve,
                                         crossgrain_monitor* monitor, crossgrain_error** error);

/** Reads lines that were written, for pictures: they have points and an axis only. */
crossgrain_status crossgrain_lines_read(const char* path, crossgrain_lines** out, crossgrain_error** error);

/** @} */
/** \defgroup c_spectra Forms of normals
 * @{ */

/** The form E(h) = h^T A h - 2 b.h + c of a set of normals (SpectrumReport). */
typedef struct crossgrain_form {
  int degree;
  size_t size;               /**< 7 or 9 */
  const double* matrix;      /**< A, row by row */
  const double* eigenvalues; /**< ascending */
  const double* linear;      /**< b */
  double constant;           /**< c */
  size_t null_space_count;
  const double* null_space; /**< null_space_count rows; degree 4: a point, then orthonormal directions */
} crossgrain_form;

/** The form of `count` normals with their weights. */
crossgrain_status crossgrain_spectrum_of_normals(const double* normals, const double* weights, size_t count,
                                                 int degree, crossgrain_spectrum** out,
                                                 crossgrain_error** error);

/** The form of a "plane", "cube", "cylinder" or "sphere". */
crossgrain_status crossgrain_spectrum_of_preset(const char* name, int degree, crossgrain_spectrum** out,
                                                crossgrain_error** error);
const crossgrain_form* crossgrain_spectrum_form(const crossgrain_spectrum* spectrum);

/** @} */

#ifdef __cplusplus
}
#endif
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif

/* SPDX-License-Identifier: Apache-2.0 */
/* Version, errors, handles, options, progress. Part of crossgrain/c.h, which has the conventions. */
#ifndef CROSSGRAIN_C_BASE_H
#define CROSSGRAIN_C_BASE_H

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
  CROSSGRAIN_HEX_FIT_OPTIONS = 11,     /**< HexFitOptions */
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

/** What became of hexahedra (HexOutcome). The report says why it is not the first. */
typedef enum crossgrain_hex_outcome {
  CROSSGRAIN_ALL_HEX = 0,         /**< valid, closed, and they keep the model's features and surface */
  CROSSGRAIN_APPROXIMATE_HEX = 1, /**< valid and closed, but they lack features or are off the surface */
  CROSSGRAIN_PARTIAL_HEX = 2,     /**< some are left out or inverted, or solids are meshed apart */
  CROSSGRAIN_NO_HEX = 3           /**< none were found */
} crossgrain_hex_outcome;

typedef struct crossgrain_progress {
  crossgrain_phase phase;
  int depth;     /**< octree depth of the level, 0 if there is none */
  int level;     /**< number of the level from 1, the coarsest; 0 if there is none */
  int levels;    /**< expected number of levels */
  int sweep;     /**< sweeps done on that level */
  size_t cells;  /**< active cells of that level; vertices on tets */
  double energy; /**< energy after that sweep; NaN if not known */
  double share;  /**< of the phase, 0 to 1, that is done; negative if not known */

  /** Of a search for hexahedra: number of the attempt at a mesh, from 1, 0 outside of one; number of its
     tets, from 1, and of how many sizes tets are made at most; number of hexahedra of the best mesh so far,
     and what it is. */
  size_t attempt;
  size_t tets;
  size_t most_tets;
  size_t hexahedra;
  crossgrain_hex_outcome outcome;
  size_t fitted; /**< hexahedra that are put onto the model, with their layers; 0 if not known yet */
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

#ifdef __cplusplus
}
#endif
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif

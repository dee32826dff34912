/* SPDX-License-Identifier: Apache-2.0 */
/* Singular lines, the answer about hexahedra, streamlines, forms of normals. Part of crossgrain/c.h, which
 * has the conventions. */
#ifndef CROSSGRAIN_C_ANALYSIS_H
#define CROSSGRAIN_C_ANALYSIS_H

#include "crossgrain/c_base.h"

#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif
#ifdef __cplusplus
extern "C" {
#endif

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

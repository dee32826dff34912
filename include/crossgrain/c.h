/* SPDX-License-Identifier: Apache-2.0 */
/**
 * The C interface of Crossgrain, for other languages: opaque handles, plain arrays, one error struct. It
 * offers what the C++ library offers, except solves by several processes; the headers beside this one
 * describe each computation and each option at length. In the library crossgrain-c, which exports the
 * functions of these headers and nothing else:
 *
 * - c_base.h: version, errors, handles, options, progress
 * - c_models.h: surfaces, tet meshes, constraints
 * - c_fields.h: fields on a grid and on tets, files of results
 * - c_hexahedra.h: meshes of hexahedra
 * - c_analysis.h: singular lines, the answer about hexahedra, streamlines, forms of normals
 *
 * Conventions:
 *
 * - Functions that can fail return a status, CROSSGRAIN_OK or the kind of error, and take a place for the
 * error as their last argument, which may be NULL. On failure nothing else is written, unless a function says
 * so.
 * - Handles are made by functions that take `crossgrain_... **out` and released by the `_free` of their type,
 * which accepts NULL. Handles are independent: an object may be released while another one that was made from
 * it lives. What a function reads of a handle that is NULL is 0 or NULL, unless it returns a status.
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

#include "crossgrain/c_analysis.h"
#include "crossgrain/c_base.h"
#include "crossgrain/c_fields.h"
#include "crossgrain/c_hexahedra.h"
#include "crossgrain/c_models.h"

#endif

// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/warning.hpp"

#include <array>

#include "base/names.hpp"

namespace crossgrain {
namespace {

/// In the order of WarningKind.
constexpr std::array kNames{
    "unknown_unit",        "missing_parts",     "loose_faces",        "repeated_bodies",
    "missing_faces",       "curved_tets",       "skipped_data",       "tet_maker",
    "thin_part",           "many_tets",         "repeated_tets",      "inverted_tets",
    "flat_tets",           "overlapping_tets",  "unused_vertices",    "touching_edges",
    "touching_vertices",   "unmerged_vertices", "stray_tags",         "listed_topology",
    "refused_splits",      "surface_finding",   "left_out_features",  "overlapping_solids",
    "touching_solids",     "empty_solids",      "crossed_interfaces", "crowded_corners",
    "knife_edges",         "faded_creases",     "unfinished",         "memory_limited",
    "thin_walls",          "excluded_surface",  "not_settled",        "tets_not_settled",
    "constraints_outside", "vertices_outside",  "other_model",        "faces_without_quads",
    "faces_off",           "poor_fit",          "attempt_limited",    "clip_missed",
    "left_out_tets",       "not_finite"};

}  // namespace

const char* name_of(WarningKind kind) {
  return name_among<WarningKind::kNotFinite>(kNames, kind);
}

}  // namespace crossgrain

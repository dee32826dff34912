// SPDX-License-Identifier: Apache-2.0
#include "c_interface/removed_options.hpp"

#include <ranges>

namespace crossgrain {
namespace {

struct RemovedOptions {
  crossgrain_options_kind kind;
  std::string_view names;  ///< one that ends with a dot is that of all members of an inner struct
  std::string_view instead;
};

constexpr std::string_view kFixed = "its former default is always taken";
constexpr std::string_view kOneLimit = "all attempts have one limit of work";
constexpr std::string_view kCreaseAngle = "use crease_angle_deg";
constexpr std::string_view kCadProgram = "install crossgrain_cad in libexec/crossgrain";

/// The first row that fits counts.
constexpr RemovedOptions kRemoved[] = {
    {CROSSGRAIN_SOLVE_OPTIONS, "creases.least_deg", kCreaseAngle},
    {CROSSGRAIN_SOLVE_OPTIONS, "onto.boundary", "use boundary"},
    {CROSSGRAIN_SOLVE_OPTIONS, "refinement. creases. solver. onto.", kFixed},
    {CROSSGRAIN_TAG_OPTIONS, "least_share most_other_share fewest_region_tets fewest", kFixed},
    {CROSSGRAIN_PREPARATION_OPTIONS, "cut_off_creases layer_spread_deg", kFixed},
    {CROSSGRAIN_READ_OPTIONS, "chord_error_cells glue_gap", kFixed},
    {CROSSGRAIN_READ_OPTIONS, "cad_program", kCadProgram},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "at_least_edges", "give the smaller of size and longest side over edges"},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "triangles.edges_per_circle", "use edges_per_circle"},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "creases.least_deg", kCreaseAngle},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "triangles. creases. stitch_share most_tets", kFixed},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "cad_program", kCadProgram},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "gmsh", "put gmsh into PATH"},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "netgen", "install crossgrain_netgen in libexec/crossgrain"},
    {CROSSGRAIN_STREAMLINE_OPTIONS,
     "tolerance largest_step_cells smallest_step_cells arc_distance_cells closing_cells end_tolerance_cells "
     "longest_sides most_points",
     kFixed},
    {CROSSGRAIN_PICTURE_OPTIONS, "width height", "use size, which has width and height"},
    {CROSSGRAIN_PICTURE_OPTIONS, "frame_spacing opacity", kFixed},
    {CROSSGRAIN_PICTURE_OPTIONS, "lines creases legend", "name it in without to leave it out"},
    {CROSSGRAIN_REPAIR_OPTIONS,
     "tries moving_sweeps least_quality passes most_sweeps disturbances finalists wanderings wandering_steps "
     "temperature seed most_work smoothing_sweeps smoothing_rad",
     kFixed},
    {CROSSGRAIN_HEX_OPTIONS,
     "repair. more_tries wandering_faults largest_gap least_share finer_sizes finer_share", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "repair_work most_maps most_mapped_tets", kOneLimit},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "tet_edge", "use tets.size"},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "most_tried_tets repair_work", kOneLimit},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "tet_shares most_sizes large_tets least_quality sizes_before_finer",
     kFixed},
};

/// Structs inside others, with the kind that has their options.
struct Inner {
  crossgrain_options_kind kind;
  std::string_view name;
  crossgrain_options_kind its_kind;
};
constexpr Inner kInner[] = {
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "hexahedra.", CROSSGRAIN_HEX_OPTIONS},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "solve.", CROSSGRAIN_SOLVE_OPTIONS},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "tets.", CROSSGRAIN_TET_MAKING_OPTIONS},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "tags.", CROSSGRAIN_TAG_OPTIONS},
    {CROSSGRAIN_HEX_FIT_OPTIONS, "tags.", CROSSGRAIN_TAG_OPTIONS},
};

bool stand_for(std::string_view names, std::string_view name) {
  for (const auto part : std::views::split(names, ' ')) {
    const std::string_view row(part.begin(), part.end());
    const bool is_struct = row.ends_with('.');
    if (name == row || (is_struct && (name.starts_with(row) || name == row.substr(0, row.size() - 1))))
      return true;
  }
  return false;
}

}  // namespace

std::string_view replacement_of(crossgrain_options_kind kind, std::string_view name) {
  for (const RemovedOptions& removed : kRemoved)
    if (removed.kind == kind && stand_for(removed.names, name)) return removed.instead;
  for (const Inner& inner : kInner)
    if (inner.kind == kind && name.starts_with(inner.name))
      return replacement_of(inner.its_kind, name.substr(inner.name.size()));
  return {};
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "c_interface/removed_options.hpp"

namespace crossgrain {
namespace {

struct RemovedOption {
  crossgrain_options_kind kind;
  std::string_view name;  ///< ends with a dot where all members of an inner struct went
  std::string_view instead;
};

constexpr std::string_view kFixed = "its former default is always taken";
constexpr std::string_view kOneLimit = "all attempts have one limit of work";
constexpr std::string_view kSize = "use size, which has width and height";
constexpr std::string_view kWithout = "name it in without to leave it out";
constexpr std::string_view kCreaseAngle = "use crease_angle_deg";

/// The first row that fits counts.
constexpr RemovedOption kRemoved[] = {
    {CROSSGRAIN_SOLVE_OPTIONS, "refinement.", kFixed},
    {CROSSGRAIN_SOLVE_OPTIONS, "creases.least_deg", kCreaseAngle},
    {CROSSGRAIN_SOLVE_OPTIONS, "creases.", kFixed},
    {CROSSGRAIN_SOLVE_OPTIONS, "solver.", kFixed},
    {CROSSGRAIN_SOLVE_OPTIONS, "onto.boundary", "use boundary"},
    {CROSSGRAIN_SOLVE_OPTIONS, "onto.", kFixed},
    {CROSSGRAIN_TAG_OPTIONS, "least_share", kFixed},
    {CROSSGRAIN_TAG_OPTIONS, "most_other_share", kFixed},
    {CROSSGRAIN_TAG_OPTIONS, "fewest_region_tets", kFixed},
    {CROSSGRAIN_TAG_OPTIONS, "fewest", kFixed},
    {CROSSGRAIN_PREPARATION_OPTIONS, "cut_off_creases", kFixed},
    {CROSSGRAIN_PREPARATION_OPTIONS, "layer_spread_deg", kFixed},
    {CROSSGRAIN_READ_OPTIONS, "chord_error_cells", kFixed},
    {CROSSGRAIN_READ_OPTIONS, "glue_gap", kFixed},
    {CROSSGRAIN_READ_OPTIONS, "cad_program", "install crossgrain_cad in libexec/crossgrain"},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "at_least_edges", "give the smaller of size and longest side over edges"},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "triangles.edges_per_circle", "use edges_per_circle"},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "triangles.", kFixed},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "creases.least_deg", kCreaseAngle},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "creases.", kFixed},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "stitch_share", kFixed},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "most_tets", kFixed},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "cad_program", "install crossgrain_cad in libexec/crossgrain"},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "gmsh", "put gmsh into PATH"},
    {CROSSGRAIN_TET_MAKING_OPTIONS, "netgen", "install crossgrain_netgen in libexec/crossgrain"},
    {CROSSGRAIN_STREAMLINE_OPTIONS, "tolerance", kFixed},
    {CROSSGRAIN_STREAMLINE_OPTIONS, "largest_step_cells", kFixed},
    {CROSSGRAIN_STREAMLINE_OPTIONS, "smallest_step_cells", kFixed},
    {CROSSGRAIN_STREAMLINE_OPTIONS, "arc_distance_cells", kFixed},
    {CROSSGRAIN_STREAMLINE_OPTIONS, "closing_cells", kFixed},
    {CROSSGRAIN_STREAMLINE_OPTIONS, "end_tolerance_cells", kFixed},
    {CROSSGRAIN_STREAMLINE_OPTIONS, "longest_sides", kFixed},
    {CROSSGRAIN_STREAMLINE_OPTIONS, "most_points", kFixed},
    {CROSSGRAIN_PICTURE_OPTIONS, "width", kSize},
    {CROSSGRAIN_PICTURE_OPTIONS, "height", kSize},
    {CROSSGRAIN_PICTURE_OPTIONS, "frame_spacing", kFixed},
    {CROSSGRAIN_PICTURE_OPTIONS, "opacity", kFixed},
    {CROSSGRAIN_PICTURE_OPTIONS, "lines", kWithout},
    {CROSSGRAIN_PICTURE_OPTIONS, "creases", kWithout},
    {CROSSGRAIN_PICTURE_OPTIONS, "legend", kWithout},
    {CROSSGRAIN_REPAIR_OPTIONS, "tries", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "moving_sweeps", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "least_quality", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "passes", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "most_sweeps", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "disturbances", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "finalists", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "wanderings", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "wandering_steps", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "temperature", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "seed", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "most_work", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "smoothing_sweeps", kFixed},
    {CROSSGRAIN_REPAIR_OPTIONS, "smoothing_rad", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "repair.", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "more_tries", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "wandering_faults", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "largest_gap", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "least_share", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "finer_sizes", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "finer_share", kFixed},
    {CROSSGRAIN_HEX_OPTIONS, "repair_work", kOneLimit},
    {CROSSGRAIN_HEX_OPTIONS, "most_maps", kOneLimit},
    {CROSSGRAIN_HEX_OPTIONS, "most_mapped_tets", kOneLimit},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "tet_edge", "use tets.size"},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "tet_shares", kFixed},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "most_sizes", kFixed},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "large_tets", kFixed},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "most_tried_tets", kOneLimit},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "repair_work", kOneLimit},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "least_quality", kFixed},
    {CROSSGRAIN_HEX_MESHING_OPTIONS, "sizes_before_finer", kFixed},
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
};

bool stands_for(std::string_view row, std::string_view name) {
  const bool is_struct = row.ends_with('.');
  return name == row || (is_struct && (name.starts_with(row) || name == row.substr(0, row.size() - 1)));
}

}  // namespace

std::string_view replacement_of(crossgrain_options_kind kind, std::string_view name) {
  for (const RemovedOption& removed : kRemoved)
    if (removed.kind == kind && stands_for(removed.name, name)) return removed.instead;
  for (const Inner& inner : kInner)
    if (inner.kind == kind && name.starts_with(inner.name))
      return replacement_of(inner.its_kind, name.substr(inner.name.size()));
  return {};
}

}  // namespace crossgrain

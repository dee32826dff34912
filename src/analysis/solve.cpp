// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "analysis/alignment.hpp"
#include "analysis/crease_report.hpp"
#include "analysis/field_data.hpp"
#include "analysis/interface_report.hpp"
#include "analysis/regions.hpp"
#include "analysis/sampling.hpp"
#include "analysis/singularity_graph.hpp"
#include "analysis/solve_checks.hpp"
#include "analysis/walls.hpp"
#include "base/frames_in_lanes.hpp"
#include "base/instruction_set.hpp"
#include "base/lanes.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "field/nested_solve.hpp"
#include "field/solve_forecast.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/frame.hpp"
#include "surface/solid_split.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// Of the coefficients as they are written.
template <int D>
double largest_deviation(std::span<const StoredQuaternion> frames) {
  std::vector<double> largest((frames.size() + kParallelGrain - 1) / kParallelGrain);
  parallel_for_chunks(frames.size(), kParallelGrain, [&](std::size_t begin, std::size_t end) {
    run_in_lanes([&]<int W>() {
      Lanes<W> most = 0.0;
      for (std::size_t i = begin; i < end; i += W) {
        Coefficients<D, Lanes<W>> h = frame_coefficients<D>(frames_in_lanes<W>(frames, i));
        for (Lanes<W>& coefficient : h) coefficient = to_single(coefficient);
        const Lanes<W> here = deviation<D>(h);
        most = select(here > most, here, most);
      }
      for (int lane = 0; lane < W; ++lane)
        largest[begin / kParallelGrain] = std::max(largest[begin / kParallelGrain], most[lane]);
    });
  });
  return largest.empty() ? 0 : *std::max_element(largest.begin(), largest.end());
}

SolveReport::Model describe(const TriangleMesh& mesh, const Surface& surface,
                            const SurfaceTopology& topology) {
  SolveReport::Model model;
  model.triangles = mesh.triangles.size();
  model.bounding_box = surface.box;
  model.watertight = topology.watertight;
  model.components = topology.components;
  model.unit = mesh.unit;
  model.file_unit = mesh.file_unit;
  return model;
}

SolveReport report_of(const Solid& solid, const SolvedField& field, const AlignmentMeasurement& alignment,
                      const SolveOptions& options) {
  SolveReport report;
  report.degree = static_cast<int>(options.degree);
  const double resolution_asked =
      longest_side(solid.surface.box) / finest_cell_size(solid.surface.box, options);
  report.resolution = std::ldexp(resolution_asked, -field.levels_left_out);
  report.levels = field.levels;
  report.expected = field.expected;
  if (field.levels_left_out > 0)
    report.limited =
        SolveReport::Limited{resolution_asked, allowed_memory_bytes(options), field.memory_needed};
  report.energy.smoothness = field.energy.smoothness;
  report.energy.boundary = field.energy.boundary;
  report.energy.unavoidable = field.energy.unavoidable;
  report.energy.total = field.energy.total();
  report.energy.deviation_max = options.degree == Degree::kThree ? largest_deviation<3>(field.frames)
                                                                 : largest_deviation<4>(field.frames);
  report.alignment_deg = alignment.alignment_deg;
  report.spectrum = alignment.spectrum;
  report.walls = measure_walls(field.level, solid, options.refinement.thickness_cells);
  report.walls.tied_cells = field.tied_leaves;
  report.seconds.grid = field.grid_seconds;
  report.seconds.solve = field.solve_seconds;
  return report;
}

void add_regions(const TriangleMesh& mesh, const Surface& outer, const GridLevel& level, FieldData& data) {
  CellRegions found = find_regions(mesh, outer, level);
  data.regions = std::move(found.of_leaf);
  data.report.regions = std::move(found.regions);
  data.report.warnings.insert(data.report.warnings.end(), found.warnings.begin(), found.warnings.end());
}

std::shared_ptr<FieldData> solve_with(const TriangleMesh& mesh, const SolveOptions& options,
                                      const Monitor& monitor, const InitialFrame& initial_frame) {
  check_options(options);
  Stopwatch watch;
  watch.start();
  const ThreadLimit thread_limit(options.threads);
  const SolidSplit split = split_solids(mesh, options.unite_solids);
  const TriangleMesh& outer = split.outer ? *split.outer : mesh;
  const Surface surface = prepare_surface(outer);
  check_size(surface, options);
  const TriangleBvh bvh(surface);
  const WindingNumber winding(surface, bvh);
  const SurfaceTopology topology =
      has_several_solids(mesh) ? analyse_topology_of_solids(outer) : analyse_topology(outer);
  const CreaseNetwork creases(surface, split.inner, CreaseAngles{}, winding.flipped());
  Guides guides = guides_along(creases.curves, creases.corners, options.solver.crease_weight);
  guides.faces = guides_across(split.inner);
  const Solid solid{surface, bvh, winding, topology.watertight, &guides};
  SolvedField solved = nested_solve(solid, options, monitor, initial_frame, watch.restart());
  check_interior(solved.level, surface, topology);

  monitor.report({"analysis", 0, solved.level.size(), 0, std::numeric_limits<double>::quiet_NaN()});
  auto data = std::make_shared<FieldData>();
  data->degree = options.degree;
  data->energy_density = std::move(solved.energy_density);
  monitor.check();
  {
    AlignmentMeasurement alignment =
        measure_alignment(solved.level, solid, {solved.level.tree, solved.frames, solved.open_faces});
    data->alignment_deg = std::move(alignment.leaf_mean_deg);
    data->report = report_of(solid, solved, alignment, options);
  }
  monitor.check();
  data->on_boundary.resize(solved.level.size());
  parallel_for(solved.level.size(), [&](std::size_t i) {
    data->on_boundary[i] = solved.level.holds_surface(static_cast<CellIndex>(i));
  });
  data->report.singularity =
      singularity_graph(solved.level.tree, solved.frames, solved.open_faces, solved.near_sharp_turn).counts();
  data->report.model = describe(mesh, surface, topology);
  if (data->report.limited) data->report.warnings = {memory_warning(data->report)};
  data->report.warnings.insert(data->report.warnings.end(), mesh.warnings.begin(), mesh.warnings.end());
  const std::vector<std::string> faults = surface_warnings(surface, topology);
  data->report.warnings.insert(data->report.warnings.end(), faults.begin(), faults.end());
  const std::vector<std::string> unresolved = resolution_warnings(data->report);
  data->report.warnings.insert(data->report.warnings.end(), unresolved.begin(), unresolved.end());
  if (!solved.settled) data->report.warnings.push_back("the energy had not settled when the sweeps ran out");
  add_regions(mesh, surface, solved.level, *data);
  data->tree = std::move(solved.level.tree);
  data->frames = std::move(solved.frames);
  data->open_faces = std::move(solved.open_faces);
  const Sampler sampler(data->tree, data->frames, data->open_faces);
  data->report.creases = crease_report(creases, sampler, finest_cell_size(surface.box, options));
  data->report.interfaces = interface_report(split.inner, sampler, finest_cell_size(surface.box, options));
  const std::vector<std::string> impossible = crease_warnings(creases);
  data->report.warnings.insert(data->report.warnings.end(), impossible.begin(), impossible.end());
  return data;
}

}  // namespace

FrameField solve(const TriangleMesh& mesh, const SolveOptions& options, const Monitor& monitor) {
  return FrameField(solve_with(mesh, options, monitor, {}));
}

FrameField solve_from(const FrameField& earlier, const TriangleMesh& mesh, const SolveOptions& options,
                      const Monitor& monitor) {
  const FieldData& data = earlier.data();
  const Sampler sampler(data.tree, data.frames, data.open_faces);
  const auto initial_frame = [&](const Vector3& point) { return sampler.at(point).frame; };
  const std::shared_ptr<FieldData> result = solve_with(mesh, options, monitor, initial_frame);
  const std::string warning =
      other_model_warning(data.report.model.bounding_box, result->report.model.bounding_box);
  if (!warning.empty()) result->report.warnings.push_back(warning);
  return FrameField(result);
}

}  // namespace crossgrain

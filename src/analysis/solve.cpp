// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/solve.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "analysis/alignment.hpp"
#include "analysis/field_data.hpp"
#include "analysis/sampling.hpp"
#include "analysis/singularity_graph.hpp"
#include "analysis/walls.hpp"
#include "base/parallel.hpp"
#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "field/nested_solve.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/frame.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// Fewer cells across than this are no grid to speak of.
constexpr int kSmallestResolution = 4;

/// Shares of the surface's area above which the user is warned of thin walls and of what no frame can meet.
constexpr double kThinShareToWarnOf = 0.02;
constexpr double kExcludedShareToWarnOf = 0.1;

bool is_degree(Degree degree) {
  return degree == Degree::kThree || degree == Degree::kFour;
}

void check_options(const SolveOptions& options) {
  const auto refuse = [](const std::string& message) { throw Error(ErrorKind::kUsage, message); };
  const SolverOptions& solver = options.solver;
  if (!is_degree(options.degree) || !is_degree(solver.relaxation_degree)) refuse("a degree must be 3 or 4");
  if (!(options.cell_size >= 0) || std::isinf(options.cell_size))
    refuse("the cell size must be a positive number");
  if (options.cell_size == 0 && options.resolution < kSmallestResolution)
    refuse("the resolution must be at least 4");
  if (options.threads < 0) refuse("the number of threads must not be negative");
  if (!(solver.boundary_weight > 0)) refuse("the boundary weight must be positive");
  if (solver.starts < 1) refuse("there must be at least one start");
  if (solver.start_relaxation < 0 || solver.level_relaxation < 0 || solver.most_sweeps < 0) {
    refuse("numbers of sweeps must not be negative");
  }
  if (!(solver.symmetrisation >= 0 && solver.symmetrisation <= 1))
    refuse("the symmetrisation must lie in [0, 1]");
  if (!(solver.sweep_tolerance >= 0)) refuse("the sweep tolerance must not be negative");
  if (options.refinement.coarsest_cells < 1) refuse("the coarsest level needs a cell");
}

/// Active cells per squared finest cell of surface, and bytes per active cell: about what the shipped models
/// take.
constexpr double kCellsPerFace = 3;
constexpr double kBytesPerCell = 250;

/// Refuses what cannot fit into the machine before hours are spent on finding out.
void check_memory(const Surface& surface, double cell_size) {
  const double area = std::accumulate(surface.areas.begin(), surface.areas.end(), 0.0);
  const double cells = kCellsPerFace * area / (cell_size * cell_size);
  const double available = static_cast<double>(physical_memory_bytes());
  if (cells < kNoCell && (available == 0 || cells * kBytesPerCell < available)) return;
  const auto rounded = [](double value) { return std::to_string(std::llround(value)); };
  throw Error(ErrorKind::kLimit, "about " + rounded(cells / 1e6) + " million cells would need " +
                                     rounded(cells * kBytesPerCell / 1e9) + " GB, and the machine has " +
                                     rounded(available / 1e9) + " GB: lower the resolution");
}

template <int D>
double largest_deviation(std::span<const StoredQuaternion> frames) {
  double largest = 0;
  for (const StoredQuaternion& frame : frames) {
    const auto h = to_stored<D>(frame_coefficients<D>(from_stored(frame)));
    largest = std::max(largest, deviation<D>(from_stored<D>(h)));
  }
  return largest;
}

std::string percent(double share) {
  return std::to_string(static_cast<int>(std::lround(100 * share))) + " %";
}

std::vector<std::string> warnings_of(const SolveReport& report, const Surface& surface) {
  std::vector<std::string> warnings;
  if (surface.degenerate_triangles > 0) {
    warnings.push_back(std::to_string(surface.degenerate_triangles) +
                       " triangles without area were left out");
  }
  if (!report.model.watertight) {
    warnings.push_back(
        "the surface is not watertight: inside and outside are told apart by the winding number");
  }
  if (report.walls.thin_share > kThinShareToWarnOf) {
    const int wanted = static_cast<int>(std::lround(report.walls.cells_wanted));
    warnings.push_back("walls below " + std::to_string(wanted) + " cells under " +
                       percent(report.walls.thin_share) +
                       " of the surface: under-resolved there, raise the resolution");
  }
  if (report.alignment_deg.excluded_share > kExcludedShareToWarnOf) {
    warnings.push_back(
        percent(report.alignment_deg.excluded_share) +
        " of the surface lies in cells whose constraints no frame meets, and is left out of alignment_deg");
  }
  return warnings;
}

SolveReport::Model describe(const TriangleMesh& mesh, const Surface& surface) {
  SolveReport::Model model;
  model.triangles = mesh.triangles.size();
  model.bounding_box = surface.box;
  const SurfaceTopology topology = analyse_topology(mesh);
  model.watertight = topology.watertight;
  model.components = topology.components;
  return model;
}

SolveReport report_of(const Solid& solid, const SolvedField& field, const AlignmentMeasurement& alignment,
                      const SolveOptions& options) {
  SolveReport report;
  report.degree = static_cast<int>(options.degree);
  report.resolution = longest_side(solid.surface.box) / finest_cell_size(solid.surface.box, options);
  report.levels = field.levels;
  report.energy.smoothness = field.energy.smoothness;
  report.energy.boundary = field.energy.boundary;
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

FrameField solve_with(const TriangleMesh& mesh, const SolveOptions& options, const Monitor& monitor,
                      const InitialFrame& initial_frame) {
  check_options(options);
  const ThreadLimit thread_limit(options.threads);
  const Surface surface = prepare_surface(mesh);
  check_memory(surface, finest_cell_size(surface.box, options));
  const TriangleBvh bvh(surface);
  const WindingNumber winding(surface, bvh);
  const Solid solid{surface, bvh, winding};
  SolvedField solved = nested_solve(solid, options, monitor, initial_frame);

  auto data = std::make_shared<FieldData>();
  data->degree = options.degree;
  std::vector<double> density = energy_density(solved.level, solved.adjacency, solved.frames);
  data->energy_density.assign(density.begin(), density.end());
  density = {};
  solved.adjacency = {};
  monitor.check();
  {
    const Sampler sampler(solved.level.tree, solved.frames, solved.open_faces);
    AlignmentMeasurement alignment = measure_alignment(solved.level, solid, sampler);
    data->alignment_deg = std::move(alignment.leaf_mean_deg);
    data->report = report_of(solid, solved, alignment, options);
  }
  monitor.check();
  data->on_boundary.resize(solved.level.size());
  for (CellIndex i = 0; i < solved.level.size(); ++i) data->on_boundary[i] = solved.level.holds_surface(i);
  data->report.singularity = singularity_graph(solved.level.tree, solved.frames, solved.open_faces).counts();
  data->report.model = describe(mesh, surface);
  data->report.warnings = warnings_of(data->report, surface);
  data->tree = std::move(solved.level.tree);
  data->frames = std::move(solved.frames);
  data->open_faces = std::move(solved.open_faces);
  return FrameField(std::move(data));
}

}  // namespace

FrameField solve(const TriangleMesh& mesh, const SolveOptions& options, const Monitor& monitor) {
  return solve_with(mesh, options, monitor, {});
}

FrameField solve_from(const FrameField& earlier, const TriangleMesh& mesh, const SolveOptions& options,
                      const Monitor& monitor) {
  const FieldData& data = earlier.data();
  const Sampler sampler(data.tree, data.frames, data.open_faces);
  return solve_with(mesh, options, monitor, [&](const Vector3& point) { return sampler.at(point).frame; });
}

}  // namespace crossgrain

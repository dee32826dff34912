// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/frames_in_lanes.hpp"
#include "base/instruction_set.hpp"
#include "base/lanes.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/system_memory.hpp"
#include "field/field_data.hpp"
#include "field/nested_solve.hpp"
#include "field/solve_forecast.hpp"
#include "harmonics/deviation.hpp"
#include "harmonics/frame.hpp"
#include "measure/alignment.hpp"
#include "measure/constraint_report.hpp"
#include "measure/crease_report.hpp"
#include "measure/grid_surface.hpp"
#include "measure/input_report.hpp"
#include "measure/interface_report.hpp"
#include "measure/regions.hpp"
#include "measure/walls.hpp"
#include "sampling/places.hpp"
#include "sampling/sampling.hpp"
#include "singularity/singular_edges.hpp"
#include "singularity/singularity_graph.hpp"
#include "solve/decided_field.hpp"
#include "solve/kept_forms.hpp"
#include "solve/level_comparison.hpp"
#include "solve/prepared_model.hpp"
#include "solve/shared_solve.hpp"
#include "solve/solve_checks.hpp"
#include "solve/tuned_solve.hpp"

namespace crossgrain {
namespace {

/// Number of leaves whose turns a place on demand takes, Sampler::Turns.
constexpr std::size_t kTurnsPerPlace = 10;

/// Returns the largest deviation from symmetry of the coefficients, rounded to single precision as in files.
template <int D>
double largest_deviation(const Share& share, std::span<const StoredQuaternion> frames) {
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
  const double most = largest.empty() ? 0 : *std::max_element(largest.begin(), largest.end());
  return largest_of_all(share, most);
}

SolveReport report_of(const Solid& solid, const SolvedField& field, const AlignmentMeasurement& alignment,
                      const SolveTuning& options) {
  SolveReport report;
  const Share share = field.level.share();
  report.degree = static_cast<int>(options.degree);
  const double resolution_requested =
      longest_side(solid.surface.box) / finest_cell_size(solid.surface.box, options);
  report.resolution = std::ldexp(resolution_requested, -field.levels_left_out);
  report.levels = field.levels;
  report.expected = field.expected;
  if (field.stopped)
    report.unfinished = SolveReport::Unfinished{resolution_requested, field.levels_left_out, false};
  else if (field.levels_left_out > 0)
    report.limited = SolveReport::Limited{
        resolution_requested, allowed_memory_bytes(options.max_memory_bytes), field.memory_needed};
  report.energy.smoothness = field.energy.smoothness;
  report.energy.boundary = field.energy.boundary;
  report.energy.unavoidable = field.energy.unavoidable;
  report.energy.total = field.energy.total();
  report.energy.deviation_max = options.degree == Degree::kThree ? largest_deviation<3>(share, field.frames)
                                                                 : largest_deviation<4>(share, field.frames);
  report.alignment_deg = alignment.alignment_deg;
  report.spectrum = alignment.spectrum;
  report.walls = measure_walls(field.level, solid);
  report.walls.tied_cells = field.tied_leaves;
  report.seconds.grid = field.grid_seconds;
  report.seconds.solve = field.solve_seconds;
  return report;
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// Size of the finest cells, model units.
double cell_size_of(const SolveReport& report) {
  return longest_side(report.model.bounding_box) / report.resolution;
}

/// Sets what can be computed from the cells alone, without interpolation between them.
/// `creases` as in SingularEdges.
void describe_cells(const PreparedModel& model, const TriangleMesh& mesh,
                    std::span<const std::vector<Vector3>> creases, SolvedField& solved,
                    const CoarserGraphs& coarser, const SolveTuning& options, FieldData& data) {
  AlignmentMeasurement alignment =
      measure_alignment(solved.level, model.solid(), {solved.level.tree, solved.frames, solved.open_faces});
  data.alignment_deg = std::move(alignment.leaf_mean_deg);
  data.constraints = std::move(alignment.leaf_constraints);
  if (options.for_page)
    data.kept_forms = kept_forms(solved.level, model.solid(), options.degree, data.constraints);
  data.report = report_of(model.solid(), solved, alignment, options);
  data.report.model = model.description();
  data.report.faces = model.faces();
  data.report.input = model.findings();
  data.singularities = std::make_shared<const SingularityGraph>(
      singularity_graph(singular_grid_edges(solved.level.tree, solved.frames, solved.open_faces, creases,
                                            solved.near_sharp_turn, solved.level.share())));
  data.report.singularity = summary_of(*data.singularities);
  data.report.coarser = coarser.before(solved.levels.back().depth, *data.singularities,
                                       data.report.resolution, cell_size_of(data.report));
  data.on_boundary.resize(solved.level.size());
  parallel_for(solved.level.size(), [&](std::size_t i) {
    data.on_boundary[i] = solved.level.holds_surface(static_cast<CellIndex>(i));
  });
  CellRegions found = find_regions(mesh, model.surface(), solved.level);
  data.regions = std::move(found.of_leaf);
  data.report.regions = std::move(found.regions);

  // Triangles of solids that touch cross where they differ.
  if (!found.warnings.empty() && found.warnings.front().kind == WarningKind::kTouchingSolids)
    std::erase_if(data.report.input.findings, [](const SolveReport::Finding& finding) {
      return finding.kind == FindingKind::kOverlappingComponents;
    });
  std::vector<Warning>& warnings = data.report.warnings;
  if (data.report.unfinished) warnings.push_back(unfinished_warning(data.report));
  if (data.report.limited) warnings.push_back(memory_warning(data.report));
  append(warnings, mesh.warnings);
  // Solids that touch or overlap have a warning of their own, with their numbers.
  const auto is_of_solids = [&](FindingKind kind) {
    return !found.warnings.empty() && found.warnings.front().kind != WarningKind::kEmptySolids &&
           (kind == FindingKind::kTouchingComponents || kind == FindingKind::kOverlappingComponents);
  };
  for (const SolveReport::Finding& finding : data.report.input.findings)
    if (!is_of_solids(finding.kind))
      warnings.emplace_back(WarningKind::kSurfaceFinding,
                            sentence_of(finding, longest_side(model.surface().box)));
  append(warnings, resolution_warnings(data.report, model.surface(), options));
  if (!solved.settled)
    warnings.emplace_back(WarningKind::kNotSettled, "the energy had not settled when the sweeps ran out",
                          Remedy::kContinueSolve);
  append(warnings, found.warnings);
}

/// How frames for the report are sampled: creases have a few per cent as many places as there are cells.
Sampler::Turns turns_for(const PreparedModel& model, const RequestedAxes& asked, const Octree& tree) {
  const std::size_t places = asked.points.size() + asked.polylines.size() + asked.faces.size() +
                             asked.stresses.size() + model.inner_faces().triangles.size();
  return kTurnsPerPlace * places < tree.size() ? Sampler::Turns::kOnDemand : Sampler::Turns::kOfAll;
}

/// Reports how well the interpolated field meets the constraints besides the surface.
void describe_guides(const PreparedModel& model, const RequestedAxes& asked, const SolveTuning& options,
                     const PlaceSampler& sampler, FieldData& data) {
  const double finest = finest_cell_size(model.surface().box, options);
  data.report.creases = crease_report(model.creases(), sampler, finest);
  data.report.interfaces = interface_report(model.inner_faces(), sampler, finest);
  if (!options.constraints.empty()) {
    data.report.constraints = constraint_report(asked, sampler);
    if (auto outside = outside_constraints_warning(asked, options.constraints.source))
      data.report.warnings.push_back(std::move(*outside));
  }
  append(data.report.warnings, crease_warnings(model.creases()));
}

/// Sets what the field makes of the creases and corners of the surface, and with that the answer.
void describe_surface(const PlaceSampler& sampler, FieldData& data) {
  add_grid_surface(*data.surface.get(), sampler, cell_size_of(data.report), *data.singularities,
                   data.report.singularity);
  data.report.answer = answer_of(data.report);
}

/// Null in processes that have no part of the field.
std::shared_ptr<FieldData> solve_with(const TriangleMesh& mesh, const SolveTuning& options,
                                      const Monitor& monitor, InitialField initial, LevelSharing& sharing) {
  check_options(options);
  check_constraints(options.constraints);
  Stopwatch watch;
  const ThreadLimit thread_limit(options.threads);
  const WatchedLoops watched(monitor, Stops::kHeeded);
  check_surface_memory(mesh, options);
  PreparedModel model(mesh, options);
  const std::vector<std::vector<Vector3>> creases = model.crease_lines();
  CoarserGraphs coarser(creases);
  const std::unique_ptr<const DecidedField> decided =
      initial.frame_at || !sharing.is_first() ? nullptr
                                              : DecidedField::solved(model.solid(), options, monitor);
  if (decided) initial = decided->initial_field();
  SolvedField solved =
      nested_solve(model.solid(), options, monitor, initial, {watch.restart()}, &coarser, &sharing);
  if (solved.level.share().of_all == 0) return nullptr;
  check_interior(solved.level, model.mended());
  if (decided) {
    solved.grid_seconds += decided->seconds() - decided->field().solve_seconds;
    solved.solve_seconds += decided->field().solve_seconds;
  }

  // The field is complete, so a stop has no effect from here on.
  const WatchedLoops watched_to_the_end(monitor, Stops::kIgnored);
  const int level = static_cast<int>(solved.levels.size());
  monitor.report({Phase::kAnalysis, 0, static_cast<std::size_t>(solved.level.share().of_all), 0,
                  std::numeric_limits<double>::quiet_NaN(), level,
                  level + (solved.stopped ? solved.levels_left_out : 0)});
  monitor.check();
  auto data = std::make_shared<FieldData>();
  data->degree = options.degree;
  data->energy_density = std::move(solved.energy_density);
  describe_cells(model, mesh, creases, solved, coarser, options, *data);
  if (decided) data->report.decision = decided->description();
  monitor.check();
  const RequestedAxes asked = requested_axes(options.constraints, model.solid(), solved.level,
                                             finest_cell_size(model.surface().box, options));
  data->tree = std::move(solved.level.tree);
  data->part = solved.level.part;
  data->frames = std::move(solved.frames);
  data->open_faces = std::move(solved.open_faces);
  const Sampler sampler(data->tree, data->frames, data->open_faces, turns_for(model, asked, data->tree));
  const PlaceSampler places(sampler, data->tree, data->share(), solved.level.ghosts);
  describe_guides(model, asked, options, places, *data);
  data->surface = std::move(model).solved_surface();
  describe_surface(places, *data);
  leave_own_leaves(*data);
  return data;
}

}  // namespace

std::optional<FrameField> solve_together(LevelSharing& sharing, const FrameField* earlier,
                                         const TriangleMesh& mesh, const SolveTuning& options,
                                         const Monitor& monitor) {
  if (earlier == nullptr) {
    auto result = solve_with(mesh, options, monitor, {}, sharing);
    return result ? std::optional(FrameField(std::move(result))) : std::nullopt;
  }
  const FieldData& data = earlier->data();
  const Sampler sampler(data.tree, data.frames, data.open_faces);
  const InitialField start{[&sampler](const Vector3& point) { return sampler.at(point).frame; }};
  auto result = solve_with(mesh, options, monitor, start, sharing);
  if (!result) return std::nullopt;
  if (auto warning = other_model_warning(data.report.model.bounding_box, result->report.model.bounding_box))
    result->report.warnings.push_back(std::move(*warning));
  return FrameField(std::move(result));
}

FrameField solve(const TriangleMesh& mesh, const SolveTuning& options, const Monitor& monitor) {
  LevelSharing alone;
  return solve_together(alone, nullptr, mesh, options, monitor).value();
}

FrameField solve(const TriangleMesh& mesh, const SolveOptions& options, const Monitor& monitor) {
  return solve(mesh, SolveTuning(options), monitor);
}

FrameField solve_from(const FrameField& earlier, const TriangleMesh& mesh, const SolveOptions& options,
                      const Monitor& monitor) {
  return solve_from(earlier, mesh, SolveTuning(options), monitor);
}

FrameField solve_from(const FrameField& earlier, const TriangleMesh& mesh, const SolveTuning& options,
                      const Monitor& monitor) {
  LevelSharing alone;
  return solve_together(alone, &earlier, mesh, options, monitor).value();
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/elementary.hpp"
#include "base/names.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/thread_limit.hpp"
#include "field/field_data.hpp"
#include "field/tet_finish.hpp"
#include "measure/answer_limits.hpp"
#include "measure/part_size.hpp"
#include "measure/tet_evaluation.hpp"
#include "singularity/tet_surface.hpp"
#include "solve/carried_frames.hpp"
#include "solve/other_starts.hpp"
#include "solve/solve_checks.hpp"
#include "solve/tet_constraints.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"
#include "solve/tuned_solve.hpp"
#include "solve/used_features.hpp"
#include "tets/inner_walls.hpp"

namespace crossgrain {
namespace {

Extent extent_of(const TetDomainData& tets) {
  const double mean_tet = raised(tets.typical_edge_length, 3) / (6 * std::numbers::sqrt2);
  return {mean_tet * static_cast<double>(tets.solid.mesh.tets.size()), longest_side(tets.box)};
}

double edge_length_needed(const SolveReport::Walls& walls, const TetDomainData& tets) {
  if (walls.resolution_needed == 0) return 0;
  const double length = longest_side(tets.box) / walls.resolution_needed;
  return length < tets.typical_edge_length ? length : 0;
}

SolveReport::Onto describe(const TetDomainData& domain, const VertexFieldEvaluation& evaluation) {
  SolveReport::Onto onto;
  onto.vertices = domain.solid.mesh.vertices.size();
  onto.tets = domain.solid.mesh.tets.size();
  onto.unused_vertices = domain.solid.unused_vertices;
  onto.inverted_tets = domain.solid.inverted_tets;
  onto.left_out_tets = domain.solid.left_out_tets;
  onto.prepared = domain.preparation;
  onto.dirichlet = evaluation.dirichlet;
  onto.edge_sum = evaluation.edge_sum;
  onto.singular = evaluation.singular;
  onto.normal_deg = evaluation.normal_deg;
  onto.crease_deg = evaluation.crease_deg;
  return onto;
}

/// Finishes the frames carried from the grid, or those of the other start that ends lower; `start` of the
/// result is its number.
TetFrames best_finish(std::vector<Quaternion> carried, const FrameField& grid, const TetDomain& domain,
                      const BoundaryVertices& boundary, const SolveTuning& options, const Monitor& monitor) {
  const TetDomainData& tets = domain.data();
  // With steps of half an edge, a polyline misses only corners of tets.
  const std::vector<VertexGuide> guides =
      vertex_guides(options.constraints, tets.solid, boundary, 0.5 * tets.typical_edge_length);
  std::vector<std::vector<Quaternion>> starts{std::move(carried)};
  std::vector<std::size_t> numbers{0};
  for (StartFrames& other : other_starts(domain, grid.report().model.bounding_box, options)) {
    numbers.push_back(other.number);
    starts.push_back(std::move(other.frames));
  }
  TetFrames finished = finish_on_tets(tets.edges, boundary, std::move(starts), grid.data().degree,
                                      {options.onto, options.boundary}, monitor, guides, extent_of(tets));
  finished.start = numbers[finished.start];
  return finished;
}

}  // namespace

const char* name_of(TetBoundary boundary) {
  constexpr std::array kNames{"all", "smooth-only"};
  return name_among<TetBoundary::kSmoothOnly>(kNames, boundary);
}

TetFrameField carry_onto(const FrameField& grid, const TetDomain& domain, const SolveTuning& options,
                         const Monitor& monitor) {
  check_options(options);
  check_constraints(options.constraints);
  check_scale(domain.data().box);
  const ThreadLimit thread_limit(options.threads);
  const WatchedLoops watched(monitor, Stops::kHeeded);
  Stopwatch stopwatch;
  const TetDomainData& tets = domain.data();
  CarriedFrames start =
      carried_frames({grid.data().tree, grid.data().frames, grid.data().open_faces}, tets.solid);
  if (start.outside == tets.solid.mesh.vertices.size() - tets.solid.unused_vertices)
    throw Error(ErrorKind::kInput, "no vertex of the tets lies in the field's solid", Remedy::kMatchUnits);
  monitor.check_stop();
  auto field = std::make_shared<TetField>();
  const UsedFeatures used(tets, options.unite_solids);
  const BoundaryVertices& boundary = used.boundary();
  TetFrames finished = best_finish(std::move(start.frames), grid, domain, boundary, options, monitor);
  field->vertex_frames = std::move(finished.frames);
  field->tet_frames = tet_frames_of(tets.solid.mesh, field->vertex_frames);
  auto lines = std::make_shared<const SingularityGraph>(graph_of(tets.solid, *field));
  monitor.check_stop();

  SolveReport report = grid.report();
  // The grid only provides initial frames, so its resolution does not limit the field on tets
  // (docs/solver.md, "On tets").
  std::erase_if(report.warnings, is_of_resolution);
  report.faces = model_faces(tets.solid, tets.walls);
  report.onto = describe(tets, evaluate_vertex_field(tets.solid, boundary, tets.edges, field->vertex_frames));
  monitor.report({Phase::kTets, 0, tets.solid.mesh.vertices.size(), finished.sweeps, report.onto->dirichlet});
  report.onto->feature_edge_deg = angles_along(tets.solid, used.features().edges, field->vertex_frames);
  report.onto->boundary = options.boundary;
  report.onto->united = options.unite_solids && has_several_regions(tets.solid.mesh);
  report.onto->start = finished.start;
  report.onto->singularity = tet_summary(tets.solid, field->tet_frames, *lines);
  report.onto->edge_length = domain.typical_edge_length();
  report.onto->unfollowed_share = unfollowed_share(tets.solid, field->tet_frames, kUnfollowedDeg);
  report.onto->edge_length_needed = edge_length_needed(report.walls, tets);
  report.onto->outside_vertices = start.outside;
  report.onto->seconds = stopwatch.restart();
  report.warnings.insert(report.warnings.end(), domain.warnings().begin(), domain.warnings().end());
  if (!finished.settled)
    report.warnings.emplace_back(WarningKind::kTetsNotSettled,
                                 "the energy on the tets had not settled when the sweeps ran out");
  if (start.outside > 0) report.warnings.push_back(outside_warning(start.outside, report.onto->vertices));
  report.answer = answer_of(report);
  return {grid, domain, std::move(field), std::move(report), std::move(lines)};
}

TetFrameField carry_onto(const FrameField& grid, const TetDomain& domain, const SolveOptions& options,
                         const Monitor& monitor) {
  return carry_onto(grid, domain, SolveTuning(options), monitor);
}

TetFrameField solve_onto(const TetDomain& domain, const SolveOptions& options, const Monitor& monitor) {
  return solve_onto(domain, SolveTuning(options), monitor);
}

SolveOptions sized_for(const TetDomain& domain, SolveOptions options) {
  return sized_for(domain, SolveTuning(options));
}

TetFrameField solve_onto(const TetDomain& domain, const SolveTuning& options, const Monitor& monitor) {
  return solve_onto(domain, OntoStart(), options, monitor).value();
}

std::optional<TetFrameField> solve_onto(const TetDomain& domain, const OntoStart& start,
                                        const SolveTuning& options, const Monitor& monitor) {
  SolveTuning sized = sized_for(domain, options);
  // In the tets' own boundary several grids are compared instead (OntoTuning::other_starts).
  if (start.surface == nullptr) sized.solver.decision_cells = 0;
  if (start.earlier != nullptr) sized.onto.other_starts.clear();
  const TriangleMesh& surface = start.surface != nullptr ? *start.surface : domain.boundary();
  const std::optional<FrameField> grid = start.solve ? start.solve(start.earlier, surface, sized, monitor)
                                         : start.earlier != nullptr
                                             ? solve_from(*start.earlier, surface, sized, monitor)
                                             : solve(surface, sized, monitor);
  if (!grid) return std::nullopt;
  monitor.check_stop();
  return carry_onto(*grid, domain, sized, monitor);
}

SolveTuning sized_for(const TetDomain& domain, SolveTuning options) {
  check_options(options);
  if (options.cell_size > 0 || options.resolution > 0) return options;
  const double wanted = options.onto.cell_size_edges * domain.typical_edge_length();
  options.cell_size = std::min(wanted, longest_side(domain.data().box) / options.onto.fewest_cells);
  return options;
}

}  // namespace crossgrain

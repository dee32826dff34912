// SPDX-License-Identifier: Apache-2.0
#include "field/nested_solve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"
#include "field/manifold_sweep.hpp"
#include "field/relaxation.hpp"
#include "grid/refinement.hpp"

namespace crossgrain {
namespace {

using Frames = std::vector<StoredQuaternion>;

/// A squared turn between neighbours that is rounding of frames in single precision: where a field costs no
/// more than that, there is nothing left to lower.
constexpr double kNoise = 1e-12;

/// Relaxation, then sweeps on the manifold, on one level.
template <int D>
class LevelSolver {
 public:
  LevelSolver(const GridLevel& level, const Solid& solid, std::span<const WeightedEdge> edges,
              const SolveOptions& options, const Monitor& monitor, int depth)
      : level_(level), solid_(solid), options_(options.solver), monitor_(monitor), depth_(depth) {
    connectivity_ = std::make_shared<const Connectivity>(connectivity_of(level, edges));
    total_weight_ = parallel_sum(level.size(), [&](std::size_t i) {
      double sum = 0;
      for (const Adjacency::Neighbour& neighbour : connectivity_->adjacency[i]) sum += neighbour.weight;
      return sum;
    });
    graph_ = {connectivity_, boundary_forms<D>(level, solid, options_.boundary_weight, Shift::kNone)};
  }

  /// Relaxation under a penalty that grows from sweep to sweep, and projection.
  Frames relaxed(Frames frames, int sweeps) {
    return options_.relaxation_degree == Degree::kThree
               ? relaxed_in(relaxed_graph3_, std::move(frames), sweeps)
               : relaxed_in(relaxed_graph4_, std::move(frames), sweeps);
  }

  /// Sweeps on the manifold until the energy settles.
  Frames settled(Frames frames) {
    FieldState<D> state = state_of<D>(std::move(frames));
    double energy = graph_energy(graph_, state);
    for (int sweep = 0; sweep < options_.most_sweeps; ++sweep) {
      const double decrease = manifold_sweep(graph_, state);
      energy -= decrease;
      advance(energy);
      settled_ = decrease <= options_.sweep_tolerance * energy + kNoise * total_weight_;
      if (settled_) break;
    }
    return std::move(state.frames);
  }

  EnergyParts energy(const Frames& frames) const {
    return degree_four_energy(level_, solid_, connectivity_->adjacency, frames, options_.boundary_weight);
  }

  const Adjacency& adjacency() const { return connectivity_->adjacency; }
  int sweeps() const { return sweeps_; }

  /// Whether the last field that was swept came to rest.
  bool is_settled() const { return settled_; }

 private:
  template <int R>
  Frames relaxed_in(FieldGraph<R>& graph, Frames frames, int sweeps) {
    if (!graph.connectivity) {
      const Shift shift = options_.shift_relaxed_forms ? Shift::kSpectral : Shift::kNone;
      graph = {connectivity_, boundary_forms<R>(level_, solid_, options_.boundary_weight, shift)};
    }
    FieldState<R> state = state_of<R>(std::move(frames));
    for (int sweep = 0; sweep < sweeps; ++sweep) {
      relaxation_sweep(graph, state, options_.symmetrisation * (sweep + 1) / sweeps);
      advance(std::numeric_limits<double>::quiet_NaN());
    }
    project_to_frames(state);
    return std::move(state.frames);
  }

  void advance(double energy) {
    ++sweeps_;
    monitor_.check();
    monitor_.report({"solve", depth_, level_.size(), sweeps_, energy});
  }

  const GridLevel& level_;
  const Solid& solid_;
  const SolverOptions& options_;
  const Monitor& monitor_;
  int depth_;
  std::shared_ptr<const Connectivity> connectivity_;
  double total_weight_;
  FieldGraph<D> graph_;
  FieldGraph<3> relaxed_graph3_;
  FieldGraph<4> relaxed_graph4_;
  int sweeps_ = 0;
  bool settled_ = true;
};

/// Each leaf takes the frame of the leaf it came from.
Frames inherited(const Frames& frames, const GridLevel& level) {
  Frames result(level.size());
  for (CellIndex i = 0; i < level.size(); ++i) result[i] = frames[level.parent[i]];
  return result;
}

Frames sampled(const InitialFrame& initial_frame, const GridLevel& level) {
  Frames frames(level.size());
  parallel_for(level.size(), [&](std::size_t i) {
    frames[i] = to_stored(initial_frame(level.tree.centre(static_cast<CellIndex>(i))));
  });
  return frames;
}

/// The nested iteration: one grid level at a time, and on it the frames of every start that is still in the
/// race.
template <int D>
class NestedSolver {
 public:
  NestedSolver(const Solid& solid, const SolveOptions& options, const Monitor& monitor,
               const InitialFrame& initial_frame)
      : solid_(solid), options_(options), monitor_(monitor), initial_frame_(initial_frame) {}

  SolvedField run() {
    level_watch_.start();
    grid_watch_.start();
    const auto [root, finest_depth] =
        frame_around(solid_.surface.box, finest_cell_size(solid_.surface.box, options_));
    const int coarsest_depth = std::max(0, finest_depth - levels_above_finest());
    result_.level = uniform_level(solid_, root, coarsest_depth, monitor_);
    for (int depth = coarsest_depth;; ++depth) {
      if (result_.level.size() == 0)
        throw Error(ErrorKind::kInput,
                    "the parts of the surface are too small for the cells; raise the resolution");
      const bool coarsest = depth == coarsest_depth, finest = depth == finest_depth;
      solve_level(depth, coarsest, finest);
      if (finest) break;
      refine(finest_depth);
    }
    result_.frames = std::move(candidates_.front());
    result_.grid_seconds = grid_watch_.seconds();
    result_.solve_seconds = solve_watch_.seconds();
    return std::move(result_);
  }

 private:
  int levels_above_finest() const {
    const Box& box = solid_.surface.box;
    const double ratio =
        longest_side(box) / finest_cell_size(box, options_) / options_.refinement.coarsest_cells;
    // The margin keeps powers of two what they are.
    return std::max(0, static_cast<int>(std::floor(std::log2(ratio) + 1e-9)));
  }

  void solve_level(int depth, bool coarsest, bool finest) {
    const GridLevel& level = result_.level;
    monitor_.report({"grid", depth, level.size(), 0, std::numeric_limits<double>::quiet_NaN()});
    LeafConnections connections = connect_leaves(level, solid_, monitor_);
    LevelSolver<D> solver(level, solid_, connections.edges, options_, monitor_, depth);
    result_.open_faces = std::move(connections.open_faces);
    result_.tied_leaves = connections.tied_leaves;
    connections = {};
    grid_watch_.stop();

    solve_watch_.start();
    start_candidates(coarsest);
    for (std::size_t c = 0; c < candidates_.size(); ++c) advance_candidate(solver, c, coarsest);
    keep_best(solver, finest || level.size() > options_.solver.start_cells);
    density_ = finest || candidates_.size() > 1
                   ? std::vector<double>{}
                   : energy_density(level, solver.adjacency(), candidates_.front());
    result_.settled = solver.is_settled();
    solve_watch_.stop();
    result_.levels.push_back({depth, level.examined_leaves, level.size(), solver.sweeps(),
                              result_.energy.total(), level_watch_.restart()});
    if (finest) result_.adjacency = solver.adjacency();
    grid_watch_.start();
  }

  void start_candidates(bool coarsest) {
    if (initial_frame_) {
      candidates_ = {sampled(initial_frame_, result_.level)};
    } else if (coarsest) {
      for (int start = 0; start < std::max(1, options_.solver.starts); ++start) {
        // Seeds far apart, so that start k of one seed is not start k - 1 of the next.
        const std::uint64_t seed = options_.seed * 0x9e3779b97f4a7c15 + static_cast<std::uint64_t>(start);
        candidates_.push_back(random_frames(result_.level.size(), seed));
      }
    } else {
      for (Frames& frames : candidates_) frames = inherited(frames, result_.level);
    }
  }

  void advance_candidate(LevelSolver<D>& solver, std::size_t c, bool coarsest) {
    const SolverOptions& options = options_.solver;
    Frames& frames = candidates_[c];
    if (!initial_frame_ && coarsest) {
      const double sweeps = options.start_relaxation / std::pow(3.0, static_cast<double>(c));
      frames = solver.relaxed(std::move(frames), static_cast<int>(sweeps));
    } else if (!initial_frame_ && result_.level.size() <= options.relaxed_cells) {
      frames = solver.relaxed(std::move(frames), options.level_relaxation);
    }
    frames = solver.settled(std::move(frames));
  }

  /// Brings the candidate of lowest energy to the front, and ends the race if told to.
  void keep_best(const LevelSolver<D>& solver, bool end_race) {
    std::size_t best = 0;
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      const EnergyParts energy = solver.energy(candidates_[c]);
      if (c == 0 || energy.total() < result_.energy.total()) {
        result_.energy = energy;
        best = c;
      }
    }
    if (end_race) {
      if (best > 0) candidates_[0] = std::move(candidates_[best]);
      candidates_.resize(1);
    }
  }

  void refine(int finest_depth) {
    // While several fields are in the race no single one says where to refine.
    const Marks marks = candidates_.size() > 1 ? Marks(result_.level.size(), true)
                                               : refinement_marks(result_.level, solid_, density_,
                                                                  finest_depth, options_.refinement);
    density_ = {};
    result_.level = refined(result_.level, solid_, marks, monitor_);
  }

  const Solid& solid_;
  const SolveOptions& options_;
  const Monitor& monitor_;
  const InitialFrame& initial_frame_;
  SolvedField result_;
  std::vector<Frames> candidates_;
  std::vector<double> density_;
  Stopwatch grid_watch_, solve_watch_, level_watch_;
};

}  // namespace

SolvedField nested_solve(const Solid& solid, const SolveOptions& options, const Monitor& monitor,
                         const InitialFrame& initial_frame) {
  return options.degree == Degree::kThree ? NestedSolver<3>(solid, options, monitor, initial_frame).run()
                                          : NestedSolver<4>(solid, options, monitor, initial_frame).run();
}

}  // namespace crossgrain

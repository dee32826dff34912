// SPDX-License-Identifier: Apache-2.0
#include "field/nested_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "field/leaf_stencil.hpp"
#include "field/solve_forecast.hpp"
#include "field/stages.hpp"
#include "grid/refinement.hpp"

namespace crossgrain {
namespace {

using Frames = std::vector<StoredQuaternion>;

/// The field of one start on the last level.
using Candidate = SettledFrames;

/// Relaxation and manifold sweeps on one level.
double volume_of(const Octree& tree) {
  return parallel_sum(tree.size(), [&](std::size_t i) {
    const double size = tree.root().cell_size(tree[static_cast<CellIndex>(i)].depth());
    return size * size * size;
  });
}

template <int D>
class LevelSolver {
 public:
  LevelSolver(const GridLevel& level, const Solid& solid, std::shared_ptr<const Connectivity> connectivity,
              const SolveOptions& options, const Monitor& monitor, const Progress& place)
      : level_(level),
        solid_(solid),
        options_(options.solver),
        monitor_(monitor),
        progress_(place),
        connectivity_(std::move(connectivity)) {
    graph_ = {connectivity_, boundary_forms<D>(level, solid, options_.boundary_weight, Shift::kNone)};
  }

  /// Relaxes if `relaxation_sweeps` is positive, then sweeps on the manifold until the energy settles.
  SettledFrames solved(Frames frames, int relaxation_sweeps, const InitialField& initial) {
    RelaxationPlan relaxation{relaxation_sweeps, options_.symmetrisation, options_.over_relaxation};
    std::vector<float> penalty_shares;
    if (relaxation_sweeps > 0 && initial.core_size > 0) {
      penalty_shares = penalty_shares_for(initial.core_size);
      relaxation.grows = false;
      relaxation.penalty_shares = penalty_shares;
    }
    SettlingPlan settling = settling_plan(options_, connectivity_->adjacency, volume_of(level_.tree),
                                          longest_side(solid_.surface.box));
    std::function<Frames(Frames)> relax;
    if (relaxation_sweeps > 0) {
      settling.sliding_fraction = initial.sliding_tolerance;
      relax = [=, this](Frames came) {
        return options_.relaxation_degree == Degree::kThree
                   ? relaxed_in(relaxed_graph3_, std::move(came), relaxation)
                   : relaxed_in(relaxed_graph4_, std::move(came), relaxation);
      };
    }
    return relaxed_and_settled(graph_, std::move(frames), relax, settling, [this](double e) { advance(e); });
  }

  int sweeps() const { return progress_.sweep; }

 private:
  /// A core of radius r balances smoothness, of weight h in cells of size h, against a penalty of weight h^3
  /// / r^2 in them.
  std::vector<float> penalty_shares_for(double core_size) const {
    std::vector<float> shares(level_.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const double ratio = level_.tree.cell_size(static_cast<CellIndex>(i)) / core_size;
      shares[i] = static_cast<float>(std::min(1.0, ratio * ratio));
    }
    return shares;
  }

  template <int R>
  Frames relaxed_in(FieldGraph<R>& graph, Frames frames, const RelaxationPlan& plan) {
    const auto after_sweep = [this](double energy) { advance(energy); };
    if constexpr (R == D) {
      if (!options_.shift_relaxed_forms) return relaxed(graph_, std::move(frames), plan, after_sweep);
    }
    if (!graph.connectivity) {
      const Shift shift = options_.shift_relaxed_forms ? Shift::kSpectral : Shift::kNone;
      graph = {connectivity_, boundary_forms<R>(level_, solid_, options_.boundary_weight, shift)};
    }
    return relaxed(graph, std::move(frames), plan, after_sweep);
  }

  void advance(double energy) {
    ++progress_.sweep;
    progress_.energy = energy;
    monitor_.check_stop();
    monitor_.report(progress_);
  }

  const GridLevel& level_;
  const Solid& solid_;
  const SolverOptions& options_;
  const Monitor& monitor_;
  Progress progress_;
  std::shared_ptr<const Connectivity> connectivity_;
  FieldGraph<D> graph_;
  FieldGraph<3> relaxed_graph3_;
  FieldGraph<4> relaxed_graph4_;
};

/// Returns for each leaf the frame of its parent.
Frames inherited(const Frames& frames, const std::vector<CellIndex>& parent) {
  auto result = sized_vector<StoredQuaternion>(parent.size());
  parallel_for(parent.size(), [&](std::size_t i) { result[i] = frames[parent[i]]; });
  return result;
}

Frames sampled(const InitialField& initial, const GridLevel& level) {
  Frames frames(level.size());
  parallel_for(level.size(), [&](std::size_t i) {
    frames[i] = to_stored(initial.frame_at(level.tree.centre(static_cast<CellIndex>(i))));
  });
  return frames;
}

/// The nested iteration, level by level, with the frames of all starts that are still candidates.
template <int D>
class NestedSolver {
 public:
  NestedSolver(const Solid& solid, const SolveOptions& options, const Monitor& monitor,
               const InitialField& initial, const PlaceInRun& place, const VisitLevel& visit_level)
      : solid_(solid),
        options_(options),
        monitor_(monitor),
        initial_(initial),
        visit_level_(visit_level),
        is_decision_(place.is_decision),
        seconds_so_far_(place.seconds_before) {}

  SolvedField run() {
    level_watch_.start();
    grid_watch_.start();
    try {
      solve_levels();
      result_.frames = std::move(candidates_.front().frames);
    } catch (const Error& error) {
      const bool is_stop = error.kind() == ErrorKind::kInterrupted && !monitor_.cancelled();
      if (!is_stop || !may_be_stopped() || !can_stand_alone(coarser_)) throw;
      result_ = std::move(coarser_);
      result_.stopped = true;
    }
    result_.grid_seconds = grid_watch_.seconds();
    result_.solve_seconds = solve_watch_.seconds();
    return std::move(result_);
  }

 private:
  void solve_levels() {
    monitor_.check_stop();
    const auto [root, finest_depth] =
        frame_around(solid_.surface.box, finest_cell_size(solid_.surface.box, options_));
    coarsest_depth_ = std::max(0, finest_depth - levels_above_finest());
    level_count_ = number_of(finest_depth);
    SolveForecast forecast(options_, finest_depth, current_memory_bytes(), may_be_stopped());
    report(Phase::kGrid, coarsest_depth_, 0);
    RefinedLevel made = uniform_level(solid_, root, coarsest_depth_, monitor_);
    for (int depth = coarsest_depth_;; ++depth) {
      result_.level = std::move(made.level);
      if (result_.level.size() == 0)
        throw Error(ErrorKind::kInput,
                    "the parts of the surface are too small for the cells; raise the resolution");
      result_.levels_left_out = finest_depth - depth;
      const LevelGrowth growth(result_.level, solid_, options_.refinement);
      const bool finest = depth == finest_depth || !next_fits(forecast, growth);
      if (finest) level_count_ = number_of(depth);
      report(Phase::kGrid, depth, result_.level.size());
      // No level follows the finest one: its neighbours end here.
      Connectivity connectivity =
          finest ? connect(std::vector(std::move(made.neighbours))) : connect(made.neighbours);
      solve_level(depth, std::move(connectivity), std::move(made.parent), finest);
      if (finest) return;
      if (!is_decision_) predict(forecast, growth);
      made = refine(std::move(made.neighbours), depth, finest_depth);
    }
  }

  /// 1-based number of the level; 1 is the coarsest. 0 if levels have no numbers.
  int number_of(int depth) const { return is_decision_ ? 0 : depth - coarsest_depth_ + 1; }

  bool may_be_stopped() const { return monitor_.may_be_stopped() && !is_decision_; }

  void report(Phase phase, int depth, std::size_t cells) const {
    monitor_.report({is_decision_ ? Phase::kSolve : phase, depth, cells, 0,
                     std::numeric_limits<double>::quiet_NaN(), number_of(depth), level_count_});
  }

  /// Reports the energy of the finished level as SolveReport::Energy has it, whatever the sweeps minimise.
  void report_energy(Progress place, int sweeps) const {
    place.sweep = sweeps;
    place.energy = result_.energy.total() + result_.energy.unavoidable;
    monitor_.report(place);
  }

  /// Returns whether a finished level was kept and has an inside; very coarse ones may have none.
  static bool can_stand_alone(const SolvedField& field) {
    const auto& winding = field.level.centre_winding;
    return std::any_of(winding.begin(), winding.end(), [](int w) { return w > 0; });
  }

  int levels_above_finest() const {
    if (initial_.first_cell_size > 0) {
      const double finest = finest_cell_size(solid_.surface.box, options_);
      return std::max(1, static_cast<int>(std::lround(std::log2(initial_.first_cell_size / finest))));
    }
    const double ratio = finest_resolution() / options_.refinement.coarsest_cells;
    // The margin keeps powers of two exact.
    return std::max(0, static_cast<int>(std::floor(std::log2(ratio) + 1e-9)));
  }

  double finest_resolution() const {
    const Box& box = solid_.surface.box;
    return longest_side(box) / finest_cell_size(box, options_);
  }

  /// Returns whether the next level fits into memory. Throws Error(kLimit) if too many levels would be left
  /// out.
  bool next_fits(const SolveForecast& forecast, const LevelGrowth& growth) {
    const LevelCounts next = growth.after(1);
    if (forecast.fits(next)) return true;
    result_.memory_needed = static_cast<std::size_t>(forecast.peak_memory(next));
    if (result_.levels_left_out > kMostLevelsLeftOut) {
      throw Error(
          ErrorKind::kLimit,
          fmt::format("{:.3g} cells along the longest side would need {:.3g} GB, and {:.3g} GB are allowed",
                      std::ldexp(finest_resolution(), 1 - result_.levels_left_out),
                      forecast.peak_memory(next) / 1e9,
                      static_cast<double>(forecast.memory_limit_bytes()) / 1e9),
          Remedy::kUseLessMemory);
    }
    return false;
  }

  void predict(SolveForecast& forecast, const LevelGrowth& growth) {
    const LevelStatistics& level = result_.levels.back();
    // A surface that encloses nothing is refused in the end, so there is nothing to expect.
    const auto& winding = result_.level.centre_winding;
    if (std::none_of(winding.begin(), winding.end(), [](int w) { return w > 0; })) return;
    const std::optional<Expectation> expected = forecast.forecast_from(
        level.depth, growth, level.sweeps, level.seconds, seconds_so_far_, finest_resolution());
    if (!expected) return;
    result_.expected = expected;
    const double left_out = std::log2(finest_resolution() / expected->resolution);
    level_count_ = number_of(level.depth + result_.levels_left_out) - static_cast<int>(std::lround(left_out));
    monitor_.expect(*expected);
  }

  /// Which leaves are compared with which. `neighbours` as in RefinedLevel.
  Connectivity connect(const std::vector<FaceNeighbours>& neighbours) {
    LeafConnections connections = connect_leaves(result_.level, neighbours, solid_, monitor_);
    Connectivity connectivity =
        connectivity_of(result_.level, neighbours, connections, options_.solver.diagonal_share);
    result_.open_faces = std::move(connections.open_faces);
    result_.tied_leaves = connections.tied_leaves;
    return connectivity;
  }

  /// `parent` as in RefinedLevel.
  void solve_level(int depth, Connectivity connectivity, std::vector<CellIndex> parent, bool finest) {
    const GridLevel& level = result_.level;
    const Progress place{Phase::kSolve, depth, level.size(), 0, 0, number_of(depth), level_count_};
    const Swept swept = settle(std::move(connectivity), std::move(parent), depth == coarsest_depth_, place);
    keep_best(swept.adjacency, finest || level.size() > options_.solver.start_cells, finest);
    report_energy(place, swept.sweeps);
    if (!finest && visit_level_)
      visit_level_({depth, level.tree, candidates_[best_].frames, result_.open_faces});
    solve_watch_.stop();
    result_.levels.push_back({depth, level.examined_leaves, level.size(), swept.sweeps,
                              result_.energy.total(), level_watch_.restart()});
    seconds_so_far_ += result_.levels.back().seconds;
    grid_watch_.start();
  }

  /// Makes the first frames of every candidate. `parent` as in RefinedLevel.
  void start_candidates(int depth, bool coarsest, std::vector<CellIndex> parent) {
    const double cell_size = result_.level.tree.root().cell_size(depth);
    if (initial_.frame_at && (coarsest || cell_size >= initial_.last_cell_size)) {
      candidates_.resize(1);
      candidates_[0].frames = sampled(initial_, result_.level);
    } else if (coarsest) {
      candidates_.resize(static_cast<std::size_t>(std::max(1, options_.solver.starts)));
      for (std::size_t start = 0; start < candidates_.size(); ++start) {
        // Seeds are spread, so that start k of one seed is not start k - 1 of the next.
        const std::uint64_t seed = options_.seed * 0x9e3779b97f4a7c15 + start;
        candidates_[start].frames = random_frames(result_.level.size(), seed);
      }
    } else {
      for (Candidate& candidate : candidates_)
        candidate.frames = inherited(candidate.frames.empty() ? coarser_.frames : candidate.frames, parent);
    }
  }

  /// What is left of a level's solver once all candidates have settled.
  struct Swept {
    Adjacency adjacency;
    int sweeps;
  };

  Swept settle(Connectivity connectivity, std::vector<CellIndex> parent, bool coarsest,
               const Progress& place) {
    const auto shared = std::make_shared<Connectivity>(std::move(connectivity));
    LevelSolver<D> solver(result_.level, solid_, shared, options_, monitor_, place);
    grid_watch_.stop();

    solve_watch_.start();
    start_candidates(place.depth, coarsest, std::move(parent));
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      candidates_[c] =
          solver.solved(std::move(candidates_[c].frames), relaxation_sweeps(c, coarsest), initial_);
    }
    return {std::move(shared->adjacency), solver.sweeps()};  // all else ends here, to make room
  }

  int relaxation_sweeps(std::size_t start, bool coarsest) const {
    const SolverOptions& options = options_.solver;
    if (initial_.frame_at)
      return result_.level.size() <= initial_.relaxed_cells ? initial_.relaxation_sweeps : 0;
    if (coarsest)
      return static_cast<int>(options.start_relaxation / std::pow(3.0, static_cast<double>(start)));
    return is_uniform_ ? options.level_relaxation : 0;
  }

  /// Finds the candidate of lowest energy; with `end_race`, drops the others.
  void keep_best(const Adjacency& adjacency, bool end_race, bool finest) {
    best_ = 0;
    const SharpTurns sharp_turns = finest ? SharpTurns::kLookedFor : SharpTurns::kLeftOut;
    std::vector<std::uint8_t> turns_sharply;
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      LevelEnergy energy = level_energy(result_.level, solid_, adjacency, candidates_[c].frames,
                                        options_.solver.boundary_weight, sharp_turns);
      if (c == 0 || energy.parts.total() + energy.parts.unavoidable <
                        result_.energy.total() + result_.energy.unavoidable) {
        result_.energy = energy.parts;
        result_.energy_density = std::move(energy.neighbours.energy_density);
        turns_sharply = std::move(energy.neighbours.turns_sharply);
        result_.settled = candidates_[c].settled;
        best_ = c;
      }
    }
    if (finest) result_.near_sharp_turn = near_sharp_turns(adjacency, turns_sharply);
    if (end_race) {
      if (best_ > 0) candidates_[0] = std::move(candidates_[std::exchange(best_, 0)]);
      candidates_.resize(1);
    }
  }

  /// Returns the next level and makes `result_` ready for it. `neighbours` are those of the solved level.
  RefinedLevel refine(std::vector<FaceNeighbours> neighbours, int depth, int finest_depth) {
    is_uniform_ = is_uniform_ && 8 * result_.level.size() <= options_.solver.relaxed_cells;
    // With several candidates no single field says where to refine.
    Marks marks = is_uniform_ || candidates_.size() > 1
                      ? Marks(result_.level.size(), true)
                      : refinement_marks(result_.level, neighbours, solid_, result_.energy_density,
                                         finest_depth, options_.refinement);
    SolvedField next;
    next.levels = result_.levels;
    next.expected = result_.expected;
    GridLevel ending;  // the solved level, unless it is kept
    if (may_be_stopped())
      keep_solved();
    else
      ending = std::move(result_.level);
    result_ = std::move(next);
    report(Phase::kGrid, depth + 1, 0);
    const GridLevel& level = may_be_stopped() ? coarser_.level : ending;
    return refined(level, neighbours, solid_, std::move(marks), monitor_);
  }

  /// Keeps the solved level, which is the result if the solve is stopped before the next level is finished.
  void keep_solved() {
    coarser_ = std::move(result_);
    // Several candidates all need their frames for the next level; that happens on small levels only.
    Frames& frames = candidates_[best_].frames;
    coarser_.frames = candidates_.size() == 1 ? std::move(frames) : frames;
  }

  const Solid& solid_;
  const SolveOptions& options_;
  const Monitor& monitor_;
  const InitialField& initial_;
  const VisitLevel& visit_level_;
  const bool is_decision_;
  SolvedField result_;   ///< the level being built or solved
  SolvedField coarser_;  ///< the finished level before it, if the solve may be stopped

  /// Fields of the starts that are still compared. If the solve may be stopped, a single one moves its frames
  /// to coarser_ between levels.
  std::vector<Candidate> candidates_;
  std::size_t best_ = 0;  ///< the candidate of lowest energy on the last level
  int coarsest_depth_ = 0;
  int level_count_ = 0;  ///< as far as known
  Stopwatch grid_watch_, solve_watch_, level_watch_;
  double seconds_so_far_;
  bool is_uniform_ = true;  ///< all cells of the level have one size; the level is small and relaxed
};

}  // namespace

SolvedField nested_solve(const Solid& solid, const SolveOptions& options, const Monitor& monitor,
                         const InitialField& initial, const PlaceInRun& place,
                         const VisitLevel& visit_level) {
  return options.degree == Degree::kThree
             ? NestedSolver<3>(solid, options, monitor, initial, place, visit_level).run()
             : NestedSolver<4>(solid, options, monitor, initial, place, visit_level).run();
}

}  // namespace crossgrain

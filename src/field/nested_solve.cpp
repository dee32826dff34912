// SPDX-License-Identifier: Apache-2.0
#include "field/nested_solve.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "field/candidates.hpp"
#include "field/finished_level.hpp"
#include "field/leaf_stencil.hpp"
#include "field/level_progress.hpp"
#include "field/level_solver.hpp"
#include "field/solve_forecast.hpp"
#include "grid/refinement.hpp"

namespace crossgrain {
namespace {

using Frames = std::vector<StoredQuaternion>;

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
  NestedSolver(const Solid& solid, const SolveTuning& options, const Monitor& monitor,
               const InitialField& initial, const PlaceInRun& place, LevelVisitor* visitor,
               LevelSharing& sharing)
      : solid_(solid),
        options_(options),
        monitor_(monitor),
        initial_(initial),
        visitor_(visitor),
        sharing_(sharing),
        is_decision_(place.is_decision),
        may_be_stopped_(monitor.may_be_stopped() && !place.is_decision && sharing.processes() == 1),
        has_field_(initial.frame_at != nullptr),
        progress_(monitor, place.is_decision),
        finished_(may_be_stopped_),
        seconds_so_far_(place.seconds_before) {}

  SolvedField run() {
    level_watch_.start();
    grid_watch_.start();
    try {
      solve_all_levels();
    } catch (const Error& error) {
      const bool is_stop = error.kind() == ErrorKind::kInterrupted && !monitor_.cancelled();
      if (!is_stop || !finished_.is_result()) throw;
      result_ = std::move(finished_).result();
    }
    result_.grid_seconds = grid_watch_.seconds();
    result_.solve_seconds = solve_watch_.seconds();
    return std::move(result_);
  }

 private:
  /// A level to solve, with the frames of candidates_.
  struct Start {
    int depth;
    RefinedLevel made;
  };

  void solve_all_levels() {
    if (const auto start = sharing_.begin(solid_, options_, visitor_)) {
      solve_levels_from(begun_from(*start));
    } else if (sharing_.is_first()) {
      try {
        solve_levels_from(coarsest_level());
      } catch (...) {
        sharing_.end_alone(/*has_failed=*/true);
        throw;
      }
      sharing_.end_alone(/*has_failed=*/false);
    } else {
      return;
    }
    result_.frames = std::move(candidates_.front().frames);
    sharing_.update_ghosts(std::span(result_.frames));
    sharing_.update_ghosts(std::span(result_.open_faces));
  }

  Start begun_from(const LevelStart& start) {
    initial_.relaxed = start.relaxed;
    progress_.begin_at(start.coarsest_depth);
    is_uniform_ = start.is_uniform;
    has_field_ = start.has_field;
    result_.levels = start.levels;
    result_.expected = start.expected;
    RefinedLevel made;
    made.level.tree = Octree(frame().root, {});
    made = started(start, std::move(made), {});
    return {start.depth, std::move(made)};
  }

  GridFrame frame() const {
    return frame_around(solid_.surface.box, finest_cell_size(solid_.surface.box, options_));
  }

  Start coarsest_level() {
    monitor_.check_stop();
    const auto [root, finest_depth] = frame();
    const int depth = std::max(0, finest_depth - levels_above_finest());
    progress_.begin_at(depth);
    progress_.tell_grid(depth, 0);
    return {depth, uniform_level(solid_, root, depth, monitor_)};
  }

  void solve_levels_from(Start start) {
    const int finest_depth = frame().finest_depth;
    progress_.end_at(finest_depth);
    SolveForecast forecast(options_, finest_depth, current_memory_bytes(), may_be_stopped_, initial_.relaxed,
                           {sharing_.processes(), static_cast<double>(sharing_.fewest_leaves())});
    RefinedLevel made = std::move(start.made);
    for (int depth = start.depth;; ++depth) {
      result_.level = std::move(made.level);
      const std::uint64_t leaves = result_.level.share().of_all;
      if (leaves == 0)
        throw Error(ErrorKind::kInput,
                    "the parts of the surface are too small for the cells; raise the resolution");
      result_.levels_left_out = finest_depth - depth;
      const LevelGrowth growth(result_.level, solid_);
      const bool finest = depth == finest_depth || !next_fits(forecast, growth);
      if (finest) progress_.end_at(depth);
      progress_.tell_grid(depth, leaves);
      std::optional<RelaxedStart> relaxed;
      if (initial_.relaxed.sweeps > 0 && leaves <= initial_.relaxed.most_cells)
        relaxed = relaxed_and_refined(depth, made);
      // No level follows the finest one: its neighbours end here.
      Connectivity connectivity =
          finest ? connect(std::vector(std::move(made.neighbours))) : connect(made.neighbours);
      solve_level(depth, std::move(connectivity), std::move(made.parent), std::move(relaxed), finest);
      if (finest) return;
      if (!is_decision_) predict(forecast, growth);
      made = refine(std::move(made.neighbours), depth, finest_depth);
    }
  }

  int levels_above_finest() const {
    if (initial_.first_cell_size > 0) {
      const double finest = finest_cell_size(solid_.surface.box, options_);
      return std::max(1, static_cast<int>(std::lround(std::log2(initial_.first_cell_size / finest))));
    }
    const double ratio = finest_resolution() / options_.solver.coarsest_cells;
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
    if (is_so_in_all(result_.level.share(), forecast.fits(next))) return true;
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
    if (!is_so_in_any(result_.level.share(), result_.level.has_inside())) return;
    const std::optional<Expectation> expected = forecast.forecast_from(
        level.depth, growth, level.sweeps, level.seconds, seconds_so_far_, finest_resolution());
    if (!expected) return;
    result_.expected = expected;
    const double left_out = std::log2(finest_resolution() / expected->resolution);
    progress_.end_at(level.depth + result_.levels_left_out - static_cast<int>(std::lround(left_out)));
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

  /// Frames of a level from which its manifold sweeps start.
  struct RelaxedStart {
    Frames frames;
    Frames original;  ///< from which they were relaxed
    int sweeps = 0;
  };

  /// Relaxes the first frames of the level `made`, whose tree is in `result_`, then refines that level once
  /// more where singular lines have moved into larger cells: there they would move on for hundreds of sweeps.
  RelaxedStart relaxed_and_refined(int depth, RefinedLevel& made) {
    auto [start, marks] = relaxed_and_marked(depth, made);
    const bool is_moved = std::find(marks.begin(), marks.end(), true) != marks.end();
    if (!is_so_in_any(result_.level.share(), is_moved)) return start;
    sharing_.complete(result_.level, made.neighbours, {}, depth, marks);
    LevelSharing::Level again{refined(result_.level, made.neighbours, solid_, std::move(marks), monitor_),
                              {}};
    again.frames = {inherited(start.frames, again.made.parent), inherited(start.original, again.made.parent)};
    if (!again.made.level.share().is_whole()) again = sharing_.shared_out(std::move(again), solid_);
    start.frames = std::move(again.frames[0]);
    start.original = std::move(again.frames[1]);
    result_.level = std::move(again.made.level);
    made = std::move(again.made);
    return start;
  }

  /// Relaxes, and marks the leaves to refine once more. All else ends with this function, to make room.
  std::pair<RelaxedStart, Marks> relaxed_and_marked(int depth, const RefinedLevel& made) {
    const auto connectivity = std::make_shared<const Connectivity>(connect(made.neighbours));
    grid_watch_.stop();
    solve_watch_.start();
    start_candidates(depth, made.parent);
    LevelSolver<D> solver(result_.level, solid_, connectivity, options_, monitor_,
                          progress_.place(depth, leaves_of_all(), 0));
    RelaxedStart start;
    start.original = std::move(candidates_.front().frames);
    start.frames = solver.relaxed_with_cores(start.original, initial_.relaxed);
    start.sweeps = solver.sweeps();
    Marks marks = moved_line_marks(result_.level, connectivity->adjacency, start.frames, depth,
                                   options_.solver.energy_density_threshold);
    solve_watch_.stop();
    grid_watch_.start();
    return {std::move(start), std::move(marks)};
  }

  std::size_t leaves_of_all() const { return static_cast<std::size_t>(result_.level.share().of_all); }

  /// `parent` as in RefinedLevel.
  void solve_level(int depth, Connectivity connectivity, std::vector<CellIndex> parent,
                   std::optional<RelaxedStart> relaxed, bool finest) {
    const std::size_t leaves = leaves_of_all();
    Progress place = progress_.place(depth, leaves, relaxed ? relaxed->sweeps : 0);
    const Swept swept = settle(std::move(connectivity), std::move(parent), std::move(relaxed), place);
    keep_best(swept, finest || leaves > options_.solver.start_cells, finest);
    // The energy of SolveReport::Energy, whatever the sweeps minimise.
    place.sweep = swept.sweeps;
    place.energy = result_.energy.total();
    monitor_.report(place);
    if (!finest && visitor_ != nullptr) visit(depth);
    solve_watch_.stop();
    result_.levels.push_back({depth, result_.level.examined_leaves, leaves, swept.sweeps,
                              result_.energy.total(), level_watch_.restart()});
    seconds_so_far_ += result_.levels.back().seconds;
    grid_watch_.start();
  }

  void visit(int depth) {
    const GridLevel& level = result_.level;
    Frames& frames = candidates_.best_frames();
    sharing_.update_ghosts(std::span(frames));
    sharing_.update_ghosts(std::span(result_.open_faces));
    sharing_.keep_seen(depth,
                       visitor_->visit({depth, level.tree, level.share(), frames, result_.open_faces}));
  }

  bool begins_with_field(const GridLevel& level, int depth) const {
    return initial_.frame_at && (depth == progress_.coarsest_depth() ||
                                 level.tree.root().cell_size(depth) >= initial_.last_cell_size);
  }

  /// Makes the first frames of every candidate. `parent` as in RefinedLevel.
  void start_candidates(int depth, const std::vector<CellIndex>& parent) {
    // A level that has been shared out has got its frames with its leaves.
    if (depth != progress_.coarsest_depth() && parent.empty()) return;
    if (begins_with_field(result_.level, depth))
      candidates_.begin_with(sampled(initial_, result_.level));
    else if (depth == progress_.coarsest_depth())
      candidates_.begin_at_random(result_.level.size(), options_.solver.starts, options_.seed);
    else
      candidates_.inherit(finished_.candidates(), parent);
    finished_.leave_frames();
  }

  /// What is left of a level's solver once all candidates have settled.
  struct Swept {
    Adjacency adjacency;
    SweepHalo halo;
    int sweeps;
  };

  Swept settle(Connectivity connectivity, std::vector<CellIndex> parent, std::optional<RelaxedStart> relaxed,
               const Progress& place) {
    const auto shared = std::make_shared<Connectivity>(std::move(connectivity));
    LevelSolver<D> solver(result_.level, solid_, shared, options_, monitor_, place);
    grid_watch_.stop();

    solve_watch_.start();
    if (relaxed) {
      candidates_.front() = solver.settled_below(std::move(relaxed->frames), std::move(relaxed->original));
    } else {
      start_candidates(place.depth, std::exchange(parent, {}));
      SweepKeeper* const keeper = sharing_.keeper_of(place.depth, result_.level.share());
      for (std::size_t c = 0; c < candidates_.size(); ++c) {
        SettledFrames& candidate = candidates_[c];
        candidate = solver.solved(std::move(candidate.frames), relaxation_sweeps(c, place.depth), keeper);
      }
    }
    return {std::move(shared->adjacency), std::move(shared->halo),
            solver.sweeps()};  // all else ends here, to make room
  }

  int relaxation_sweeps(std::size_t start, int depth) const {
    const SolverTuning& options = options_.solver;
    if (has_field_) return 0;
    if (depth == progress_.coarsest_depth())
      return static_cast<int>(options.start_relaxation / std::pow(3.0, static_cast<double>(start)));
    return is_uniform_ ? options.level_relaxation : 0;
  }

  void keep_best(const Swept& swept, bool end_race, bool finest) {
    const SharpTurns sharp_turns = finest ? SharpTurns::kLookedFor : SharpTurns::kLeftOut;
    Candidates::Best best = candidates_.find_best(result_.level, solid_, swept.adjacency,
                                                  options_.solver.boundary_weight, sharp_turns, end_race);
    NeighbourComparison& neighbours = best.energy.neighbours;
    result_.energy = best.energy.parts;
    result_.energy_density = std::move(neighbours.energy_density);
    result_.settled = best.settled;
    if (!finest) return;
    swept.halo.refresh(std::span(neighbours.turns_sharply));
    result_.near_sharp_turn = near_sharp_turns(swept.adjacency, neighbours.turns_sharply);
  }

  /// Returns the next level and makes `result_` ready for it. `neighbours` are those of the solved level.
  RefinedLevel refine(std::vector<FaceNeighbours> neighbours, int depth, int finest_depth) {
    is_uniform_ = is_uniform_ && 8 * result_.level.share().of_all <= options_.solver.relaxed_cells;
    // With several candidates no single field says where to refine.
    std::vector<ReachedPlace> elsewhere;
    Marks marks = is_uniform_ || candidates_.size() > 1
                      ? Marks(result_.level.size(), true)
                      : refinement_marks(result_.level, neighbours, solid_, result_.energy_density,
                                         options_.solver.energy_density_threshold, finest_depth, &elsewhere);
    sharing_.complete(result_.level, neighbours, elsewhere, finest_depth, marks);
    SolvedField next;
    next.levels = result_.levels;
    next.expected = result_.expected;
    finished_.set(std::exchange(result_, std::move(next)), std::exchange(candidates_, {}));
    progress_.tell_grid(depth + 1, 0);
    RefinedLevel made = refined(finished_.level(), neighbours, solid_, std::move(marks), monitor_);
    finished_.leave_level();
    return is_to_share(made.level) ? shared_out(std::move(made), depth + 1) : made;
  }

  bool is_to_share(const GridLevel& level) const {
    if (!level.share().is_whole()) return true;  // as the level that it was refined from
    return finished_.candidates().size() == 1 && level.size() >= sharing_.fewest_leaves();
  }

  RefinedLevel shared_out(RefinedLevel made, int depth) {
    const LevelStart start{
        {depth, progress_.coarsest_depth(), is_uniform_, has_field_, initial_.relaxed, result_.expected},
        result_.levels};
    Frames frames = begins_with_field(made.level, depth)
                        ? sampled(initial_, made.level)
                        : inherited(finished_.candidates().front().frames, made.parent);
    finished_.leave_frames();
    return started(start, std::move(made), std::move(frames));
  }

  RefinedLevel started(const LevelStart& start, RefinedLevel made, Frames frames) {
    std::vector<Frames> of_level;
    of_level.push_back(std::move(frames));
    LevelSharing::Level level = sharing_.started(start, {std::move(made), std::move(of_level)}, solid_);
    candidates_.begin_with(std::move(level.frames.front()));
    return std::move(level.made);
  }

  const Solid& solid_;
  const SolveTuning& options_;
  const Monitor& monitor_;
  InitialField initial_;
  LevelVisitor* const visitor_;  ///< may be null
  LevelSharing& sharing_;
  const bool is_decision_, may_be_stopped_;
  bool has_field_;  ///< the solve has begun with a field
  LevelProgress progress_;
  SolvedField result_;      ///< the level being built or solved
  Candidates candidates_;   ///< fields of the starts that are still compared
  FinishedLevel finished_;  ///< the level before it
  Stopwatch grid_watch_, solve_watch_, level_watch_;
  double seconds_so_far_;
  bool is_uniform_ = true;  ///< all cells of the level have one size; the level is small and relaxed
};

}  // namespace

SolvedField nested_solve(const Solid& solid, const SolveTuning& options, const Monitor& monitor,
                         const InitialField& initial, const PlaceInRun& place, LevelVisitor* visitor,
                         LevelSharing* sharing) {
  LevelSharing alone;
  LevelSharing& shares = sharing != nullptr ? *sharing : alone;
  return options.degree == Degree::kThree
             ? NestedSolver<3>(solid, options, monitor, initial, place, visitor, shares).run()
             : NestedSolver<4>(solid, options, monitor, initial, place, visitor, shares).run();
}

}  // namespace crossgrain

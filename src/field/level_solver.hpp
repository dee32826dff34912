// SPDX-License-Identifier: Apache-2.0
// Relaxation and manifold sweeps on one level of the nested iteration.
#pragma once

#include <algorithm>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/monitor.hpp"
#include "field/octree_graph.hpp"
#include "field/relaxed_levels.hpp"
#include "field/solve_tuning.hpp"
#include "field/stages.hpp"
#include "grid/grid_level.hpp"

namespace crossgrain {

/// Solves one level for the nested iteration, and reports each sweep to the monitor, which may end the solve.
template <int D>
class LevelSolver {
 public:
  using Frames = std::vector<StoredQuaternion>;

  /// All arguments but `connectivity` and `place` must outlive the solver. Sweeps are counted from
  /// `place.sweep`.
  LevelSolver(const GridLevel& level, const Solid& solid, std::shared_ptr<const Connectivity> connectivity,
              const SolveTuning& options, const Monitor& monitor, const Progress& place)
      : level_(level),
        solid_(solid),
        options_(options.solver),
        monitor_(monitor),
        progress_(place),
        connectivity_(std::move(connectivity)) {}

  /// Relaxes if `relaxation_sweeps` is positive, under a penalty that grows, then sweeps on the manifold
  /// until the energy settles; `keeper`, which may be null, keeps the sweeps where nothing is relaxed.
  SettledFrames solved(Frames frames, int relaxation_sweeps, SweepKeeper* keeper) {
    if (relaxation_sweeps == 0) {
      SettlingPlan plan = settling();
      plan.keeper = keeper;
      SettledFrames result = settled(graph(), std::move(frames), plan, after_sweep());
      progress_.sweep += result.sweeps_before;
      return result;
    }
    const RelaxationPlan plan{relaxation_sweeps, options_.symmetrisation, options_.over_relaxation};
    Frames start = relaxed_by(plan, frames);
    return lower_settled(graph(), std::move(start), std::move(frames), settling(), after_sweep());
  }

  Frames relaxed_with_cores(Frames frames, const RelaxedLevels& relaxed) {
    const std::vector<float> shares = penalty_shares(relaxed.core_size);
    RelaxationPlan plan{relaxed.sweeps, options_.symmetrisation, options_.over_relaxation};
    plan.grows = false;
    plan.penalty_shares = shares;
    return relaxed_by(plan, std::move(frames));
  }

  /// Settles `relaxed`, and, if that ends above the energy of `original`, that instead.
  SettledFrames settled_below(Frames relaxed, Frames original) {
    return lower_settled(graph(), std::move(relaxed), std::move(original), settling(), after_sweep());
  }

  int sweeps() const { return progress_.sweep; }

 private:
  /// A core of radius r balances smoothness, of weight h in cells of size h, against a penalty of weight h^3
  /// / r^2 in them.
  std::vector<float> penalty_shares(double core_size) const {
    std::vector<float> shares(level_.size());
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const double ratio = level_.tree.cell_size(static_cast<CellIndex>(i)) / core_size;
      shares[i] = static_cast<float>(std::min(1.0, ratio * ratio));
    }
    return shares;
  }

  /// In degree 4, whatever the degree of the field: the relaxed problem is then quadratic but for the
  /// penalty, so that a long relaxation becomes independent of its start; the degree-3 energy has many poor
  /// minima.
  Frames relaxed_by(const RelaxationPlan& plan, Frames frames) {
    return relaxed(graph<4>(), std::move(frames), plan, after_sweep());
  }

  template <int R = D>
  FieldGraph<R>& graph() {
    FieldGraph<R>& graph = std::get<FieldGraph<R>>(graphs_);
    if (!graph.connectivity)
      graph = {connectivity_, boundary_forms<R>(level_, solid_, options_.boundary_weight)};
    return graph;
  }

  SettlingPlan settling() const {
    const double volume = parallel_sum(level_.share(), [&](std::size_t i) {
      const double size = level_.tree.cell_size(static_cast<CellIndex>(i));
      return size * size * size;
    });
    return settling_plan(options_, *connectivity_, volume, longest_side(solid_.surface.box));
  }

  SweepMonitor after_sweep() {
    return [this](double energy) {
      ++progress_.sweep;
      progress_.energy = energy;
      monitor_.check_stop();
      monitor_.report(progress_);
    };
  }

  const GridLevel& level_;
  const Solid& solid_;
  const SolverTuning& options_;
  const Monitor& monitor_;
  Progress progress_;
  std::shared_ptr<const Connectivity> connectivity_;
  std::tuple<FieldGraph<3>, FieldGraph<4>> graphs_;  ///< each made when it is first needed
};

}  // namespace crossgrain

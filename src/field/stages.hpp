// SPDX-License-Identifier: Apache-2.0
// The two stages of a solve on one graph, an octree level or a tet mesh: relaxation, in which singular arcs
// form and move, and settling, in which frames rotate until the energy converges.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "field/energy.hpp"
#include "field/field_graph.hpp"
#include "field/field_state.hpp"
#include "field/solve_tuning.hpp"
#include "field/sweep_keeper.hpp"

namespace crossgrain {

/// Called after every sweep with the energy, or NaN while it is unknown.
using SweepMonitor = std::function<void(double energy)>;

struct RelaxationPlan {
  int sweeps = 0;
  double symmetrisation = 0;  ///< of the last sweep
  double over_relaxation = 1;
  bool grows = true;  ///< the penalty grows linearly from zero; false: it is the same in all sweeps
  std::span<const float> penalty_shares = {};  ///< of each cell, as in relaxation_sweep
};

/// Cells rest whose last step lowered the energy by at most this share of the tolerance, divided by the
/// number of cells, until a neighbour's step lowers it by more. The tolerance counts less by this share, for
/// what rests (docs/notes/performance.md, "The sweep").
constexpr double kRestingShare = 0.3;

struct SettlingPlan {
  int most_sweeps = 0;
  double over_relaxation = 1;

  /// Stops after a sweep that lowers the energy by at most `fraction` of it, or by at most `noise`.
  double fraction = 0;
  double noise = 0;

  /// Cells rest whose last step lowered the energy by at most this share of what ends the sweeps, divided by
  /// the number of cells: in one sweep all of them together would hardly lower it by more than that share,
  /// which is taken off what ends the sweeps.
  double resting_share = 0;

  /// `fraction` is of at least this energy. Below `calm_energy`, sweeps that run out are followed by up to
  /// `more_sweeps` with an over-relaxation of their own (CalmFieldTuning).
  double least_energy = 0;
  double calm_energy = 0;
  int more_sweeps = 0;
  double calm_over_relaxation = 1;

  SweepKeeper* keeper = nullptr;  ///< null: nothing is kept
};

/// Returns a plan of SolverTuning or TetFinishing for a graph in a part of this volume and longest side.
template <class Options>
SettlingPlan settling_plan(const Options& options, const Connectivity& connectivity, double volume,
                           double side);

struct SettledFrames {
  std::vector<StoredQuaternion> frames;
  double energy = 0;      ///< in the field's own degree
  bool settled = false;   ///< false: the sweeps ran out
  int sweeps_before = 0;  ///< made by an earlier solve, from which this one went on
};

/// Runs the relaxation sweeps of a plan. Returns the frames nearest to the resulting coefficients.
template <int D>
std::vector<StoredQuaternion> relaxed(const FieldGraph<D>& graph, std::vector<StoredQuaternion> frames,
                                      const RelaxationPlan& plan, const SweepMonitor& after_sweep);

/// Runs manifold sweeps until the energy settles; it never rises.
template <int D>
SettledFrames settled(const FieldGraph<D>& graph, std::vector<StoredQuaternion> frames,
                      const SettlingPlan& plan, const SweepMonitor& after_sweep);

/// Settles `relaxed`. If that ends above the energy of `original`, from which it was relaxed, settles that
/// instead, so that the energy never rises.
template <int D>
SettledFrames lower_settled(const FieldGraph<D>& graph, std::vector<StoredQuaternion> relaxed,
                            std::vector<StoredQuaternion> original, const SettlingPlan& plan,
                            const SweepMonitor& after_sweep) {
  const double energy_before = graph_energy(graph, state_of<D>(original));
  SettledFrames result = settled(graph, std::move(relaxed), plan, after_sweep);
  if (!(result.energy <= energy_before)) result = settled(graph, std::move(original), plan, after_sweep);
  return result;
}

/// Energy due to rounding of frames to single precision: a squared rotation of 1e-12 across every edge.
/// Smaller decreases are meaningless.
double rounding_noise(const Adjacency& adjacency, const Share& share);

}  // namespace crossgrain

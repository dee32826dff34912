// SPDX-License-Identifier: Apache-2.0
// Repair of matchings, so that a map of integers can follow them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <span>
#include <vector>

#include "matching/matched_field.hpp"
#include "repair/moves.hpp"
#include "repair/repair_cost.hpp"

namespace crossgrain {

/// Lowers the cost of a field by moves that change the holonomies of few edges.
class MatchingRepair {
 public:
  /// `work` is that of repairs of the same try before (RepairTuning::most_work).
  MatchingRepair(MatchedField& field, const RepairWeights& weights, std::size_t work = 0);

  /// Moves until none lowers the cost, then disturbs the vertices that are left
  /// (RepairTuning::disturbances).
  void run(const RepairTuning& options);

  /// Lets faults wander once (RepairTuning::wandering_steps).
  void wander(const RepairTuning& options, std::uint64_t seed);

  double cost() const;
  std::size_t moves() const { return moves_; }

  /// Costs of edges and vertices that were found so far, those before among them.
  std::size_t work() const { return work_; }

 private:
  using Vertices = std::set<std::uint32_t>;

  bool may_go_on(const RepairTuning& options) const {
    return options.most_work == 0 || work_ < options.most_work;
  }
  void pull_off_creases();

  /// Lists the vertices that moves may help.
  void touch_faults();

  /// Lowers the cost by pushes and flips at the touched vertices and those that they touch, until none does.
  void settle(int most_sweeps);
  bool push_at(std::uint32_t vertex);
  bool push_along(std::uint32_t vertex, std::uint32_t from);
  bool flip_at(std::uint32_t vertex);
  bool flip_best(std::uint32_t face, std::uint32_t vertex);

  /// Whether a change of one face is worth a try: whether it would lower the cost by what it does to its
  /// edges and to one of its vertices, if the others lost all that they cost. Vertices farther along an arc,
  /// which may gain too, are left out; they are tried themselves.
  bool may_gain(const FaceChange& change, std::uint32_t vertex);

  /// Turns random faces near a vertex, settles what they touch, and takes it back if the cost rises by more
  /// than an allowance, in mean edge lengths.
  bool disturb(std::uint32_t vertex, std::uint64_t random, double allowance);

  /// Adds the vertices whose states depend on what is at others: along edges without a sense of their own.
  void add_along_arcs(const Vertices& from, Vertices& vertices) const;

  bool is_costly(std::uint32_t vertex) const { return vertex_costs_[vertex] > 0; }

  /// Applies changes; keeps them and returns true if they lower the cost.
  bool accept(std::span<const FaceChange> changes);
  double apply(std::span<const FaceChange> changes);  ///< returns the change of the cost
  void undo();
  void keep();
  void roll_back(std::size_t mark);

  struct OldCost {
    std::uint32_t index;
    double cost;
  };

  MatchedField& field_;
  const TetComplex& complex_;
  const RepairCost cost_;
  std::vector<double> edge_costs_, vertex_costs_;
  std::vector<std::uint8_t> is_singular_;  ///< of inner edges
  Vertices touched_;                       ///< near which something changed and no move was tried since
  std::vector<FaceChange> undo_faces_;
  std::vector<OldCost> undo_edges_, undo_vertices_;
  std::vector<FaceChange> journal_;  ///< former matchings of all kept changes, in their order
  double gained_ = 0;                ///< sum of all kept changes of the cost
  std::size_t moves_ = 0;
  std::size_t work_;
};

}  // namespace crossgrain

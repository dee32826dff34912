// SPDX-License-Identifier: Apache-2.0
#include "repair/repaired_matchings.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "matching/matched_field.hpp"
#include "matching/repaired_graph.hpp"
#include "reduction/arc_lengths.hpp"
#include "repair/frozen_frames.hpp"
#include "repair/matching_repair.hpp"
#include "repair/repair_cost.hpp"

namespace crossgrain {
namespace {

std::vector<std::uint32_t> impossible_vertices_of(const MatchedField& field) {
  std::vector<std::uint32_t> vertices;
  for (std::uint32_t v = 0; v < field.complex().solid().mesh.vertices.size(); ++v)
    if (field.vertex_state(v) == VertexState::kImpossible) vertices.push_back(v);
  return vertices;
}

std::size_t faulty_edges_of(const MatchedField& field) {
  std::size_t faults = 0;
  const TetComplex& complex = field.complex();
  for (std::uint32_t e = 0; e < complex.edges().size(); ++e) {
    const TetComplex::Edge& edge = complex.edges()[e];
    if (edge.is_branched) continue;
    faults +=
        edge.is_on_boundary() ? field.boundary_turn(e).hexahedra == 0 : !field.turn_around(e).may_be_meshed();
  }
  return faults;
}

std::size_t faults_of(const MatchedField& field) {
  return faulty_edges_of(field) + impossible_vertices_of(field).size();
}

double cost_of(const MatchedField& field, const RepairWeights& weights) {
  const RepairCost cost(field, weights);
  double sum = 0;
  for (std::uint32_t e = 0; e < field.complex().edges().size(); ++e) sum += cost.of_edge(e);
  return sum;
}

/// How many arcs no map gives a length; SIZE_MAX if its equations have no solution in double precision.
std::size_t zero_lengths_of(const MatchedField& field) {
  try {
    return arcs_of_length_zero(field, repaired_graph(field)).size();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kLimit) throw;
    return SIZE_MAX;
  }
}

/// A try with what is wrong with it, and its cost by the first weights. The field refers to the frames.
struct Try : RepairTry {
  std::optional<MatchedField> field;
  double cost = 0;

  bool operator<(const Try& other) const {
    return std::tuple(tets.faults, zero_lengths, cost) <
           std::tuple(other.tets.faults, other.zero_lengths, other.cost);
  }
};

void judge(Try& what, const RepairTuning& options) {
  what.impossible_vertices = impossible_vertices_of(*what.field);
  what.tets.faults = faulty_edges_of(*what.field) + what.impossible_vertices.size();
  what.zero_lengths = zero_lengths_of(*what.field);
  what.cost = cost_of(*what.field, options.tries.front());
}

/// Passes of repair and smoothing in turn; fewer if the last finds nothing to repair.
constexpr int kPasses = 3;

/// Smooths frames for the matchings, and repairs what that leaves: faults depend on the directions of edges
/// in their frames too.
void finish(Try& what, const RepairTuning& options) {
  for (int pass = 0; pass < kPasses; ++pass) {
    what.tets.frames = smoothed_frames(*what.field, std::move(what.tets.frames));
    what.field = what.field->with_frames(what.tets.frames);
    judge(what, options);
    if (what.tets.faults == 0 || pass + 1 == kPasses) break;
    MatchingRepair repair(*what.field, what.weights, what.tets.work);
    repair.run(options);
    what.tets.moves += repair.moves();
    what.tets.work = repair.work();
    if (repair.moves() == 0) break;
  }
}

/// Lets faults wander for the k-th time.
void wander_once(Try& what, int k, const RepairTuning& options) {
  MatchingRepair repair(*what.field, what.weights, what.tets.work);
  repair.wander(options, static_cast<std::uint64_t>(k));
  what.tets.moves += repair.moves();
  what.tets.work = repair.work();
  finish(what, options);
}

/// `done` of all repairs is behind the loop, and `own` after it.
struct ShareOfRepairs {
  double done = 0, own = 1;
};

/// Repairs before their frames are smoothed, and after.
constexpr ShareOfRepairs kFirstHalf{0, 0.5}, kSecondHalf{0.5, 0.5};

template <typename Body>
void for_each_try(std::vector<Try>& tries, std::size_t count, ShareOfRepairs share, const Body& body) {
  std::atomic<std::size_t> ended = 0;
  parallel_for(
      count,
      [&](std::size_t k) {
        body(tries[k], k);
        const double part = static_cast<double>(++ended) / static_cast<double>(count);
        tell_watched(Phase::kRepair, share.done + share.own * part);
      },
      /*grain=*/1);
}

/// All tries with the frames given, the best first; those without faults have different matchings.
std::vector<Try> ranked_tries(const MatchedField& given, const RepairTuning& options) {
  std::vector<Try> tries(options.tries.size());
  for_each_try(tries, tries.size(), kFirstHalf, [&](Try& one, std::size_t k) {
    one.weights = options.tries[k];
    one.tets.frames.assign(given.frames().begin(), given.frames().end());
    one.field = given.with_frames(one.tets.frames);
    MatchingRepair repair(*one.field, one.weights);
    repair.run(options);
    one.tets.moves = repair.moves();
    one.tets.work = repair.work();
    judge(one, options);
  });
  std::stable_sort(tries.begin(), tries.end());
  std::vector<Try> distinct;
  for (Try& one : tries) {
    const auto is_same = [&](const Try& other) { return other.field->matchings() == one.field->matchings(); };
    if (one.tets.faults > 0 || std::none_of(distinct.begin(), distinct.end(), is_same))
      distinct.push_back(std::move(one));
  }
  return distinct;
}

RepairedTets result_of(Try& what, const MatchedField& given) {
  what.tets.matchings = what.field->matchings();
  what.tets.faults_before = faults_of(given);
  return std::move(what.tets);
}

std::vector<RepairTry> results_of(std::vector<Try> tries, const MatchedField& given) {
  std::stable_sort(tries.begin(), tries.end());
  std::vector<RepairTry> results;
  for (Try& one : tries) {
    one.tets = result_of(one, given);
    results.push_back(std::move(one));
  }
  return results;
}

}  // namespace

std::vector<RepairTry> repair_tries(const MatchedField& given, const RepairTuning& options) {
  std::vector<Try> tries = ranked_tries(given, options);
  for_each_try(tries, tries.size(), kSecondHalf, [&](Try& one, std::size_t) { finish(one, options); });
  return results_of(std::move(tries), given);
}

std::vector<RepairTry> wandered_tries(const MatchedField& given, std::vector<RepairTry> tries,
                                      std::size_t most_faults, const RepairTuning& options) {
  std::erase_if(tries,
                [&](const RepairTry& one) { return one.tets.faults == 0 || one.tets.faults > most_faults; });
  std::vector<Try> wandering(tries.size());
  for_each_try(wandering, wandering.size(), {}, [&](Try& one, std::size_t k) {
    one.weights = tries[k].weights;
    one.tets = tries[k].tets;
    one.field = given.with_frames(one.tets.frames);
    for (std::uint32_t f = 0; f < one.tets.matchings.size(); ++f)
      one.field->set_matching(f, CubeGroup::instance().number_of(one.tets.matchings[f]));
    std::size_t before = SIZE_MAX;
    for (int round = 1; round <= options.wanderings && one.tets.faults > 0; ++round) {
      constexpr std::size_t kFew = 2;
      if (one.tets.faults > std::max(kFew, before / 2)) break;
      before = one.tets.faults;
      wander_once(one, round, options);
    }
  });
  return results_of(std::move(wandering), given);
}

RepairedTets repaired_tets(const MatchedField& given, const RepairTuning& options) {
  std::vector<Try> tries = ranked_tries(given, options);
  finish(tries.front(), options);
  Try* best = &tries.front();
  if (best->tets.faults > 0) {
    const auto finalists =
        std::clamp<std::size_t>(static_cast<std::size_t>(options.finalists), 1, tries.size());
    for_each_try(tries, finalists, kSecondHalf, [&](Try& one, std::size_t k) {
      if (k > 0) finish(one, options);
      for (int round = 1; round <= options.wanderings && one.tets.faults > 0; ++round)
        wander_once(one, round, options);
    });
    best = &*std::min_element(tries.begin(), tries.begin() + static_cast<std::ptrdiff_t>(finalists));
  }
  return result_of(*best, given);
}

RepairedTets smoothed_tets(const MatchedField& given, std::size_t known_faults, const RepairTuning& options) {
  std::vector<Quaternion> frames = smoothed_frames(given, {given.frames().begin(), given.frames().end()});
  const MatchedField field = given.with_frames(frames);
  const std::size_t faults = faults_of(field);
  if (faults > known_faults) return repaired_tets(field, options);
  return {field.matchings(), std::move(frames), /*moves=*/0, /*work=*/0, faults, faults};
}

}  // namespace crossgrain

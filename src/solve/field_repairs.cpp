// SPDX-License-Identifier: Apache-2.0
#include "solve/field_repairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "base/degree.hpp"
#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "base/required_memory.hpp"
#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/place.hpp"
#include "crossgrain/repair.hpp"
#include "field/tet_finish.hpp"
#include "harmonics/frame.hpp"
#include "matching/matched_field.hpp"
#include "matching/repaired_graph.hpp"
#include "measure/angle_statistics.hpp"
#include "measure/answer_limits.hpp"
#include "measure/tet_evaluation.hpp"
#include "repair/moved_vertices.hpp"
#include "repair/repair_cost.hpp"
#include "repair/repaired_matchings.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"
#include "solve/used_features.hpp"

namespace crossgrain {
namespace {

using Repair = SolveReport::Onto::Repair;

/// Bytes of a repair for a tet at its peak, beyond the field: 0.7 to 1.1 kB on three models of 55,000 to
/// 86,000 tets.
constexpr double kBytesOfTet = 1400;

/// The frames of vertices that suit those of tets: nearest to the mean around, by volume, and exactly along
/// the normal at smooth vertices of the surface.
std::vector<Quaternion> vertex_frames_for(const TetMesh& mesh, const BoundaryVertices& boundary,
                                          std::span<const Quaternion> tet_frames,
                                          std::vector<Quaternion> frames) {
  std::vector<Coefficients<4>> sums(frames.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    const std::vector<Vector3>& v = mesh.vertices;
    const double volume = dot(cross(v[b] - v[a], v[c] - v[a]), v[d] - v[a]);
    const Coefficients<4> h = frame_coefficients<4>(tet_frames[t]);
    for (const std::uint32_t vertex : mesh.tets[t]) add_scaled(sums[vertex], volume, h);
  }
  parallel_for(frames.size(), [&](std::size_t v) {
    if (squared_norm(sums[v]) > 0) frames[v] = nearest_frame<4>(sums[v]);
  });
  for (std::size_t k = 0; k < boundary.size(); ++k) {
    if (boundary.classes[k] != BoundaryClass::kSmooth) continue;
    Quaternion& frame = frames[boundary.vertices[k]];
    frame = with_axis_along(frame, boundary.normals[k]);
  }
  return frames;
}

SolveReport::AngleSummary turns_between(std::span<const Quaternion> before,
                                        std::span<const Quaternion> after) {
  std::vector<double> angles(before.size());
  parallel_for(angles.size(), [&](std::size_t t) {
    const Quaternion turn = conjugate(before[t]) * after[t];
    const Quaternion small = turn * to_quaternion(inverse(nearest_cube_rotation(turn)));
    angles[t] = 2 * arc_cosine(std::min(1.0, std::abs(small.w))) / kDegree;
  });
  return summary_of(std::move(angles));
}

std::set<std::int64_t> vertices_on(const SingularityGraph& graph) {
  std::set<std::int64_t> vertices;
  for (const SingularityGraph::Arc& arc : graph.arcs)
    vertices.insert(arc.vertices.begin(), arc.vertices.end());
  return vertices;
}

/// Vertices of a set and their neighbours.
std::set<std::int64_t> grown(const TetComplex& complex, const std::set<std::int64_t>& vertices) {
  std::set<std::int64_t> all = vertices;
  for (const std::int64_t v : vertices) {
    if (v < 0) continue;
    for (const std::uint32_t e : complex.edges_at(static_cast<std::uint32_t>(v)))
      for (const std::uint32_t end : complex.edges()[e].ends) all.insert(end);
  }
  return all;
}

void compare(const TetComplex& complex, const SingularityGraph& before, const SingularityGraph& after,
             Repair& repair) {
  const std::set<std::int64_t> near_new = grown(complex, vertices_on(after));
  for (const SingularityGraph::Arc& arc : before.arcs) {
    const auto left = std::count_if(arc.vertices.begin(), arc.vertices.end(),
                                    [&](std::int64_t v) { return v < 0 || near_new.count(v) > 0; });
    const auto all = static_cast<std::ptrdiff_t>(arc.vertices.size());
    repair.removed_arcs += left == 0;
    repair.shortened_arcs += left > 0 && left < all;
  }
  std::set<std::int64_t> ends_before;
  const auto for_ends = [](const SingularityGraph& graph, const auto& visit) {
    for (const SingularityGraph::Arc& arc : graph.arcs) {
      if (!arc.nodes) continue;
      for (std::size_t k = 0; k < 2; ++k)
        if (graph.nodes[(*arc.nodes)[k]].on_boundary)
          visit(k == 0 ? arc.vertices.front() : arc.vertices.back());
    }
  };
  for_ends(before, [&](std::int64_t v) { ends_before.insert(v); });
  const std::set<std::int64_t> near_ends = grown(complex, ends_before);
  for_ends(after, [&](std::int64_t v) { repair.led_arcs += near_ends.count(v) == 0; });
}

/// What the repair started from.
Repair former(const SolveReport::Onto& onto, const TetSolid& solid, std::span<const Quaternion> frames) {
  Repair repair;
  repair.edges_before = onto.singularity.edges;
  repair.length_before = onto.singularity.length;
  repair.contacts_before = onto.singularity.contacts;
  repair.arcs_before = onto.singularity.arcs;
  repair.boundary_ends_before = onto.singularity.boundary_ends;
  repair.energy_before = evaluate_cell_field(solid, frames).dirichlet;
  return repair;
}

void count_bent_edges(const MatchedField& field, Repair& repair) {
  const RepairCost cost(field, RepairWeights{});
  const auto& edges = field.complex().edges();
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (!edges[e].is_on_boundary() || cost.of_edge(e) == 0) continue;
    ++repair.bent_edges;
    repair.bent_length += edges[e].length;
  }
}

/// Repaired tets on a domain, whose vertices may have moved.
struct Repaired {
  TetDomain domain;
  RepairedTets tets;
};

/// Moves vertices for the matchings, and repairs what that leaves.
Repaired with_moved_vertices(Repaired repaired, const InnerFeatures& features, const RepairTuning& tuning) {
  constexpr int kMostRounds = 2;
  for (int round = 0; round < kMostRounds; ++round) {
    const TetComplex before(repaired.domain.data().solid, features);
    RepairedTets& former = repaired.tets;
    TetDomain domain =
        repaired.domain.with_vertices(moved_vertices(MatchedField(before, former.frames, former.matchings)));
    const TetComplex complex(domain.data().solid, features);
    RepairedTets tets =
        smoothed_tets(MatchedField(complex, former.frames, former.matchings), former.faults, tuning);
    if (tets.faults > former.faults) break;
    const bool goes_on = tets.moves > 0;
    tets.moves += former.moves;
    tets.faults_before = former.faults_before;
    repaired = {std::move(domain), std::move(tets)};
    if (!goes_on) break;
  }
  return repaired;
}

std::size_t moved_between(const TetMesh& before, const TetMesh& after) {
  std::size_t count = 0;
  for (std::size_t v = 0; v < before.vertices.size(); ++v) count += before.vertices[v] != after.vertices[v];
  return count;
}

/// Refuses tets, first with the number of those that bring it about.
[[noreturn]] void refuse(const TetSolid& solid, const std::string& why) {
  std::string text;
  if (solid.faulty_tets > 0)
    text = fmt::format("{} of {} tets {} inverted or flat, the first at {}: ", solid.faulty_tets,
                       solid.mesh.tets.size() + solid.left_out_tets, is_or_are(solid.faulty_tets),
                       words_of_place(solid.faulty_place));
  throw Error(ErrorKind::kInput, {"", "", text + why + "; mesh the part again before a repair"});
}

[[noreturn]] void refuse_overlap(const TetSolid& solid) {
  refuse(solid, "tets overlap, so that no way leads around some edges through all their tets");
}

void check_rings(const TetComplex& complex, const TetSolid& solid) {
  for (const TetComplex::Edge& edge : complex.edges())
    if (edge.is_branched && !edge.is_on_boundary()) refuse_overlap(solid);
}

bool is_united(const TetFrameField& field) {
  return field.report().onto && field.report().onto->united;
}

}  // namespace

void check_repairable(const TetDomain& domain) {
  for (const Warning& warning : domain.warnings())
    if (warning.kind == WarningKind::kOverlappingTets) refuse_overlap(domain.data().solid);
  if (domain.data().solid.left_out_tets > 0)
    refuse(domain.data().solid, "tets without volume or duplicates leave gaps that no matching crosses");
}

FieldRepairs::FieldRepairs(TetFrameField field, RepairOptions options, RepairTuning tuning,
                           const Monitor& monitor)
    : field_(std::move(field)),
      options_(options),
      tuning_(std::move(tuning)),
      matchings_(matchings_of(field_.domain().data().solid, field_.data())),
      used_(field_.domain().data(), is_united(field_)),
      complex_(field_.domain().data().solid, used_.features()) {
  check_repairable(field_.domain());
  if (field_.report().constraints)
    throw Error(ErrorKind::kUsage, {"", "the repair", "smoothed frames would leave the field's constraints"});
  check_rings(complex_, field_.domain().data().solid);
  const std::size_t tets = field_.domain().mesh().tets.size();
  require_memory(kBytesOfTet * static_cast<double>(tets), fmt::format("a repair on {} tets", tets),
                 Remedy::kAllowMemory);
  monitor.report({Phase::kRepair, 0, field_.domain().data().solid.mesh.vertices.size(), 0, std::nan("")});
}

MatchedField FieldRepairs::given() const {
  return {complex_, field_.data().tet_frames, matchings_};
}

std::vector<RepairTry> FieldRepairs::tries() const {
  return repair_tries(given(), tuning_);
}

std::vector<RepairTry> FieldRepairs::wandered(std::vector<RepairTry> tries, std::size_t most_faults) const {
  return wandered_tries(given(), std::move(tries), most_faults, tuning_);
}

TetFrameField FieldRepairs::field_of(RepairTry one) const {
  RepairTuning single = tuning_;
  single.tries = {one.weights};
  single.wanderings = std::min(single.wanderings, 1);
  return completed(std::move(one.tets), single);
}

TetFrameField FieldRepairs::best() const {
  return completed(repaired_tets(given(), tuning_), tuning_);
}

TetFrameField FieldRepairs::completed(RepairedTets repaired_tets, const RepairTuning& tuning) const {
  const TetFrameField& field = field_;
  const TetDomainData& given = field.domain().data();
  const InnerFeatures features = used_.features();
  Repaired found{field.domain(), std::move(repaired_tets)};
  if (options_.moves_vertices && given.preparation)
    found = with_moved_vertices(std::move(found), features, tuning);

  const std::vector<Quaternion>& former_frames = field.data().tet_frames;
  const TetDomainData& tets = found.domain.data();
  const TetComplex complex(tets.solid, features);
  const UsedFeatures used(tets, is_united(field));
  auto result = std::make_shared<TetField>();
  result->matchings = std::move(found.tets.matchings);
  result->tet_frames = std::move(found.tets.frames);
  result->vertex_frames =
      vertex_frames_for(tets.solid.mesh, used.boundary(), result->tet_frames, field.data().vertex_frames);
  const MatchedField matched(complex, result->tet_frames, result->matchings);
  auto lines = std::make_shared<const SingularityGraph>(repaired_graph(matched));

  SolveReport report = field.report();
  SolveReport::Onto& onto = report.onto.value();
  Repair repair = former(onto, given.solid, former_frames);
  repair.moves = found.tets.moves;
  repair.moved_vertices = moved_between(given.solid.mesh, tets.solid.mesh);
  repair.faults_before = found.tets.faults_before;
  repair.faults = found.tets.faults;
  for (std::size_t f = 0; f < matchings_.size(); ++f)
    repair.changed_faces += !(matchings_[f] == result->matchings[f]);
  compare(complex, field.singularities(), *lines, repair);
  count_bent_edges(matched, repair);
  repair.energy = evaluate_cell_field(tets.solid, result->tet_frames).dirichlet;
  repair.turned_deg = turns_between(former_frames, result->tet_frames);

  const VertexFieldEvaluation evaluation =
      evaluate_vertex_field(tets.solid, used.boundary(), tets.edges, result->vertex_frames);
  onto.dirichlet = evaluation.dirichlet;
  onto.edge_sum = evaluation.edge_sum;
  onto.singular = evaluation.singular;
  onto.normal_deg = evaluation.normal_deg;
  onto.crease_deg = evaluation.crease_deg;
  onto.feature_edge_deg = angles_along(tets.solid, features.edges, result->vertex_frames);
  onto.singularity = repaired_summary(matched, *lines);
  onto.unfollowed_share = unfollowed_share(tets.solid, result->tet_frames, kUnfollowedDeg);
  onto.repair = repair;
  report.answer = answer_of(report);
  return {field.grid(), std::move(found.domain), std::move(result), std::move(report), std::move(lines)};
}

TetFrameField repaired(const TetFrameField& field, const RepairOptions& options, const Monitor& monitor) {
  const WatchedLoops watched(monitor, Stops::kHeeded, options.max_memory_bytes);
  Stopwatch stopwatch;
  TetFrameField result = FieldRepairs(field, options, RepairTuning(), monitor).best();
  SolveReport report = result.report();
  report.onto->repair->seconds = stopwatch.restart();
  return result.with_report(std::move(report));
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "meshing/made_tets.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/finding.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/solve.hpp"
#include "hex/hex_making.hpp"
#include "hex/hex_memory.hpp"
#include "hex/work.hpp"
#include "measure/body_contacts.hpp"
#include "solve/tet_domain_data.hpp"

namespace crossgrain {
namespace {

/// Edges of tets in those of hexahedra.
constexpr double kTetEdge = 1.4;

/// StartingField::work_share of each size.
constexpr double kWorkShare = 0.25;

/// Returns how tets of a share of the first size are made.
TetMakingTuning tet_options(const HexMeshingOptions& options, double share) {
  TetMakingTuning result{options.tets};
  if (result.size == 0) {
    const HexOptions& hexahedra = options.hexahedra;
    result.size = hexahedra.size;
    if (hexahedra.size == 0) result.edges = std::max(result.edges, hexahedra.cells);
    result.at_least_edges = true;
    share *= kTetEdge;
  }
  result.size *= share;
  result.edges /= share;
  return result;
}

bool are_same(const TetDomain& tets, const TetDomain& other) {
  return other.mesh().vertices == tets.mesh().vertices && other.mesh().tets == tets.mesh().tets;
}

/// The median of the edges, each counted once for each of its tets.
double median_edge(const TetMesh& mesh) {
  std::vector<double> edges;
  edges.reserve(6 * mesh.tets.size());
  for (const auto& tet : mesh.tets)
    for (std::size_t a = 0; a < 4; ++a)
      for (std::size_t b = a + 1; b < 4; ++b)
        edges.push_back(norm(mesh.vertices[tet[b]] - mesh.vertices[tet[a]]));
  if (edges.empty()) return 0;
  const auto middle = edges.begin() + static_cast<std::ptrdiff_t>(edges.size() / 2);
  std::nth_element(edges.begin(), middle, edges.end());
  return *middle;
}

}  // namespace

TetDomain prepared(const TetDomain& domain, const HexMeshingOptions& options) {
  check_repairable(domain);
  if (domain.preparation()) return domain;
  return domain.prepared_for_map({.unite_solids = options.solve.unite_solids});
}

TetDomain domain_of(const std::function<TetMesh()>& make, const HexMeshingOptions& options, bool warns,
                    const Monitor& monitor) {
  const ReadLimits limits(monitor, options.solve.max_memory_bytes);
  TetMesh mesh = make();
  const std::vector<Warning> warnings = mesh.warnings;
  const TetDomain domain(std::move(mesh), options.tags);
  if (warns && options.on_warning) {
    // Of solids that meet, the contacts say more.
    const std::vector<BodyContact> contacts = body_contacts(domain.data().solid);
    for (const Warning& warning : warnings)
      if (contacts.empty() || !is_of_contact(warning)) options.on_warning(warning);
    if (!contacts.empty()) options.on_warning(warning_of(contacts));
  }
  return prepared(domain, options);
}

StartingField solved_on(const TetDomain& domain, const HexMeshingOptions& options, AttemptQueue& queue,
                        const HexExpectation::TetSize& made) {
  const std::size_t tets = domain.mesh().tets.size();
  require_memory_of_tets(tets, made.used > 0 ? Remedy::kUseLessMemory : Remedy::kAllowMemory);
  const bool is_first = queue.rounds() == 0;
  if (is_first) {
    const double size = asked_size(domain, options.hexahedra);
    const double hexahedra = expected_hexahedra(domain, size);
    require_memory_of_hexahedra(hexahedra);
    queue.expect(hexahedra);
    if (options.on_expected) options.on_expected({tets, size, hexahedra, made});
  }
  TetFrameField field = solve_onto(domain, options.solve, queue.monitor());
  queue.monitor().check_stop();
  if (is_first && options.on_answer) options.on_answer(field.report().answer);
  return starting_field(std::move(field), options.hexahedra);
}

std::optional<Turn> MadeTets::next(const AttemptQueue& queue) const {
  if (rounds_left(queue) == 0) return std::nullopt;
  return Turn{queue.rounds(), Turn::Step::kTets};
}

/// The next of MeshingTuning::tet_shares that may make other tets, not too many.
std::size_t MadeTets::next_share() const {
  const std::vector<double>& shares = tuning_.tet_shares;
  std::size_t at = at_;
  while (at < shares.size() && !may_be_new(shares[at])) ++at;
  return at;
}

bool MadeTets::may_be_new(double share) const {
  return share > large_share_ && std::none_of(made_.begin(), made_.end(), [&](const Made& one) {
           return share >= one.least_share && share <= one.most_share;
         });
}

std::string MadeTets::plan(const AttemptQueue&) const {
  if (next_tets_) return fmt::format("tets of {:.3g}", next_.tet_size);
  // Those that could not be made.
  if (made_.empty()) return "tets";
  const double longest = longest_side(made_.back().domain.data().box);
  const double size = tet_options(options_, tuning_.tet_shares[at_ - 1]).size_for(longest);
  return fmt::format("tets of {:.3g}", size);
}

std::size_t MadeTets::rounds_left(const AttemptQueue&) const {
  const auto& shares = tuning_.tet_shares;
  const auto sizes = std::count_if(shares.begin() + static_cast<std::ptrdiff_t>(at_), shares.end(),
                                   [&](double share) { return may_be_new(share); });
  return std::min(static_cast<std::size_t>(sizes), tuning_.most_sizes - sizes_) + (next_tets_ ? 1 : 0);
}

/// Whether tets are new, and not too many, is known once they are made.
bool MadeTets::prepare(AttemptQueue& queue) {
  Stopwatch stopwatch;
  next_ = {};
  next_tets_ = next_domain(queue.monitor(), next_);
  next_.seconds = stopwatch.restart();
  return next_tets_.has_value();
}

std::vector<HexCandidate> MadeTets::make(AttemptQueue& queue) {
  Stopwatch stopwatch;
  HexCandidate made;
  const TetDomain domain = *std::exchange(next_tets_, std::nullopt);
  made.attempt = std::exchange(next_, {});
  made.attempt.round = queue.rounds();
  StartingField start = solved_on(domain, options_, queue, size_);
  start.work_share = kWorkShare;
  queue.start_on(std::move(start));
  made.attempt.work = kTetWork * static_cast<double>(made.attempt.tets);
  made.attempt.seconds += stopwatch.restart();
  return {std::move(made)};
}

/// The first of the next sizes whose tets are not those of an earlier one, nor too many.
std::optional<TetDomain> MadeTets::next_domain(const Monitor& monitor, HexAttempt& attempt) {
  const std::vector<double>& shares = tuning_.tet_shares;
  while ((at_ = next_share()) < shares.size()) {
    const bool is_first = made_.empty() && large_share_ == 0;
    // Who gives a size wants it.
    const bool is_given = is_first && options_.tets.size > 0;
    auto domain = domain_of(shares[at_++], is_given, monitor, attempt);
    if (!domain && is_first) domain = coarse_domain(monitor, attempt);
    if (domain) return domain;
  }
  return std::nullopt;
}

/// Where the first size has too many tets: the coarsest of MeshingTuning::tet_shares, however many tets it
/// has. Still coarser tets hold to the limit, but lose meshes: housing has one on 53,791 tets of 4 times the
/// size, and none on 23,289 of 8 times.
std::optional<TetDomain> MadeTets::coarse_domain(const Monitor& monitor, HexAttempt& attempt) {
  const std::vector<double>& shares = tuning_.tet_shares;
  return domain_of(*std::max_element(shares.begin(), shares.end()), /*may_be_large=*/true, monitor, attempt);
}

std::optional<TetDomain> MadeTets::domain_of(double share, bool may_be_large, const Monitor& monitor,
                                             HexAttempt& attempt) {
  Stopwatch stopwatch;
  TetMakingTuning making = tet_options(options_, share);
  making.on_solid = [this](const SearchableSurface& part) { asked_.check(part); };
  ++sizes_;  // also if this fails
  const bool warns = !std::exchange(has_warned_, true);
  const auto make = [&] {
    TetMesh mesh = make_(making, monitor);
    attempt.tet_edge = median_edge(mesh);
    return mesh;
  };
  TetDomain domain = crossgrain::domain_of(make, options_, warns, monitor);
  attempt.tet_size = making.size_for(longest_side(domain.data().box));
  attempt.tets = domain.mesh().tets.size();
  attempt.tet_seconds += stopwatch.restart();
  const auto known = std::find_if(made_.begin(), made_.end(),
                                  [&](const Made& other) { return are_same(domain, other.domain); });
  const bool is_large = !may_be_large && attempt.tets > tuning_.large_tets;
  if (is_large && made_.empty() && large_share_ == 0) size_ = {0, attempt.tet_size, attempt.tets};
  if (is_large) large_share_ = std::max(large_share_, share);
  if (known != made_.end()) {
    // So are those of all sizes between.
    known->least_share = std::min(known->least_share, share);
    known->most_share = std::max(known->most_share, share);
  }
  if (known != made_.end() || is_large) {
    --sizes_;
    return std::nullopt;
  }
  if (!made_.empty()) size_ = {};
  size_.used = attempt.tet_size;
  made_.push_back({share, share, domain});
  return domain;
}

}  // namespace crossgrain

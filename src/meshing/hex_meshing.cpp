// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hex_meshing.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex/hex_options.hpp"
#include "solve/tet_domain_data.hpp"
#include "tet_making/tet_making_tuning.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Throws before the work for options that are out of range.
void check(const HexMeshingOptions& options) {
  check_options(options.hexahedra);
  if (!options.solve.constraints.empty())
    throw Error(ErrorKind::kUsage,
                {"", "hexahedra", "their field takes no constraints, which a repair would leave"});
  const auto is_share = [](double share) { return share > 0 && std::isfinite(share); };
  if (options.tet_shares.empty() ||
      !std::all_of(options.tet_shares.begin(), options.tet_shares.end(), is_share))
    throw Error(ErrorKind::kUsage, "tet_shares must be positive numbers, at least one");
  if (!is_share(options.tet_edge)) throw Error(ErrorKind::kUsage, "tet_edge must be a positive number");
}

/// Returns how tets of a share of the first size are made.
TetMakingTuning tet_options(const HexMeshingOptions& options, double share) {
  TetMakingTuning result{options.tets};
  if (result.size == 0) {
    const HexOptions& hexahedra = options.hexahedra;
    result.size = hexahedra.size;
    if (hexahedra.size == 0) result.edges = std::max(result.edges, hexahedra.cells);
    result.at_least_edges = true;
    share *= options.tet_edge;
  }
  result.size *= share;
  result.edges /= share;
  result.crease_angle_deg = options.solve.creases.least_deg;
  result.max_memory_bytes = options.solve.max_memory_bytes;
  return result;
}

/// Returns the size that `make_tets` takes.
double size_of(const TetMakingTuning& options, const TetDomain& domain) {
  const double of_edges = longest_side(domain.data().box) / options.edges;
  if (options.size == 0) return of_edges;
  return options.at_least_edges ? std::min(options.size, of_edges) : options.size;
}

TetDomain prepared(const TetDomain& domain, const HexMeshingOptions& options) {
  check_repairable(domain);
  if (domain.preparation()) return domain;
  return domain.prepared_for_map({.unite_solids = options.solve.unite_solids});
}

/// Returns the tets of `make`, ready for a solve.
template <class Make>
TetDomain domain_of(const Make& make, const HexMeshingOptions& options, bool warns, const Monitor& monitor) {
  const ReadLimits limits(monitor, options.solve.max_memory_bytes);
  TetMesh mesh = make();
  if (warns && options.on_warning)
    for (const Warning& warning : mesh.warnings) options.on_warning(warning);
  return prepared(TetDomain(std::move(mesh), options.tags), options);
}

HexExpectation expectation_of(const TetDomain& domain, const HexOptions& options) {
  const double longest = longest_side(domain.data().box);
  HexExpectation expected{domain.mesh().tets.size(), options.size, 0};
  if (options.size == 0) expected.size = longest / options.cells;
  expected.hexahedra = volume_of(domain.mesh()) / std::pow(expected.size, 3);
  return expected;
}

Hexahedra made_on(const TetDomain& domain, const HexMeshingOptions& options, const Monitor& monitor) {
  if (options.on_expected) options.on_expected(expectation_of(domain, options.hexahedra));
  const TetFrameField field = solve_onto(domain, options.solve, monitor);
  monitor.check_stop();
  return hexahedra(field, options.hexahedra, monitor);
}

/// Returns hexahedra whose field tells how long their tets took, and everything.
Hexahedra with_seconds(Hexahedra made, double tet_seconds, double seconds) {
  SolveReport report = made.field.report();
  report.hexahedra = made.report;
  report.seconds.read = tet_seconds;
  report.seconds.total = seconds;
  made.field = made.field.with_report(std::move(report));
  return made;
}

double volume_missed(const HexReport& report) {
  return std::abs(report.volume / report.model_volume - 1);
}

bool is_good(const HexReport& report, const HexMeshingOptions& options) {
  return report.outcome == HexOutcome::kAllHex && !report.is_coarse &&
         report.quality.least >= options.least_quality;
}

bool is_better(const HexReport& report, const HexReport& best, const HexMeshingOptions& options) {
  const auto rank = [&](const HexReport& of) {
    return std::tuple(!is_good(of, options), of.outcome != HexOutcome::kAllHex, volume_missed(of));
  };
  return rank(report) < rank(best);
}

/// The report of smaller hexahedra on a repaired field, with what came before on it. The first attempt of
/// `next` is the best one of `first` again.
HexReport joined(const HexReport& first, HexReport next) {
  std::vector<HexAttempt> attempts = first.attempts;
  for (std::size_t k = 1; k < next.attempts.size(); ++k) {
    next.attempts[k].repair = first.attempts[first.best_attempt].repair;
    attempts.push_back(next.attempts[k]);
  }
  next.best_attempt =
      next.best_attempt == 0 ? first.best_attempt : first.attempts.size() + next.best_attempt - 1;
  next.attempts = std::move(attempts);
  next.repair_seconds += first.repair_seconds;
  next.map_seconds += first.map_seconds;
  next.extraction_seconds += first.extraction_seconds;
  next.smoothing_seconds += first.smoothing_seconds;
  next.analysis_seconds += first.analysis_seconds;
  return next;
}

using MakeTets = std::function<TetMesh(const TetMakingTuning& options)>;

/// Tries tets of one size after another until hexahedra fill the model, then smaller hexahedra on those whose
/// map only rounding folds: other tets may have a map at the size that was asked for.
class TetTries {
 public:
  TetTries(MakeTets make, const HexMeshingOptions& options, const Monitor& monitor)
      : make_(std::move(make)), options_(options), monitor_(monitor) {}

  Hexahedra best();

 private:
  /// Whether tets may be more than `large_tets`: there are coarser ones to try first.
  enum class Large : std::uint8_t { kNo, kYes };
  void attempt(double share, Large may_be_large);
  void attempt_timed(double share, Large may_be_large);
  void take(Hexahedra made, std::size_t of_try);
  void keep_or_rethrow(const Error& error, TriedTets& tried) const;
  void try_finer_sizes();
  bool is_done() const;

  /// Whether an earlier size gave the same tets, because details bound them.
  bool is_known(const TetDomain& domain) const {
    return std::any_of(domains_.begin(), domains_.end(), [&](const TetDomain& other) {
      return other.mesh().vertices == domain.mesh().vertices && other.mesh().tets == domain.mesh().tets;
    });
  }

  MakeTets make_;
  const HexMeshingOptions& options_;
  const Monitor& monitor_;
  std::vector<TriedTets> tries_;
  std::vector<TetDomain> domains_;  ///< of tries
  std::optional<Hexahedra> best_;
  std::map<std::size_t, TetFrameField> folded_;  ///< by rounding; by the number of the try
  bool has_warned_ = false;
};

void TetTries::attempt(double share, Large may_be_large) {
  const bool is_first = !std::exchange(has_warned_, true);
  TriedTets& tried = tries_.emplace_back();
  Stopwatch stopwatch;
  stopwatch.start();
  const TetMakingTuning making = tet_options(options_, share);
  const TetDomain domain = domain_of([&] { return make_(making); }, options_, is_first, monitor_);
  tried.tet_seconds = stopwatch.restart();
  tried.size = size_of(making, domain);
  tried.tets = domain.mesh().tets.size();
  if (is_known(domain) || (may_be_large == Large::kNo && tried.tets > options_.large_tets)) {
    tries_.pop_back();
    return;
  }
  domains_.push_back(domain);
  HexMeshingOptions options = options_;
  std::size_t& work = options.hexahedra.repair_work;
  work = work == 0 ? options.repair_work : std::min(work, options.repair_work);
  options.hexahedra.finer_sizes = 0;
  Hexahedra made = made_on(domain, options, monitor_);
  tried.outcome = made.report.outcome;
  tried.hexahedra = made.report.hexahedra;
  const std::size_t number = tries_.size() - 1;
  const HexReport& report = made.report;
  if (options_.hexahedra.finer_sizes > 0 && !is_good(report, options_) &&
      report.attempts[report.best_attempt].is_folded_by_rounding())
    folded_.emplace(number, made.field);
  take(std::move(made), number);
}

void TetTries::take(Hexahedra made, std::size_t of_try) {
  if (best_ && !is_better(made.report, best_->report, options_)) return;
  TriedTets& tried = tries_[of_try];
  tried.outcome = made.report.outcome;
  tried.hexahedra = made.report.hexahedra;
  for (TriedTets& other : tries_) other.is_used = &other == &tried;
  best_ = std::move(made);
}

/// To be called with the error in flight: what earlier tets have given is worth more than the reason why
/// others fail.
void TetTries::keep_or_rethrow(const Error& error, TriedTets& tried) const {
  if (!best_ || error.kind() == ErrorKind::kInterrupted) throw;
  tried.failure = error.text();
}

void TetTries::try_finer_sizes() {
  for (const auto& [number, field] : std::exchange(folded_, {})) {
    if (is_good(best_->report, options_)) return;
    Stopwatch stopwatch;
    stopwatch.start();
    try {
      Hexahedra made = hexahedra(field, options_.hexahedra, monitor_);
      made.report = joined(*field.report().hexahedra, std::move(made.report));
      take(std::move(made), number);
    } catch (const Error& error) {
      keep_or_rethrow(error, tries_[number]);
    }
    tries_[number].seconds += stopwatch.restart();
  }
}

bool TetTries::is_done() const {
  std::size_t tets = 0;
  for (const TriedTets& tried : tries_) tets += tried.tets;
  return best_ && (is_good(best_->report, options_) || tries_.size() >= options_.most_sizes ||
                   tets >= options_.most_tried_tets);
}

void TetTries::attempt_timed(double share, Large may_be_large) {
  Stopwatch stopwatch;
  stopwatch.start();
  const std::size_t before = tries_.size();
  try {
    attempt(share, may_be_large);
  } catch (const Error& error) {
    keep_or_rethrow(error, tries_.back());
  }
  if (tries_.size() > before) tries_.back().seconds = stopwatch.restart();
}

Hexahedra TetTries::best() {
  check(options_);
  const ThreadLimit limit(options_.solve.threads);
  Stopwatch stopwatch;
  stopwatch.start();
  const double coarsest = *std::max_element(options_.tet_shares.begin(), options_.tet_shares.end());
  for (const double share : options_.tet_shares) {
    if (is_done()) break;
    attempt_timed(share, share == coarsest ? Large::kYes : Large::kNo);
    if (tries_.empty()) attempt_timed(coarsest, Large::kYes);
    if (!folded_.empty() && tries_.size() > folded_.begin()->first + options_.sizes_before_finer)
      try_finer_sizes();
  }
  try_finer_sizes();
  double tet_seconds = 0;
  for (const TriedTets& tried : tries_) tet_seconds += tried.tet_seconds;
  best_->report.tried_tets = std::move(tries_);
  return with_seconds(*std::move(best_), tet_seconds, stopwatch.restart());
}

/// Returns what an error about a model in a file is.
Error named(const Error& error, const std::filesystem::path& model) {
  const bool is_of_model = error.kind() == ErrorKind::kInput || error.kind() == ErrorKind::kLimit;
  return is_of_model && error.file().empty() ? error.with_file(model.string()) : error;
}

/// Returns hexahedra in the tets that `make` gives.
template <class Make>
Hexahedra in_tets(const Make& make, const HexMeshingOptions& options, const Monitor& monitor) {
  check(options);
  const ThreadLimit limit(options.solve.threads);
  Stopwatch stopwatch;
  stopwatch.start();
  const TetDomain domain = make();
  const double tet_seconds = stopwatch.restart();
  Hexahedra made = made_on(domain, options, monitor);
  return with_seconds(std::move(made), tet_seconds, tet_seconds + stopwatch.restart());
}

}  // namespace

Hexahedra make_hexahedra(const std::filesystem::path& model, const HexMeshingOptions& options,
                         const Monitor& monitor) {
  try {
    if (!is_tet_file(model))
      return TetTries([&](const auto& making) { return make_tets(model, making, monitor); }, options, monitor)
          .best();
    const auto read = [&] { return read_tets(model); };
    return in_tets([&] { return domain_of(read, options, true, monitor); }, options, monitor);
  } catch (const Error& error) {
    throw named(error, model);
  }
}

Hexahedra make_hexahedra(const TriangleMesh& surface, const HexMeshingOptions& options,
                         const Monitor& monitor) {
  return TetTries([&](const auto& making) { return make_tets(surface, making, monitor); }, options, monitor)
      .best();
}

Hexahedra make_hexahedra(const TetDomain& tets, const HexMeshingOptions& options, const Monitor& monitor) {
  return in_tets([&] { return prepared(tets, options); }, options, monitor);
}

}  // namespace crossgrain

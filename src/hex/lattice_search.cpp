// SPDX-License-Identifier: Apache-2.0
#include "hex/lattice_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <exception>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>

#include "base/digits.hpp"
#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "base/required_memory.hpp"
#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/message.hpp"
#include "fit/feature_fit.hpp"
#include "hex/attempt_kinds.hpp"
#include "hex/hex_forecast.hpp"
#include "hex/hex_report.hpp"
#include "hex/lattice_faults.hpp"
#include "lattice/holes.hpp"
#include "lattice/lattice.hpp"
#include "measure/feature_measure.hpp"
#include "surface/findings.hpp"
#include "surface/mending.hpp"
#include "surface/searchable_surface.hpp"
#include "surface/self_intersections.hpp"
#include "surface/shells.hpp"

namespace crossgrain {
namespace {

/// A worst scaled Jacobian that counts as better, and from which others are not worth hexahedra beyond
/// kMostOfLattice.
constexpr double kFairShape = 0.1;

/// How far the worst distance or volume is beyond its limit, in classes of a factor of two.
int excess_of(const HexFeatures& features) {
  double worst = 1;
  for (const HexFeatures::Lack& lack : features.lacking) {
    if (lack.kind == HexLackKind::kVolume)
      worst = std::max(worst, std::abs(lack.figure - 1) / kMostVolumeOff);
    if (lack.kind == HexLackKind::kOffModel || lack.kind == HexLackKind::kOffMesh)
      worst = std::max(worst, lack.figure / kMostOff);
  }
  return std::ilogb(worst);
}

/// What makes one result worth less than another.
auto flaws_of(const HexReport& report) {
  const std::size_t lacking = report.features ? report.features->lacking.size() : SIZE_MAX;
  const double least = report.quality.least;
  const int excess = report.features ? excess_of(*report.features) : 0;
  return std::tuple(report.outcome, least < kPoorestShape, lacking, excess, least < kFairShape,
                    least < kGoodShape, std::bit_width(report.quality.below_tenth), report.hexahedra);
}

bool is_good(const HexReport& report) {
  return report.outcome == HexOutcome::kAllHex && report.quality.least >= kGoodShape;
}

/// The text of a mesh: its first fault.
std::string text_of(const HexReport& report) {
  const std::string all = counted(report.hexahedra, "hexahedron", "hexahedra");
  if (report.outcome == HexOutcome::kPartial) return all + ": " + report.reason;
  const std::string fills = all + (report.hexahedra == 1 ? " fills the model" : " fill the model");
  if (!report.reason.empty()) return fills + ", but: " + report.reason.substr(0, report.reason.find(';'));
  return is_good(report)
             ? fills
             : fills + fmt::format(", but: poor shapes (worst scaled Jacobian {:.2g})", report.quality.least);
}

/// About how many hexahedra a lattice becomes. Layers cover slanted and curved faces, and some of those
/// beside them. With 20 cells, 67 of 72 lattices that are written become between half and twice as many, and
/// 112 of all 128 that are tried; with 12 cells 60 of 71 and 106 of 137 (bench/first_words.py, with
/// `--lattice` among its options; before padding was a way). Shares of faces with a slanted border, and of
/// slanted curves, tell no more: which layers there are is known once curves have paths.
double fitted_count(const Lattice& lattice) {
  constexpr double kAddedForQuad = 1.5;
  return static_cast<double>(lattice.mesh.hexahedra.size()) +
         kAddedForQuad * std::sqrt(lattice.slanted_share) * static_cast<double>(lattice.mesh.boundary.size());
}

}  // namespace

/// A lattice, and what becomes of it.
struct LatticeSearch::Prepared {
  Lattice lattice;
  double size;
  bool is_alike;   ///< of the model's topology, or nothing else is left
  bool is_finer;   ///< in places, than one before of the same size
  bool is_raised;  ///< to a higher level than that
  double seconds;
};

LatticeSearch::LatticeSearch(const FittingModel& model, double size, const Monitor& monitor)
    : model_(model),
      surface_(outer_surface(model.features)),
      shells_(euler_numbers_of_shells(model.features.triangles)),
      holes_(holes_of(model.features)),
      lines_(soft_lines_of(model.features)),
      monitor_(monitor),
      asked_size_(size),
      next_size_(size),
      expected_(expected_hexahedra(surface_.mesh, enclosed_volume(surface_), size)) {}

LatticeSearch::~LatticeSearch() = default;

bool LatticeSearch::prepare() {
  if (ended_) std::rethrow_exception(std::exchange(ended_, nullptr));
  Stopwatch stopwatch;
  while (!prepared_ && !is_done() && may_take(next_size_)) {
    const double size = next_size_;
    // A lattice of millions takes long to find that out.
    constexpr double kCertainly = 2;
    const double most = most_fitted();
    if (best_ &&
        (fitted_ >= most || fitted_ + expected_ * raised(asked_size_ / size, 3) > kCertainly * most)) {
      next_coarse();
      continue;
    }
    Lattice lattice = lattice_at(size);
    const auto cells = static_cast<double>(lattice.mesh.hexahedra.size());
    const bool is_fair = best_ && best_->outcome == HexOutcome::kAllHex && best_->quality.least >= kFairShape;
    const double number = is_fair ? fitted_count(lattice) : cells;
    if (best_ && (number > std::max(kFew, kMostOfLattice * expected_) || fitted_ + cells > most)) {
      is_raised_ ? give_up_level() : next_coarse();
      continue;
    }
    const bool is_alike = lattice.shells == shells_ || may_be_joined(lattice);
    prepared_ = std::make_unique<Prepared>(
        Prepared{std::move(lattice), size, is_alike, !fine_.empty(), is_raised_, stopwatch.restart()});
  }
  if (!prepared_ && !best_ && other_) {
    prepared_ = std::move(other_);
    prepared_->is_alike = true;
  }
  return prepared_ != nullptr;
}

std::string LatticeSearch::plan() const {
  if (!prepared_) return fmt::format("a lattice of {:.3g}", next_size_);
  const std::string words = prepared_->is_finer    ? "finer planes of the lattice there"
                            : prepared_->is_raised ? "planes of the lattice at thin walls and narrow holes"
                                                   : fmt::format("a lattice of {:.3g}", prepared_->size);
  return prepared_->is_alike ? fmt::format("{}, {}", words, about(expected())) : words;
}

double LatticeSearch::size() const {
  return prepared_->size;
}

double LatticeSearch::expected() const {
  return fitted_count(prepared_->lattice);
}

LatticeSearch::Trial LatticeSearch::make() {
  const std::unique_ptr<Prepared> prepared = std::move(prepared_);
  return prepared->is_alike ? fitted(*prepared) : skipped(*prepared);
}

HexAttempt LatticeSearch::begin(const Prepared& prepared) {
  HexAttempt attempt;
  attempt.kind = kLatticeKind;
  attempt.number = ++tried_;
  attempt.size = prepared.size;
  attempt.hexahedra = prepared.lattice.mesh.hexahedra.size();
  attempt.seconds = prepared.seconds;
  return attempt;
}

/// A lattice of another topology than the model.
LatticeSearch::Trial LatticeSearch::skipped(Prepared& prepared) {
  const HexAttempt attempt = begin(prepared);
  prepared.is_raised ? give_up_level() : next_coarse();
  if (attempt.hexahedra == 0) return {attempt, "no cell of the lattice is inside the model", {}};
  std::string text = fmt::format("a lattice of {} has other bodies or holes than the model",
                                 counted(attempt.hexahedra, "cell"));
  other_ = std::make_unique<Prepared>(std::move(prepared));
  return {attempt, std::move(text), {}};
}

LatticeSearch::Trial LatticeSearch::fitted(Prepared& prepared) {
  Stopwatch stopwatch;
  require_memory_to_fit(prepared.lattice);
  HexAttempt attempt = begin(prepared);
  LatticeHexahedra made;
  made.mesh = std::move(prepared.lattice.mesh);
  made.mesh.unit = model_.solid.mesh.unit;
  made.report = fit_to_model(model_, {prepared.size, asked_size_}, FitWays::kLayersOnly, monitor_, made.mesh,
                             made.warnings);
  made.report.expected = expected_;
  made.has_joined = made.report.outcome != HexOutcome::kAllHex && touches_itself_.value_or(false);
  attempt.outcome = made.report.outcome;
  attempt.hexahedra = made.report.hexahedra;
  attempt.seconds += stopwatch.restart();
  const double before = fitted_;
  for (const HexFitTry& one : made.report.fit_tries)
    if (one.way >= HexFitWay::kFitted) fitted_ += static_cast<double>(one.hexahedra);
  Trial trial{attempt, text_of(made.report), {}, fitted_ - before};
  const bool is_better = !best_ || flaws_of(made.report) < flaws_of(*best_);
  if (is_better) {
    best_ = made.report;
    has_joined_ = made.has_joined;
  }
  try {
    choose_next(made, prepared, is_better);
  } catch (const Error&) {
    ended_ = std::current_exception();  // this mesh is kept
  }
  if (is_better) trial.better = std::move(made);
  return trial;
}

/// Goes on with a smaller size everywhere.
void LatticeSearch::next_coarse() {
  next_size_ *= kSmallerSize;
  fine_.clear();
  is_raised_ = false;
  refinements_ = 0;
}

/// Goes on with planes at thin walls and narrow holes, once, where a lattice lacks something; then with
/// places to refine; or with a smaller size everywhere.
void LatticeSearch::choose_next(const LatticeHexahedra& last, const Prepared& prepared, bool is_better) {
  const WatchedLoops watched(monitor_, Stops::kHeeded);
  if (prepared.is_raised && !is_better) return give_up_level();
  // What is needed for the topology at one size keeps the geometry at the next.
  if (last.report.outcome != HexOutcome::kAllHex)
    level_ = std::max(level_, std::min(prepared.lattice.level, NarrowLevel::kHoles));
  std::vector<FinePlace> places;
  if (last.report.outcome == HexOutcome::kApproximate && refinements_ < kMostRefinements)
    places = places_to_refine(last.mesh, last.report, surface_, next_size_, fine_);
  NarrowFeatures narrow = narrow_features();
  narrow.level = prepared.lattice.level;
  if (last.report.outcome != HexOutcome::kAllHex && !has_raised_ && narrow.level < NarrowLevel::kHoles &&
      has_other_planes(surface_, next_size_, std::move(narrow), NarrowLevel::kHoles)) {
    level_ = NarrowLevel::kHoles;
    is_raised_ = has_raised_ = true;
    places_ = std::move(places);
    return;
  }
  refine(std::move(places));
}

void LatticeSearch::refine(std::vector<FinePlace> places) {
  is_raised_ = false;
  if (places.empty()) return next_coarse();
  fine_ = std::move(places);
  ++refinements_;
}

/// Goes on as if there were no planes at what is narrow.
void LatticeSearch::give_up_level() {
  level_ = NarrowLevel::kNothing;
  refine(std::exchange(places_, {}));
}

/// Most hexahedra that are fitted once there is a mesh: fewer where only its shapes are poor.
double LatticeSearch::most_fitted() const {
  return best_ && best_->outcome == HexOutcome::kAllHex ? kMostForShapes : kMostFitted;
}

/// Whether lattices of a size may be small enough.
bool LatticeSearch::may_take(double size) const {
  const double share = raised(asked_size_ / size, 3);
  return share <= kMostOfLattice || expected_ * share <= kFew || tried_ == 0;
}

bool LatticeSearch::is_done() const {
  return best_ && (is_good(*best_) || best_->is_stopped || has_joined_);
}

/// Whether a lattice has the tunnels of a surface that touches itself, whose shells no lattice has.
bool LatticeSearch::may_be_joined(const Lattice& lattice) {
  const auto tunnels = [](const std::vector<int>& shells) {
    return std::ssize(shells) - std::accumulate(shells.begin(), shells.end(), std::ptrdiff_t{0}) / 2;
  };
  const bool has_tunnels = shells_.empty() || tunnels(lattice.shells) == tunnels(shells_);
  return !lattice.shells.empty() && has_tunnels && touches_itself();
}

bool LatticeSearch::touches_itself() {
  if (touches_itself_) return *touches_itself_;
  const WatchedLoops watched(monitor_, Stops::kHeeded);
  const SearchableSurface searchable(mend_surface(CheckedMesh::derived(surface_.mesh)));
  SurfaceFindings findings = searchable.mended().findings;
  find_self_intersections(searchable.mended(), searchable.bvh(), searchable.winding(), findings);
  constexpr std::array kKinds{FindingKind::kTouchingComponents, FindingKind::kOverlappingComponents,
                              FindingKind::kSelfIntersection, FindingKind::kNonmanifoldEdge};
  touches_itself_ =
      std::ranges::any_of(kKinds, [&](FindingKind kind) { return find(findings, kind) != nullptr; });
  return *touches_itself_;
}

NarrowFeatures LatticeSearch::narrow_features() const {
  return {.level = level_, .holes = holes_, .fine = fine_, .lines = lines_};
}

/// With planes at more narrow features only where it has another topology without them.
Lattice LatticeSearch::lattice_at(double size) const {
  const WatchedLoops watched(monitor_, Stops::kHeeded);
  tell_watched(Phase::kHexahedra, kUnknownShare);
  NarrowFeatures narrow = narrow_features();
  Lattice lattice = lattice_of(surface_, size, narrow);
  for (const NarrowLevel level : {NarrowLevel::kWalls, NarrowLevel::kHoles, NarrowLevel::kRings}) {
    if (lattice.shells == shells_) break;
    if (level <= narrow.level || (level > NarrowLevel::kWalls && holes_.empty())) continue;
    narrow.level = level;
    Lattice other = lattice_of(surface_, size, narrow);
    if (other.shells == shells_ || lattice.mesh.hexahedra.empty()) lattice = std::move(other);
  }
  return lattice;
}

/// Throws Error(kLimit) unless there is memory to fit a lattice, which is of no use otherwise.
void LatticeSearch::require_memory_to_fit(const Lattice& lattice) const {
  const WatchedLoops watched(monitor_, Stops::kHeeded);
  require_memory(kBytesOfFittedHexahedron * fitted_count(lattice) + bytes_to_fit_to(model_.features),
                 fmt::format("fitting a lattice of {}", counted(lattice.mesh.hexahedra.size(), "cell")),
                 Remedy::kTakeFewerHexahedra);
}

Surface outer_surface(const FeatureComplex& features) {
  TriangleMesh mesh;
  mesh.vertices = features.vertices;
  mesh.triangles = features.triangles;
  return prepare_surface(CheckedMesh::derived(std::move(mesh)));
}

void choose_remedy_of_lattices(HexReport& report, bool has_joined) {
  if (report.is_stopped) {
    if (!is_good(report)) report.remedy = Remedy::kLetFinish;
    return;
  }
  if (has_joined) {
    report.remedy = Remedy::kNone;
    return;
  }
  double last_size = 0;
  std::size_t lattices = 0;
  for (const HexAttempt& attempt : report.attempts) {
    if (!attempt.is_of_lattice()) continue;
    last_size = attempt.size;
    ++lattices;
  }
  if (report.outcome == HexOutcome::kAllHex && (lattices > 1 || report.remedy == Remedy::kNone)) {
    report.remedy = Remedy::kNone;
    return;
  }
  const double next = next_smaller_size(last_size);
  const bool has_size = report.remedy == Remedy::kUseHexSize && report.remedy_number > 0;
  report.remedy_number = has_size ? std::min(next, report.remedy_number) : next;
  report.remedy = Remedy::kUseHexSize;
  report.remedy_hexahedra = report.model_volume / raised(report.remedy_number, 3);
}

}  // namespace crossgrain

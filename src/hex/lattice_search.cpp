// SPDX-License-Identifier: Apache-2.0
#include "hex/lattice_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
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
#include "hex/hex_report.hpp"
#include "hex/lattice_faults.hpp"
#include "lattice/holes.hpp"
#include "lattice/lattice.hpp"
#include "surface/shells.hpp"

namespace crossgrain {
namespace {

/// What makes one result worth less than another.
auto flaws_of(const HexReport& report) {
  const std::size_t lacking = report.features ? report.features->lacking.size() : SIZE_MAX;
  const double least = report.quality.least;
  return std::tuple(report.outcome, least < kPoorestShape, lacking, least < 0.1, least < kGoodShape,
                    std::bit_width(report.quality.below_tenth), report.hexahedra);
}

bool is_good(const HexReport& report) {
  return report.outcome == HexOutcome::kAllHex && report.quality.least >= kGoodShape;
}

class Search {
 public:
  Search(const FittingModel& model, double size, const Monitor& monitor,
         const std::function<void(const HexAttemptEnd&)>& on_end)
      : model_(model),
        surface_(outer_surface(model.features)),
        shells_(euler_numbers_of_shells(model.features.triangles)),
        holes_(holes_of(model.features)),
        lines_(soft_lines_of(model.features)),
        monitor_(monitor),
        on_end_(on_end),
        asked_size_(size),
        expected_(enclosed_volume(surface_) / raised(size, 3)) {}

  LatticeHexahedra run() {
    try {
      for (next_size_ = asked_size_; may_take(next_size_) && !is_done();)
        if (!try_lattice()) next_coarse();
    } catch (const Error& error) {
      const bool is_stop = error.kind() == ErrorKind::kInterrupted && monitor_.may_be_stopped() &&
                           monitor_.stopped() && !monitor_.cancelled();
      if (!best_ || !(is_stop || error.kind() == ErrorKind::kLimit)) throw;
      if (is_stop)
        stop();
      else
        best_->warnings.push_back(ended_at(error));
    }
    Stopwatch stopwatch;
    if (!best_ && other_) take(*std::move(other_), other_size_, stopwatch);
    if (!best_)
      throw Error(ErrorKind::kInput, "no cell of a lattice is inside the model",
                  Remedy::kTakeSmallerHexahedra);
    HexReport& report = best_->report;
    report.attempts = std::move(attempts_);
    report.best_attempt = best_attempt_;
    if (report.remedy != Remedy::kLetFinish) choose_remedy(report);
    return *std::move(best_);
  }

 private:
  /// Makes the next lattice and says whether it could be.
  bool try_lattice() {
    Stopwatch stopwatch;
    const double size = next_size_;
    Lattice lattice = lattice_at(size);
    const auto cells = static_cast<double>(lattice.mesh.hexahedra.size());
    if (best_ && (cells > kMostOfLattice * expected_ || fitted_ + cells > kMostFitted)) return false;
    if (lattice.shells == shells_) {
      take(std::move(lattice), size, stopwatch);
    } else {
      next_coarse();
      skip(lattice, size, stopwatch);
      other_size_ = size;
      if (!lattice.mesh.hexahedra.empty()) other_ = std::move(lattice);
    }
    return true;
  }

  /// Goes on with a smaller size everywhere.
  void next_coarse() {
    next_size_ *= kSmallerLattice;
    fine_.clear();
    refinements_ = 0;
  }

  /// Goes on with planes nearer to each other where the last lattice lacks something, or with a smaller size
  /// everywhere.
  void choose_next(const LatticeHexahedra& last) {
    const bool is_lacking = last.report.outcome == HexOutcome::kApproximate;
    if (is_lacking && refinements_ < kMostRefinements) {
      fine_ = places_to_refine(last, surface_, next_size_, fine_);
      ++refinements_;
      if (!fine_.empty()) return;
    }
    next_coarse();
  }

  /// Of what is lacking, the size that comes next; but where only shapes are bad, smaller ones were no help.
  void choose_remedy(HexReport& report) const {
    if (report.outcome == HexOutcome::kAllHex) {
      if (report.attempts.size() > 1) report.remedy = Remedy::kNone;
      return;
    }
    const double next = rounded_down(kSmallerLattice * report.attempts.back().size, 2);
    const bool has_size = report.remedy == Remedy::kUseHexSize && report.remedy_number > 0;
    report.remedy_number = has_size ? std::min(next, report.remedy_number) : next;
    report.remedy = Remedy::kUseHexSize;
    report.remedy_hexahedra = report.model_volume / raised(report.remedy_number, 3);
  }

  void stop() {
    best_->report.is_stopped = true;
    if (!is_good(best_->report)) best_->report.remedy = Remedy::kLetFinish;
  }

  /// Whether lattices of a size may be small enough.
  bool may_take(double size) const {
    return raised(asked_size_ / size, 3) <= kMostOfLattice || attempts_.empty();
  }

  bool is_done() const { return best_ && (is_good(best_->report) || best_->report.is_stopped); }

  /// With planes at narrow features only where it has another topology without them: at walls; at holes too;
  /// and around these.
  Lattice lattice_at(double size) {
    const WatchedLoops watched(monitor_, Stops::kHeeded);
    NarrowFeatures narrow{.fine = fine_, .lines = lines_};
    Lattice lattice = lattice_of(surface_, size, narrow);
    const auto try_narrow = [&] {
      if (lattice.shells == shells_) return;
      Lattice other = lattice_of(surface_, size, narrow);
      if (other.shells == shells_) lattice = std::move(other);
    };
    narrow.walls = true;
    try_narrow();
    narrow.holes = holes_;
    if (!holes_.empty()) try_narrow();
    narrow.have_rings = true;
    if (!holes_.empty()) try_narrow();
    return lattice;
  }

  HexAttempt& begin(const Lattice& lattice, double size) {
    HexAttempt& attempt = attempts_.emplace_back();
    attempt.kind = kLatticeKind;
    attempt.number = attempts_.size();
    attempt.size = size;
    attempt.hexahedra = lattice.mesh.hexahedra.size();
    return attempt;
  }

  void end(const HexAttempt& attempt, std::string text) const {
    if (!on_end_) return;
    HexAttemptEnd end;
    end.attempt = attempt.number;
    end.outcome = attempt.outcome;
    end.hexahedra = attempt.hexahedra;
    end.text = std::move(text);
    end.seconds = attempt.seconds;
    if (!is_done() && may_take(next_size_))
      end.next = fine_.empty() ? fmt::format("a lattice of {:.3g}", next_size_)
                               : "finer planes of the lattice there";
    on_end_(end);
  }

  void skip(const Lattice& lattice, double size, Stopwatch& stopwatch) {
    HexAttempt& attempt = begin(lattice, size);
    attempt.seconds = stopwatch.restart();
    end(attempt, attempt.hexahedra == 0
                     ? "no cell of the lattice is inside the model"
                     : fmt::format("a lattice of {} has other bodies or holes than the model",
                                   counted(attempt.hexahedra, "cell")));
  }

  /// The text of a mesh: its first fault.
  static std::string text_of(const HexReport& report) {
    const std::string all = counted(report.hexahedra, "hexahedron", "hexahedra");
    if (report.outcome == HexOutcome::kPartial) return all + ": " + report.reason;
    const std::string fills = all + (report.hexahedra == 1 ? " fills the model" : " fill the model");
    return report.reason.empty() ? fills
                                 : fills + ", but: " + report.reason.substr(0, report.reason.find(';'));
  }

  /// Throws Error(kLimit) unless there is memory to fit a lattice, which is of no use otherwise: layers add
  /// about 1.5 hexahedra for a quad of its surface.
  void require_memory_to_fit(const HexMesh& mesh) const {
    constexpr double kAddedForQuad = 1.5;
    const WatchedLoops watched(monitor_, Stops::kHeeded);
    const double count = static_cast<double>(mesh.hexahedra.size()) +
                         kAddedForQuad * static_cast<double>(mesh.boundary.size());
    require_memory(kBytesOfFittedHexahedron * count,
                   fmt::format("fitting a lattice of {}", counted(mesh.hexahedra.size(), "cell")),
                   Remedy::kTakeFewerHexahedra);
  }

  void take(Lattice lattice, double size, Stopwatch& stopwatch) {
    require_memory_to_fit(lattice.mesh);
    HexAttempt attempt = begin(lattice, size);
    LatticeHexahedra made;
    made.mesh = std::move(lattice.mesh);
    made.mesh.unit = model_.solid.mesh.unit;
    made.report = fit_to_model(model_, size, FitWays::kLayersOnly, monitor_, made.mesh, made.warnings);
    made.report.size = asked_size_;
    made.report.expected = expected_;
    attempt.outcome = made.report.outcome;
    attempt.hexahedra = made.report.hexahedra;
    attempt.seconds = stopwatch.restart();
    attempts_.back() = attempt;
    std::string text = text_of(made.report);
    fitted_ += static_cast<double>(attempt.hexahedra);
    choose_next(made);
    if (!best_ || flaws_of(made.report) < flaws_of(best_->report)) {
      best_ = std::move(made);
      best_attempt_ = attempts_.size() - 1;
    }
    end(attempt, std::move(text));
  }

  const FittingModel& model_;
  const Surface surface_;
  const std::vector<int> shells_;
  const std::vector<std::vector<Vector3>> holes_, lines_;
  const Monitor& monitor_;
  const std::function<void(const HexAttemptEnd&)>& on_end_;
  const double asked_size_, expected_;
  double next_size_ = 0, fitted_ = 0;  ///< of the next lattice; hexahedra of all that were fitted
  std::vector<FinePlace> fine_;        ///< of the next lattice
  int refinements_ = 0;                ///< of lattices of this size
  std::vector<HexAttempt> attempts_;
  std::optional<LatticeHexahedra> best_;
  std::optional<Lattice> other_;  ///< the last of another topology, gone on with only where there is no other
  double other_size_ = 0;
  std::size_t best_attempt_ = 0;
};

}  // namespace

Surface outer_surface(const FeatureComplex& features) {
  TriangleMesh mesh;
  mesh.vertices = features.vertices;
  mesh.triangles = features.triangles;
  return prepare_surface(CheckedMesh::derived(std::move(mesh)));
}

LatticeHexahedra lattice_hexahedra(const FittingModel& model, double size, const Monitor& monitor,
                                   const std::function<void(const HexAttemptEnd&)>& on_end) {
  return Search(model, size, monitor, on_end).run();
}

}  // namespace crossgrain

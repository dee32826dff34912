// SPDX-License-Identifier: Apache-2.0
// Attempts at hexahedra, one after the other, until one is good.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/hexahedra.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "hex/hex_candidate.hpp"
#include "hex/hex_report.hpp"

namespace crossgrain {

class AttemptQueue;

/// When an attempt is due: rounds in their order, and steps within a round. A round begins with tets and a
/// field on them.
struct Turn {
  std::size_t round = 0;

  enum class Step : int { kTets, kRepair, kPart, kSmaller, kLattice };
  Step step = Step::kTets;

  auto operator<=>(const Turn&) const = default;
};

/// Attempts of one kind: says when the next is due, and makes it.
class AttemptKind : public Interface {
 public:
  /// A name for reports: "repair".
  virtual const char* name() const = 0;

  /// When the next attempt is due; none if there is none for now.
  virtual std::optional<Turn> next(const AttemptQueue& queue) const = 0;

  /// Finds out whether there is a next attempt, before it is told of: does of it what that takes. Without
  /// one, what is due next has changed.
  virtual bool prepare(AttemptQueue&) { return true; }

  /// Makes the next attempt, or several at the same time, the first first. What is due next has changed
  /// afterwards, even after an exception.
  virtual std::vector<HexCandidate> make(AttemptQueue& queue) = 0;

  /// What the next attempt tries, for the user: "tets of 2.1".
  virtual std::string plan(const AttemptQueue& queue) const = 0;

  /// Number of the round of the next attempt, from 0.
  virtual std::size_t round(const AttemptQueue& queue) const;

  /// How many further rounds its attempts begin at most.
  virtual std::size_t rounds_left(const AttemptQueue&) const { return 0; }

  /// Whether its attempts are at meshes, not only at what others start from.
  virtual bool makes_meshes() const { return true; }

  /// Whether its attempts are at tets and a field on them.
  virtual bool follows_field() const { return true; }

  /// Whether its attempts are made without any work left if there is no mesh: they give one from what is
  /// there.
  virtual bool is_last_resort() const { return false; }
};

/// A field that attempts start from.
struct StartingField {
  TetFrameField field;
  double size = 0;        ///< of the hexahedra that are asked for
  double work_share = 1;  ///< of the work of repairs that this field may take
};

/// The only search: what is due first is made first, of what is due at the same time the kind that was added
/// first. It ends with a good candidate (is_good) of a map, when nothing is due, or once the work of all
/// attempts is `most_work`, or less beside a lattice (limit_maps_beside_lattice), and there is a mesh, but
/// for last resorts. Work is counted, never timed, so that results are the same on every machine.
class AttemptQueue {
 public:
  /// The monitor must outlive the queue.
  AttemptQueue(double most_work, double least_quality, const Monitor& monitor);

  void add(std::unique_ptr<AttemptKind> kind) { kinds_.push_back(std::move(kind)); }

  /// Makes attempts until the end. An attempt that fails by an Error is reported, and others go on; but it is
  /// thrown if there is no mesh yet, and kInterrupted always but after a stop that the monitor allows: that
  /// is the end, if there is a mesh.
  void run();

  /// Sets the work of maps after which nothing but last resorts is tried once there is a lattice that fills
  /// the model: `if_good` where it keeps all of it, which maps only improve on. 0: nothing.
  void limit_maps_beside_lattice(double work, double if_good) { beside_lattice_ = {work, if_good}; }

  /// How many attempts at maps there are at most beside a lattice that keeps all: on small meshes work is
  /// longer than it is counted. Of nine models whose map came after the first attempts, seven took no more.
  static constexpr std::ptrdiff_t kMostMapsBesideGood = 6;

  /// Takes candidates for good although they do not keep all of the model.
  void end_at_approximate() { ends_at_approximate_ = true; }

  /// Calls a listener at the end of each attempt at a mesh.
  void hear_ends(std::function<void(const HexAttemptEnd&)> listener) { on_end_ = std::move(listener); }

  /// Sets how many hexahedra are expected, for the report.
  void expect(double hexahedra) { expected_hexahedra_ = hexahedra; }
  double expected_hexahedra() const { return expected_hexahedra_; }

  /// Begins a round with a field.
  void start_on(StartingField field);

  /// Whether the monitor allows stops.
  bool may_be_stopped() const { return may_be_stopped_; }

  /// Whether a stop has ended it.
  bool is_stopped() const { return is_stopped_; }

  /// The number of rounds, those among them whose tets failed; the field of the last one, if it has one.
  std::size_t rounds() const { return rounds_; }
  const std::optional<StartingField>& start() const { return start_; }

  /// The best candidate so far, or null; and of each round, where it may still be needed.
  const HexCandidate* best() const { return best_.get(); }
  const std::vector<std::shared_ptr<const HexCandidate>>& best_of_rounds() const { return of_rounds_; }

  /// Whether there is a mesh.
  bool has_mesh() const { return best_ && best_->made; }

  /// Number of the best attempt in attempts().
  std::size_t best_attempt() const { return best_ ? best_->number : 0; }

  /// All attempts, in the order in which they were made.
  const std::vector<HexAttempt>& attempts() const { return attempts_; }

  /// The error of the first that ended at a limit, such as that of memory.
  const std::optional<Error>& limit() const { return limit_; }

  /// Seconds of the steps of all of them.
  const HexSeconds& seconds() const { return seconds_; }

  /// The work of all attempts at maps so far, and whether it is the most.
  double work() const { return work_; }
  bool is_exhausted() const { return best_ && work_ >= allowed_work(); }

  double most_work() const { return most_work_; }
  double least_quality() const { return least_quality_; }

  /// To be given to what an attempt calls: its progress tells the attempt and the best so far too.
  const Monitor& monitor() const { return monitor_; }

 private:
  AttemptKind* due() const;
  AttemptKind* ready();
  void make(AttemptKind& kind);
  void add(const AttemptKind& kind, HexCandidate candidate);
  void add_failure(const AttemptKind& kind, const Error& error, double seconds);
  void add_end(HexAttempt& attempt, EndWords words);
  void tell_ends(const AttemptKind* next);
  std::string why_over() const;
  bool is_ended_by_stop();
  std::size_t most_rounds() const;
  void keep_if_better(const std::shared_ptr<const HexCandidate>& candidate);
  bool is_done() const;
  double allowed_work() const;
  void tell_more(Progress& progress) const;

  double most_work_, least_quality_, work_ = 0;
  bool ends_at_approximate_ = false;
  bool may_be_stopped_, is_stopped_ = false;
  Monitor monitor_;
  std::function<void(const HexAttemptEnd&)> on_end_;
  std::size_t at_meshes_ = 0;    ///< attempts that were made
  std::size_t round_ = 0;        ///< of the attempt that is being made
  std::size_t most_rounds_ = 0;  ///< before that attempt
  bool is_preparing_ = false;    ///< and has not begun it
  std::exception_ptr failure_;   ///< of what is ready
  std::string plan_;             ///< of the attempt that is being made
  bool follows_field_ = true;    ///< that attempt
  double expected_hexahedra_ = 0;
  std::vector<HexAttemptEnd> ends_;  ///< that are not told yet
  std::vector<std::unique_ptr<AttemptKind>> kinds_;
  std::size_t rounds_ = 0;
  std::optional<StartingField> start_;
  std::shared_ptr<const HexCandidate> best_, lattice_;
  std::array<double, 2> beside_lattice_{INFINITY, INFINITY};  ///< most work of maps, and where it is good
  std::vector<std::shared_ptr<const HexCandidate>> of_rounds_;
  std::vector<HexAttempt> attempts_;
  std::optional<Error> limit_;
  HexSeconds seconds_;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "progress_lines.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "crossgrain/message.hpp"
#include "progress_json.hpp"
#include "terminal_width.hpp"

namespace crossgrain::app {
namespace {

/// Frequent enough to look alive, rare enough to cost nothing.
constexpr std::chrono::milliseconds kRewritingInterval{100};

/// Interval without reports, so that the seconds keep counting.
constexpr std::chrono::milliseconds kMovingInterval{500};

bool can_move_lines() {
  const char* const terminal = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

/// Queried for every line, since windows change. One less than the width, because some terminals start a new
/// line after the last column.
std::size_t room_on_line() {
  return terminal_width(STDERR_FILENO) - 1;
}

/// Returns "level 3 of 5", or "level 3" as long as their number is not known.
std::string level_number(const Progress& progress) {
  const std::string text = fmt::format("level {}", progress.level);
  return progress.levels >= progress.level ? text + fmt::format(" of {}", progress.levels) : text;
}

std::string level_text(const Progress& progress, double seconds) {
  std::string text = level_number(progress) + ": ";
  text += progress.cells == 0 ? "making cells" : cells_text(progress.cells);
  if (progress.sweep > 0 && std::isfinite(progress.energy))
    text += fmt::format(", energy {:.6g}", progress.energy);
  return text + fmt::format(", {:.1f} s", seconds);
}

std::string phase_text(const Progress& progress) {
  if (progress.cells == 0) return name_of(progress.phase);
  const bool is_tets = progress.phase == Phase::kTets || progress.phase == Phase::kRepair;
  std::string text =
      fmt::format("{}: {} {}", name_of(progress.phase), progress.cells, is_tets ? "vertices" : "cells");
  if (progress.sweep > 0) text += fmt::format(", sweep {}", progress.sweep);
  if (std::isfinite(progress.energy)) text += fmt::format(", energy {:.6g}", progress.energy);
  return text;
}

/// What an attempt at hexahedra is at, in words for its user: all of the solve is one stage.
const char* stage_of(Phase phase) {
  switch (phase) {
    case Phase::kRead:
    case Phase::kMakeTets:
      return "making tets";
    case Phase::kGrid:
    case Phase::kSolve:
    case Phase::kAnalysis:
    case Phase::kTets:
      return "solving the field";
    case Phase::kRepair:
      return "repairing";
    case Phase::kMap:
      return "mapping";
    case Phase::kHexahedra:
      return "making hexahedra";
    case Phase::kSmooth:
      return "smoothing";
    case Phase::kWrite:
      return "writing";
  }
  return "";
}

bool is_of_attempt(const Progress& progress) {
  return progress.attempt > 0;
}

/// How far a stage is; empty if that is not known.
std::string share_text(const Progress& progress) {
  if (progress.level > 0) return ", " + level_number(progress);
  if (progress.share > 0) return fmt::format(", {:.0f} % done", 100 * progress.share);
  return "";
}

std::string attempt_text(const Progress& progress) {
  std::string text = fmt::format("attempt {}", progress.attempt);
  if (progress.most_tets > 1)
    text += fmt::format(", tets {} of at most {}", progress.tets, progress.most_tets);
  text += fmt::format(": {}", stage_of(progress.phase));
  return progress.fitted == 0 ? text : text + " " + counted(progress.fitted, "hexahedron", "hexahedra");
}

std::string best_text(const Progress& progress) {
  if (progress.hexahedra == 0) return "";
  return fmt::format("; best {}, {}", counted(progress.hexahedra, "hexahedron", "hexahedra"),
                     name_of(progress.outcome));
}

/// Grid and frames of a level share one line.
bool is_of_level(const Progress& progress) {
  return progress.level > 0 && (progress.phase == Phase::kGrid || progress.phase == Phase::kSolve);
}

bool same_line(const Progress& a, const Progress& b) {
  if (is_of_attempt(a) || is_of_attempt(b))
    return a.attempt == b.attempt && a.fitted == b.fitted &&
           stage_of(a.phase) == std::string_view(stage_of(b.phase));
  if (is_of_level(a) || is_of_level(b)) return is_of_level(a) && is_of_level(b) && a.level == b.level;
  return a.phase == b.phase;
}

void write(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

double seconds_of(std::chrono::steady_clock::duration duration) {
  return std::chrono::duration<double>(duration).count();
}

}  // namespace

std::string cells_text(std::size_t cells) {
  constexpr double kMillion = 1e6;
  if (static_cast<double>(cells) < kMillion) return counted(cells, "cell");
  return fmt::format("{:.3g} million cells", static_cast<double>(cells) / kMillion);
}

ProgressLines::ProgressLines(ProgressForm form, bool quiet)
    : quiet_(quiet),
      as_json_(!quiet && form == ProgressForm::kJson),
      shown_(!quiet && !as_json_ && (form == ProgressForm::kLines || isatty(STDERR_FILENO) != 0)),
      moving_(shown_ && can_move_lines()) {
  if (moving_) mover_ = std::thread([this] { keep_moving(); });
}

ProgressLines::~ProgressLines() {
  leave_line();
  if (!mover_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    over_ = true;
  }
  over_changed_.notify_all();
  mover_.join();
}

void ProgressLines::show(const Progress& progress) {
  if (!shown_ && !as_json_) return;
  const std::lock_guard lock(mutex_);
  const bool continues = current_ && same_line(*current_, progress);
  if (as_json_) {
    if (continues && Clock::now() - rewritten_ < kRewritingInterval) return;
    rewritten_ = Clock::now();
    current_ = progress;
    return tell_as_json(progress);
  }
  if (!continues) {
    end(/*done=*/true);
    begun_ = Clock::now();
  }
  current_ = progress;
  if (moving_ && (!continues || Clock::now() - rewritten_ >= kRewritingInterval)) rewrite();
}

template <class Event>
void ProgressLines::tell_as_json(const Event& event) {
  write(json_line(event, seconds_of(Clock::now() - start_)));
}

void ProgressLines::expect(const Expectation& expected) {
  const std::lock_guard lock(mutex_);
  remaining_.expect(expected.seconds);
  if (as_json_) tell_as_json(expected);
}

void ProgressLines::expect(const HexExpectation& expected) {
  const std::lock_guard lock(mutex_);
  if (as_json_) tell_as_json(expected);
}

void ProgressLines::tell(const ModelSummary& model) {
  const std::lock_guard lock(mutex_);
  if (as_json_) return tell_as_json(model);
  end(/*done=*/true);
}

void ProgressLines::end_attempt(const HexAttemptEnd& ended) {
  if (quiet_) return;
  const std::lock_guard lock(mutex_);
  if (as_json_) return tell_as_json(ended);
  end(/*done=*/true);
  std::string text = ended.text;
  if (text == ended_.text)
    text = fmt::format("ends as attempt {} did", ended_.attempt);
  else if (!ended.fault.empty() && ended.fault == ended_.fault)
    text = "the same" + text.substr(ended.fault.size());
  else if (!ended.fault.empty())
    text = "no mesh: " + text;
  if (!ended.next.empty()) text += "; trying " + ended.next;
  if (!ended.over.empty()) text += "; " + ended.over;
  write(fmt::format("attempt {}: {}\n", ended.attempt, text));
  if (ended.text != ended_.text) ended_ = ended;
}

void ProgressLines::leave_line() {
  const std::lock_guard lock(mutex_);
  end(/*done=*/false);
}

void ProgressLines::end_line() {
  const std::lock_guard lock(mutex_);
  end(/*done=*/true);
}

std::string ProgressLines::text(bool done) const {
  const auto now = Clock::now();
  const double of_line = seconds_of(now - begun_);
  if (is_of_attempt(*current_)) return text_of_attempt(done, of_line, seconds_of(now - start_));
  std::string text = is_of_level(*current_) ? level_text(*current_, of_line) : phase_text(*current_);
  if (!done) {
    if (const auto left = remaining_.seconds(*current_, seconds_of(now - start_), of_line))
      text += fmt::format(", about {} left", duration_text(*left));
  }
  return moving_ ? text.substr(0, room_on_line()) : text;
}

/// The time of the whole run comes first, so that no narrow terminal loses it; what is least needed comes
/// last, and only whole.
std::string ProgressLines::text_of_attempt(bool done, double of_line, double of_run) const {
  std::string text = fmt::format("{:5.1f} s  {}", of_run, attempt_text(*current_));
  const std::string more[] = {done ? fmt::format(" took {:.1f} s", of_line) : share_text(*current_),
                              best_text(*current_)};
  if (!moving_) return text + more[0] + more[1];
  for (const std::string& part : more)
    if (text.size() + part.size() <= room_on_line()) text += part;
  return text.substr(0, room_on_line());
}

void ProgressLines::rewrite() {
  rewritten_ = Clock::now();
  write(fmt::format("\r{}\x1b[K", text(/*done=*/false)));
}

void ProgressLines::end(bool done) {
  if (!current_ || as_json_) return;
  if (moving_)
    write(fmt::format("\r{}\x1b[K\n", text(/*done=*/true)));
  else if (done)
    write(text(/*done=*/true) + "\n");
  if (done && is_of_level(*current_))
    remaining_.add_level(current_->cells, seconds_of(Clock::now() - begun_));
  current_.reset();
}

void ProgressLines::keep_moving() {
  std::unique_lock lock(mutex_);
  while (!over_) {
    over_changed_.wait_for(lock, kMovingInterval);
    if (!over_ && current_ && Clock::now() - rewritten_ >= kMovingInterval) rewrite();
  }
}

}  // namespace crossgrain::app

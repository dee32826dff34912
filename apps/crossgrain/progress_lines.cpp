// SPDX-License-Identifier: Apache-2.0
#include "progress_lines.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "crossgrain/message.hpp"
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

std::string level_text(const Progress& progress, double seconds) {
  std::string text = fmt::format("level {} of {}: ", progress.level, progress.levels);
  text += progress.cells == 0 ? "making cells" : cells_text(progress.cells);
  if (progress.sweep > 0 && std::isfinite(progress.energy))
    text += fmt::format(", energy {:.6g}", progress.energy);
  return text + fmt::format(", {:.1f} s", seconds);
}

std::string phase_text(const Progress& progress) {
  if (progress.cells == 0) return name_of(progress.phase);
  const bool is_tets = progress.phase == Phase::kTets || progress.phase == Phase::kRepair ||
                       progress.phase == Phase::kHexahedra;
  std::string text =
      fmt::format("{}: {} {}", name_of(progress.phase), progress.cells, is_tets ? "vertices" : "cells");
  if (progress.sweep > 0) text += fmt::format(", sweep {}", progress.sweep);
  if (std::isfinite(progress.energy)) text += fmt::format(", energy {:.6g}", progress.energy);
  return text;
}

/// Of a search for hexahedra: which attempt it is at, and what it has.
std::string attempt_text(const Progress& progress) {
  if (progress.attempt == 0) return "";
  std::string text = fmt::format("attempt {}", progress.attempt);
  if (progress.hexahedra > 0)
    text += fmt::format(", best so far {}{}", counted(progress.hexahedra, "hexahedron", "hexahedra"),
                        progress.is_whole ? "" : ", a part");
  return text + "; ";
}

/// Grid and frames of a level share one line.
bool is_of_level(const Progress& progress) {
  return progress.level > 0 && (progress.phase == Phase::kGrid || progress.phase == Phase::kSolve);
}

bool same_line(const Progress& a, const Progress& b) {
  if (is_of_level(a) || is_of_level(b)) return is_of_level(a) && is_of_level(b) && a.level == b.level;
  return a.phase == b.phase && a.attempt == b.attempt;
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

ProgressLines::ProgressLines(bool shown) : shown_(shown), moving_(shown && can_move_lines()) {
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
  if (!shown_) return;
  const std::lock_guard lock(mutex_);
  const bool continues = current_ && same_line(*current_, progress);
  if (!continues) {
    end(/*done=*/true);
    begun_ = Clock::now();
  }
  current_ = progress;
  if (moving_ && (!continues || Clock::now() - rewritten_ >= kRewritingInterval)) rewrite();
}

void ProgressLines::expect(double total_seconds) {
  const std::lock_guard lock(mutex_);
  remaining_.expect(total_seconds);
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
  std::string text = attempt_text(*current_) +
                     (is_of_level(*current_) ? level_text(*current_, of_line) : phase_text(*current_));
  if (!done) {
    if (const auto left = remaining_.seconds(*current_, seconds_of(now - start_), of_line))
      text += fmt::format(", about {} left", duration_text(*left));
  }
  return moving_ ? text.substr(0, room_on_line()) : text;
}

void ProgressLines::rewrite() {
  rewritten_ = Clock::now();
  write(fmt::format("\r{}\x1b[K", text(/*done=*/false)));
}

void ProgressLines::end(bool done) {
  if (!current_) return;
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

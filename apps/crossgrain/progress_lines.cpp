// SPDX-License-Identifier: Apache-2.0
#include "progress_lines.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <string_view>

namespace crossgrain::app {
namespace {

/// Often enough to look alive, seldom enough to cost nothing.
constexpr std::chrono::milliseconds kRewritingInterval{100};

/// What is being worked on: a level of the octree, all cells, or the vertices of tets.
std::string extent_of(const Progress& progress) {
  const std::string_view phase = progress.phase;
  if (phase == "tets") return fmt::format("{} vertices", progress.cells);
  if (phase == "analysis") return fmt::format("{} cells", progress.cells);
  return fmt::format("level {}, {} cells", progress.depth, progress.cells);
}

std::string text_of(const Progress& progress) {
  if (progress.cells == 0) return progress.phase;
  std::string text = fmt::format("{}: {}", progress.phase, extent_of(progress));
  if (progress.sweep > 0) text += fmt::format(", sweep {}", progress.sweep);
  if (std::isfinite(progress.energy)) text += fmt::format(", energy {:.6g}", progress.energy);
  return text;
}

void write(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
}

bool same_line(const Progress& a, const Progress& b) {
  return std::string_view(a.phase) == b.phase && a.depth == b.depth;
}

}  // namespace

ProgressLines::ProgressLines(bool shown) : shown_(shown), terminal_(isatty(STDERR_FILENO) != 0) {}

ProgressLines::~ProgressLines() {
  end_line();
}

void ProgressLines::show(const Progress& progress) {
  if (!shown_) return;
  const bool continues = current_ && same_line(*current_, progress);
  if (!continues) end_line();
  current_ = progress;
  if (!terminal_) return;
  const auto now = Clock::now();
  if (continues && now - rewritten_ < kRewritingInterval) return;
  rewritten_ = now;
  write("\r\x1b[K" + text_of(progress));
}

void ProgressLines::end_line() {
  if (!current_) return;
  write((terminal_ ? "\r\x1b[K" : "") + text_of(*current_) + "\n");
  current_.reset();
}

}  // namespace crossgrain::app

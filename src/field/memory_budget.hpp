// SPDX-License-Identifier: Apache-2.0
// Memory of a solve at its peaks, structure by structure: the table in docs/notes/performance.md, used for
// memory limits and forecasts. tests/field/memory_budget_test.cpp compares it with actual allocations.
#pragma once

#include <algorithm>
#include <array>

#include "grid/level_growth.hpp"

namespace crossgrain {

/// The three moments of the finest level with most memory in use.
enum class MemoryMoment {
  kConnecting,  ///< rows of neighbours are built
  kSettling,    ///< sweeps run
  kComparing    ///< energies are computed
};

/// Bytes of one structure per cell, surface cell, cell of several normals and piece. Coefficients and forms
/// are those of degree 4; in degree 3 they are smaller.
struct MemoryLine {
  double per_cell = 0;
  double per_surface_cell = 0;
  double per_cell_of_several_normals = 0;
  double per_piece = 0;
  std::array<bool, 3> held{};  ///< by MemoryMoment

  constexpr double bytes(const LevelCounts& counts) const {
    return per_cell * counts.cells + per_surface_cell * counts.surface_cells +
           per_cell_of_several_normals * counts.several_normals + per_piece * counts.pieces;
  }
};

namespace memory_lines {

inline constexpr std::array kAlways{true, true, true};
inline constexpr std::array kWhileConnecting{true, false, false};
inline constexpr std::array kFromConnecting{true, true, false};
inline constexpr std::array kWhileSettling{false, true, false};
inline constexpr std::array kFromSettling{false, true, true};
inline constexpr std::array kWhileComparing{false, false, true};

inline constexpr MemoryLine kTree{.per_cell = 8, .held = kAlways};
inline constexpr MemoryLine kPieceBegin{.per_cell = 4, .held = kAlways};
inline constexpr MemoryLine kPieces{.per_piece = 8, .held = kAlways};
inline constexpr MemoryLine kWinding{.per_cell = 1, .held = kAlways};
inline constexpr MemoryLine kFaceNeighbours{.per_cell = 24, .held = kWhileConnecting};
inline constexpr MemoryLine kParents{.per_cell = 4, .held = kWhileConnecting};
inline constexpr MemoryLine kFaceWeights{.per_cell = 6, .held = kWhileConnecting};
inline constexpr MemoryLine kOpenFaces{.per_cell = 1, .held = kAlways};
inline constexpr MemoryLine kAdjacency{.per_cell = 55, .per_surface_cell = 22, .held = kAlways};
inline constexpr MemoryLine kSweepOrder{.per_cell = 4, .held = kFromConnecting};
inline constexpr MemoryLine kFormSlots{.per_cell = 4, .held = kWhileSettling};
inline constexpr MemoryLine kPlaneForms{
    .per_surface_cell = 16, .per_cell_of_several_normals = -16, .held = kWhileSettling};
inline constexpr MemoryLine kGeneralForms{.per_cell_of_several_normals = 220, .held = kWhileSettling};
inline constexpr MemoryLine kCoarserFrames{.per_cell = 6, .held = kWhileConnecting};
inline constexpr MemoryLine kFrames{.per_cell = 16, .held = kFromSettling};
inline constexpr MemoryLine kCoefficients{.per_cell = 36, .held = kFromSettling};
inline constexpr MemoryLine kEnergyDensity{.per_cell = 4, .held = kWhileComparing};
inline constexpr MemoryLine kSharpTurns{.per_cell = 1, .held = kWhileComparing};

/// Only in a solve that may be stopped, so not in `kAll`: the finished level before the current one, about a
/// quarter as large, with its tree, surface, guides, frames and energy density.
inline constexpr MemoryLine kKeptLevel{.per_cell = 10, .per_piece = 2, .held = kAlways};

/// Only on levels that are relaxed after the decision, so not in `kAll`: the frames before the relaxation.
inline constexpr MemoryLine kUnrelaxedFrames{.per_cell = 16, .held = kFromSettling};

inline constexpr std::array kAll{
    kTree,         kPieceBegin,    kPieces,    kWinding,      kFaceNeighbours, kParents,
    kFaceWeights,  kOpenFaces,     kAdjacency, kSweepOrder,   kFormSlots,      kPlaneForms,
    kGeneralForms, kCoarserFrames, kFrames,    kCoefficients, kEnergyDensity,  kSharpTurns};

}  // namespace memory_lines

/// Bytes of all structures in use at one moment.
constexpr double memory_bytes(MemoryMoment moment, const LevelCounts& counts) {
  double bytes = 0;
  for (const MemoryLine& line : memory_lines::kAll) {
    if (line.held[static_cast<std::size_t>(moment)]) bytes += line.bytes(counts);
  }
  return bytes;
}

/// Peak memory in bytes while a level is built and solved.
constexpr double peak_memory_bytes(const LevelCounts& counts) {
  return std::max({memory_bytes(MemoryMoment::kConnecting, counts),
                   memory_bytes(MemoryMoment::kSettling, counts),
                   memory_bytes(MemoryMoment::kComparing, counts)});
}

/// Bytes used besides the level by parallel loops, analysis and writing, whatever the size.
inline constexpr double kMemoryOfOther = 5e6;

}  // namespace crossgrain

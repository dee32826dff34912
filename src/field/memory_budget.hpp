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
  const char* structure;
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

inline constexpr MemoryLine kTree{.structure = "tree", .per_cell = 8, .held = kAlways};
inline constexpr MemoryLine kPieceBegin{.structure = "piece_begin", .per_cell = 4, .held = kAlways};
inline constexpr MemoryLine kPieces{.structure = "pieces", .per_piece = 8, .held = kAlways};
inline constexpr MemoryLine kWinding{.structure = "centre_winding", .per_cell = 1, .held = kAlways};
inline constexpr MemoryLine kFaceNeighbours{
    .structure = "face neighbours", .per_cell = 24, .held = kWhileConnecting};
inline constexpr MemoryLine kParents{.structure = "parents", .per_cell = 4, .held = kWhileConnecting};
inline constexpr MemoryLine kFaceWeights{
    .structure = "face weights", .per_cell = 6, .held = kWhileConnecting};
inline constexpr MemoryLine kOpenFaces{.structure = "open faces", .per_cell = 1, .held = kAlways};
inline constexpr MemoryLine kAdjacency{
    .structure = "adjacency", .per_cell = 55, .per_surface_cell = 22, .held = kAlways};
inline constexpr MemoryLine kSweepOrder{.structure = "sweep order", .per_cell = 4, .held = kFromConnecting};
inline constexpr MemoryLine kFormSlots{.structure = "slots of forms", .per_cell = 4, .held = kWhileSettling};
inline constexpr MemoryLine kPlaneForms{.structure = "forms of planes",
                                        .per_surface_cell = 16,
                                        .per_cell_of_several_normals = -16,
                                        .held = kWhileSettling};
inline constexpr MemoryLine kGeneralForms{
    .structure = "forms of several normals", .per_cell_of_several_normals = 220, .held = kWhileSettling};
inline constexpr MemoryLine kCoarserFrames{
    .structure = "frames of the level before", .per_cell = 6, .held = kWhileConnecting};
inline constexpr MemoryLine kFrames{.structure = "frames", .per_cell = 16, .held = kFromSettling};
inline constexpr MemoryLine kCoefficients{.structure = "coefficients", .per_cell = 36, .held = kFromSettling};
inline constexpr MemoryLine kEnergyDensity{
    .structure = "energy density", .per_cell = 4, .held = kWhileComparing};
inline constexpr MemoryLine kSharpTurns{.structure = "sharp turns", .per_cell = 1, .held = kWhileComparing};

/// Only in a solve that may be stopped, so not in `kAll`: the finished level before the current one, about a
/// quarter as large, with its tree, surface, guides, frames and energy density.
inline constexpr MemoryLine kKeptLevel{
    .structure = "the level before", .per_cell = 10, .per_piece = 2, .held = kAlways};

/// Only on levels that are relaxed after the decision, so not in `kAll`: the frames before the relaxation.
inline constexpr MemoryLine kUnrelaxedFrames{
    .structure = "frames before the relaxation", .per_cell = 16, .held = kFromSettling};

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

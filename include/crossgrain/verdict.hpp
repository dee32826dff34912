// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "crossgrain/message.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup lines Singular lines, answers and streamlines
/// @{

struct SolveReport;

/// Whether a hexahedral mesh can follow a field, or a part of it, locally. What holds everywhere locally is
/// necessary for a mesh, not sufficient.
enum class Verdict : std::uint8_t {
  kMeshable = 0,
  kNotMeshable = 1,
  kUndecided = 2,  ///< the cells do not resolve what decides, or rounding does, or it is too large to judge
};

/// Returns the name in report.json: "meshable", "not_meshable" or "undecided".
const char* name_of(Verdict verdict);

/// Returns the answer in short: "hexahedra fit locally", "hexahedra cannot follow this field" or "undecided".
const char* words_of(Verdict verdict);

/// Why a field is not meshable or undecided.
enum class ReasonKind : std::uint8_t {
  kKnifeEdge,     ///< a crease without room for a hexahedron
  kCorner,        ///< a corner of the surface around which no hexahedra fit
  kArc,           ///< an arc that turns, or rotates frames about a diagonal
  kNode,          ///< a node inside that no hexahedra have
  kEnds,          ///< arcs that end so close together that the cells do not separate them
  kOtherAtHalf,   ///< the singular lines at half the resolution are others
  kNoComparison,  ///< there is no coarser level to compare with
  kWalls,         ///< walls of too few cells
  kSurface,       ///< surface that frames do not follow
  kCreases,       ///< creases that frames do not follow
  kShortLines,    ///< many lines that are too short for the cells
  kUnfinished,    ///< the solve was stopped, or ran out of memory or sweeps
};

/// Returns the name in report.json, such as "knife_edge".
const char* name_of(ReasonKind kind);

/// The answer about a whole field.
struct Answer {
  struct Reason {
    ReasonKind kind{};
    Verdict verdict{};              ///< kNotMeshable or kUndecided
    std::size_t count = 0;          ///< number of places with this fault; 0 if it is about no place
    Vector3 place{};                ///< the first or worst one, model units; only if there is one
    std::string text;               ///< such as "the edge of 30 degrees between faces 3 and 5 is too sharp"
    Remedy remedy = Remedy::kNone;  ///< what to do next
    double remedy_number = 0;       ///< if `has_number`
  };
  Verdict verdict = Verdict::kUndecided;
  std::vector<Reason> reasons;  ///< those of the verdict first; empty if meshable
  bool is_meshed = false;       ///< hexahedra were made of the field: their report tells what became of it
};

/// Returns the answer about the field of a report: that on tets if there is one, otherwise that on the grid.
Answer answer_of(const SolveReport& report);

/// Returns the answer in one line: "hexahedra fit locally (necessary, not sufficient)", "this field has no
/// hexahedra at ...: ...; 'crossgrain hex' may still find a mesh; next: ..." or "undecided, because ...;
/// next:
/// ...". It is about the field, not about the part, of which another field may have hexahedra.
std::string sentence_of(const Answer& answer);

/// Returns the sentence with other words for the remedy of the first reason.
std::string sentence_of(const Answer& answer, const std::string& remedy_words);

/// @}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "crossgrain/message.hpp"

namespace crossgrain {

/// What to know before trusting a mesh or a field.
enum class WarningKind : int {
  // A file that is read.
  kUnknownUnit,   ///< a CAD file names none
  kMissingParts,  ///< of a CAD file, not read
  kLooseFaces,    ///< of a CAD file, in no solid
  kMissingFaces,  ///< of a CAD file, not cut into triangles
  kCurvedTets,    ///< taken as straight
  kSkippedData,   ///< of a VTK file, not known

  // Tets.
  kRepeatedTets,
  kInvertedTets,
  kFlatTets,
  kOverlappingTets,
  kUnusedVertices,
  kTouchingEdges,  ///< along which the solid touches itself
  kTouchingVertices,
  kUnmergedVertices,  ///< parts lie face to face and share no vertices
  kStrayTags,         ///< tagged triangles that are faces of no tet

  // The surface and its solids.
  kSurfaceFinding,  ///< one of SolveReport::input
  kOverlappingSolids,
  kTouchingSolids,
  kEmptySolids,  ///< too small to hold a cell
  kCrowdedCorners,
  kKnifeEdges,

  // The solve.
  kUnfinished,
  kMemoryLimited,    ///< cells are larger than was asked for
  kThinWalls,        ///< under-resolved
  kExcludedSurface,  ///< no frame meets the constraints of its cells
  kNotSettled,       ///< sweeps ran out
  kTetsNotSettled,
  kConstraintsOutside,
  kVerticesOutside,  ///< of the tet mesh, in no cell
  kOtherModel,       ///< the field that was started from is of another one

  // What is written.
  kClipMissed,
  kLeftOutTets
};

/// A name for files and scripts: "thin_walls".
const char* name_of(WarningKind kind);

struct Warning : Message {
  WarningKind kind{};

  Warning() = default;
  Warning(WarningKind its_kind, Message message) : Message(std::move(message)), kind(its_kind) {}

  /// Of no certain file or place.
  Warning(WarningKind its_kind, std::string its_text, Remedy its_remedy = Remedy::kNone)
      : Message{{}, {}, std::move(its_text), its_remedy}, kind(its_kind) {}

  bool operator==(const Warning&) const = default;
};

}  // namespace crossgrain

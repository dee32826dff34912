// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "crossgrain/message.hpp"

namespace crossgrain {

/// \addtogroup fields Fields
/// @{

/// What a warning is about.
enum class WarningKind : int {
  // A file that is read.
  kUnknownUnit,     ///< a CAD file names no unit
  kMissingParts,    ///< parts of a CAD file could not be read
  kLooseFaces,      ///< faces of a CAD file belong to no solid
  kRepeatedBodies,  ///< faces and solids of a CAD file that are there twice, left out
  kMissingFaces,    ///< faces of a CAD file could not be triangulated
  kCurvedTets,      ///< tets of higher order were read as straight
  kSkippedData,     ///< data of a VTK file are not known

  // Tets that are made.
  kTetMaker,  ///< they were made in another way than usual

  // Hexahedra that are made.
  kThinPart,  ///< few fit across most of the model
  kManyTets,  ///< tets of the size that is given are many

  // Tets.
  kRepeatedTets,      ///< duplicates, left out
  kInvertedTets,      ///< reoriented
  kFlatTets,          ///< without volume, left out
  kOverlappingTets,   ///< both tets of a face are on the same side of it
  kUnusedVertices,    ///< vertices of no tet
  kTouchingEdges,     ///< the solid touches itself along edges
  kTouchingVertices,  ///< the solid touches itself at vertices
  kUnmergedVertices,  ///< parts lie face to face and share no vertices
  kStrayTags,         ///< tagged triangles are faces of no tet
  kListedTopology,    ///< tags and lists that name nearly everything, ignored
  kRefusedSplits,     ///< splits for a map were not made

  // The surface and its solids.
  kSurfaceFinding,     ///< one of SolveReport::input
  kLeftOutFeatures,    ///< small holes and bosses were left out, as asked for
  kOverlappingSolids,  ///< solids overlap
  kTouchingSolids,     ///< solids touch without shared triangles
  kEmptySolids,        ///< solids are too small to hold a cell
  kCrossedInterfaces,  ///< hexahedra reach across faces between solids
  kCrowdedCorners,     ///< more than three creases meet
  kKnifeEdges,         ///< edges are too sharp for any frame
  kFadedCreases,       ///< creases end in the smooth surface, which a smaller angle would follow

  // The solve.
  kUnfinished,          ///< it was stopped
  kMemoryLimited,       ///< cells are larger than requested
  kThinWalls,           ///< walls are not resolved
  kExcludedSurface,     ///< a large part of the surface has constraints that no frame meets
  kNotSettled,          ///< the sweeps on the grid ran out
  kTetsNotSettled,      ///< the sweeps on the tets ran out
  kConstraintsOutside,  ///< constraints lie in no cell
  kVerticesOutside,     ///< vertices of the tet mesh lie in no cell
  kOtherModel,          ///< the solve started from a field of another model

  // Hexahedra.
  kFacesWithoutQuads,  ///< faces of the model have none
  kFacesOff,           ///< the quads of faces cover another area than these
  kPoorFit,            ///< they miss much of the model's volume, or are far from its surface
  kAttemptLimited,     ///< an attempt at better ones ended at a limit, such as that of memory

  // What is written.
  kClipMissed,   ///< no cell touches the box
  kLeftOutTets,  ///< files number tets without those that were left out
  kNotFinite     ///< numbers of the report are not finite
};

/// Returns a name for files and scripts: "thin_walls".
const char* name_of(WarningKind kind);

/// What to know before trusting a mesh or a field.
struct Warning : Message {
  WarningKind kind{};

  Warning() = default;
  Warning(WarningKind its_kind, Message message) : Message(std::move(message)), kind(its_kind) {}

  /// A warning without file and place.
  Warning(WarningKind its_kind, std::string its_text, Remedy its_remedy = Remedy::kNone)
      : Message{{}, {}, std::move(its_text), its_remedy}, kind(its_kind) {}

  bool operator==(const Warning&) const = default;
};

/// @}

}  // namespace crossgrain

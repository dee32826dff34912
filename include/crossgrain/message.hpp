// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

namespace crossgrain {

/// \addtogroup errors Errors and messages
/// @{

/// Returns a number with its noun: "1 cell", "2 cells". `many` is the plural unless it ends in a mere s.
std::string counted(std::size_t count, const std::string& one, const std::string& many = {});

/// Returns the verb after a number of things.
inline const char* is_or_are(std::size_t count) {
  return count == 1 ? "is" : "are";
}

/// What the caller can do about an error or a warning; `words_of` puts it into words.
enum class Remedy : int {
  kNone,  ///< nothing, or the text says it

  // A file that is read.
  kCheckPath,
  kCheckDisk,
  kAllowReading,   ///< change its permissions
  kGiveFile,       ///< name a regular file
  kCopyAgain,      ///< copy or export it again: it is cut short
  kRepairFile,     ///< its content is invalid
  kExportAgain,    ///< it may be valid, but is not what is needed
  kGivePartFiles,  ///< its parts are in other files
  kCorrectLine,    ///< correct the line of a text file
  kRename,         ///< its extension belongs to another format
  kConvertFile,    ///< convert it to a known format
  kTriangulate,
  kCutIntoTets,
  kSimplify,
  kSimplifyOrAllowMemory,  ///< ReadOptions::max_memory_bytes
  kAllowMemory,            ///< max_memory_bytes of the options
  kFreeMemory,
  kAllowReadTime,  ///< ReadOptions::read_seconds
  kReadUnglued,    ///< without ReadOptions::glue
  kInstallCadReader,
  kInstallOpenCascade,
  kReinstall,

  // What `write_field` and `write_streamlines` have written.
  kSolveAgain,
  kCopyOrSolveAgain,
  kGiveFieldFolder,
  kGiveModel,  ///< not a field
  kTraceStreamlines,
  kMakeHexahedra,
  kFitHexahedra,
  kContinueSolve,  ///< `solve_from` the field
  kSolveAnew,      ///< without CheckpointFolders::resume
  kGiveCheckpoint,
  kGiveSameModel,  ///< and the same options, as for the checkpoint
  kUseWrittenMesh,

  // The model.
  kCloseSurface,
  kRescale,
  kMoveToOrigin,
  kMatchUnits,
  kRemoveElement,
  kRemoveOverlaps,
  kMergeVertices,
  kGlueSolids,
  kSeparateSolids,
  kSplitTets,
  kKeepTags,  ///< TetTagOptions::keep_all
  kGiveSolvedSurface,

  // Tets that are made.
  kCloseHoles,
  kUniteParts,  ///< and remove triangles that cross others
  kInstallTetMaker,
  kAllowTetTime,   ///< TetMakingOptions::seconds
  kChangeTetSize,  ///< TetMakingOptions::size
  kTakeLargerTets,
  kGiveTetSize,  ///< another TetMakingOptions::size; with a number
  kFreeTemporarySpace,

  // Hexahedra that are made.
  kGiveHexSize,  ///< another HexOptions::size; with a number
  kUseHexSize,   ///< HexOptions::size; with a number
  kTakeLargerHexahedra,
  kTakeFewerHexahedra,  ///< larger ones, or allow them more memory

  // Options.
  kRaiseResolution,
  kLowerResolution,
  kUseLessMemory,
  kUseCreaseAngle,  ///< crease_angle_deg of the options; with a number
  kGiveCellSize,    ///< another SolveOptions::cell_size; with a number
  kTurnView,

  // The answer whether hexahedra can follow a field (Answer::Reason).
  kRoundEdge,
  kCutCorner,
  kChangeAngles,  ///< or take smaller cells there
  kCutTip,        ///< or take smaller cells
  kTryOtherCells,
  kUseResolution,  ///< SolveOptions::resolution; with a number
  kUseEdgeLength,  ///< of the tets; with a number, model units
  kLetFinish,
  kMeshAgain,

  // A file that is written.
  kNameOutput,
  kChooseWritablePlace,
  kFreeSpace,
  kMoveCheckpoint,  ///< or free some space
  kMakeFolder,
  kCheckOutputDisk,
  kClearPlace,
  kChooseFolder,  ///< or allow it: OutputOptions::foreign_files
  kAwaitSolve,

  kReportModel  ///< to the makers of this library
};

/// Returns the remedy in words, without options of any program: "raise the resolution, or take smaller
/// cells"; empty for kNone.
const char* words_of(Remedy remedy);

/// Whether a remedy needs a number to say what to do.
inline bool has_number(Remedy remedy) {
  return remedy == Remedy::kUseResolution || remedy == Remedy::kUseEdgeLength ||
         remedy == Remedy::kUseHexSize || remedy == Remedy::kGiveHexSize || remedy == Remedy::kGiveTetSize ||
         remedy == Remedy::kGiveCellSize || remedy == Remedy::kUseCreaseAngle;
}

/// Returns a remedy in words, with its number if it has one: "use a resolution of 128".
std::string words_of(Remedy remedy, double number);

/// Returns a name for files and scripts: "raise_resolution". Names do not change with the words.
const char* name_of(Remedy remedy);

/// The content of an error or a warning.
struct Message {
  std::string file;  ///< empty if it is not about a file
  std::string
      place;  ///< in the file or the object: "line 12", "vertex 7 (counted from 0)"; empty for all of it
  std::string text;  ///< what is wrong, in one line
  Remedy remedy = Remedy::kNone;
  double remedy_number = 0;  ///< if `has_number`

  bool operator==(const Message&) const = default;
};

/// Returns "FILE: PLACE: TEXT; REMEDY" without the empty parts.
std::string sentence_of(const Message& message);

/// Returns the sentence with other words for the remedy.
std::string sentence_of(const Message& message, const std::string& remedy_words);

/// @}

}  // namespace crossgrain

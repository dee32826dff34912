// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace crossgrain {

/// What the caller can do about an error or a warning. `words_of` says each in words.
enum class Remedy : int {
  kNone,  ///< there is nothing to do, or the text says it

  // A file that is read.
  kCheckPath,
  kCheckDisk,
  kAllowReading,  ///< its permissions do not
  kGiveFile,      ///< a regular one
  kCopyAgain,     ///< it is cut short, or was exported so
  kRepairFile,    ///< what is in it makes no sense
  kExportAgain,   ///< it may be sound, but not what is needed
  kCorrectLine,   ///< of a text file that people write
  kRename,        ///< its name ends like that of another format
  kConvertFile,   ///< to a format that is known
  kTriangulate,
  kCutIntoTets,
  kSimplify,
  kSimplifyOrAllowMemory,  ///< ReadOptions::max_memory_bytes
  kAllowMemory,            ///< max_memory_bytes of the options
  kFreeMemory,
  kAllowReadTime,  ///< ReadOptions::read_seconds
  kInstallCadReader,
  kInstallOpenCascade,
  kReinstall,

  // What `write_field` and `write_streamlines` have written.
  kSolveAgain,
  kCopyOrSolveAgain,
  kGiveFieldFolder,
  kGiveModel,  ///< not a field
  kTraceStreamlines,
  kContinueSolve,  ///< `solve_from` the field
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
  kGiveSolvedSurface,

  // Options.
  kRaiseResolution,
  kLowerResolution,
  kUseLessMemory,
  kTurnView,

  // A file that is written.
  kNameOutput,
  kChooseWritablePlace,
  kFreeSpace,
  kMakeFolder,
  kCheckOutputDisk,
  kClearPlace,

  kReportModel  ///< to the makers of this library
};

/// The remedy in words, without options of any program: "raise the resolution, or take smaller cells". Empty
/// for kNone.
const char* words_of(Remedy remedy);

/// A name for files and scripts: "raise_resolution". Stays the same when the words change.
const char* name_of(Remedy remedy);

/// What an error or a warning says.
struct Message {
  std::string file;  ///< empty for what is not in a file
  std::string
      place;  ///< in the file or the object: "line 12", "vertex 7 (counted from 0)"; empty for all of it
  std::string text;  ///< what is wrong, in one line
  Remedy remedy = Remedy::kNone;

  bool operator==(const Message&) const = default;
};

/// "FILE: PLACE: TEXT; REMEDY", less what is empty.
std::string sentence_of(const Message& message);

/// The same with other words for the remedy.
std::string sentence_of(const Message& message, const std::string& remedy_words);

}  // namespace crossgrain

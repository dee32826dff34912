// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <new>
#include <system_error>
#include <thread>

namespace crossgrain::app {
namespace {

constexpr unsigned bit(Command command) {
  return 1u << static_cast<unsigned>(command);
}

constexpr unsigned kSolve = bit(Command::kSolve) | bit(Command::kProcesses), kHex = bit(Command::kHex),
                   kFit = bit(Command::kFit), kTets = bit(Command::kTets), kOther = bit(Command::kOther),
                   kFolders = kSolve | kHex, kWritten = kFolders | kFit, kModels = kWritten | kTets,
                   kAll = kModels | kOther;

struct OptionWords {
  Remedy remedy;
  const char* words;  ///< with {} for the number of a remedy that has one
  unsigned commands;  ///< bits
};

/// The first row of a remedy and a command counts.
constexpr OptionWords kOptionWords[] = {
    {Remedy::kRaiseResolution, "raise --resolution, or lower --cell-size", kSolve},
    {Remedy::kRaiseResolution, "take smaller tets with --tet-size", kHex},
    {Remedy::kLowerResolution, "lower --resolution, or raise --cell-size", kSolve},
    {Remedy::kLowerResolution, "take larger tets with --tet-size", kHex},
    {Remedy::kUseLessMemory, "lower --resolution, raise --cell-size or allow more memory with --max-memory",
     kSolve},
    {Remedy::kUseLessMemory, "raise --size or --tet-size, or allow more memory with --max-memory", kHex},
    {Remedy::kAllowMemory, "allow more memory with --max-memory", kModels},
    {Remedy::kSimplifyOrAllowMemory, "simplify it, or allow more memory with --max-memory", kModels},
    {Remedy::kAllowReadTime, "repair it and export it again, or allow more time with --read-seconds",
     kModels},
    {Remedy::kReadUnglued, "repair them, or leave out --glue", kModels},
    {Remedy::kContinueSolve, "a solve with --from goes on from here", kSolve},
    {Remedy::kSolveAnew, "solve without --restart", bit(Command::kProcesses)},
    {Remedy::kGiveCheckpoint, "name the folder of --checkpoint", bit(Command::kProcesses)},
    {Remedy::kMoveCheckpoint,
     "free some space, or choose another disk with --checkpoint; what it held is kept",
     bit(Command::kProcesses)},
    {Remedy::kKeepTags, "--keep-tags follows them all the same", kWritten},
    {Remedy::kTurnView, "choose another --view or --cut", kOther},
    {Remedy::kGiveFieldFolder, "give a folder that 'crossgrain solve' or 'crossgrain hex' has written", kAll},
    {Remedy::kTraceStreamlines, "trace lines with 'crossgrain streamlines'", kAll},
    {Remedy::kMakeHexahedra, "make them with 'crossgrain hex'", kAll},
    {Remedy::kFitHexahedra, "'crossgrain fit' puts them onto a model", kAll},
    {Remedy::kNameOutput, "name one with -o", kAll},
    {Remedy::kChooseWritablePlace, "choose a place you may write to with -o", kAll},
    {Remedy::kFreeSpace, "free some space, or choose another disk with -o", kAll},
    {Remedy::kMakeFolder, "make that folder, or choose another with -o", kAll},
    {Remedy::kCheckOutputDisk, "check the disk, or choose another place with -o", kAll},
    {Remedy::kChooseFolder, "choose another folder with -o, or write there with --force", kWritten},
    {Remedy::kAwaitSolve, "wait for its end, or choose another folder with -o", kWritten},
    {Remedy::kClearPlace, "remove it, or choose another place with -o", kAll},
    {Remedy::kTakeLargerTets, "take larger tets with --size or --edges", kTets},
    {Remedy::kTakeLargerTets, "take larger tets with --tet-size", kFolders},
    {Remedy::kGiveTetSize, "try --size {}", kTets},
    {Remedy::kGiveTetSize, "try --tet-size {}", kFolders},
    {Remedy::kGiveCellSize, "try --cell-size {}", kSolve},
    {Remedy::kUseCreaseAngle, "follow such edges with --crease-angle {}", kModels},
    {Remedy::kGiveHexSize, "try --size {}", kHex},
    {Remedy::kUseHexSize, "try --size {}", kHex},
    {Remedy::kTakeLargerHexahedra, "raise --size, or lower --cells", kHex},
    {Remedy::kUseHexSize, "give hexahedra of {} as MESH", kFit},
    {Remedy::kTakeFewerHexahedra, "raise --size, or allow more memory with --max-memory", kHex},
    {Remedy::kAllowTetTime, "take larger tets with --size or --edges, or allow more time with --seconds",
     kTets},
    {Remedy::kAllowTetTime,
     "take larger tets with --tet-size, or allow more time with 'crossgrain tets --seconds'", kFolders},
    {Remedy::kChangeTetSize, "take another --size, or the other program with --by", kTets},
    {Remedy::kChangeTetSize, "take another size with --tet-size", kFolders},
    {Remedy::kUseEdgeLength, "try --tet-size {}", kHex},
    {Remedy::kUseResolution, "use --resolution {}", kSolve},
    {Remedy::kUseResolution, "solve with --resolution {}", kOther},
};

/// Returns whether the system starts no more threads, for which oneTBB has no exception of its own.
bool has_no_threads_left() {
  try {
    std::thread([] {}).join();
    return false;
  } catch (const std::system_error&) {
    return true;
  }
}

}  // namespace

int exit_code_of(ErrorKind kind) {
  switch (kind) {
    case ErrorKind::kUsage:
      return 2;
    case ErrorKind::kInput:
      return 3;
    case ErrorKind::kOutput:
      return 4;
    case ErrorKind::kLimit:
      return 5;
    case ErrorKind::kInterrupted:
      return 130;
  }
  return 1;
}

std::string words_of(Remedy remedy, double number, Command command) {
  const auto found = std::find_if(
      std::begin(kOptionWords), std::end(kOptionWords),
      [&](const OptionWords& row) { return row.remedy == remedy && (row.commands & bit(command)) != 0; });
  if (found == std::end(kOptionWords)) return words_of(remedy, number);
  if (!has_number(remedy)) return found->words;
  return fmt::format(fmt::runtime(found->words), fmt::format("{:.6g}", number));
}

std::string line_of(const Message& message, Command command) {
  return sentence_of(message, words_of(message.remedy, message.remedy_number, command));
}

Failure failure_of(const std::exception_ptr& exception, const std::string& subject, Command command) {
  constexpr int kInternalError = 1;
  const std::string begin = subject.empty() ? "" : subject + ": ";
  try {
    std::rethrow_exception(exception);
  } catch (const Error& error) {
    return {exit_code_of(error.kind()), line_of(error.message(), command)};
  } catch (const std::bad_alloc&) {
    const Remedy remedy = (kFolders & bit(command)) != 0 ? Remedy::kUseLessMemory
                          : command == Command::kTets    ? Remedy::kTakeLargerTets
                                                         : Remedy::kFreeMemory;
    return {exit_code_of(ErrorKind::kLimit), begin + line_of({"", "", "out of memory", remedy}, command)};
  } catch (const std::exception& error) {
    if (!has_no_threads_left())
      return {kInternalError, begin + "unexpected: " + error.what() + "; please report this with the input"};
    return {exit_code_of(ErrorKind::kLimit), begin +
                                                 "the system starts no more threads; end some processes, or "
                                                 "raise their limit (ulimit -u) or that of "
                                                 "memory (ulimit -v)"};
  } catch (...) {
    return {kInternalError, begin + "unexpected; please report this"};
  }
}

}  // namespace crossgrain::app

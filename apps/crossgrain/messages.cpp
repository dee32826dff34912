// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <algorithm>
#include <iterator>
#include <new>
#include <system_error>
#include <thread>

namespace crossgrain::app {
namespace {

enum class For { kAll, kSolve, kTets, kSolveAndTets };

struct OptionWords {
  Remedy remedy;
  const char* words;
  For commands;
};

bool is_for(For commands, Command command) {
  switch (commands) {
    case For::kAll:
      return true;
    case For::kSolve:
      return command == Command::kSolve;
    case For::kTets:
      return command == Command::kTets;
    case For::kSolveAndTets:
      return command == Command::kSolve || command == Command::kTets;
  }
  return false;
}

constexpr OptionWords kOptionWords[] = {
    {Remedy::kRaiseResolution, "raise --resolution, or lower --cell-size", For::kSolve},
    {Remedy::kLowerResolution, "lower --resolution, or raise --cell-size", For::kSolve},
    {Remedy::kUseLessMemory, "lower --resolution, raise --cell-size or allow more memory with --max-memory",
     For::kSolve},
    {Remedy::kAllowMemory, "allow more memory with --max-memory", For::kSolveAndTets},
    {Remedy::kSimplifyOrAllowMemory, "simplify it, or allow more memory with --max-memory",
     For::kSolveAndTets},
    {Remedy::kAllowReadTime, "repair it and export it again, or allow more time with --read-seconds",
     For::kSolveAndTets},
    {Remedy::kContinueSolve, "a solve with --from goes on from here", For::kSolve},
    {Remedy::kSolveAnew, "solve without --restart", For::kSolve},
    {Remedy::kGiveCheckpoint, "name the folder of --checkpoint", For::kSolve},
    {Remedy::kMoveCheckpoint,
     "free some space, or choose another disk with --checkpoint; what it held is kept", For::kSolve},
    {Remedy::kKeepTags, "--keep-tags follows them all the same", For::kSolve},
    {Remedy::kTurnView, "choose another --view or --cut", For::kAll},
    {Remedy::kGiveFieldFolder, "give a folder that 'crossgrain solve' has written", For::kAll},
    {Remedy::kTraceStreamlines, "trace lines with 'crossgrain streamlines'", For::kAll},
    {Remedy::kMakeHexahedra, "make them with 'crossgrain hex'", For::kAll},
    {Remedy::kNameOutput, "name one with -o", For::kAll},
    {Remedy::kChooseWritablePlace, "choose a place you may write to with -o", For::kAll},
    {Remedy::kFreeSpace, "free some space, or choose another disk with -o", For::kAll},
    {Remedy::kMakeFolder, "make that folder, or choose another with -o", For::kAll},
    {Remedy::kCheckOutputDisk, "check the disk, or choose another place with -o", For::kAll},
    {Remedy::kChooseFolder, "choose another folder with -o, or write there with --force", For::kSolve},
    {Remedy::kAwaitSolve, "wait for its end, or choose another folder with -o", For::kSolve},
    {Remedy::kClearPlace, "remove it, or choose another place with -o", For::kAll},
    {Remedy::kTakeLargerTets, "take larger tets with --size or --edges", For::kTets},
    {Remedy::kTakeLargerTets, "take larger tets with --tet-size", For::kSolve},
    {Remedy::kGiveTetSize, "set --size", For::kTets},
    {Remedy::kGiveTetSize, "set --tet-size", For::kSolve},
    {Remedy::kGiveCellSize, "set --cell-size", For::kSolve},
    {Remedy::kGiveHexSize, "set --size", For::kSolve},
    {Remedy::kTakeLargerHexahedra, "raise --size, or lower --cells", For::kSolve},
    {Remedy::kTakeSmallerHexahedra, "lower --size, or raise --cells", For::kSolve},
    {Remedy::kAllowTetTime, "take larger tets with --size or --edges, or allow more time with --seconds",
     For::kTets},
    {Remedy::kAllowTetTime,
     "take larger tets with --tet-size, or allow more time with 'crossgrain tets --seconds'", For::kSolve},
    {Remedy::kChangeTetSize, "take another --size, or the other program with --by", For::kTets},
    {Remedy::kTakeSmallerHexahedra, "take smaller hexahedra with --size or --cells", For::kSolve},
    {Remedy::kChangeTetSize, "take another size with --tet-size", For::kSolve},
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

std::string line_of(const Message& message, Command command) {
  const auto found = std::find_if(
      std::begin(kOptionWords), std::end(kOptionWords),
      [&](const OptionWords& row) { return row.remedy == message.remedy && is_for(row.commands, command); });
  return sentence_of(message, found == std::end(kOptionWords) ? words_of(message.remedy) : found->words);
}

Failure failure_of(const std::exception_ptr& exception, const std::string& subject, Command command) {
  constexpr int kInternalError = 1;
  const std::string begin = subject.empty() ? "" : subject + ": ";
  try {
    std::rethrow_exception(exception);
  } catch (const Error& error) {
    return {exit_code_of(error.kind()), line_of(error.message(), command)};
  } catch (const std::bad_alloc&) {
    const Remedy remedy = command == Command::kSolve  ? Remedy::kUseLessMemory
                          : command == Command::kTets ? Remedy::kTakeLargerTets
                                                      : Remedy::kFreeMemory;
    return {exit_code_of(ErrorKind::kLimit), begin + line_of({"", "", "out of memory", remedy}, command)};
  } catch (const std::exception& error) {
    if (!has_no_threads_left())
      return {kInternalError, begin + "unexpected: " + error.what() + "; please report this with the input"};
    return {
        exit_code_of(ErrorKind::kLimit),
        begin + "the system starts no more threads; end some processes, or raise their limit (ulimit -u)"};
  } catch (...) {
    return {kInternalError, begin + "unexpected; please report this"};
  }
}

}  // namespace crossgrain::app

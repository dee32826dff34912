// SPDX-License-Identifier: Apache-2.0
#include "messages.hpp"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <thread>

namespace crossgrain::app {
namespace {

struct OptionWords {
  Remedy remedy;
  const char* words;
  bool is_for_all_commands;
};

constexpr OptionWords kOptionWords[] = {
    {Remedy::kRaiseResolution, "raise --resolution, or lower --cell-size", false},
    {Remedy::kLowerResolution, "lower --resolution, or raise --cell-size", false},
    {Remedy::kUseLessMemory, "lower --resolution, raise --cell-size or allow more memory with --max-memory",
     false},
    {Remedy::kAllowMemory, "allow more memory with --max-memory", false},
    {Remedy::kSimplifyOrAllowMemory, "simplify it, or allow more memory with --max-memory", false},
    {Remedy::kAllowReadTime, "repair it and export it again, or allow more time with --read-seconds", false},
    {Remedy::kContinueSolve, "a solve with --from goes on from here", false},
    {Remedy::kSolveAnew, "solve without --restart", false},
    {Remedy::kGiveCheckpoint, "name the folder of --checkpoint", false},
    {Remedy::kMoveCheckpoint,
     "free some space, or choose another disk with --checkpoint; what it held is kept", false},
    {Remedy::kKeepTags, "--keep-tags follows them all the same", false},
    {Remedy::kTurnView, "choose another --view or --cut", true},
    {Remedy::kGiveFieldFolder, "give a folder that 'crossgrain solve' has written", true},
    {Remedy::kTraceStreamlines, "trace lines with 'crossgrain streamlines'", true},
    {Remedy::kNameOutput, "name one with -o", true},
    {Remedy::kChooseWritablePlace, "choose a place you may write to with -o", true},
    {Remedy::kFreeSpace, "free some space, or choose another disk with -o", true},
    {Remedy::kMakeFolder, "make that folder, or choose another with -o", true},
    {Remedy::kCheckOutputDisk, "check the disk, or choose another place with -o", true},
    {Remedy::kChooseFolder, "choose another folder with -o, or write there with --force", false},
    {Remedy::kAwaitSolve, "wait for its end, or choose another folder with -o", false},
    {Remedy::kClearPlace, "remove it, or choose another place with -o", true},
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

Unexpected unexpected_of(const std::exception& exception) {
  if (has_no_threads_left())
    return {exit_code_of(ErrorKind::kLimit),
            "the system starts no more threads; end some processes, or raise their limit (ulimit -u)"};
  return {kInternalError,
          std::string("unexpected: ") + exception.what() + "; please report this with the input"};
}

std::string line_of(const Message& message, Command command) {
  const auto found =
      std::find_if(std::begin(kOptionWords), std::end(kOptionWords), [&](const OptionWords& row) {
        return row.remedy == message.remedy && (row.is_for_all_commands || command == Command::kSolve);
      });
  return sentence_of(message, found == std::end(kOptionWords) ? words_of(message.remedy) : found->words);
}

}  // namespace crossgrain::app

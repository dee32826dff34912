// SPDX-License-Identifier: Apache-2.0
#include "files/new_folders.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "crossgrain/error.hpp"
#include "files/folder_calls.hpp"

namespace crossgrain {
namespace {

// The user's umask is subtracted.
constexpr mode_t kFolderMode = 0777;

/// Another process may remove folders on the way while they are created; each attempt fails only if that
/// happens again.
constexpr int kMakeAttempts = 20;

}  // namespace

NewFolders::NewFolders(const std::filesystem::path& folder) {
  try {
    for (int attempt = 0; attempt < kMakeAttempts; ++attempt)
      if (make(folder)) return;
    fail_output(folder.string(), "created", ENOENT);
  } catch (...) {
    remove();
    throw;
  }
}

bool NewFolders::make(const std::filesystem::path& folder) {
  std::filesystem::path reached;
  for (const std::filesystem::path& step : folder) {
    reached /= step;
    if (::mkdir(reached.c_str(), kFolderMode) == 0) {
      made_.push_back(reached);
      continue;
    }
    const int code = errno;
    struct stat status {};
    if (::stat(reached.c_str(), &status) != 0) {
      if (errno == ENOENT && ::lstat(reached.c_str(), &status) == 0)
        throw Error(ErrorKind::kOutput, {reached.string(), "", "is a link to nothing", Remedy::kClearPlace});
      if (code == EEXIST || code == ENOENT) return false;
      fail_output(reached.string(), "created", code);
    }
    if (!S_ISDIR(status.st_mode))
      throw Error(ErrorKind::kOutput,
                  {reached.string(), "", "is a file, but must be a folder", Remedy::kClearPlace});
  }
  return true;
}

void NewFolders::remove() noexcept {
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) ::rmdir(folder->c_str());
  made_.clear();
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "files/folder_calls.hpp"

#include <dirent.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <system_error>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

constexpr int kOpenFolder = O_RDONLY | O_DIRECTORY | O_CLOEXEC;

Remedy remedy_for(int code) {
  switch (code) {
    case EACCES:
    case EPERM:
    case EROFS:
      return Remedy::kChooseWritablePlace;
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return Remedy::kFreeSpace;
    case ENOENT:
    case ENOTDIR:
      return Remedy::kMakeFolder;
    default:
      return Remedy::kCheckOutputDisk;
  }
}

}  // namespace

void fail_output(const std::string& name, const std::string& doing, int code) {
  throw Error(ErrorKind::kOutput,
              {name, "", fmt::format("cannot be {}: {}", doing, std::generic_category().message(code)),
               remedy_for(code)});
}

Descriptor open_folder(const std::filesystem::path& path) {
  return Descriptor(::open(path.empty() ? "." : path.c_str(), kOpenFolder));
}

Descriptor open_folder_in(int folder, const std::string& name) {
  return Descriptor(::openat(folder, name.c_str(), kOpenFolder | O_NOFOLLOW));
}

struct stat status_in(int folder, const std::string& name) {
  struct stat status {};
  if (::fstatat(folder, name.c_str(), &status, AT_SYMLINK_NOFOLLOW) != 0) return {};
  return status;
}

bool is_same_file(const struct stat& a, const struct stat& b) {
  return a.st_mode != 0 && b.st_mode != 0 && a.st_dev == b.st_dev && a.st_ino == b.st_ino;
}

std::vector<std::string> names_in(int folder, const std::string& shown) {
  // Opened anew, since listing moves a position that descriptors share.
  Descriptor again = open_folder_in(folder, ".");
  if (!again.is_open()) fail_output(shown, "listed", errno);
  const std::unique_ptr<DIR, int (*)(DIR*)> list(::fdopendir(again.number()), ::closedir);
  if (!list) fail_output(shown, "listed", errno);
  again.release();
  std::vector<std::string> names;
  for (;;) {
    errno = 0;
    const dirent* const entry = ::readdir(list.get());
    if (entry == nullptr) break;
    const std::string name = entry->d_name;
    if (name != "." && name != "..") names.push_back(name);
  }
  if (errno != 0) fail_output(shown, "listed", errno);
  std::sort(names.begin(), names.end());
  return names;
}

bool sync_folder(int folder) {
  return ::fsync(folder) == 0 || errno == EINVAL || errno == ENOTSUP;
}

bool try_lock(int folder) {
  while (::flock(folder, LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return false;
    if (errno != EINTR) break;
  }
  return true;
}

}  // namespace crossgrain

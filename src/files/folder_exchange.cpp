// SPDX-License-Identifier: Apache-2.0
#include "files/folder_exchange.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <sys/xattr.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <system_error>
#include <utility>

#include "crossgrain/error.hpp"
#include "files/folder_calls.hpp"
#include "files/output_file.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;

constexpr mode_t kPermissions = 07777;

/// Returns whether a folder has access lists or other attributes. Those of security modules come with the
/// place.
bool has_attributes(int folder) {
  std::string names(1 << 16, '\0');
  const ssize_t size = ::flistxattr(folder, names.data(), names.size());
  names.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  for (std::size_t begin = 0; begin < names.size(); begin = names.find('\0', begin) + 1)
    if (!std::string_view(names).substr(begin).starts_with("security.")) return true;
  return false;
}

bool is_mount_point(int parent, int folder) {
#ifdef STATX_ATTR_MOUNT_ROOT
  struct statx status {};
  if (::statx(folder, "", AT_EMPTY_PATH, STATX_BASIC_STATS, &status) == 0 &&
      (status.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0)
    return true;
#endif
  struct stat above {
  }, itself{};
  return ::fstat(parent, &above) != 0 || ::fstat(folder, &itself) != 0 || above.st_dev != itself.st_dev;
}

bool holds_current_folder(const fs::path& path) {
  std::error_code unknown;
  const fs::path current = fs::current_path(unknown);
  return !unknown &&
         std::mismatch(path.begin(), path.end(), current.begin(), current.end()).first == path.end();
}

bool exchange(const FolderEntry& a, const FolderEntry& b) {
#ifdef RENAME_EXCHANGE
  return ::renameat2(a.parent, a.name.c_str(), b.parent, b.name.c_str(), RENAME_EXCHANGE) == 0;
#else
  errno = ENOSYS;
  return false;
#endif
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// Names in a folder that the new one is to keep; nothing if a link cannot keep one of them.
std::vector<std::string> kept_names(int folder, const std::vector<std::string>& replaced,
                                    const std::string& shown, bool& has_folders) {
  std::vector<std::string> kept;
  for (std::string& name : names_in(folder, shown)) {
    has_folders = has_folders || S_ISDIR(status_in(folder, name).st_mode);
    if (!contains(replaced, name)) kept.push_back(std::move(name));
  }
  return kept;
}

/// Returns whether a file of the old folder is missing in the new one, or is another one there that was
/// changed earlier.
bool is_later(const struct stat& here, const struct stat& there) {
  if (there.st_mode == 0) return true;
  const auto time_of = [](const struct stat& status) {
    return std::pair(status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
  };
  return !is_same_file(here, there) && time_of(there) < time_of(here);
}

/// Links are made for these names in turn, and removed again unless they are to stay.
class Links {
 public:
  Links(int from, int to) : from_(from), to_(to) {}
  ~Links() {
    for (const std::string& name : made_) ::unlinkat(to_, name.c_str(), 0);
  }
  Links(const Links&) = delete;
  Links& operator=(const Links&) = delete;

  bool make(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      if (::linkat(from_, name.c_str(), to_, name.c_str(), 0) != 0) return false;
      made_.push_back(name);
    }
    return true;
  }
  void keep() { made_.clear(); }

 private:
  int from_, to_;
  std::vector<std::string> made_;
};

}  // namespace

bool may_be_exchanged(int parent, int folder, const fs::path& path) {
  return !is_mount_point(parent, folder) && !has_attributes(folder) && !holds_current_folder(path);
}

bool take_permissions(int new_folder, int old_folder) {
  struct stat old_status {
  }, new_status{};
  if (::fstat(old_folder, &old_status) != 0 || ::fstat(new_folder, &new_status) != 0) return false;
  const bool has_owner = old_status.st_uid == new_status.st_uid && old_status.st_gid == new_status.st_gid;
  if (!has_owner && ::fchown(new_folder, old_status.st_uid, old_status.st_gid) != 0) return false;
  return ::fchmod(new_folder, old_status.st_mode & kPermissions) == 0;
}

bool exchange_folders(const FolderEntry& old_entry, int old_folder, const FolderEntry& new_entry,
                      int new_folder, const std::vector<std::string>& replaced, const std::string& shown) {
  bool has_folders = false;
  const std::vector<std::string> kept = kept_names(old_folder, replaced, shown, has_folders);
  Links links(old_folder, new_folder);
  if (has_folders || !links.make(kept)) return false;
  if (!sync_folder(new_folder)) fail_output(shown, "put in place", errno);
  if (!exchange(new_entry, old_entry)) return false;
  if (!sync_folder(old_entry.parent)) {
    const int code = errno;
    // If this fails too, the links must stay.
    if (!exchange(new_entry, old_entry)) links.keep();
    fail_output(shown, "put in place", code);
  }
  links.keep();
  return true;
}

void retire_folder(const FolderEntry& old_entry, int old_folder, int new_folder,
                   const std::vector<std::string>& replaced) {
  std::vector<std::string> names;
  try {
    names = names_in(old_folder, old_entry.name);
  } catch (const Error&) {
    return;
  }
  for (const std::string& name : names) {
    const struct stat here = status_in(old_folder, name), there = status_in(new_folder, name);
    if (here.st_mode == 0) continue;
    if (contains(replaced, name) || is_temporary_name(name) || !is_later(here, there))
      ::unlinkat(old_folder, name.c_str(), 0);
    else
      ::renameat(old_folder, name.c_str(), new_folder, name.c_str());
  }
  ::unlinkat(old_entry.parent, old_entry.name.c_str(), AT_REMOVEDIR);
}

bool remove_unfinished(const FolderEntry& entry, int folder) {
  try {
    for (const std::string& name : names_in(folder, entry.name)) ::unlinkat(folder, name.c_str(), 0);
  } catch (const Error&) {
    return false;
  }
  return ::unlinkat(entry.parent, entry.name.c_str(), AT_REMOVEDIR) == 0;
}

}  // namespace crossgrain

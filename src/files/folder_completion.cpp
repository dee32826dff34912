// SPDX-License-Identifier: Apache-2.0
#include "files/folder_completion.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "files/descriptor.hpp"
#include "files/folder_calls.hpp"
#include "files/replaced_names.hpp"

namespace crossgrain {
namespace {

/// Moves all files but the list.
void move_files(int from, int to, const std::string& shown) {
  for (const std::string& name : names_in(from, shown)) {
    if (name == kReplacedNames) continue;
    // A rename to a link of the same file does nothing; an exchange that failed may have left one.
    const bool is_there = is_same_file(status_in(from, name), status_in(to, name));
    const int result =
        is_there ? ::unlinkat(from, name.c_str(), 0) : ::renameat(from, name.c_str(), to, name.c_str());
    if (result != 0) fail_output(shown + "/" + name, "put in place", errno);
  }
}

void remove_files(int folder, const std::vector<std::string>& names, const std::string& shown) {
  for (const std::string& name : names)
    if (::unlinkat(folder, name.c_str(), 0) != 0 && errno != ENOENT && errno != EISDIR)
      fail_output(shown + "/" + name, "removed", errno);
}

}  // namespace

bool has_incomplete_files(int folder) {
  const mode_t mode = status_in(folder, kCompleteFiles).st_mode;
  // If the system does not tell, completing them does.
  return S_ISDIR(mode) || (mode == 0 && errno != ENOENT);
}

void put_files_in_place(const FolderEntry& new_entry, int folder, const std::string& shown) {
  if (::renameat(new_entry.parent, new_entry.name.c_str(), folder, kCompleteFiles) != 0)
    fail_output(shown, "put in place", errno);
  if (!sync_folder(folder)) {
    const int code = errno;
    ::renameat(folder, kCompleteFiles, new_entry.parent, new_entry.name.c_str());
    fail_output(shown, "put in place", code);
  }
  complete_files(folder, shown);
}

void complete_files(int folder, const std::string& shown) {
  const Descriptor complete = open_folder_in(folder, kCompleteFiles);
  if (!complete.is_open() && errno == ENOENT) return;
  if (!complete.is_open()) fail_output(shown, "put in place", errno);
  // The names outlive the files in the list, so that removing can begin again at any point.
  const std::vector<std::string> outdated = read_replaced_names(complete.number(), shown);
  move_files(complete.number(), folder, shown);
  remove_files(folder, outdated, shown);
  if (!sync_folder(folder)) fail_output(shown, "put in place", errno);
  remove_replaced_names(complete.number());
  ::unlinkat(folder, kCompleteFiles, AT_REMOVEDIR);
}

}  // namespace crossgrain

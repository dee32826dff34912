// SPDX-License-Identifier: Apache-2.0
// Replaces a whole folder by a new one beside it, in one call of the system (renameat2 with RENAME_EXCHANGE):
// whoever opens it, at any moment, sees all of the old one or all of the new one.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace crossgrain {

/// A name in a folder.
struct FolderEntry {
  int parent;
  std::string name;
};

/// Returns whether the folder at an absolute path is one that a new folder can stand for: no mount point,
/// without access lists, and not the current folder, which would be a removed one afterwards.
bool may_be_exchanged(int parent, int folder, const std::filesystem::path& path);

/// Gives a new folder the owner and permissions of the old one. Returns false if that is not allowed.
bool take_permissions(int new_folder, int old_folder);

/// Exchanges the folder `old_entry`, open as `old_folder`, with `new_entry`, open as `new_folder`. The new
/// one gets links to what else is in the old one, all but the `replaced` names. Returns false, with nothing
/// changed, if there are folders in it or the file system cannot do it. Throws Error(kOutput), naming the
/// folder `shown`, with the old one in place.
bool exchange_folders(const FolderEntry& old_entry, int old_folder, const FolderEntry& new_entry,
                      int new_folder, const std::vector<std::string>& replaced, const std::string& shown);

/// Removes an old folder after an exchange: its `replaced` names, sorted, and links that the new one has too.
/// Moves to the new one what was put into it too late to be linked. What cannot be removed stays for the next
/// run.
void retire_folder(const FolderEntry& old_entry, int old_folder, int new_folder,
                   const std::vector<std::string>& replaced);

/// Removes a folder of files that was not finished. Returns false, with errno set, if that fails.
bool remove_unfinished(const FolderEntry& entry, int folder);

}  // namespace crossgrain

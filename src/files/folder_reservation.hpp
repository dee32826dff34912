// SPDX-License-Identifier: Apache-2.0
// The right to replace the files of a folder, and the place where new ones are written (docs/design.md,
// section 9).
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "files/descriptor.hpp"
#include "files/folder_exchange.hpp"
#include "files/new_folders.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// While an object lives, no other one gets the same folder, in this process or another on this machine. The
/// lock ends with the process.
class FolderReservation {
 public:
  /// Reserves a folder, which need not exist; its missing parents are created. Finishes or removes what an
  /// earlier process has left of its work. Throws Error(kOutput), with the folder as it was: it cannot be
  /// written to, or is reserved.
  explicit FolderReservation(const std::filesystem::path& folder);

  /// Removes what was written but not published, and folders that were created for it.
  ~FolderReservation();
  FolderReservation(const FolderReservation&) = delete;
  FolderReservation& operator=(const FolderReservation&) = delete;

  /// The folder as it was given.
  const std::string& name() const { return shown_; }

  /// Throws Error(kOutput) if a file of such a name cannot be put into the folder.
  void check_names(const std::vector<std::string>& names) const;

  /// Returns `is_so()`, or true if that was true of this file before and nobody has touched the file since.
  bool is_still_so(const std::string& name, const std::function<bool()>& is_so);

  /// Returns the absolute path of the folder of files that are not published, and makes it if there is none.
  std::filesystem::path staging_place();

  /// Creates a file, which appears in the folder when it is published.
  std::unique_ptr<OutputFile> create(const std::string& name);

  /// Replaces the files of the folder: those created (`names`), finished, take the place of earlier ones
  /// of the same names, and the `outdated` ones, unless they are folders, go. All happens at once or, where
  /// that cannot be, so that an interrupted replacement is noticed and finished by the next reader or writer.
  /// Throws Error(kOutput).
  void publish(const std::vector<std::string>& names, const std::vector<std::string>& outdated);

  /// Removes files that were created and are not published.
  void discard(const std::vector<std::string>& names) noexcept;

 private:
  bool open_if_there();
  bool open_parent();
  void clear_leftovers();
  void clear_leftover(const FolderEntry& entry);
  bool make_staging();
  void require_staging();
  bool stage_inside();
  bool publish_new();
  void publish_over(const std::vector<std::string>& names, const std::vector<std::string>& outdated);
  FolderEntry entry() const { return {parent_.number(), path_.filename().string()}; }
  FolderEntry entry_beside() const;
  FolderEntry entry_inside() const;
  FolderEntry staging_entry() const { return is_beside_ ? entry_beside() : entry_inside(); }
  std::string shown_of(const std::string& name) const { return std::filesystem::path(shown_) / name; }
  [[noreturn]] void refuse_busy() const;

  std::string shown_;
  std::filesystem::path path_;  ///< absolute, behind all links
  std::optional<NewFolders> made_;
  Descriptor parent_;
  Descriptor folder_;  ///< locked; not open while there is none
  bool is_beside_ = true;
  Descriptor staging_;  ///< locked; not open once it is published
  int staging_error_ = 0;
  std::map<std::string, struct stat> looked_at_;  ///< what was known of files when `is_so()` was true
};

/// Finishes what an interrupted replacement of files in a folder has left to do; waits a little for one in
/// progress. Does nothing if there is none, also if there is no such folder. Throws Error(kInput) if it
/// cannot be finished.
void complete_folder(const std::filesystem::path& folder);

/// Returns whether a file or folder has a name for work in progress, which a killed process may leave.
bool is_name_of_unfinished_work(const std::string& name);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "files/folder_reservation.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "crossgrain/error.hpp"
#include "files/folder_calls.hpp"
#include "files/folder_completion.hpp"
#include "files/replaced_names.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kPart = ".crossgrain-part";

/// Folders come and go while others reserve them; each attempt fails only if that happens again.
constexpr int kAttempts = 20;

/// Longest name that leaves room for the rest of a name of 255 bytes.
constexpr std::size_t kLongestName = 255 - 1 - kPart.size();

// The user's umask is subtracted. Over an earlier folder nobody else may look until its permissions are
// known.
constexpr mode_t kNewMode = 0777, kPrivateMode = 0700;

fs::path without_trailing_slash(const fs::path& path) {
  return path.has_filename() || !path.has_relative_path() ? path : path.parent_path();
}

fs::path resolved(const fs::path& folder) {
  std::error_code failure;
  const fs::path absolute = fs::absolute(without_trailing_slash(folder), failure);
  const fs::path path = fs::weakly_canonical(absolute, failure);
  return failure ? absolute : path;
}

bool is_untouched(const struct stat& before, const struct stat& now) {
  const auto same = [](const timespec& a, const timespec& b) {
    return a.tv_sec == b.tv_sec && a.tv_nsec == b.tv_nsec;
  };
  return is_same_file(before, now) && before.st_size == now.st_size && same(before.st_mtim, now.st_mtim) &&
         same(before.st_ctim, now.st_ctim);
}

bool is_at(const FolderEntry& entry, const Descriptor& folder) {
  struct stat status {};
  return folder.is_open() && ::fstat(folder.number(), &status) == 0 &&
         is_same_file(status, status_in(entry.parent, entry.name));
}

}  // namespace

FolderReservation::FolderReservation(const fs::path& folder)
    : shown_(folder.string()), path_(resolved(folder)) {
  if (folder.empty())
    throw Error(ErrorKind::kOutput, {"''", "", "names no folder to write into", Remedy::kNameOutput});
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    if (!open_if_there()) made_.emplace(without_trailing_slash(folder).parent_path());
    if (!open_parent()) continue;
    clear_leftovers();
    is_beside_ = !folder_.is_open() || (parent_.is_open() && path_.has_filename() &&
                                        may_be_exchanged(parent_.number(), folder_.number(), path_));
    if (make_staging()) return;
  }
  // In a folder like /proc names can be made by nobody.
  if (staging_error_ == ENOENT) fail_output(shown_, "created", ENOENT);
  refuse_busy();
}

FolderReservation::~FolderReservation() {
  // If an exchange could not be undone, something else has this name.
  if (is_at(staging_entry(), staging_)) remove_unfinished(staging_entry(), staging_.number());
}

FolderEntry FolderReservation::entry_beside() const {
  return {parent_.number(), fmt::format(".{}{}", path_.filename().string().substr(0, kLongestName), kPart)};
}

FolderEntry FolderReservation::entry_inside() const {
  return {folder_.number(), std::string(kPart)};
}

void FolderReservation::refuse_busy() const {
  throw Error(ErrorKind::kOutput, {shown_, "", "another solve is writing to it", Remedy::kAwaitSolve});
}

bool FolderReservation::open_if_there() {
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    folder_ = Descriptor();
    struct stat status {};
    if (::lstat(path_.c_str(), &status) != 0) {
      if (errno == ENOENT || errno == ENOTDIR) return false;
      fail_output(shown_, "opened", errno);
    }
    if (S_ISLNK(status.st_mode))
      throw Error(ErrorKind::kOutput, {shown_, "", "is a link to nothing", Remedy::kClearPlace});
    if (!S_ISDIR(status.st_mode))
      throw Error(ErrorKind::kOutput, {shown_, "", "is a file, but must be a folder", Remedy::kClearPlace});
    folder_ = open_folder(path_);
    if (!folder_.is_open() && errno != ENOENT) fail_output(shown_, "opened", errno);
    if (!folder_.is_open()) continue;
    // An exchange needs no permission for the folder itself, but who has withdrawn it means the files.
    if (::faccessat(folder_.number(), ".", W_OK | X_OK, AT_EACCESS) != 0)
      fail_output(shown_, "written", errno);
    if (!try_lock(folder_.number())) refuse_busy();
    // An exchange may have come between.
    if (is_at({AT_FDCWD, path_.string()}, folder_)) return true;
  }
  refuse_busy();
}

bool FolderReservation::open_parent() {
  parent_ = open_folder(path_.parent_path());
  if (parent_.is_open() || folder_.is_open()) return true;
  // Another solve that had created it may have given up and removed it.
  if (errno != ENOENT) fail_output(shown_, "created", errno);
  return false;
}

void FolderReservation::clear_leftovers() {
  if (parent_.is_open()) clear_leftover(entry_beside());
  if (!folder_.is_open()) return;
  clear_leftover(entry_inside());
  complete_files(folder_.number(), shown_);
  remove_replaced_names(folder_.number());
  if (has_replaced_names(folder_.number(), shown_)) fail_output(shown_, "written", EACCES);
}

void FolderReservation::clear_leftover(const FolderEntry& leftover) {
  const Descriptor old = open_folder_in(leftover.parent, leftover.name);
  if (!old.is_open()) return;
  if (!try_lock(old.number())) refuse_busy();
  if (!is_at(leftover, old)) return;
  // With the list only in the folder, an exchange was the last thing done.
  if (folder_.is_open() && has_replaced_names(folder_.number(), shown_) &&
      !has_replaced_names(old.number(), shown_))
    retire_folder(leftover, old.number(), folder_.number(), read_replaced_names(folder_.number(), shown_));
  else
    remove_unfinished(leftover, old.number());
  if (is_at(leftover, old)) fail_output((path_.parent_path() / leftover.name).string(), "removed", errno);
}

bool FolderReservation::stage_inside() {
  if (staging_.is_open()) remove_unfinished(staging_entry(), staging_.number());
  staging_ = Descriptor();
  is_beside_ = false;
  return make_staging();
}

bool FolderReservation::make_staging() {
  const FolderEntry place = staging_entry();
  const bool may_be_inside = is_beside_ && folder_.is_open();
  if (::mkdirat(place.parent, place.name.c_str(), folder_.is_open() ? kPrivateMode : kNewMode) != 0) {
    staging_error_ = errno;
    if (errno == EEXIST || (errno == ENOENT && !folder_.is_open())) return false;
    const bool is_forbidden = errno == EACCES || errno == EPERM || errno == EROFS;
    if (may_be_inside && is_forbidden) return stage_inside();
    fail_output(shown_, folder_.is_open() ? "written" : "created", errno);
  }
  staging_ = open_folder_in(place.parent, place.name);
  if (!staging_.is_open()) {
    const int code = errno;
    if (code == ENOENT) return false;  // another one took it for a leftover
    ::unlinkat(place.parent, place.name.c_str(), AT_REMOVEDIR);
    fail_output(shown_, "written", code);
  }
  if (!try_lock(staging_.number())) {
    staging_ = Descriptor();  // the other one removes it
    refuse_busy();
  }
  if (!is_at(place, staging_)) return false;
  const bool is_like_folder = !folder_.is_open() || take_permissions(staging_.number(), folder_.number());
  return is_like_folder || !may_be_inside || stage_inside();
}

void FolderReservation::check_names(const std::vector<std::string>& names) const {
  for (const std::string& name : names) {
    struct stat status {};
    if (!folder_.is_open() || ::fstatat(folder_.number(), name.c_str(), &status, 0) != 0) continue;
    if (!S_ISREG(status.st_mode))
      throw Error(ErrorKind::kOutput,
                  {shown_of(name), "",
                   S_ISDIR(status.st_mode) ? "is a folder, but must be a file" : "is not a regular file",
                   Remedy::kClearPlace});
    if (::faccessat(folder_.number(), name.c_str(), W_OK, AT_EACCESS) != 0)
      fail_output(shown_of(name), "written", errno);
  }
}

bool FolderReservation::is_still_so(const std::string& name, const std::function<bool()>& is_so) {
  struct stat now {};
  // Behind links, as the content is.
  const bool is_known = folder_.is_open() && ::fstatat(folder_.number(), name.c_str(), &now, 0) == 0;
  const auto before = looked_at_.find(name);
  if (is_known && before != looked_at_.end() && is_untouched(before->second, now)) return true;
  if (!is_so()) return false;
  if (is_known) looked_at_[name] = now;
  return true;
}

void FolderReservation::require_staging() {
  if (!staging_.is_open() && !make_staging()) refuse_busy();
}

fs::path FolderReservation::staging_place() {
  require_staging();
  return (is_beside_ ? path_.parent_path() : path_) / staging_entry().name;
}

std::unique_ptr<OutputFile> FolderReservation::create(const std::string& name) {
  check_names({name});
  require_staging();
  return std::make_unique<OutputFile>(staging_.number(), name, shown_of(name));
}

void FolderReservation::discard(const std::vector<std::string>& names) noexcept {
  // Not where they are complete and will be put in place.
  if (!is_at(staging_entry(), staging_)) return;
  for (const std::string& name : names) ::unlinkat(staging_.number(), name.c_str(), 0);
}

void FolderReservation::publish(const std::vector<std::string>& names,
                                const std::vector<std::string>& outdated) {
  if (!staging_.is_open()) return;
  if (!sync_folder(staging_.number())) fail_output(shown_, "written", errno);
  if (!folder_.is_open() && publish_new()) return;
  publish_over(names, outdated);
}

/// Returns false, with the folder open, if somebody has made it meanwhile.
bool FolderReservation::publish_new() {
  const FolderEntry from = staging_entry(), to = entry();
  if (::renameat(from.parent, from.name.c_str(), to.parent, to.name.c_str()) != 0) {
    const int code = errno;
    if ((code == EEXIST || code == ENOTEMPTY || code == ENOTDIR) && open_if_there()) return false;
    fail_output(shown_, "put in place", code);
  }
  if (!sync_folder(parent_.number())) {
    const int code = errno;
    ::renameat(to.parent, to.name.c_str(), from.parent, from.name.c_str());
    fail_output(shown_, "put in place", code);
  }
  folder_ = std::exchange(staging_, Descriptor());
  if (made_) made_->keep();
  return true;
}

void FolderReservation::publish_over(const std::vector<std::string>& names,
                                     const std::vector<std::string>& outdated) {
  if (is_beside_) {
    std::vector<std::string> replaced = names;
    replaced.insert(replaced.end(), outdated.begin(), outdated.end());
    replaced.emplace_back(kReplacedNames);
    write_replaced_names(staging_.number(), replaced, shown_);
    if (exchange_folders(entry(), folder_.number(), staging_entry(), staging_.number(), replaced, shown_)) {
      std::swap(folder_, staging_);
      retire_folder(staging_entry(), staging_.number(), folder_.number(), replaced);
      if (!is_at(staging_entry(), staging_)) remove_replaced_names(folder_.number());
      staging_ = Descriptor();
      return;
    }
  }
  write_replaced_names(staging_.number(), outdated, shown_);
  if (!sync_folder(staging_.number())) fail_output(shown_, "written", errno);
  put_files_in_place(staging_entry(), folder_.number(), shown_);
  staging_ = Descriptor();
}

void complete_folder(const fs::path& folder) {
  // As long as it takes to rename some files on a slow disk.
  constexpr std::chrono::milliseconds kPatience{5000}, kPause{20};
  const Descriptor opened = open_folder(folder);
  if (!opened.is_open()) return;
  const auto begin = std::chrono::steady_clock::now();
  while (has_incomplete_files(opened.number())) {
    if (try_lock(opened.number())) {
      try {
        return complete_files(opened.number(), folder.string());
      } catch (const Error& error) {
        throw Error(ErrorKind::kInput,
                    {folder.string(), "",
                     "holds a result that an interrupted solve has not put in place, and " + error.file() +
                         " " + error.message().text,
                     Remedy::kSolveAgain});
      }
    }
    if (std::chrono::steady_clock::now() - begin > kPatience)
      throw Error(ErrorKind::kInput, {folder.string(), "", "a solve is writing to it", Remedy::kAwaitSolve});
    std::this_thread::sleep_for(kPause);
  }
}

bool is_name_of_unfinished_work(const std::string& name) {
  return is_temporary_name(name) || name == kReplacedNames || name == kCompleteFiles ||
         (name.starts_with('.') && name.ends_with(kPart));
}

}  // namespace crossgrain

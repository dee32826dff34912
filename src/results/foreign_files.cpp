// SPDX-License-Identifier: Apache-2.0
#include "results/foreign_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <vector>

#include "crossgrain/error.hpp"
#include "files/file_mark.hpp"
#include "files/file_seal.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "results/field_pieces.hpp"
#include "results/report_file.hpp"
#include "results/result_files.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;

/// What is known of a file in a folder, in the order in which messages name them.
enum class Origin { kOwn, kChanged, kForeign, kUnlisted };

/// Returns whether desktops leave a file of this name in folders that they show, or a run of this library
/// that was killed.
bool is_litter(const std::string& name) {
  constexpr std::array<std::string_view, 3> kOfDesktops = {".DS_Store", "Thumbs.db", "desktop.ini"};
  return std::find(kOfDesktops.begin(), kOfDesktops.end(), name) != kOfDesktops.end() ||
         is_name_of_unfinished_work(name);
}

/// Returns the names of all that is in a folder, sorted; empty if it does not exist.
std::vector<std::string> names_in(const fs::path& folder) {
  std::error_code failure;
  std::vector<std::string> names;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end; entry.increment(failure))
    names.push_back(entry->path().filename().string());
  std::error_code unknown;
  if (failure && fs::is_directory(folder, unknown))
    throw Error(ErrorKind::kOutput, {folder.string(), "", "cannot be listed: " + failure.message(),
                                     Remedy::kChooseWritablePlace});
  std::sort(names.begin(), names.end());
  return names;
}

/// The files of a folder, and what its report says of them.
class FolderContent {
 public:
  FolderContent(const fs::path& folder, const OutputOptions& options, FolderReservation& reservation,
                const Monitor& monitor)
      : folder_(folder),
        reservation_(reservation),
        monitor_(monitor),
        listed_(files_of_report(folder / kReportFile)),
        result_names_(all_result_files()) {
    if (options.companion) result_names_.push_back(options.companion->name);
    for (std::string& name : pieces_in(folder)) result_names_.push_back(std::move(name));
  }

  /// Returns whether a new result may replace or remove the file.
  bool would_be_lost(const std::string& name) const {
    return std::find(result_names_.begin(), result_names_.end(), name) != result_names_.end() ||
           entry_of(name) != nullptr;
  }

  Origin origin_of(const std::string& name) const {
    const fs::path path = folder_ / name;
    const ResultInventory::File* entry = entry_of(name);
    const auto is_as_written = [&] {
      return (entry != nullptr && has_content(path, entry->bytes, entry->checksum, monitor_)) ||
             has_whole_seal(path, monitor_);
    };
    if (reservation_.is_still_so(name, is_as_written)) return Origin::kOwn;
    if (entry != nullptr) return Origin::kChanged;
    if (!has_mark(path)) return Origin::kForeign;
    if (!would_be_lost(name)) return Origin::kOwn;
    return name == kReportFile || name == kStreamlinesFile ? Origin::kChanged : Origin::kUnlisted;
  }

 private:
  const ResultInventory::File* entry_of(const std::string& name) const {
    const auto is_named = [&](const ResultInventory::File& file) { return file.name == name; };
    const auto entry = std::find_if(listed_.begin(), listed_.end(), is_named);
    return entry == listed_.end() ? nullptr : &*entry;
  }

  fs::path folder_;
  FolderReservation& reservation_;
  const Monitor& monitor_;
  std::vector<ResultInventory::File> listed_;
  std::vector<std::string> result_names_;
};

/// A file that stands against writing to its folder.
struct Obstacle {
  bool would_be_lost;
  Origin origin;
  std::string name;
};

std::string text_of(const std::vector<Obstacle>& obstacles) {
  const Obstacle& first = obstacles.front();
  const auto others = static_cast<std::size_t>(
      std::count_if(obstacles.begin() + 1, obstacles.end(),
                    [&](const Obstacle& obstacle) { return obstacle.origin == first.origin; }));
  const std::string text =
      fmt::format("holds '{}'{}, which ", first.name,
                  others > 0 ? fmt::format(" and {}", counted(others, "other file")) : std::string());
  if (first.origin == Origin::kForeign) return text + "Crossgrain did not write";
  if (first.origin == Origin::kUnlisted) return text + "no report.json lists";
  return text +
         (others == 0 ? "was changed since Crossgrain wrote it" : "were changed since Crossgrain wrote them");
}

}  // namespace

void check_foreign_files(const fs::path& folder, const OutputOptions& options, FolderReservation& reservation,
                         const Monitor& monitor) {
  if (options.foreign_files == ForeignFiles::kReplace) return;
  const FolderContent content(folder, options, reservation, monitor);
  std::vector<Obstacle> obstacles;
  for (const std::string& name : names_in(folder)) {
    const bool would_be_lost = content.would_be_lost(name);
    if (is_litter(name) || (!would_be_lost && options.foreign_files == ForeignFiles::kKeep)) continue;
    const Origin origin = content.origin_of(name);
    if (origin != Origin::kOwn) obstacles.push_back({would_be_lost, origin, name});
  }
  if (obstacles.empty()) return;
  // The message names a file that would be lost, if there is one.
  std::stable_sort(obstacles.begin(), obstacles.end(), [](const Obstacle& a, const Obstacle& b) {
    return std::tuple(!a.would_be_lost, a.origin) < std::tuple(!b.would_be_lost, b.origin);
  });
  throw Error(ErrorKind::kOutput, {folder.string(), "", text_of(obstacles), Remedy::kChooseFolder});
}

std::vector<std::string> listed_names_in(const fs::path& folder) {
  const std::vector<std::string> present = names_in(folder);
  std::vector<std::string> names;
  for (const ResultInventory::File& file : files_of_report(folder / kReportFile))
    if (std::binary_search(present.begin(), present.end(), file.name)) names.push_back(file.name);
  return names;
}

void check_is_folder(const fs::path& folder) {
  std::error_code failure;
  const fs::file_status status = fs::status(folder, failure);
  if (fs::is_directory(status)) return;
  const char* text = "is not a folder";
  if (!fs::exists(status))
    text = "no such folder";
  else if (fs::exists(folder.parent_path() / kCellsFile, failure))
    text = "is one file of a result, not its folder";
  else if (is_model_file(folder))
    text = "is a model, not a folder with a result";
  throw Error(ErrorKind::kInput, {folder.string(), "", text, Remedy::kGiveFieldFolder});
}

bool may_exist(const fs::path& path) {
  std::error_code unknown;
  return fs::status(path, unknown).type() != fs::file_type::not_found;
}

bool may_be_model(const fs::path& path) {
  std::error_code unknown;
  return fs::is_regular_file(path, unknown) && is_model_file(path);
}

bool is_own_file(const fs::path& path) {
  return has_mark(path);
}

bool is_unchanged_alone(const fs::path& path) {
  return has_whole_seal(path);
}

}  // namespace crossgrain

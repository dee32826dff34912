// SPDX-License-Identifier: Apache-2.0
#include "results/foreign_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "crossgrain/error.hpp"
#include "files/file_mark.hpp"
#include "files/folder_reservation.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "results/report_file.hpp"
#include "results/result_files.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;
using UnmarkedFile = ResultInventory::UnmarkedFile;

std::string text_of(const Checksum& checksum) {
  return fmt::format("{:016x}", checksum.value());
}

/// Returns the list in the report of a folder.
std::vector<UnmarkedFile> unmarked_in(const fs::path& folder) {
  return has_mark(folder / kReportFile) ? unmarked_files_of(folder / kReportFile)
                                        : std::vector<UnmarkedFile>();
}

/// Returns whether a file is what the report says that was written.
bool is_unchanged(const fs::path& path, const UnmarkedFile& written) {
  std::error_code unknown;
  if (!fs::is_regular_file(path, unknown)) return false;
  if (written.checksum.empty()) return true;
  if (fs::file_size(path, unknown) != written.bytes) return false;
  std::ifstream file(path, std::ios::binary);
  std::string block(1 << 18, '\0');
  Checksum checksum;
  do {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    checksum.add(std::string_view(block).substr(0, static_cast<std::size_t>(file.gcount())));
  } while (file);
  return file.eof() && text_of(checksum) == written.checksum;
}

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

std::vector<std::string> foreign_names(const fs::path& folder) {
  const std::vector<UnmarkedFile> unmarked = unmarked_in(folder);
  std::vector<std::string> foreign;
  for (std::string& name : names_in(folder)) {
    const auto is_own = [&](const UnmarkedFile& file) {
      return file.name == name && is_unchanged(folder / name, file);
    };
    if (is_litter(name) || has_mark(folder / name) || std::any_of(unmarked.begin(), unmarked.end(), is_own))
      continue;
    foreign.push_back(std::move(name));
  }
  return foreign;
}

}  // namespace

void check_foreign_files(const fs::path& folder, const OutputOptions& options) {
  if (options.foreign_files == ForeignFiles::kReplace) return;
  std::vector<std::string> foreign = foreign_names(folder);
  std::vector<std::string> results = all_result_files();
  if (options.companion) results.push_back(options.companion->name);
  const auto would_be_lost = [&](const std::string& name) {
    return std::find(results.begin(), results.end(), name) != results.end();
  };
  // The message names a file that would be lost, if there is one.
  const auto rest = std::stable_partition(foreign.begin(), foreign.end(), would_be_lost);
  if (options.foreign_files == ForeignFiles::kKeep) foreign.erase(rest, foreign.end());
  if (foreign.empty()) return;
  const std::size_t others = foreign.size() - 1;
  throw Error(ErrorKind::kOutput,
              {folder.string(), "",
               others == 0 ? fmt::format("holds '{}', which Crossgrain did not write", foreign.front())
                           : fmt::format("holds '{}' and {}, which Crossgrain did not write", foreign.front(),
                                         counted(others, "other file")),
               Remedy::kChooseFolder});
}

void list_unmarked(const std::string& name, const OutputFile& file, ResultInventory& report) {
  report.unmarked_files.push_back({name, file.position(), text_of(file.checksum().value())});
}

void list_companion(const OutputOptions& options, ResultInventory& report) {
  if (options.companion && options.companion->name != kPageFile)
    report.unmarked_files.push_back({options.companion->name, 0, {}});
}

std::vector<std::string> companions_in(const fs::path& folder) {
  const std::vector<std::string> present = names_in(folder);
  std::vector<std::string> names;
  for (const UnmarkedFile& file : unmarked_in(folder))
    if (file.checksum.empty() && std::binary_search(present.begin(), present.end(), file.name))
      names.push_back(file.name);
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

bool is_own_file(const fs::path& path) {
  return has_mark(path);
}

}  // namespace crossgrain

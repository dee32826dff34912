// SPDX-License-Identifier: Apache-2.0
// Names of the files in a result folder; crossgrain/result_folder.hpp has those that programs of others need.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "crossgrain/result_folder.hpp"

namespace crossgrain {

inline constexpr const char* kSurfaceFile = "surface.vtu";
inline constexpr const char* kReportFile = "report.json";

inline constexpr const char* kTetFramesFile = "onto.frames";
inline constexpr const char* kTetGridFile = "onto.vtu";

/// Returns the names of all files of the folder of a field: those of `write_field`, kPageFile and
/// kStreamlinesFile.
std::vector<std::string> all_result_files();

/// Returns whether a report is of hexahedra without a field.
bool is_without_field(const SolveReport& report);

/// Returns the names of the files of hexahedra that `write_field` writes with these options.
std::vector<std::string> hexahedra_files(const OutputOptions& options);

/// Returns false if there is certainly no such file. If the system does not tell, reading it will say why.
bool may_exist(const std::filesystem::path& path);

/// Returns whether there is a regular file with an extension that a reader of models has.
bool may_be_model(const std::filesystem::path& path);

/// Throws Error(kInput) unless there is a folder of this name.
void check_is_folder(const std::filesystem::path& folder);

/// Returns whether a file has the mark that the files of this library carry, pictures included; those of
/// formats without comments do not (docs/field-file.md).
bool is_own_file(const std::filesystem::path& path);

/// Returns whether a file is as this library has written it alone: lines in .vtu, a picture, tets in .mesh,
/// a page.
bool is_unchanged_alone(const std::filesystem::path& path);

}  // namespace crossgrain

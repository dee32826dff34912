// SPDX-License-Identifier: Apache-2.0
// Table of the output files of a field on tets.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "results/tet_writers.hpp"

namespace crossgrain {

/// A file of a format; a format may have several.
struct TetFile {
  const char* format;  ///< OutputOptions::formats
  const char* name;    ///< in the folder
  const char* description;
  bool is_always_written;
  bool has_rows_of_tets;  ///< one row per tet, or numbers of tets
  bool is_of_map;         ///< needs TetOutput::map
  void (*write)(OutputFile& file, const TetOutput& output, const Monitor& monitor);
};

/// Returns all files; those of one format are consecutive.
std::span<const TetFile> tet_files();

/// Returns whether a file is to be written.
bool is_asked_for(const TetFile& file, const std::vector<std::string>& formats);

/// Throws Error(kUsage) that lists all formats if one of these is unknown.
void check_formats(const std::vector<std::string>& formats);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// The table of what a field on tets can be written to.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/result/tet_writers.hpp"

namespace crossgrain {

/// One file of a format; a format may have several.
struct TetFile {
  const char* format;  ///< OutputOptions::formats
  const char* name;    ///< in the folder
  const char* description;
  bool is_always_written;
  bool has_rows_of_tets;  ///< one for each tet, or their numbers
  void (*write)(OutputFile& file, const TetOutput& output, const Monitor& monitor);
};

/// Files of one format follow one another.
std::span<const TetFile> tet_files();

/// Whether a file is to be written.
bool is_asked_for(const TetFile& file, const std::vector<std::string>& formats);

/// Throws Error(kUsage) where one of these is no format, with the names of all.
void check_formats(const std::vector<std::string>& formats);

}  // namespace crossgrain

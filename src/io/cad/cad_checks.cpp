// SPDX-License-Identifier: Apache-2.0
#include "io/cad/cad_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace crossgrain {
namespace {

/// Returns whether a text occurs in the first or last bytes of a file.
bool begins_with(const InputFile& file, std::string_view text) {
  constexpr std::size_t kHead = 200;
  return file.bytes().substr(0, kHead).find(text) != std::string_view::npos;
}
bool ends_with(const InputFile& file, std::string_view text) {
  constexpr std::size_t kTail = 2000;
  const std::string_view bytes = file.bytes();
  return bytes.substr(bytes.size() - std::min(bytes.size(), kTail)).find(text) != std::string_view::npos;
}

/// Returns the last line that is not blank.
std::string_view last_line(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  const std::string_view lines = bytes.substr(0, bytes.find_last_not_of("\r\n \x1a") + 1);
  return lines.substr(lines.find_last_of('\n') + 1);
}

/// Returns whether a line can end a BREP text file: '+1 0', orientation and number of a shape, and location.
bool is_shape_reference(std::string_view line) {
  constexpr std::string_view kOrientations = "+-ie";
  return !line.empty() && kOrientations.find(line[0]) != std::string_view::npos &&
         line.find_first_not_of("0123456789 ", 1) == std::string_view::npos;
}

}  // namespace

void check_step_file(const InputFile& file) {
  if (!begins_with(file, "ISO-10303-21"))
    fail_input(file, {}, "is not a STEP file: it does not begin with 'ISO-10303-21'", Remedy::kExportAgain);
  if (!ends_with(file, "END-ISO-10303-21"))
    fail_input(file, {}, "does not end with 'END-ISO-10303-21': cut short", Remedy::kCopyAgain);
}

/// Column 73 of every line of an IGES file names its section: S, G, D and P, in this order, and T at the end.
void check_iges_file(const InputFile& file) {
  constexpr std::size_t kSectionColumn = 72;
  constexpr std::string_view kSections = "SGDPT";
  std::string_view rest = file.bytes();
  std::size_t section = 0, number = 0;
  while (section + 1 < kSections.size()) {
    ++number;
    const std::string_view line = rest.substr(0, rest.find('\n'));
    const std::size_t here =
        line.size() > kSectionColumn ? kSections.find(line[kSectionColumn]) : std::string_view::npos;
    if (here == std::string_view::npos || here < section || (number == 1 && here > 0))
      fail_input(file, at_line(number),
                 fmt::format("no {} in column 73, where IGES names its sections: damaged, cut short or not "
                             "an IGES file in text",
                             kSections[section]),
                 Remedy::kCopyAgain);
    section = here;
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
  }
}

void check_brep_file(const InputFile& file) {
  if (!begins_with(file, "CASCADE Topology V"))
    fail_input(file, {}, "is not a BREP file: it does not name a 'CASCADE Topology'", Remedy::kExportAgain);
  const bool is_binary = begins_with(file, "Open CASCADE Topology V");
  if (!is_binary && !is_shape_reference(last_line(file)))
    fail_input(file, {}, "does not end with a shape: cut short", Remedy::kCopyAgain);
}

}  // namespace crossgrain

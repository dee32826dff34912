// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/cad_checks.hpp"

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

constexpr std::string_view kStepBlanks = " \t\r\x1a";

std::string_view trimmed(std::string_view line) {
  const std::size_t first = line.find_first_not_of(kStepBlanks);
  if (first == std::string_view::npos) return {};
  return line.substr(first, line.find_last_not_of(kStepBlanks) + 1 - first);
}

/// Returns whether a line begins with '+1 0': orientation and number of a shape, and its location.
bool is_shape_reference(std::string_view line) {
  constexpr std::string_view kOrientations = "+-ie", kDigits = "0123456789";
  if (line.empty() || kOrientations.find(line[0]) == std::string_view::npos) return false;
  const std::size_t number_end = line.find_first_not_of(kDigits, 1);
  return number_end != std::string_view::npos && number_end > 1 && line.size() > number_end + 1 &&
         line[number_end] == ' ' && kDigits.find(line[number_end + 1]) != std::string_view::npos;
}

/// Returns whether the list of shapes, each of which ends with '*', is followed by a reference to one of
/// them. Programs write more after it: DRAW a '0', others a text of their own.
bool names_a_shape(std::string_view bytes) {
  bool is_referred_to = false;
  while (!bytes.empty()) {
    const std::size_t start = bytes.find_last_of('\n') + 1;  // 0 if there is none
    const std::string_view line = trimmed(bytes.substr(start));
    bytes = bytes.substr(0, start == 0 ? 0 : start - 1);
    if (line.empty()) continue;
    if (is_referred_to && line.back() == '*') return true;
    is_referred_to = is_shape_reference(line);
  }
  return false;
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
  if (!is_binary && !names_a_shape(file.bytes()))
    fail_input(file, {}, "does not end with a shape: cut short", Remedy::kCopyAgain);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/cells/abaqus_lines.hpp"

#include <algorithm>

namespace crossgrain {
namespace {

constexpr std::string_view kBlanks = " \t\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

}  // namespace

std::optional<std::string_view> AbaqusKeyword::find(std::string_view parameter) const {
  const auto found = std::ranges::find_if(
      parameters, [&](const Parameter& other) { return equals_ignoring_case(other.name, parameter); });
  if (found == parameters.end()) return std::nullopt;
  return found->value;
}

void AbaqusLines::find_line() {
  const std::string_view text = scanner_.file().bytes();
  for (;;) {
    const std::size_t begin = scanner_.position();
    const std::size_t end = std::min(text.find_first_of("\r\n", begin), text.size());
    line_ = trimmed(text.substr(begin, end - begin));
    if (!line_.empty() && !line_.starts_with("**")) return;
    if (!scanner_.next_line()) {
      is_at_end_ = true;
      return;
    }
  }
}

void AbaqusLines::pass_line() {
  if (scanner_.next_line())
    find_line();
  else
    is_at_end_ = true;
}

void AbaqusLines::split_line() {
  std::string_view rest = line_;
  while (!rest.empty()) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    fields_.push_back(trimmed(rest.substr(0, comma)));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
  }
}

AbaqusKeyword AbaqusLines::take_keyword() {
  row_ = scanner_;
  fields_.clear();
  bool goes_on = true;
  while (goes_on && !is_at_end_) {
    goes_on = line_.ends_with(',');
    split_line();
    pass_line();
  }
  AbaqusKeyword keyword{trimmed(fields_.front().substr(1)), {}};
  for (std::size_t k = 1; k < fields_.size(); ++k) {
    const std::size_t equals = std::min(fields_[k].find('='), fields_[k].size());
    const std::string_view value = fields_[k].substr(std::min(equals + 1, fields_[k].size()));
    keyword.parameters.push_back({trimmed(fields_[k].substr(0, equals)), trimmed(value)});
  }
  return keyword;
}

const std::vector<std::string_view>& AbaqusLines::take_row() {
  row_ = scanner_;
  fields_.clear();
  split_line();
  pass_line();
  return fields_;
}

void AbaqusLines::skip_rows() {
  while (is_row()) pass_line();
}

}  // namespace crossgrain

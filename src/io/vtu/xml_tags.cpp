// SPDX-License-Identifier: Apache-2.0
#include "io/vtu/xml_tags.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace crossgrain {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";

std::string unescaped(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kEntities = {
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string out;
  while (!text.empty()) {
    const auto entity = std::find_if(kEntities.begin(), kEntities.end(),
                                     [&](const auto& e) { return text.starts_with(e.first); });
    out += entity == kEntities.end() ? text[0] : entity->second;
    text.remove_prefix(entity == kEntities.end() ? 1 : entity->first.size());
  }
  return out;
}

}  // namespace

std::string_view XmlTag::attribute(std::string_view key) const {
  const auto found = attributes.find(key);
  return found == attributes.end() ? std::string_view() : found->second;
}

void XmlTags::skip_blanks() {
  position_ = std::min(text_.find_first_not_of(kBlanks, position_), text_.size());
}

/// Moves behind the next '<' that opens a tag; false at the end of the text.
bool XmlTags::skip_markup_but_tags() {
  for (;;) {
    position_ = text_.find('<', position_);
    if (position_ == std::string_view::npos) break;
    const std::string_view rest = text_.substr(position_);
    const std::string_view closing = rest.starts_with("<!--") ? "-->" : rest.starts_with("<?") ? "?>" : "";
    if (closing.empty()) {
      ++position_;
      return true;
    }
    position_ = text_.find(closing, position_);
    if (position_ == std::string_view::npos) break;
  }
  position_ = text_.size();
  return false;
}

std::optional<XmlTag> XmlTags::next() {
  if (!skip_markup_but_tags()) return std::nullopt;
  const std::size_t name_end = text_.find_first_of(" \t\r\n/>", position_ + 1);
  if (name_end == std::string_view::npos) return std::nullopt;
  XmlTag tag;
  tag.name = text_.substr(position_, name_end - position_);
  position_ = name_end;
  if (!parse_attributes(tag)) return std::nullopt;
  return tag;
}

bool XmlTags::parse_attributes(XmlTag& tag) {
  for (;;) {
    skip_blanks();
    if (position_ >= text_.size()) return false;
    if (text_[position_] == '/') {
      ++position_;
      continue;
    }
    if (text_[position_] == '>') {
      ++position_;
      return true;
    }
    const std::size_t equals = text_.find('=', position_);
    if (equals == std::string_view::npos || equals + 1 >= text_.size()) return false;
    const char quote = text_[equals + 1];
    const std::size_t end = text_.find(quote, equals + 2);
    if ((quote != '"' && quote != '\'') || end == std::string_view::npos) return false;
    tag.attributes[std::string(text_.substr(position_, equals - position_))] =
        unescaped(text_.substr(equals + 2, end - equals - 2));
    position_ = end + 1;
  }
}

}  // namespace crossgrain

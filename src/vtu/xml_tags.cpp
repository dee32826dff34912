// SPDX-License-Identifier: Apache-2.0
#include "vtu/xml_tags.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace crossgrain {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kNameEnds = " \t\r\n=/>";

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

/// Moves to the byte after the next '<' that opens a tag. Returns false at the end of the text.
bool XmlTags::skip_markup_but_tags() {
  for (;;) {
    position_ = std::min(text_.find('<', position_), text_.size());
    if (position_ == text_.size()) return false;
    const std::string_view rest = text_.substr(position_);
    const std::string_view closing = rest.starts_with("<!--") ? "-->" : rest.starts_with("<?") ? "?>" : "";
    if (closing.empty()) {
      ++position_;
      return true;
    }
    const std::size_t closed = text_.find(closing, position_);
    malformed_ = closed == std::string_view::npos;
    if (malformed_) return false;
    position_ = closed;
  }
}

std::optional<XmlTag> XmlTags::next() {
  if (malformed_ || !skip_markup_but_tags()) return std::nullopt;
  XmlTag tag;
  malformed_ = !parse_name(tag) || !parse_attributes(tag);
  if (malformed_) return std::nullopt;
  return tag;
}

bool XmlTags::parse_name(XmlTag& tag) {
  const std::size_t letters = position_ + (text_.substr(position_).starts_with('/') ? 1 : 0);
  const std::size_t end = text_.find_first_of(kNameEnds, letters);
  if (end == std::string_view::npos || end == letters || text_[end] == '=') return false;
  tag.name = text_.substr(position_, end - position_);
  position_ = end;
  return true;
}

bool XmlTags::parse_attributes(XmlTag& tag) {
  for (;;) {
    skip_blanks();
    if (position_ >= text_.size()) return false;
    if (text_[position_] == '/') {
      ++position_;
    } else if (text_[position_] == '>') {
      ++position_;
      return true;
    } else if (!parse_attribute(tag)) {
      return false;
    }
  }
}

/// Reads a name, '=' and a quoted value; blanks may surround '='.
bool XmlTags::parse_attribute(XmlTag& tag) {
  const std::size_t begin = position_;
  position_ = std::min(text_.find_first_of(kNameEnds, position_), text_.size());
  const std::string_view name = text_.substr(begin, position_ - begin);
  skip_blanks();
  if (name.empty() || position_ >= text_.size() || text_[position_] != '=') return false;
  ++position_;
  skip_blanks();
  if (position_ >= text_.size() || (text_[position_] != '"' && text_[position_] != '\'')) return false;
  const std::size_t end = text_.find(text_[position_], position_ + 1);
  if (end == std::string_view::npos) return false;
  tag.attributes[std::string(name)] = unescaped(text_.substr(position_ + 1, end - position_ - 1));
  position_ = end + 1;
  return true;
}

}  // namespace crossgrain

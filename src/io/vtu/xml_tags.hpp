// SPDX-License-Identifier: Apache-2.0
// The tags of an XML text, one after the other: as much of XML as the headers of VTK files need.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace crossgrain {

struct XmlTag {
  std::string name;  ///< "/Piece" for </Piece>
  std::map<std::string, std::string, std::less<>> attributes;

  /// Empty where there is none.
  std::string_view attribute(std::string_view key) const;
};

/// Passes over text, comments and declarations. Never looks beyond its text.
class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : text_(text) {}

  /// The next tag; nothing at the end of the text or where a tag is malformed.
  std::optional<XmlTag> next();

  /// The byte after the last tag.
  std::size_t position() const { return position_; }

 private:
  bool skip_markup_but_tags();
  bool parse_attributes(XmlTag& tag);
  void skip_blanks();

  std::string_view text_;
  std::size_t position_ = 0;
};

}  // namespace crossgrain

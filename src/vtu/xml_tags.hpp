// SPDX-License-Identifier: Apache-2.0
// Iterates over the tags of an XML text: the part of XML that headers of VTK files use.
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

  /// Value of an attribute; empty if there is none.
  std::string_view attribute(std::string_view key) const;
};

/// Skips text, comments and declarations. Never reads beyond its text.
class XmlTags {
 public:
  explicit XmlTags(std::string_view text) : text_(text) {}

  /// Returns the next tag; nothing at the end of the text or if it is malformed.
  std::optional<XmlTag> next();

  /// Returns whether `next` stopped at malformed XML, or within a tag or comment, rather than at the end of
  /// the text.
  bool malformed() const { return malformed_; }

  /// The byte after the last tag, or the one where the text is malformed.
  std::size_t position() const { return position_; }

 private:
  bool skip_markup_but_tags();
  bool parse_name(XmlTag& tag);
  bool parse_attributes(XmlTag& tag);
  bool parse_attribute(XmlTag& tag);
  void skip_blanks();

  std::string_view text_;
  std::size_t position_ = 0;
  bool malformed_ = false;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Reads XML by expat, for documents of other programs. Headers of VTK files, which go on with raw data, have
// vtu/xml_tags.hpp.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>

#include "files/input_file.hpp"

namespace crossgrain {

/// An element at its beginning. Texts live during the call that gets it.
struct XmlElement {
  std::string_view space;  ///< URI of the namespace; empty if there is none
  std::string_view name;
  const char** attributes;  ///< pairs of a name with its namespace and a value, then null
  std::size_t line;

  /// Value of an attribute of a namespace, by default of none; empty if there is none.
  std::string_view value(std::string_view attribute, std::string_view of_space = {}) const;
};

/// What is done with elements, in their order.
struct XmlUse {
  std::function<void(const XmlElement&)> begin;
  std::function<void(std::string_view space, std::string_view name)> end = {};  ///< may be empty
};

/// Gives all elements of a text to `use`, and passes on what that throws. Throws Error(kInput) naming `file`,
/// `part` of it and the line, for malformed XML, and for a declaration of the document's type, which could
/// define texts of any size.
void read_xml(const InputFile& file, std::string_view part, std::string_view text, const XmlUse& use);

/// Throws Error(kInput) naming the file, the part and the line.
[[noreturn]] void fail_in_part(const InputFile& file, std::string_view part, std::size_t line,
                               const std::string& text);

}  // namespace crossgrain

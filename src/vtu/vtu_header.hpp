// SPDX-License-Identifier: Apache-2.0
// Parses the XML of VTK files of unstructured grids (.vtu) from any writer: which arrays there are, and
// where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/message.hpp"
#include "vtu/vtu_data.hpp"
#include "vtu/vtu_types.hpp"

namespace crossgrain {

struct VtuHeader {
  struct Array {
    VtuSection section;
    std::string name;
    NumberType type;
    std::uint64_t components;
    std::string format;      ///< ascii (or empty), binary (base64 in place) or appended
    std::uint64_t offset;    ///< of an appended array, from the begin of the appended data
    std::size_t begin, end;  ///< range of the text between its tags
  };

  /// Block of the data of all arrays with format="appended".
  struct AppendedData {
    std::size_t begin;  ///< the byte after '_'
    bool is_base64;     ///< else raw
  };

  VtuPackage package;
  std::uint64_t points = 0, cells = 0;  ///< of the only piece with cells, or of the first piece
  std::vector<Array> arrays;            ///< numeric arrays of that piece and of no piece
  std::optional<AppendedData> appended;

  /// Returns the array of a name, or the first of the section if the name is empty. Null if there is none.
  const Array* find(VtuSection section, std::string_view name) const;
};

/// An error in a header at a byte of its text.
struct VtuHeaderFault {
  std::size_t position;
  std::string text;
  Remedy remedy;
};

/// Parses tags up to the appended data, which may hold anything. Counts and offsets are those of the text,
/// unchecked. Throws VtuHeaderFault.
VtuHeader read_vtu_header(std::string_view text);

}  // namespace crossgrain

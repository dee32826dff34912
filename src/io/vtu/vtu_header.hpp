// SPDX-License-Identifier: Apache-2.0
// The XML of VTK files of unstructured grids (.vtu), whoever wrote them: what arrays there are and where.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/message.hpp"
#include "io/vtu/vtu_data.hpp"
#include "io/vtu/vtu_types.hpp"

namespace crossgrain {

struct VtuHeader {
  struct Array {
    VtuSection section;
    std::string name;
    NumberType type;
    std::uint64_t components;
    std::string format;      ///< ascii (or empty), binary (base64 in place) or appended
    std::uint64_t offset;    ///< of an appended one, from the begin of the appended data
    std::size_t begin, end;  ///< what stands between its tags
  };

  /// What the bytes of all arrays with format="appended" stand in.
  struct AppendedData {
    std::size_t begin;  ///< the byte after '_'
    bool is_base64;     ///< else raw
  };

  VtuPackage package;
  std::uint64_t points = 0, cells = 0;  ///< of the only piece with cells, or of the first piece
  std::vector<Array> arrays;            ///< those of numbers, of that piece and of no piece
  std::optional<AppendedData> appended;

  /// By its name, or the first of the section where that is empty. Null where there is none.
  const Array* find(VtuSection section, std::string_view name) const;
};

/// What is wrong with a header, at a byte of its text.
struct VtuHeaderFault {
  std::size_t position;
  std::string text;
  Remedy remedy;
};

/// Reads tags up to the appended data, which may hold anything. Counts and offsets are as the text claims
/// them. Throws VtuHeaderFault.
VtuHeader read_vtu_header(std::string_view text);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Shapes in OpenCASCADE's own format, each with its place, as one text: what the program crossgrain_cad gets
// of a document of FreeCAD. Compiled into both the library and the program.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain {

struct PlacedBrep {
  /// The shape is turned by the quaternion (w, x, y, z), then moved.
  std::array<double, 4> turn{1, 0, 0, 0};
  std::array<double, 3> move{};

  std::string brep;  ///< text or binary
};

/// Appends a shape to a text of such.
void append_brep(std::string& text, const PlacedBrep& shape);

/// Returns the shapes in a text; nothing if it is no such text.
std::optional<std::vector<PlacedBrep>> placed_breps_in(std::string_view text);

}  // namespace crossgrain

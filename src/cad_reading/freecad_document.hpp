// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "crossgrain/warning.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// What a document of FreeCAD (.FCStd) shows.
struct FreeCadShapes {
  std::string placed_breps;  ///< text of append_brep, of one shape at least; in millimetres
  std::vector<Warning> warnings;
};

/// Returns the shapes of the objects that are visible, in their places: bodies in place of what they are made
/// of, parts with what they hold, links with what they show. In a document that was saved without a window,
/// and so tells of nothing whether it is visible, these are the objects that no other is made of. Sketches,
/// planes of reference and the like are left out, with a warning what cannot be read. Throws Error(kInput)
/// for a damaged document and for one that shows nothing; Error(kLimit).
FreeCadShapes read_freecad_document(const InputFile& file);

}  // namespace crossgrain

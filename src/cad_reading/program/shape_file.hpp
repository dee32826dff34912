// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <TopoDS_Shape.hxx>
#include <string>
#include <vector>

#include "cad_reading/cad_messages.hpp"
#include "crossgrain/warning.hpp"

namespace crossgrain {

struct CadShape {
  TopoDS_Shape shape;     ///< not null
  std::string unit;       ///< of the shape: "mm", or empty if the format has no units
  std::string file_unit;  ///< of the file, such as "inch"; empty if it does not say
  std::vector<Warning> warnings;
};

/// Returns the contents of a CAD file as one shape, with all parts of assemblies in their places. Throws
/// Fault, and whatever OpenCASCADE throws.
CadShape read_shape(const std::string& path, CadFormat format);

}  // namespace crossgrain

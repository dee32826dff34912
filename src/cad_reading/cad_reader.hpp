// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad_reading/cad_messages.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

enum class CadContent { kTriangles, kWithSolids };

struct CadModel {
  TriangleMesh mesh;
  CadSolids solids;  ///< with CadContent::kWithSolids
};

/// Reads STEP (AP203, AP214, AP242), IGES 5, OpenCASCADE's own BREP, in text or binary, and what documents of
/// FreeCAD show (cad_reading/freecad_document.hpp), in a separate
/// process (cad_reading/cad_messages.hpp), which ends when the monitor is cancelled. Throws as `read_surface`
/// does.
CadModel read_cad(const InputFile& file, CadFormat format, const CadReading& options, const Monitor& monitor,
                  CadContent content = CadContent::kTriangles);

}  // namespace crossgrain

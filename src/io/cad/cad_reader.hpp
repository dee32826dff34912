// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "files/input_file.hpp"
#include "io/cad/cad_messages.hpp"

namespace crossgrain {

enum class CadContent { kTriangles, kWithSolids };

struct CadModel {
  TriangleMesh mesh;
  CadSolids solids;  ///< with CadContent::kWithSolids
};

/// Reads STEP (AP203, AP214, AP242), IGES 5 and OpenCASCADE's own BREP, in text or binary, in a separate
/// process (io/cad/cad_messages.hpp), which ends when the monitor is cancelled. Throws as `read_surface`
/// does.
CadModel read_cad(const InputFile& file, CadFormat format, const ReadOptions& options, const Monitor& monitor,
                  CadContent content = CadContent::kTriangles);

}  // namespace crossgrain

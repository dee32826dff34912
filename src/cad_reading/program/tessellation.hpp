// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cad_reading/cad_messages.hpp"
#include "cad_reading/program/bodies.hpp"

namespace crossgrain {

/// Returns the triangles of all bodies, one body after the other, with faces oriented outwards; with faces,
/// solids, corner normals and creases. Warns of faces that could not be meshed. Throws Fault if none could.
/// Results are reproducible: meshing uses one thread.
TriangleMesh tessellate(const Bodies& bodies, const CadReading& options);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace crossgrain {

/// Returns what a program made as a mesh for a field: without vertices that no tet uses, all tets with a
/// positive volume by the order of their vertices. Throws TetFailure if a tet has no volume, or the tets
/// overlap or fold over themselves. Where the solid touches itself, TetMesh::warnings says so.
TetMesh checked_tets(TetMesh mesh, const std::string& program);

}  // namespace crossgrain

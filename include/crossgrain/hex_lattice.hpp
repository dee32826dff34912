// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "crossgrain/error.hpp"
#include "crossgrain/hex_fit.hpp"
#include "crossgrain/hex_meshing.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup hexahedra Hexahedra
/// @{

/// Returns hexahedra that fill a model without tets, a field or a map: the cells of a lattice that have half
/// of their volume inside, on planes turned to the directions of most of the surface and moved onto its large
/// faces; put onto the corners, creases and faces of the model as `fit_hexahedra` does. Smaller lattices
/// follow until all is kept (HexReport::attempts).
///
/// The model is a CAD file, a surface or a tet mesh, as for `read_surface` and `read_tets`; holes are filled,
/// and its solids are one (kApproximate where they touch). Of the options those about tets and the field do
/// not matter. The same to the bit for any number of threads. Errors as of `fit_hexahedra`, and kUsage for
/// sizes that do not suit the model.
FittedHexahedra lattice_hexahedra(const std::filesystem::path& model, const HexMeshingOptions& options = {},
                                  const Monitor& monitor = {});

/// The same in a surface.
FittedHexahedra lattice_hexahedra(const TriangleMesh& surface, const HexMeshingOptions& options = {},
                                  const Monitor& monitor = {});

/// Returns lattice_hexahedra of a model of which `make_hexahedra` could make no tets, with a warning that
/// says why not: triangles of it cross, or no program can cut it. `error` is what that threw; throws it again
/// if it is another one, if no lattice is wanted (HexPreference::kMapOnly), or if the model cannot be used
/// for one.
FittedHexahedra lattice_without_tets(const Error& error, const std::filesystem::path& model,
                                     const HexMeshingOptions& options = {}, const Monitor& monitor = {});

/// The same in a surface.
FittedHexahedra lattice_without_tets(const Error& error, const TriangleMesh& surface,
                                     const HexMeshingOptions& options = {}, const Monitor& monitor = {});

/// @}

}  // namespace crossgrain

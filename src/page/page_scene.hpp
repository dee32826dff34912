// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/hex_fit.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/tet_frame_field.hpp"

namespace crossgrain {

/// The scene of a page: a field reduced to what a browser can draw at once, in the layout of
/// viewer/README.md: the surface and its creases, singular arcs, at most kMostCellsOfPage cells, forms of
/// some of them, streamlines. The same bytes for any number of threads. Throws Error(kInterrupted).
std::string page_scene(const FrameField& field, const Monitor& monitor = {});

/// Likewise of a field on tets, with the grid from which it started beside it, and with hexahedra unless they
/// are null.
std::string page_scene(const TetFrameField& field, const HexMesh* hexahedra = nullptr,
                       const Monitor& monitor = {});

/// Likewise of hexahedra without a field: no cells, tets, arcs and streamlines.
std::string page_scene(const FittedHexahedra& fitted, const Monitor& monitor = {});

}  // namespace crossgrain

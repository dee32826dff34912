// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/hex_fit.hpp"
#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/tet_frame_field.hpp"

namespace crossgrain {

/// \addtogroup files Files, pages and pictures
/// @{

/// Largest number of cells that a page shows, enough for every cell of a part at the default resolution.
/// Those of a field with more are merged (OutputOptions::level).
inline constexpr std::size_t kMostCellsOfPage = 200000;

/// Largest number of hexahedra that a page shows.
inline constexpr std::size_t kMostHexahedraOfPage = 150000;

/// The page that shows a field in a browser (docs/page.md), as a file for `write_field` to write with its own
/// (OutputOptions::companion): the surface, singular arcs, frames and energies of at most kMostCellsOfPage
/// cells, and streamlines, which are traced when the file is written. Independent of the number of threads.
CompanionFile page_of(const FrameField& field);

/// Likewise of a field on tets: its boundary, singular arcs, and the frames and energies of at most 300,000
/// tets, with the grid from which it started to choose instead. Unless they are null, the page shows
/// hexahedra first, at most kMostHexahedraOfPage: of a larger mesh those at its surface, then the worst.
CompanionFile page_of(const TetFrameField& field, std::shared_ptr<const HexMesh> hexahedra = nullptr);

/// The page of hexahedra without a field, likewise, with the surface of their model; they must live until it
/// is written. Throws Error(kUsage) without FittedHexahedra::surface.
CompanionFile page_of(const FittedHexahedra& fitted);

/// Writes the page as a single HTML file that needs no other. The file appears complete or not at all.
/// Errors: kUsage for a name that ends in anything but .html or .htm, if in anything; kInput for a field
/// without its surface; kOutput; kInterrupted.
void write_page(const FrameField& field, const std::filesystem::path& path, const Monitor& monitor = {});
void write_page(const TetFrameField& field, const std::filesystem::path& path, const Monitor& monitor = {});

/// @}

}  // namespace crossgrain

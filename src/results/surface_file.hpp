// SPDX-License-Identifier: Apache-2.0
// Writes and reads the surface of a solve as a file for ParaView (docs/field-file.md): triangles, then
// creases as polylines.
#pragma once

#include <filesystem>

#include "crossgrain/monitor.hpp"
#include "field/solved_surface.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// Throws Error(kOutput), and Error(kInterrupted) once the monitor is cancelled.
void write_surface(OutputFile& file, const SolvedSurface& surface, const Monitor& monitor);

/// Returns the surface in a file written by `write_surface`, read when first needed; none if there is no such
/// file. The file is opened now, so it may be renamed or removed afterwards. Throws Error(kInput), now or
/// when read, if the file is invalid.
SurfaceSource surface_in(const std::filesystem::path& path);

}  // namespace crossgrain

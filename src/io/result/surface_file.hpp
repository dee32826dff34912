// SPDX-License-Identifier: Apache-2.0
// The surface that a field was solved with as a file that ParaView opens (docs/field-file.md): triangles,
// then creases as polylines.
#pragma once

#include <filesystem>

#include "crossgrain/monitor.hpp"
#include "field/solved_surface.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

inline constexpr const char* kSurfaceFile = "surface.vtu";

/// Throws Error(kOutput), and Error(kInterrupted) once the monitor is cancelled.
void write_surface(OutputFile& file, const SolvedSurface& surface, const Monitor& monitor);

/// The surface in a file that `write_surface` has written, to be read when it is asked for; none where there
/// is no such file. The file is opened now, so that it does not matter what becomes of its name. Throws
/// Error(kInput) where it is no such file, now or when asked.
SurfaceSource surface_in(const std::filesystem::path& path);

}  // namespace crossgrain

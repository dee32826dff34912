// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/spectrum.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

/// \addtogroup files Files, pages and pictures
/// @{

// In the following, the path "-" stands for standard input or standard output. Text files have one item per
// line, with numbers separated by blanks; blank lines and everything after a word that begins with '#' are
// ignored.

/// Reads points, `x y z` per line. Throws Error(kInput) naming the line, and for a file without points.
std::vector<Vector3> read_points(const std::filesystem::path& path);

/// Reads normals of any length except zero, `nx ny nz [weight]` per line; the default weight is 1. Throws
/// Error(kInput) naming the line, and for a file without normals.
std::vector<WeightedNormal> read_normals(const std::filesystem::path& path);

/// Destinations of `write_samples`.
struct SampleFiles {
  std::filesystem::path frames = "-";

  /// Receives the points outside, `x y z` per line after a comment line; no such file if empty.
  std::filesystem::path outside;
};

/// Writes a comment line that names the columns, then the frame at each point (FrameField::sample), one line
/// per point: the nine numbers of its three unit axes, with 17 significant digits. Returns the number of
/// points outside all active cells. Both files appear complete or not at all. Throws Error(kUsage) for names
/// that end in anything but .txt or .dat, if in anything; Error(kOutput) and Error(kInterrupted).
std::size_t write_samples(const FrameField& field, std::span<const Vector3> points, const SampleFiles& files,
                          const Monitor& monitor = {});

/// Throws the Error(kUsage) of `write_samples` for names of other formats.
void check_sample_names(const SampleFiles& files);

/// @}

}  // namespace crossgrain

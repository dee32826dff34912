// SPDX-License-Identifier: Apache-2.0
// Files packed by gzip (RFC 1952), whose names end with .gz after the extension of their format.
#pragma once

#include <filesystem>

#include "files/input_file.hpp"

namespace crossgrain {

/// Returns the name of what a file holds: "part.step" for part.step.gz in either case, else the name itself.
std::filesystem::path unpacked_name(const std::filesystem::path& path);

/// Reads a file as InputFile does, and unpacks it if its name ends with .gz: all members, one after the
/// other. Takes memory for what comes out, within the limits of reading. Throws Error(kInput), also for a
/// damaged or truncated archive and for one in another; Error(kLimit).
InputFile read_unpacked(const std::filesystem::path& path);

}  // namespace crossgrain

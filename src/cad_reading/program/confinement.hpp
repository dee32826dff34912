// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace crossgrain {

/// What the kernel offers for confinement.
struct Confinement {
  bool of_calls;  ///< seccomp: no system calls but those that reading a file and computing need
  bool of_files;  ///< Landlock: no file but one can be opened
};

/// Takes from this process for good what reading one file does not need, since a file from a stranger may
/// take over OpenCASCADE: sockets, other programs and processes, signals to others, executable memory, and
/// all files but that one, which can only be read. Descriptors that are open stay usable. A forbidden system
/// call fails with EPERM, a forbidden file with EACCES. Where the kernel lacks a part, the others still hold.
///
/// For x86-64 and aarch64; elsewhere only Landlock. To be called before other threads start.
Confinement confine_to_reading(const std::string& path);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Checks of a CAD file before OpenCASCADE reads it. OpenCASCADE does not notice that a file is damaged or
// truncated and sometimes crashes; these cheap checks detect most such files.
#pragma once

#include "files/input_file.hpp"

namespace crossgrain {

/// Each function throws Error(kInput) if the file does not have the format or is truncated.
void check_step_file(const InputFile& file);
void check_iges_file(const InputFile& file);
void check_brep_file(const InputFile& file);

}  // namespace crossgrain

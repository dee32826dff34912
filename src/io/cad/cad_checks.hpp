// SPDX-License-Identifier: Apache-2.0
// What is looked at in a CAD file before OpenCASCADE sees it. That does not see when a file is damaged or
// ends too early, and crashes on it now and then; these checks are cheap and tell most of that.
#pragma once

#include "files/input_file.hpp"

namespace crossgrain {

/// Each throws Error(kInput) for what is no file of the format or one cut short.
void check_step_file(const InputFile& file);
void check_iges_file(const InputFile& file);
void check_brep_file(const InputFile& file);

}  // namespace crossgrain

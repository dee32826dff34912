// SPDX-License-Identifier: Apache-2.0
// Whether results may go where they would, before they are computed.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "arguments.hpp"
#include "crossgrain/result_folder.hpp"

namespace crossgrain::app {

/// Returns the sole right to write the result to the folder. Throws Error(kOutput) if that is not possible,
/// if the folder holds a file that Crossgrain did not write, or that was changed since, or if nobody named it
/// and it holds the field of another model.
std::shared_ptr<FolderReservation> reserve_output_folder(const SolveArguments& arguments);

/// Returns the other model whose field in the folder the result will replace, if there is one.
std::optional<std::string> replaced_model(const SolveArguments& arguments);

/// Throws Error(kOutput) if a file exists and Crossgrain did not write it, or it was changed since. For
/// outputs that the user has not named.
void check_output_file(const std::string& path);

}  // namespace crossgrain::app

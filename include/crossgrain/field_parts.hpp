// SPDX-License-Identifier: Apache-2.0
// Fields that several processes have solved together (crossgrain/processes.hpp). All of them call each
// function together; `write_field` (crossgrain/result_folder.hpp) takes parts too.
#pragma once

#include <cstddef>
#include <optional>

#include "crossgrain/frame_field.hpp"

namespace crossgrain {

/// \addtogroup solving Solving
/// @{

/// Returns the whole field in process 0, nothing in others. A field that is no part is returned as it is.
std::optional<FrameField> whole_of_parts(FrameField part);

/// Returns in process 0 a field of at most `most_cells` cells, as far as merging cells gives that: those
/// deeper than one level of the octree are merged (OutputOptions::level). Its report and its singular graph
/// are those of the whole field. Nothing in others. A field that is no part is returned as it is.
std::optional<FrameField> thinned_from_parts(const FrameField& part, std::size_t most_cells);

/// @}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// A field that several processes write: field.pvtu, a list of field_0.vtu, field_1.vtu, ..., each with the
// successive cells of one process.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "crossgrain/result_folder.hpp"
#include "field/field_data.hpp"
#include "files/output_folder.hpp"

namespace crossgrain {

/// Returns the names of the pieces that the list of a folder names, in order; empty if it has no list. Throws
/// Error(kInput) for a list of anything else.
std::vector<std::string> listed_pieces(const std::filesystem::path& folder);

/// Returns the files with the cells of the field in a folder, in order: field.vtu, or the pieces. Throws
/// Error(kInput), naming the folder, if there are none.
std::vector<std::filesystem::path> cell_files(const std::filesystem::path& folder);

/// Returns the names of pieces in a folder, listed or not, that this library has written.
std::vector<std::string> pieces_in(const std::filesystem::path& folder);

/// Writes the cells of a part to a piece, and in the first process the list; returns there what the report is
/// to say of the pieces. All processes that share the field call it together: the first with its folder, the
/// others with null. Throws in every process if one fails: that one its own error, the others
/// OtherProcessFailed. Only Error(kInterrupted) is thrown at once, and the others wait.
std::vector<ResultInventory::File> write_pieces(const FieldData& part, const OutputOptions& options,
                                                OutputFolder* output, const Monitor& monitor);

/// Tells the others, who are in write_pieces, that the first process has failed before it came there.
void cancel_pieces(const FieldData& part);

}  // namespace crossgrain

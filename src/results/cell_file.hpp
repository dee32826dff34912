// SPDX-License-Identifier: Apache-2.0
// The file of cells: field.vtu, or a piece of it.
#pragma once

#include <vector>

#include "crossgrain/monitor.hpp"
#include "crossgrain/result_folder.hpp"
#include "field/field_data.hpp"
#include "files/output_file.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {

/// Returns the cell data of the file. `data` must outlive them.
std::vector<VtuArray> cell_data_arrays(const FieldData& data);

/// Writes and finishes the file. A few arrays define the field; they are field data, or derived from nothing
/// else, and only they are read (vtu/array_names.hpp). What ParaView shows (axes, coefficients, ...) is
/// derived from them. `options` say which part of the field the data are. Throws Error(kOutput) and
/// Error(kInterrupted).
void write_cell_file(const FieldData& data, const OutputOptions& options, OutputFile& file,
                     const Monitor& monitor);

}  // namespace crossgrain

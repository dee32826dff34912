// SPDX-License-Identifier: Apache-2.0
// What `hex` and `fit` do of a run.
#pragma once

#include <memory>

#include "crossgrain/error.hpp"
#include "crossgrain/hex_meshing.hpp"
#include "crossgrain/report.hpp"
#include "job.hpp"

namespace crossgrain::app {

/// Makes hexahedra along a field in the model, or those of a lattice where it comes to that. Prints what is
/// expected and what is at risk.
std::shared_ptr<const Hexahedra> made_hexahedra(const Job& job);

/// Leaves out the formats of maps where hexahedra are those of a lattice, with a warning.
void leave_out_maps(const Job& job, OutputOptions& options);

/// Puts hexahedra that are given, or those of a lattice, onto the model and writes them.
SolveReport fit_and_write(const Job& job, const std::shared_ptr<FolderReservation>& reservation);

/// Makes a lattice and writes it, where the way along a field ended with an error about tets
/// (lattice_without_tets).
SolveReport lattice_and_write(const Job& job, const std::shared_ptr<FolderReservation>& reservation,
                              const Error& error);

}  // namespace crossgrain::app

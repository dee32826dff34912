// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "arguments.hpp"
#include "crossgrain/hex_fit.hpp"
#include "crossgrain/hex_lattice.hpp"

namespace crossgrain::app {

/// The options that arguments of `hex` stand for, without listeners.
HexMeshingOptions hex_options(const SolveArguments& arguments);

/// Reads the mesh of `fit` and puts it onto its model. Warnings of reading are handed out before the work.
FittedHexahedra fitted_mesh(const SolveArguments& arguments, const std::function<void(const Warning&)>& warn,
                            const Monitor& monitor);

/// lattice_without_tets of the model.
FittedHexahedra lattice_mesh_without_tets(const Error& error, const SolveArguments& arguments,
                                          const HexMeshingOptions& options, const Monitor& monitor);

/// Makes hexahedra of a lattice.
FittedHexahedra lattice_mesh(const SolveArguments& arguments, const HexMeshingOptions& options,
                             const Monitor& monitor);

}  // namespace crossgrain::app

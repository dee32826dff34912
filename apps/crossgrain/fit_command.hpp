// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "arguments.hpp"
#include "crossgrain/hex_fit.hpp"

namespace crossgrain::app {

/// Reads the mesh of `fit` and puts it onto its model. Warnings of reading are handed out before the work.
FittedHexahedra fitted_mesh(const SolveArguments& arguments, const std::function<void(const Warning&)>& warn,
                            const Monitor& monitor);

}  // namespace crossgrain::app

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "arguments.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace crossgrain::app {

/// Adds the options of `solve` that make tets of the model, which `onto` excludes.
void add_making_of_tets(CLI::App& command, SolveArguments& arguments, CLI::Option* onto);

}  // namespace crossgrain::app

// SPDX-License-Identifier: Apache-2.0
// The commands and their options, with help. Each function adds one command, whose options are written to
// `arguments` when the command line is parsed. Few files include CLI11, which takes seconds to compile.
#pragma once

#include "arguments.hpp"

namespace CLI {
class App;
}

namespace crossgrain::app {

CLI::App* add_solve(CLI::App& app, SolveArguments& arguments);
/// `hex`, a solve on tets with hexahedra.
CLI::App* add_hex(CLI::App& app, SolveArguments& arguments);
/// `fit`, whose arguments are those of `hex` with a mesh.
CLI::App* add_fit(CLI::App& app, SolveArguments& arguments);
CLI::App* add_tets(CLI::App& app, TetsArguments& arguments);
CLI::App* add_sample(CLI::App& app, SampleArguments& arguments);
CLI::App* add_streamlines(CLI::App& app, StreamlinesArguments& arguments);
CLI::App* add_render(CLI::App& app, RenderArguments& arguments);
CLI::App* add_spectrum(CLI::App& app, SpectrumArguments& arguments);
CLI::App* add_check(CLI::App& app, CheckArguments& arguments);
CLI::App* add_view(CLI::App& app, ViewArguments& arguments);

}  // namespace crossgrain::app

// SPDX-License-Identifier: Apache-2.0
// What the command line says, parsed.
#pragma once

#include <string>
#include <variant>

#include "crossgrain/io.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/streamlines.hpp"

namespace crossgrain::app {

struct SolveArguments {
  std::string model;
  std::string output;       ///< the folder to write; never empty
  std::string from;         ///< the folder of an earlier field; empty for none
  std::string onto;         ///< the tet mesh to carry the field onto; empty for none
  std::string constraints;  ///< a file of them; empty for none
  SolveOptions options;
  OutputOptions output_options;
  bool page = true;  ///< whether to write report.html
  double read_seconds = ReadOptions().read_seconds;
  bool quiet = false;
  bool progress = false;
};

struct SampleArguments {
  std::string field;
  std::string points;
  std::string output = "-";
  std::string outside;  ///< empty for none
};

struct StreamlinesArguments {
  std::string field;
  std::string seeds;    ///< a file, or "-"; empty for `count` of them evenly spread
  std::string output;   ///< never empty
  std::string surface;  ///< the model; empty where lines are to end with the active cells
  std::size_t count = 100;
  StreamlineOptions options;
  bool quiet = false;
};

struct RenderArguments {
  std::string field;
  std::string output;  ///< the PNG file; never empty
  PictureOptions options;
  bool streamlines = false;  ///< draw those of kStreamlinesFile in the folder
  int threads = 0;
  bool quiet = false;
};

struct SpectrumArguments {
  std::string preset;   ///< empty where `normals` is given
  std::string normals;  ///< a file, or "-"
  Degree degree = Degree::kFour;
  bool json = false;
};

struct CheckArguments {
  std::string field;
  bool json = false;
};

struct ViewArguments {
  std::string folder;
  int port = 0;  ///< 0 for a free one
  bool no_browser = false;
};

/// Nothing is left to do but to end with `exit_code`; what there was to say has been said.
struct Finished {
  int exit_code;
};

using Arguments = std::variant<Finished, SolveArguments, SampleArguments, SpectrumArguments, CheckArguments,
                               StreamlinesArguments, RenderArguments, ViewArguments>;

/// Prints help and version on standard output; throws Error(kUsage) for a command line that makes no sense.
Arguments parse_arguments(int argc, char** argv);

}  // namespace crossgrain::app

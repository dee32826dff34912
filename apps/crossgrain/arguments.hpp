// SPDX-License-Identifier: Apache-2.0
// The parsed command line.
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "crossgrain/hex_meshing.hpp"
#include "crossgrain/options.hpp"
#include "crossgrain/picture.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/streamlines.hpp"
#include "crossgrain/tet_making.hpp"

namespace crossgrain::app {

/// How progress is shown on standard error: as lines where it is a terminal, as lines in any case, or as
/// JSON, a line an event.
enum class ProgressForm { kOnTerminal, kLines, kJson };

struct SolveArguments {
  std::string model;
  std::string output;            ///< folder to write; never empty
  bool is_output_named = false;  ///< by the user, not after the model
  std::string from;              ///< folder of an earlier field; empty for none
  std::string onto;              ///< tet mesh for the field; empty for none
  std::string constraints;       ///< file of constraints; empty for none
  std::string checkpoint;        ///< folder for going on after a break; empty for none
  double checkpoint_minutes = 10;
  std::string restart;      ///< folder to go on from; empty for none
  bool makes_tets = false;  ///< whether the model is cut into tets first, which are solved
  double tet_size = 0;      ///< their largest edge; 0 for the default
  SolveOptions options;
  TetTagOptions tags;
  bool prepare = false;  ///< whether tets are split for a map
  OutputOptions output_options;
  bool page = true;  ///< whether to write report.html
  std::string mesh;  ///< file of hexahedra that are put onto the model, as `fit` does; empty for none

  /// Whether and how to make hexahedra, as `hex` does; `options` and `tags` replace its own. Of a `fit` too.
  std::optional<HexMeshingOptions> hexahedra;
  bool lattice = false;              ///< whether hexahedra are those of a lattice
  bool accepts_approximate = false;  ///< whether hexahedra that are HexOutcome::kApproximate will do
  bool repair = false;               ///< whether to repair the matchings of the field on tets
  double read_seconds = ReadOptions().read_seconds;
  bool glue = false;
  LengthUnit unit = LengthUnit::kUnknown;  ///< of files that name none
  bool quiet = false;
  bool verbose = false;  ///< prints all numbers, those of several processes too
  ProgressForm progress = ProgressForm::kOnTerminal;
};

/// Whether the model is solved as tets, read or made.
bool solves_tets(const SolveArguments& arguments);

struct TetsArguments {
  std::string model;
  std::string output;            ///< file to write; never empty
  bool is_output_named = false;  ///< by the user, not after the model
  TetMakingOptions options;
  int threads = 0;
  bool quiet = false;
  ProgressForm progress = ProgressForm::kOnTerminal;
};

struct SampleArguments {
  std::string field;
  std::string points_file;      ///< a file, or "-"; empty if `points` is given
  std::vector<Vector3> points;  ///< given on the command line
  std::string output = "-";
  std::string outside;  ///< empty for none
};

/// The field of a result that a command works on.
enum class FieldChoice {
  kTetsIfAny,
  kTets,
  kGrid  ///< also where it is that from which the field on tets started
};

/// Where evenly spread seeds lie: in the volume, on the surface, or on a cut.
struct SeedPlaces {
  bool on_surface = false;
  std::optional<PictureOptions::Cut> cut;
};

struct StreamlinesArguments {
  std::string field;
  FieldChoice choice = FieldChoice::kTetsIfAny;
  std::string seeds;   ///< file, or "-"; empty for `count` evenly spread seeds
  std::string output;  ///< never empty
  bool is_output_named = false;
  SeedPlaces places;
  std::size_t count = 1000;
  std::optional<double> spacing;  ///< in longest sides; by default 0 for seeds of a file
  StreamlineOptions options;
  bool quiet = false;
};

/// What `render` draws.
enum class Subject { kHexahedraIfAny, kField, kHexahedra };

struct RenderArguments {
  std::string field;
  FieldChoice choice = FieldChoice::kTetsIfAny;
  std::string output;  ///< PNG file; never empty
  bool is_output_named = false;
  PictureOptions options;
  bool streamlines = false;  ///< draw the lines of kStreamlinesFile in the folder
  Subject subject = Subject::kHexahedraIfAny;
  int threads = 0;
  bool quiet = false;
};

struct SpectrumArguments {
  std::string preset;   ///< empty if `normals` is given
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

/// The program ends with `exit_code`; all output has been printed.
struct Finished {
  int exit_code;
};

using Arguments = std::variant<Finished, SolveArguments, SampleArguments, SpectrumArguments, CheckArguments,
                               StreamlinesArguments, RenderArguments, ViewArguments, TetsArguments>;

/// Returns the parsed arguments. Prints help and version on standard output. Throws Error(kUsage) for an
/// invalid command line.
Arguments parse_arguments(int argc, char** argv);

/// The same for `crossgrain-mpi`, which only solves.
Arguments parse_arguments_of_processes(int argc, char** argv);

}  // namespace crossgrain::app

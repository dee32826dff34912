// SPDX-License-Identifier: Apache-2.0
// Prints the numbers of a table of docs/notes/hexahedra.md: hexahedra of tet meshes, one row for each mesh
// and number of cells.
//
//   hex_table CELLS[,CELLS...] MESH...      tet meshes as for `crossgrain solve`
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <sstream>
#include <string>

#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/hexahedra.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/warning.hpp"

namespace crossgrain {
namespace {

void add_row(const std::string& name, const TetFrameField& field, double cells, double solve_seconds) {
  Stopwatch stopwatch;
  stopwatch.start();
  HexOptions options;
  options.cells = cells;
  const HexReport r = hexahedra(field, options).report();
  fmt::print(
      "| {} | {:g} | {} | {} | {} | {:.3f} → {:.3f} | {:.3f} | {} | {:.2f} % | {:.3f} | {:.3f} | {}, {}, {} "
      "| {:.2f} | {} |\n",
      name, cells, name_of(r.outcome), r.hexahedra, r.left_out, r.quality_before.least, r.quality.least,
      r.quality.mean, r.quality.inverted, 100 * (r.volume / r.model_volume - 1), r.largest_distance / r.size,
      r.largest_distance_of_model / r.size, r.crowded_faces, r.open_edges, r.pinched_vertices,
      solve_seconds + stopwatch.restart(), r.reason);
  for (const HexAttempt& a : r.attempts)
    fmt::print(stderr,
               "   {} {}: size {:.3g}, {} faults, {} arcs without length, flips {} -> {}, {} hexahedra, "
               "{:.2f} s\n",
               a.kind, a.repair, a.size, a.faults, a.arcs_without_length,
               a.seamless_flips ? std::to_string(*a.seamless_flips) : "-",
               a.flips ? std::to_string(*a.flips) : "-", a.hexahedra, a.seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  using namespace crossgrain;
  fmt::print(
      "| mesh | cells | outcome | hexahedra | left out | worst scaled Jacobian | mean | inverted | volume | "
      "distance / size | "
      "of the model | crowded, open, pinched | s | reason "
      "|\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int k = 2; k < argc; ++k) {
    const std::string name = std::filesystem::path(argv[k]).stem().string();
    try {
      Stopwatch stopwatch;
      stopwatch.start();
      const TetFrameField field = solve_onto(TetDomain(read_tets(argv[k])).prepared_for_map());
      const double seconds = stopwatch.restart();
      std::stringstream all(argv[1]);
      for (std::string cells; std::getline(all, cells, ',');) add_row(name, field, std::stod(cells), seconds);
    } catch (const Error& error) {
      fmt::print("| {} | {} |\n", name, error.what());
    }
  }
}

// SPDX-License-Identifier: Apache-2.0
// Arrays in, hexahedra out, with the libraries core and hex alone.
#include <cstdio>

#include "crossgrain/hexahedra.hpp"
#include "crossgrain/solve.hpp"
#include "crossgrain/version.hpp"

int main() {
  const crossgrain::TetMesh cube{
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}},
      {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
  crossgrain::SolveOptions solve_options;
  solve_options.resolution = 8;
  crossgrain::HexOptions hex_options;
  hex_options.cells = 2;
  const crossgrain::TetFrameField field =
      crossgrain::solve_onto(crossgrain::TetDomain(cube).prepared_for_map(), solve_options);
  const crossgrain::Hexahedra made = crossgrain::hexahedra(field, hex_options);
  std::printf("crossgrain %s\n", crossgrain::kVersion);

  const bool is_sound =
      made.report().outcome == crossgrain::HexOutcome::kAllHex && made.mesh.hexahedra.size() == 8;
  if (!is_sound) std::fprintf(stderr, "%s\n", sentence_of(made.report()).c_str());
  return is_sound ? 0 : 1;
}

// SPDX-License-Identifier: Apache-2.0
// Prints a table of maps to the grid of repaired fields on tets, and of the hexahedra in them
// (docs/notes/hexahedra.md).
//
//   grid_maps CELLS OUT FOLDER...      folders of `crossgrain solve --repair`; CELLS hexahedra along the
//   longest side
//
// OUT gets NAME.hexex, the map for libHexEx, and NAME.mesh, the hexahedra, both in sizes of hexahedra: for
// bench/judges/same_hexahedra.py.
#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <filesystem>

#include "base/vector3.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "crossgrain/writing.hpp"
#include "hex/hex_extraction.hpp"
#include "hex/hex_map.hpp"
#include "map/integer_grid_map.hpp"
#include "reduction/demanded_splits.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

void write_both(const std::filesystem::path& path, HexMap map, HexMesh hexahedra) {
  for (auto* vertices : {&map.vertices, &hexahedra.vertices})
    for (Vector3& vertex : *vertices) vertex = (1 / map.size) * vertex;
  map.size = 1;
  write_map(map, path.string() + ".hexex");
  write_hexahedra(hexahedra, path.string() + ".mesh");
}

void add_row(double cells, const std::filesystem::path& out, const std::filesystem::path& folder) {
  const std::optional<TetFrameField> field = read_tet_field(folder);
  if (!field) return fmt::print("| {} | no field on tets |\n", folder.string());
  const std::string name =
      (folder.filename() == "repaired" ? folder.parent_path() : folder).filename().string();
  const TetDomainData& data = field->domain().data();
  const TetComplex complex(data.solid, data.features);
  const auto start = Clock::now();
  const OwnedField split =
      split_for_map(MatchedField(complex, field->data().tet_frames, matchings_of(data.solid, field->data())));
  const CutSolid cut(*split.field);
  const MapUnknowns unknowns(cut);
  const double size = longest_side(data.box) / cells;
  const MapEnergy energy(unknowns, size);
  const IntegerGridMap map = integer_grid_map(energy);
  const double mapped = seconds_since(start);
  const auto begun = Clock::now();
  const ExtractedHexahedra found = extracted_hexahedra(unknowns, map.coordinates);
  fmt::print("| {} | {:.0f} | {} | {} → {} | {} → {} | {} → {} | {} | {} | {:.2f} | {:.2f} |\n", name, cells,
             map.integers, data.solid.mesh.tets.size(), split.solid->mesh.tets.size(), map.seamless.tets,
             map.untangled.tets, map.rounded.tets, map.flips.tets, found.mesh.hexahedra.size(),
             found.left_out, mapped, seconds_since(begun));
  std::fflush(stdout);
  write_both(out / name, hex_map_of(unknowns, map, size), found.mesh);
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fputs("usage: grid_maps CELLS OUT FOLDER...\n", stderr);
    return 2;
  }
  std::filesystem::create_directories(argv[2]);
  fmt::print(
      "| mesh | cells | integers | tets, after splits | flips of the seamless map, untangled | flips "
      "rounded, untangled | "
      "hexahedra | cells left out | s, map | s, hexahedra |\n|---|---|---|---|---|---|---|---|---|---|\n");
  for (int k = 3; k < argc; ++k) crossgrain::add_row(std::atof(argv[1]), argv[2], argv[k]);
}

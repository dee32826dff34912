// SPDX-License-Identifier: Apache-2.0
// Prints the table of docs/notes/hexahedra.md: maps to the grid of repaired fields on tets, and the hexahedra
// in them.
//
//   grid_maps CELLS OUT FOLDER...      folders of `crossgrain solve --repair`; CELLS hexahedra along the
//   longest side
//
// OUT gets NAME.hexex, the map for libHexEx, and NAME.mesh, the hexahedra, both in sizes of hexahedra: for
// bench/judges/same_hexahedra.py.
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "base/vector3.hpp"
#include "crossgrain/io.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "hex/hex_extraction.hpp"
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

void write_map(const std::filesystem::path& path, const MapUnknowns& unknowns, const MapCoordinates& map,
               double scale) {
  const CutSolid& cut = unknowns.cut();
  const TetMesh& mesh = cut.field().complex().solid().mesh;
  std::ofstream out(path);
  out << mesh.vertices.size() << '\n';
  for (const Vector3& p : mesh.vertices)
    out << fmt::format("{:.17g} {:.17g} {:.17g}\n", scale * p[0], scale * p[1], scale * p[2]);
  out << mesh.tets.size() << '\n';
  for (std::uint32_t t = 0; t < mesh.tets.size(); ++t) {
    out << fmt::format("{}", fmt::join(mesh.tets[t], " "));
    for (std::size_t a = 0; a < 4; ++a) {
      for (Eigen::Index k = 0; k < 3; ++k) {
        const double value = map[static_cast<Eigen::Index>(3 * cut.copy_of(t, a)) + k];
        constexpr double kWhole = 1e-9;
        out << fmt::format(" {:.17g}",
                           std::abs(value - std::round(value)) < kWhole ? std::round(value) : value);
      }
    }
    out << '\n';
  }
}

void write_hexahedra(const std::filesystem::path& path, const HexMesh& mesh, double scale) {
  std::ofstream out(path);
  out << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << mesh.vertices.size() << '\n';
  for (const Vector3& p : mesh.vertices)
    out << fmt::format("{:.17g} {:.17g} {:.17g} 0\n", scale * p[0], scale * p[1], scale * p[2]);
  out << "Hexahedra\n" << mesh.hexahedra.size() << '\n';
  for (const auto& hexahedron : mesh.hexahedra) {
    for (const std::uint32_t v : hexahedron) out << v + 1 << ' ';
    out << "0\n";
  }
  out << "End\n";
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
  const double scale = cells / longest_side(data.box);
  const MapEnergy energy(unknowns, 1 / scale);
  const IntegerGridMap map = integer_grid_map(energy);
  const double mapped = seconds_since(start);
  const auto begun = Clock::now();
  const ExtractedHexahedra found = extracted_hexahedra(unknowns, map.coordinates);
  fmt::print("| {} | {:.0f} | {} | {} → {} | {} → {} | {} → {} | {} | {} | {:.2f} | {:.2f} |\n", name, cells,
             map.integers, data.solid.mesh.tets.size(), split.solid->mesh.tets.size(), map.seamless.tets,
             map.untangled.tets, map.rounded.tets, map.flips.tets, found.mesh.hexahedra.size(),
             found.left_out, mapped, seconds_since(begun));
  std::fflush(stdout);
  write_map(out / (name + ".hexex"), unknowns, map.coordinates, scale);
  write_hexahedra(out / (name + ".mesh"), found.mesh, scale);
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

// SPDX-License-Identifier: Apache-2.0
// Prints how many hexahedra the lattices of `hex --lattice` need beside those of lattices with even planes
// that keep as much of the model: the smallest of sizes 1, 0.84, 0.7, 0.59, ... of that asked for whose
// hexahedra, put onto the model in the same ways, keep its features, its volume and its surface, judged in
// the size asked for, and have no worse class of shapes.
//
//   even_lattices CELLS MOST_TIMES MODEL...      MOST_TIMES the hexahedra of the first are the most of the
//   others
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "hex/lattice_search.hpp"
#include "hex/lattice_trials.hpp"
#include "hex/model_fitting.hpp"
#include "lattice/lattice.hpp"
#include "lattice/lattice_axes.hpp"
#include "meshing/read_model.hpp"

namespace crossgrain {
namespace {

constexpr double kNextSize = 0.84;  // the fourth is a half

/// Planes a size apart, or a little less, between the outermost ones of the surface, and one on either side.
LatticePlanes even_planes(const Surface& along, double size) {
  LatticePlanes planes;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double low = along.box.low[axis], high = along.box.high[axis];
    const auto cells = static_cast<int>(std::max(1.0, std::round((high - low) / size)));
    for (int k = -1; k <= cells + 1; ++k) planes.at[axis].push_back(low + (high - low) * k / cells);
  }
  return planes;
}

int class_of(double least) {
  return static_cast<int>(
      std::ranges::count_if(std::array{0.02, 0.1, 0.2}, [&](double bound) { return least >= bound; }));
}

void add_row(const std::filesystem::path& path, double cells, double most_times) {
  const ReadModel read = read_model(path, {}, Monitor());
  const FittingModel& model = read.model;
  const Surface surface = outer_surface(model.features);
  const double size = longest_side(read.description.bounding_box) / cells;
  const LatticeHexahedra made = lattice_hexahedra(model, size, Monitor(), {});
  const HexReport& ours = made.report;
  const std::vector<int> shells = shells_of(made.mesh);
  std::string even = "none";
  std::size_t number = 0;
  for (double smaller = size;; smaller *= kNextSize) {
    Lattice lattice = lattice_between(surface, lattice_axes(surface),
                                      [&](const Surface& along) { return even_planes(along, smaller); });
    if (static_cast<double>(lattice.mesh.hexahedra.size()) > most_times * static_cast<double>(ours.hexahedra))
      break;
    if (lattice.shells != shells) continue;
    std::vector<Warning> warnings;
    const HexReport report =
        fit_to_model(model, {smaller, size}, FitWays::kLayersOnly, Monitor(), lattice.mesh, warnings);
    if (report.outcome != ours.outcome || class_of(report.quality.least) < class_of(ours.quality.least))
      continue;
    number = report.hexahedra;
    even = fmt::format("{} of {:.2g} sizes, worst {:.2f}", number, smaller / size, report.quality.least);
    break;
  }
  fmt::print("| {} | {} | {} | {:.2f} | {} | {} |\n", path.stem().string(), name_of(ours.outcome),
             ours.hexahedra, ours.quality.least, even,
             number > 0
                 ? fmt::format("{:.2f}", static_cast<double>(ours.hexahedra) / static_cast<double>(number))
                 : fmt::format("below {:.2f}", 1 / most_times));
  std::fflush(stdout);
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  using namespace crossgrain;
  fmt::print(
      "| model | outcome | hexahedra | worst | with even planes | ratio |\n|---|---|---|---|---|---|\n");
  for (int k = 3; k < argc; ++k) {
    try {
      add_row(argv[k], std::atof(argv[1]), std::atof(argv[2]));
    } catch (const Error& error) {
      fmt::print("| {} | {} |\n", argv[k], error.what());
    }
  }
}

// SPDX-License-Identifier: Apache-2.0
// How far the default field is from the lowest one known (docs/notes/solver.md): fields of 12 grids from 16
// to 128 cells, each with the boundary weights 1, 2, 5 and 10, are carried onto the tets, or for a surface
// onto one grid of 160 cells, and their energies are compared there.
//
//   valley_search [--all] MODEL...      MODEL as for `crossgrain solve`
//
// Prints a row for each model: energy of the default field, the lowest one found, how far the default is
// above it in per cent, where it was found, and the numbers of arcs. With --all also a row for each field.
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>

#include "crossgrain/crossgrain.hpp"
#include "solve/tuned_solve.hpp"

namespace {

using namespace crossgrain;

constexpr int kGrids = 12;
constexpr double kCoarsest = 16, kFinest = 128;
constexpr double kBoundaryWeights[] = {1, 2, 5, 10};
constexpr int kCommonResolution = 160;

struct Found {
  double energy = INFINITY;
  std::size_t arcs = 0;
  std::string where;
};

/// The energy of the field that a model has with the options of its grid.
using Carry = std::function<Found(const SolveTuning&)>;

Carry carry_onto_tets(const std::string& path) {
  const auto domain = std::make_shared<TetDomain>(read_tets(path));
  return [domain](const SolveTuning& options) {
    const TetFrameField field = solve_onto(*domain, options);
    return Found{field.report().onto->dirichlet, field.report().onto->singularity.arcs, ""};
  };
}

Carry carry_onto_grid(const std::string& path) {
  const auto mesh = std::make_shared<TriangleMesh>(read_surface(path));
  return [mesh](const SolveTuning& options) {
    SolveTuning common;
    common.resolution = kCommonResolution;
    const FrameField field =
        options.resolution == 0 ? solve(*mesh, common) : solve_from(solve(*mesh, options), *mesh, common);
    return Found{field.report().energy.total, field.report().singularity.arcs, ""};
  };
}

void search(const std::string& path, bool all) {
  const Carry carry = is_tet_file(path) ? carry_onto_tets(path) : carry_onto_grid(path);
  const Found found = carry({});
  Found best;
  for (int grid = 0; grid < kGrids; ++grid) {
    for (const double weight : kBoundaryWeights) {
      SolveTuning options;
      options.resolution =
          static_cast<int>(std::lround(kCoarsest * std::pow(kFinest / kCoarsest, grid / (kGrids - 1.0))));
      options.solver.boundary_weight = weight;
      options.onto.other_starts.clear();
      Found other = carry(options);
      other.where =
          std::to_string(options.resolution) + " cells, weight " + std::to_string(static_cast<int>(weight));
      if (all) std::printf("    %-24s %10.3f %4zu\n", other.where.c_str(), other.energy, other.arcs);
      if (other.energy < best.energy) best = other;
    }
  }
  std::printf("| %s | %.3f | %.3f | %+.2f | %s | %zu, %zu |\n", std::filesystem::path(path).stem().c_str(),
              found.energy, best.energy, 100 * (found.energy / best.energy - 1), best.where.c_str(),
              found.arcs, best.arcs);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const bool all = argc > 1 && std::strcmp(argv[1], "--all") == 0;
  if (argc < 2 + all) {
    std::fprintf(stderr, "valley_search [--all] MODEL...\n");
    return 2;
  }
  std::printf("| model | default | lowest | above it, %% | found with | arcs |\n|---|---|---|---|---|---|\n");
  for (int k = 1 + all; k < argc; ++k) search(argv[k], all);
}

// SPDX-License-Identifier: Apache-2.0
// The sweep that chose SolverTuning::crease_weight (docs/notes/solver.md).
//
//   crease_sweep RESOLUTION MODEL...      models of any kind; RESOLUTION 0: the one of the program
//
// Prints one line per weight: for a surface smoothness, the share of its area in conflicted cells, and angles
// in degrees over the rest and along creases; for tets their Dirichlet energy and the grid's creases.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/crossgrain.hpp"
#include "solve/tuned_solve.hpp"

namespace {

using namespace crossgrain;

struct Model {
  std::optional<TetDomain> tets;
  TriangleMesh surface = {};
};

Model read(const char* path) {
  if (is_tet_file(path)) return {.tets = TetDomain(read_tets(path))};
  return {.tets = std::nullopt, .surface = read_surface(path)};
}

void print(const SolveReport& report) {
  const auto& creases = report.creases.tangent_deg;
  if (report.onto) std::printf("%9.3f", report.onto->dirichlet);
  if (!report.onto)
    std::printf("%9.4g %4.1f%% %5.2f %5.2f", report.energy.smoothness,
                100 * report.alignment_deg.excluded_share, report.alignment_deg.mean.value_or(NAN),
                report.alignment_deg.p95.value_or(NAN));
  std::printf(" |%6.2f %5.2f    ", creases.mean.value_or(0), creases.p95.value_or(0));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fprintf(stderr, "crease_sweep RESOLUTION MODEL...\n");
    return 2;
  }
  std::vector<Model> models;
  std::printf("%-8s", "weight");
  for (int k = 2; k < argc; ++k) {
    models.push_back(read(argv[k]));
    const std::string path = argv[k];
    std::printf("%-*.20s", models.back().tets ? 27 : 45, path.substr(path.find_last_of('/') + 1).c_str());
  }
  std::printf("\n");
  for (const double weight : {0.0, 0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) {
    std::printf("%-8g", weight);
    for (const Model& model : models) {
      SolveTuning options;
      options.resolution = std::atoi(argv[1]);
      options.solver.crease_weight = weight;
      if (model.tets) print(solve_onto(*model.tets, options).report());
      if (!model.tets) print(solve(model.surface, options).report());
    }
    std::printf("\n");
    std::fflush(stdout);
  }
}

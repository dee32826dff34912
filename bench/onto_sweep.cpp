// SPDX-License-Identifier: Apache-2.0
// The sweep that chose the defaults of OntoTuning (docs/notes/solver.md): the Dirichlet energy on tet meshes
// for one option at a time, each over several seeds.
//
//   onto_sweep SEEDS MESH...      MESH as for `crossgrain solve`
//
// Prints one line per value: smallest .. largest energy over the seeds and the largest angle at creases for
// each mesh, and the processor seconds of all solves without reading.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "crossgrain/crossgrain.hpp"
#include "variants.hpp"

namespace {

using namespace crossgrain;

std::vector<Variant> variants() {
  std::vector<Variant> list{
      {"defaults", [](SolveTuning&) {}},
      {"degree 3", [](SolveTuning& options) { options.degree = Degree::kThree; }},
      {"smooth-only", [](SolveTuning& options) { options.boundary = TetBoundary::kSmoothOnly; }}};
  add(list, "cell_size_edges", &SolveTuning::onto, &OntoTuning::cell_size_edges, {0.7, 1.0, 1.4, 2.8});
  add(list, "crease_weight", &SolveTuning::onto, &OntoTuning::crease_weight,
      {0.1, 0.2, 1.0, 3.0, 10.0, 100.0});
  add(list, "relaxation_sweeps", &SolveTuning::onto, &OntoTuning::relaxation_sweeps,
      {0, 10, 20, 30, 60, 120});
  add(list, "symmetrisation", &SolveTuning::onto, &OntoTuning::symmetrisation, {0.0, 0.5, 1.0, 2.0, 8.0});
  add(list, "over_relaxation", &SolveTuning::onto, &OntoTuning::over_relaxation, {1.0, 1.3, 1.6, 1.8});
  add(list, "most_sweeps", &SolveTuning::onto, &OntoTuning::most_sweeps, {10, 20, 40, 300});
  add(list, "sweep_tolerance", &SolveTuning::onto, &OntoTuning::sweep_tolerance, {1e-3, 1e-4, 1e-6});
  return list;
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 0;
  if (seeds < 1 || argc < 3) {
    std::fprintf(stderr, "onto_sweep SEEDS MESH...\n");
    return 2;
  }
  std::vector<TetDomain> domains;
  std::printf("%-26s", "");
  for (int k = 2; k < argc; ++k) {
    domains.emplace_back(read_tets(argv[k]));
    const std::string name = argv[k];
    std::printf("%-27.25s", name.substr(name.find_last_of('/') + 1).c_str());
  }
  std::printf("cpu s\n");
  for (const Variant& variant : variants()) {
    std::printf("%-26s", variant.name.c_str());
    const std::clock_t begin = std::clock();
    for (const TetDomain& domain : domains) {
      double lowest = INFINITY, highest = -INFINITY, crease_deg = 0;
      for (int seed = 0; seed < seeds; ++seed) {
        SolveTuning options;
        options.seed = static_cast<std::uint64_t>(seed);
        variant.apply(options);
        const TetFrameField field = solve_onto(domain, options);
        lowest = std::min(lowest, field.report().onto->dirichlet);
        highest = std::max(highest, field.report().onto->dirichlet);
        crease_deg = std::max(crease_deg, field.report().onto->crease_deg.max.value_or(0));
      }
      std::printf("%6.3f .. %6.3f %5.1f    ", lowest, highest, crease_deg);
    }
    std::printf("%6.2f\n", static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    std::fflush(stdout);
  }
}

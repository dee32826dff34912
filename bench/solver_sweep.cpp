// SPDX-License-Identifier: Apache-2.0
// The sweep that chose the defaults of SolverTuning (docs/notes/solver.md): the final degree-4 energy on
// four generated solids for one option at a time, each over several seeds.
//
//   solver_sweep [SEEDS]      default 3
//
// Prints one line per value: smallest .. largest energy over the seeds for each solid, and the processor
// seconds of all.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "field/nested_solve.hpp"
#include "support/shapes.hpp"
#include "variants.hpp"

namespace {

using namespace crossgrain;

struct Shape {
  const char* name;
  TriangleMesh mesh;
  double cell_size;
};

std::vector<Shape> shapes() {
  const Quaternion tilt = from_rotation_vector({0.3 / std::sqrt(2.0), 0.3 / std::sqrt(2.0), 0});
  return {{"sphere", make_sphere(0.8, 4), 1.0 / 16},
          {"cylinder", rotate_mesh(make_cylinder(0.55, 0.7, 96, 16), tilt), 1.0 / 16},
          {"torus", make_torus(0.6, 0.25, 96, 48), 1.0 / 16},
          {"bracket", make_bracket(64), 1.0 / 32}};
}

std::vector<Variant> variants() {
  std::vector<Variant> list{{"defaults", [](SolveTuning&) {}},
                            {"degree 3", [](SolveTuning& options) { options.degree = Degree::kThree; }}};
  add(list, "starts", &SolveTuning::solver, &SolverTuning::starts, {1, 2, 5});
  add(list, "start_cells", &SolveTuning::solver, &SolverTuning::start_cells, {0, 100, 300, 5000});
  add(list, "start_relaxation", &SolveTuning::solver, &SolverTuning::start_relaxation, {1, 15, 50, 400});
  add(list, "level_relaxation", &SolveTuning::solver, &SolverTuning::level_relaxation, {0, 10, 20, 60, 120});
  add(list, "relaxed_cells", &SolveTuning::solver, &SolverTuning::relaxed_cells, {0, 5000, 20000});
  add(list, "symmetrisation", &SolveTuning::solver, &SolverTuning::symmetrisation,
      {0.0, 0.25, 0.5, 2.0, 4.0, 8.0});
  add(list, "over_relaxation", &SolveTuning::solver, &SolverTuning::over_relaxation, {1.0, 1.2, 1.6, 1.8});
  add(list, "most_sweeps", &SolveTuning::solver, &SolverTuning::most_sweeps, {10, 20, 200});
  add(list, "sweep_tolerance", &SolveTuning::solver, &SolverTuning::sweep_tolerance, {1e-3, 3e-4, 1e-5});
  add(list, "coarsest_cells", &SolveTuning::solver, &SolverTuning::coarsest_cells, {3, 8});
  add(list, "energy_density_threshold", &SolveTuning::solver, &SolverTuning::energy_density_threshold,
      {0.05, 1.0});
  return list;
}

}  // namespace

int main(int argc, char** argv) {
  const int seeds = argc > 1 ? std::atoi(argv[1]) : 3;
  const std::vector<Shape> solids = shapes();
  std::printf("%-34s", "");
  for (const Shape& shape : solids) std::printf("%-22s", shape.name);
  std::printf("%s\n", "cpu s");
  for (const Variant& variant : variants()) {
    std::printf("%-34s", variant.name.c_str());
    const std::clock_t begin = std::clock();
    for (const Shape& shape : solids) {
      const Surface surface = prepare_surface(shape.mesh);
      const TriangleBvh bvh(surface);
      const WindingNumber winding(bvh);
      double lowest = INFINITY, highest = -INFINITY;
      for (int seed = 0; seed < seeds; ++seed) {
        SolveTuning options;
        options.cell_size = shape.cell_size;
        options.seed = static_cast<std::uint64_t>(seed);
        variant.apply(options);
        const double energy = nested_solve({surface, bvh, winding, true}, options, Monitor{}).energy.total();
        lowest = std::min(lowest, energy);
        highest = std::max(highest, energy);
      }
      std::printf("%8.3f .. %-10.3f", lowest, highest);
    }
    std::printf("%6.2f\n", static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
    std::fflush(stdout);
  }
}

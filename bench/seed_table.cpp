// SPDX-License-Identifier: Apache-2.0
// The degree-4 energies of ten seeds on generated solids, with relaxation and without (docs/notes/solver.md).
#include <algorithm>
#include <cstdio>

#include "field/nested_solve.hpp"
#include "support/shapes.hpp"

namespace {

using namespace crossgrain;

constexpr int kSeeds = 10;

void print_row(const char* name, const TriangleMesh& mesh, Degree degree, bool relax) {
  const Surface surface = prepare_surface(mesh);
  const TriangleBvh bvh(surface);
  const WindingNumber winding(bvh);
  SolveTuning options;
  options.cell_size = 1.0 / 16;
  options.degree = degree;
  if (!relax) {
    options.solver.start_relaxation = options.solver.level_relaxation = 0;
    options.solver.starts = 1;
  }
  double lowest = INFINITY, highest = -INFINITY;
  std::printf("%-9s degree %d %-10s", name, static_cast<int>(degree), relax ? "relaxed" : "sweeps");
  for (int seed = 0; seed < kSeeds; ++seed) {
    options.seed = static_cast<std::uint64_t>(seed);
    const double energy = nested_solve({surface, bvh, winding, true}, options, Monitor{}).energy.total();
    lowest = std::min(lowest, energy);
    highest = std::max(highest, energy);
    std::printf(" %7.3f", energy);
  }
  std::printf("   spread %.2f %%\n", 100 * (highest / lowest - 1));
  std::fflush(stdout);
}

}  // namespace

int main() {
  const TriangleMesh sphere = make_sphere(0.8, 4), torus = make_torus(0.6, 0.25, 96, 48);
  for (const Degree degree : {Degree::kFour, Degree::kThree}) {
    for (const bool relax : {false, true}) {
      print_row("sphere", sphere, degree, relax);
      print_row("torus", torus, degree, relax);
    }
  }
}

// SPDX-License-Identifier: Apache-2.0
// The sweep that chose SolverTuning::diagonal_share (docs/notes/solver.md): ratios of the energies of
// rotated parts to those of the upright ones.
//
//   diagonal_sweep [PART.stl...]      default: the bracket of the tests
//
// Prints one line per share and part: smallest and largest ratio of total energies, and of smoothness, over
// 60 to 67 cells along the longest side and two rotations each, and the processor seconds of all solves.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <random>
#include <string>
#include <vector>

#include "crossgrain/reading.hpp"
#include "field/nested_solve.hpp"
#include "support/shapes.hpp"

namespace {

using namespace crossgrain;

struct Range {
  double low = INFINITY, high = -INFINITY;
  void add(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
  }
};

EnergyParts energy_of(const TriangleMesh& mesh, const SolveTuning& options) {
  const Surface surface = prepare_surface(mesh);
  const TriangleBvh bvh(surface);
  const WindingNumber winding(bvh);
  return nested_solve({surface, bvh, winding, true}, options, Monitor{}).energy;
}

std::vector<Quaternion> rotations() {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  std::vector<Quaternion> result;
  for (int k = 0; k < 2; ++k) {
    const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
    result.push_back(normalised(Quaternion{w, x, y, z}));
  }
  return result;
}

void print_line(const std::string& name, const TriangleMesh& mesh, double share) {
  const double extent = longest_side(prepare_surface(mesh).box);
  const std::clock_t begin = std::clock();
  Range total, smoothness;
  for (int cells = 60; cells < 68; ++cells) {
    SolveTuning options;
    options.cell_size = extent / cells;
    options.solver.diagonal_share = share;
    const EnergyParts upright = energy_of(mesh, options);
    for (const Quaternion& rotation : rotations()) {
      const EnergyParts turned = energy_of(rotate_mesh(mesh, rotation), options);
      total.add(turned.total() / upright.total());
      smoothness.add(turned.smoothness / upright.smoothness);
    }
  }
  std::printf("%-8.4g %-20s total %.3f .. %.3f   smoothness %.3f .. %.3f   %.1f s\n", share, name.c_str(),
              total.low, total.high, smoothness.low, smoothness.high,
              static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  std::vector<std::pair<std::string, TriangleMesh>> parts;
  for (int k = 1; k < argc; ++k) {
    const std::string path = argv[k];
    parts.emplace_back(path.substr(path.find_last_of('/') + 1), read_surface(path));
  }
  if (parts.empty()) parts.emplace_back("generated bracket", make_bracket(48));
  for (const double share : {0.0, 0.1, 1.0 / 6, 0.2, 0.225, 0.25}) {
    for (const auto& [name, mesh] : parts) print_line(name, mesh, share);
  }
}

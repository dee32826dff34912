// SPDX-License-Identifier: Apache-2.0
// Measures the energies that random frames on the tets themselves reach, with creases free: how likely the
// field of `solve --boundary smooth-only` is the minimum with normals held (docs/notes/fields.md).
//
//   tet_starts STARTS MESH      MESH as for `crossgrain solve`
//
// Each start is relaxed for 0, 60 or 300 sweeps with one of two penalties and one of three over-relaxations,
// then settled. Prints the number of starts for each energy, lowest first.
#include <cstdio>
#include <cstdlib>
#include <map>

#include "crossgrain/reading.hpp"
#include "crossgrain/tet_domain.hpp"
#include "field/field_state.hpp"
#include "field/tet_finish.hpp"
#include "measure/tet_evaluation.hpp"
#include "solve/tet_domain_data.hpp"

int main(int argc, char** argv) {
  using namespace crossgrain;
  const int starts = argc == 3 ? std::atoi(argv[1]) : 0;
  if (starts < 1) {
    std::fprintf(stderr, "tet_starts STARTS MESH\n");
    return 2;
  }
  const TetDomain domain(read_tets(argv[2]));
  const TetDomainData& tets = domain.data();
  std::map<long, int> ends;  // key: energy in thousandths
  for (int k = 0; k < starts; ++k) {
    std::vector<Quaternion> frames;
    for (const StoredQuaternion& frame :
         random_frames(tets.solid.mesh.vertices.size(), static_cast<std::uint64_t>(k)))
      frames.push_back(from_stored(frame));
    TetFinishing options;
    options.boundary = TetBoundary::kSmoothOnly;
    options.relaxation_sweeps = k % 3 == 0 ? 300 : k % 3 == 1 ? 60 : 0;
    options.symmetrisation = k % 2 == 0 ? 2 : 6;
    options.over_relaxation = 1.5 + 0.1 * (k / 6 % 3);
    options.most_sweeps = 300;
    options.sweep_tolerance = 1e-6;
    const TetFrames found =
        finish_on_tets(tets.edges, tets.boundary, {std::move(frames)}, Degree::kFour, options, Monitor());
    const double energy =
        evaluate_vertex_field(tets.solid, tets.boundary, tets.edges, found.frames).dirichlet;
    ++ends[std::lround(1000 * energy)];
  }
  int printed = 0;
  for (const auto& [energy, count] : ends) {
    std::printf("%8.3f  %d of %d\n", static_cast<double>(energy) / 1000, count, starts);
    if (++printed == 10) break;
  }
}

// SPDX-License-Identifier: Apache-2.0
// Prints the numbers of docs/notes/map-preparation.md: what TetDomain::prepared_for_map makes of tet meshes,
// and the singular edges of fields that touch the surface.
//
//   map_preparation MESH...      meshes as for `crossgrain solve`
//
// Quality is the mean ratio, 12 (3 volume)^(2/3) over the sum of squared edges: 1 for a regular tet, 0 for a
// flat one.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "base/vector3.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/solve.hpp"
#include "solve/tet_domain_data.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using Clock = std::chrono::steady_clock;

double worst_quality(const TetMesh& mesh) {
  double worst = 1;
  for (const auto& [a, b, c, d] : mesh.tets)
    worst =
        std::min(worst, mean_ratio({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c], mesh.vertices[d]}));
  return worst;
}

/// Number of tets with two or more faces on the boundary.
std::size_t crowded_tets(const TetSolid& solid) {
  std::vector<std::size_t> faces(solid.mesh.tets.size(), 0);
  for (const std::uint32_t tet : solid.boundary_tets)
    if (tet != kNoTet) ++faces[tet];
  return static_cast<std::size_t>(
      std::count_if(faces.begin(), faces.end(), [](std::size_t n) { return n > 1; }));
}

std::size_t contacts_of(const TetDomain& domain) {
  return solve_onto(domain, {}).report().onto->singularity.contacts;
}

void print_row(const std::filesystem::path& path) {
  const TetDomain given(read_tets(path));
  const auto start = Clock::now();
  const TetDomain prepared = given.prepared_for_map();
  const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
  const MapPreparation& did = prepared.preparation().value();
  std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %.3f | %.3f | %zu | %zu | %zu | %zu | %.2f |\n",
              path.stem().c_str(), did.tets_before, prepared.mesh().tets.size(), did.split_edges,
              did.split_faces, did.refused_splits, worst_quality(given.mesh()),
              worst_quality(prepared.mesh()), crowded_tets(given.data().solid),
              crowded_tets(prepared.data().solid), contacts_of(given), contacts_of(prepared), seconds);
  std::fflush(stdout);
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  std::printf(
      "| mesh | tets | after | edges | faces | refused | quality | after | two faces | after | contacts | "
      "after | s |\n");
  std::printf("|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (int k = 1; k < argc; ++k) crossgrain::print_row(argv[k]);
}

// SPDX-License-Identifier: Apache-2.0
// The sweep that chose CreaseGaps (docs/notes/solver.md).
//
//   crease_gaps ANGLE MODEL...
//
// Prints for each model, by its triangles alone, the number of edges of creases without closed gaps; then for
// each rule how many edges it adds, how many of these lie on an edge that the model states as a CAD file, and
// the number of curves with, in brackets, those that end in nothing. Knobbly spheres come last.
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/tet_domain.hpp"
#include "support/curved_shapes.hpp"
#include "surface/creases.hpp"
#include "surface/faded_creases.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace {

using namespace crossgrain;

constexpr std::array kRules{CreaseGaps{.9, 1, 10}, CreaseGaps{.8, 1, 10},  CreaseGaps{.7, 1, 0},
                            CreaseGaps{.7, 1, 5},  CreaseGaps{.7, .5, 10}, CreaseGaps{.7, 1, 10},
                            CreaseGaps{.7, 1, 20}, CreaseGaps{.6, 1, 10},  CreaseGaps{.5, 1, 10}};

struct Creases {
  std::set<std::pair<Vector3, Vector3>> edges;  ///< ends in ascending order
  std::size_t curves = 0, open = 0;
};

Creases creases_of(const std::vector<CreaseCurve>& curves) {
  Creases creases{{}, curves.size(), 0};
  std::map<Vector3, int> ends;
  for (const CreaseCurve& curve : curves) {
    ++ends[curve.points.front()], ++ends[curve.points.back()];
    for (std::size_t k = 0; k + 1 < curve.points.size(); ++k)
      creases.edges.insert(std::minmax(curve.points[k], curve.points[k + 1]));
  }
  creases.open = static_cast<std::size_t>(std::ranges::count_if(curves, [&](const CreaseCurve& curve) {
    return ends[curve.points.front()] == 1 || ends[curve.points.back()] == 1;
  }));
  return creases;
}

/// The model without the creases that a tet mesh tags.
TriangleMesh read_model(const std::string& file) {
  if (!is_tet_file(file)) return read_surface(file);
  TriangleMesh boundary = TetDomain(read_tets(file)).boundary();
  boundary.creases.clear();
  return boundary;
}

void print_row(const std::string& name, TriangleMesh mesh, double angle_deg) {
  const Creases truth = creases_of(mesh.creases);
  mesh.creases.clear();
  mesh.faces.clear();
  const Surface surface = prepare_surface(CheckedMesh::derived(weld(*CheckedMesh(std::move(mesh)))));
  CreaseAngles angles{.least_deg = angle_deg};
  angles.gaps.share = 1;
  const Creases without = creases_of(sharp_curves(surface, angles));
  std::printf("%-24.24s %5zu: %3zu (%zu)", name.c_str(), without.edges.size(), without.curves, without.open);
  for (const CreaseGaps& rule : kRules) {
    angles.gaps = rule;
    const Creases with = creases_of(sharp_curves(surface, angles));
    std::size_t added = 0, right = 0;
    for (const auto& edge : with.edges) {
      added += !without.edges.contains(edge);
      right += !without.edges.contains(edge) && truth.edges.contains(edge);
    }
    std::printf(" | +%zu", added);
    if (!truth.edges.empty()) std::printf("/%zu", right);
    std::printf(": %zu (%zu)", with.curves, with.open);
  }
  angles.gaps = {};
  const auto warning = faded_crease_warning(surface, sorted_edge_uses(surface.mesh.triangles), angles);
  std::printf("%s%s\n", warning ? "\n  " : "", warning ? sentence_of(*warning).c_str() : "");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const double angle_deg = argc > 1 ? std::atof(argv[1]) : 35;
  std::printf("share, longest, least_radii");
  for (const auto& [share, longest, least_radii] : kRules)
    std::printf(" | %g, %g, %g", share, longest, least_radii);
  std::printf("\n");
  for (int k = 2; k < argc; ++k) {
    const std::string file = argv[k];
    print_row(file.substr(file.find_last_of('/') + 1), read_model(file), angle_deg);
  }
  for (const int subdivisions : {3, 4}) {
    for (const auto& [knobs, noise] :
         {std::array{0.9, 0.0}, {0.5, 0.0}, {0.5, 0.01}, {0.0, 0.02}, {0.0, 0.03}}) {
      char name[64];
      std::snprintf(name, sizeof name, "knobs %g, noise %g, %d", knobs, noise, subdivisions);
      print_row(name, make_knobbly_sphere(subdivisions, knobs, noise, 1), angle_deg);
    }
  }
}

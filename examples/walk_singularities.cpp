// SPDX-License-Identifier: Apache-2.0
// Lists the lines around which the frames rotate, and whether a hexahedral mesh can have them. A cylinder has
// four, from one end to the other, each with three hexahedra around it.
#include <cstdio>

#include "crossgrain/crossgrain.hpp"
#include "solid_shapes.hpp"

int main() {
  using namespace crossgrain;
  try {
    SolveOptions options;
    options.resolution = 32;
    const FrameField field = solve(cylinder(0.5, 2), options);
    const SingularityGraph& graph = field.singularities();
    for (const SingularityGraph::Arc& arc : graph.arcs) {
      const Vector3 &from = arc.points.front(), &to = arc.points.back();
      std::printf("index %+.2f, length %.2f, from (%.2f, %.2f, %.2f) to (%.2f, %.2f, %.2f)\n", arc.index,
                  arc.length, from[0], from[1], from[2], to[0], to[1], to[2]);
    }
    for (const SingularityGraph::Node& node : graph.nodes)
      std::printf("%s of %zu arcs at (%.2f, %.2f, %.2f)\n", node.on_boundary ? "end" : "node", node.degree(),
                  node.place[0], node.place[1], node.place[2]);
    if (graph.arcs.size() != 4 || graph.nodes.size() != 8) return 1;
    std::puts(crossgrain::name_of(graph.verdict()));
  } catch (const Error& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

# SPDX-License-Identifier: Apache-2.0
"""Lists the singular arcs of a field: around which the hexahedra of a mesh are not four."""

import crossgrain as cg
from solids import cylinder

field = cg.solve(*cylinder(), resolution=48)
graph = field.singularities
print(f"{len(graph.arcs)} arcs, {len(graph.nodes)} nodes: {graph.verdict}")
for arc in graph.arcs:
    ends = "closed" if arc.is_closed else " to ".join("surface" if graph.nodes[node].on_boundary else "inside" for node in arc.nodes)
    print(f"  valence {arc.valence}, length {arc.length:.2f}, {ends}, through {arc.points[len(arc.points) // 2].round(2)}")

# A cylinder has four arcs of valence three from end to end.
assert [arc.valence for arc in graph.arcs] == [3] * 4

# SPDX-License-Identifier: Apache-2.0
"""The arcs and nodes of onto_singularities.vtu, put on the singular edges of the field: every edge belongs to one arc, to a
node of several vertices, or to a loop or stub that is too short to be an arc."""

from collections import Counter, defaultdict
from pathlib import Path

import numpy as np

from judge_lines import LOOP_CELLS, MERGE_CELLS, ArcJudgement
from recompute_singularity import Graph

NEAR = 1.1  # margin of lengths in cells: how the size of a cell is averaged is left open


class ArcsOnEdges:
    """`arcs`: an ArcJudgement each. `faults`: lines about edges that belong to nothing or twice. Numbers of lines too short to
    be arcs: `loops`, `stubs` of third turns, `arches` from the surface to a neighbouring vertex of it, `lone_nodes` whose
    lines are all short. `ends`: vertices where arcs end."""

    def __init__(self, folder, lines):
        self.graph, self.lines, self.field = Graph(Path(folder) / "onto_singularities.vtu"), lines, lines.field
        self.vertices = [self.graph.arrays["vertex"][arc].tolist() for arc in self.graph.arcs]
        self.faults, self.used = [], Counter()
        self.edges = [self.known_edges(i, names) for i, names in enumerate(self.vertices)]
        self.joined = defaultdict(set)  # vertices of each node of several vertices, by its point
        for i, names in enumerate(self.vertices):
            self.find_hidden_edges(i, names)
        self.faults += [f"arc_list[{i}] goes through vertex {v}, where {len(lines.at[v])} singular edges meet"
                        for i, names in enumerate(self.vertices) for v in names[1:-1] if v >= 0 and len(lines.at[v]) != 2]
        self.faults += [f"edge {e} of the field belongs to {n} arcs" for e, n in self.used.items() if n > 1]
        self.sort_left_over(set(lines.turns) - set(self.used))
        points = self.graph.points
        self.arcs = [ArcJudgement(lines, edges, names, points[arc])
                     for edges, names, arc in zip(self.edges, self.vertices, self.graph.arcs)]
        self.find_ends()

    def known_edges(self, i, names):
        """The edges of an arc, -1 where an end is a node of several vertices."""
        edges = []
        for a, b in zip(names[:-1], names[1:]):
            edge = self.field.number.get((min(a, b), max(a, b)), -1) if min(a, b) >= 0 else -1
            if min(a, b) >= 0 and edge not in self.lines.turns:
                self.faults.append(f"arc_list[{i}]: the edge from vertex {a} to {b} is not singular")
                edge = -1
            if edge >= 0:
                self.used[edge] += 1
            edges.append(edge)
        return edges

    def find_hidden_edges(self, i, names):
        """Gives an arc the edges by which it leaves nodes of several vertices: those at its next vertex that no arc has."""
        for k, (a, b) in enumerate(zip(names[:-1], names[1:])):
            if (a < 0) == (b < 0):
                continue
            vertex, point = (b, self.graph.arcs[i][k]) if a < 0 else (a, self.graph.arcs[i][k + 1])
            free = [e for e in self.lines.at[vertex] if not self.used[e]]
            if not free:
                self.faults.append(f"arc_list[{i}]: no singular edge leads from vertex {vertex} to the node at its end")
                continue
            place = self.graph.points[point]
            edge = min(free, key=lambda e: np.linalg.norm(self.field.points[self.lines.other_end(e, vertex)] - place))
            self.edges[i][k] = edge
            self.used[edge] += 1
            self.joined[point].add(self.lines.other_end(edge, vertex))

    def cells(self, edges):
        return sum(self.field.length[e] / self.field.edge_size[e] for e in edges)

    def sort_left_over(self, left):
        """Loops, stubs, and the short lines of which nodes of several vertices consist."""
        self.loops = self.stubs = self.arches = self.lone_nodes = 0
        while left:
            group, waiting = set(), [next(iter(left))]
            while waiting:
                edge = waiting.pop()
                if edge in left:
                    left.remove(edge)
                    group.add(edge)
                    waiting += [e for v in self.field.edges[edge].tolist() for e in self.lines.at[v]]
            self.sort_group(group)

    def sort_group(self, group):
        degrees = Counter(v for e in group for v in self.field.edges[e].tolist())
        vertices = set(degrees)
        nodes = [point for point, own in self.joined.items() if own & vertices]
        for point in nodes:
            self.joined[point] |= vertices
        ends = sorted(v for v in vertices if degrees[v] == 1)
        cells = self.cells(group)
        if len(nodes) > 1:
            self.faults.append(f"{len(group)} edges at vertex {min(vertices)} belong to {len(nodes)} nodes")
        elif nodes or max(degrees.values()) > 2:
            if cells > NEAR * LOOP_CELLS * len(group):
                self.faults.append(f"{len(group)} edges at vertex {min(vertices)} make a node of {cells:.1f} cells")
            self.lone_nodes += not nodes
        elif not ends and cells <= NEAR * LOOP_CELLS:
            self.loops += 1
        elif len(ends) == 2 and cells <= NEAR * MERGE_CELLS and all(self.lines.turns[e].quarters == 0 for e in group):
            self.stubs += 1
        elif len(ends) == 2 and cells <= NEAR * LOOP_CELLS and tuple(ends) in self.field.number:
            self.arches += 1
        else:
            self.faults.append(f"{len(group)} singular edges, one at vertex {min(vertices)}, belong to no arc")

    def find_ends(self):
        self.ends = set()
        for i, names in enumerate(self.vertices):
            if not self.graph.is_closed(i):
                for k in (0, -1):
                    self.ends |= {names[k]} if names[k] >= 0 else self.joined[self.graph.arcs[i][k]]

    def contacts(self):
        """Number of singular edges with one end on the surface where no arc ends."""
        count = 0
        for edge in self.lines.turns:
            touching = [v for v in self.field.edges[edge].tolist() if self.field.on_surface[v]]
            count += len(touching) == 1 and touching[0] not in self.ends
        return count

    def is_on_boundary(self, node):
        """Whether an arc reaches the surface at a node: at a vertex on it, or as the only one at several vertices."""
        vertex = self.graph.arrays["vertex"][node]
        own = {int(vertex)} if vertex >= 0 else self.joined[node]
        return any(self.field.on_surface[v] for v in own) or len(self.graph.arcs_at(node)) == 1

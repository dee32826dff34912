# SPDX-License-Identifier: Apache-2.0
"""Recomputes `singularity` of report.json from singularities.vtu, or that of tets from onto_singularities.vtu."""

import numpy as np

from field_reader import read_arrays

TYPES = ["regular", "changing", "no_axis"]
VERDICTS = ["meshable", "not_meshable", "undecided"]
VTK_POLY_LINE = 4

# Pairs (arcs of index 1/4, arcs of index -1/4) for which the sphere has a triangulation with vertices of valence 3, 5, and
# otherwise 4.
MESHABLE_NODES = {(4, 0), (2, 0), (2, 2), (0, 2), (1, 3), (0, 4), (2, 6), (0, 6), (0, 8), (0, 12)}


class Graph:
    def __init__(self, path):
        self.arrays = read_arrays(path)
        self.points = self.arrays["Points"].reshape(-1, 3)
        ends = [0, *self.arrays["offsets"]]
        self.arcs = [self.arrays["connectivity"][a:b] for a, b in zip(ends[:-1], ends[1:])]
        assert (self.arrays["types"] == VTK_POLY_LINE).all()
        # Points that are nodes come first, in their order.
        self.nodes = np.flatnonzero(self.arrays["node"] >= 0)
        assert (self.arrays["node"][self.nodes] == np.arange(len(self.nodes))).all()

    def arcs_at(self, node):
        return [i for i, arc in enumerate(self.arcs) for end in (arc[0], arc[-1]) if end == node and not self.is_closed(i)]

    def is_closed(self, i):
        return bool(self.arcs[i][0] == self.arcs[i][-1] and self.arcs[i][0] not in self.nodes)

    def length(self, i):
        return np.linalg.norm(np.diff(self.points[self.arcs[i]], axis=0), axis=1).sum()

    def half_way(self, i):
        points = self.points[self.arcs[i]]
        along = np.cumsum([0, *np.linalg.norm(np.diff(points, axis=0), axis=1)])
        return [np.interp(along[-1] / 2, along, points[:, k]) for k in range(3)]

    def arc_verdict(self, i):
        """That of the file, if it is one that an arc of this type and index may have."""
        of_file = VERDICTS[self.arrays["verdict"][i]]
        if TYPES[self.arrays["type"][i]] == "changing" or self.arrays["index"][i] == 0.5:
            return "not_meshable"
        possible = {"regular": ("meshable", "undecided"), "no_axis": ("not_meshable", "undecided")}
        return of_file if of_file in possible[TYPES[self.arrays["type"][i]]] else None

    def node_verdict(self, node):
        arcs = self.arcs_at(node)
        verdicts = [self.arc_verdict(i) for i in arcs]
        indices = [self.arrays["index"][i] for i in arcs]
        if self.arrays["node_on_boundary"][node]:
            # Arcs of n hexahedra that meet on the surface leave 4 - sum (4 - n).
            leaves_room = "not_meshable" in verdicts or 4 - sum(4 * index for index in indices) >= 1
            return "meshable" if leaves_room else "undecided"
        for verdict in ("not_meshable", "undecided"):
            if verdict in verdicts:
                return verdict
        if any(abs(index) == 0.5 for index in indices):
            # Euler's formula leaves a whole number of regular edges, or there is no such sphere; the rest is for tests/singularity.
            twice_regular = 12 - sum(2 + 4 * index for index in indices)
            return None if twice_regular >= 0 and twice_regular % 2 == 0 else "not_meshable"
        return "meshable" if (indices.count(0.25), indices.count(-0.25)) in MESHABLE_NODES else "not_meshable"


def worst(verdicts):
    return next((verdict for verdict in ("not_meshable", "undecided") if verdict in verdicts), "meshable")


def graph_faults(name, section, path):
    """One line for each number of a section of the report that is not what the file says. Not `edges`, `length`, what is too
    short, contacts, creases and corners, which are not in it."""
    graph = Graph(path)
    on_boundary = graph.arrays["node_on_boundary"]
    faults = []

    def compare(key, reported, expected, tolerance=0.0):
        same = reported == expected if tolerance == 0 else np.allclose(reported, expected, rtol=0, atol=tolerance)
        if not same:
            faults.append(f"{name}.{key}: {reported} in the report, {expected} recomputed")

    size = np.ptp(graph.points, axis=0).max() if len(graph.points) else 1
    compare("arcs", section["arcs"], len(graph.arcs))
    compare("arc_list", len(section["arc_list"]), len(graph.arcs))
    compare("node_list", len(section["node_list"]), len(graph.nodes))
    for i, arc in enumerate(section["arc_list"][: len(graph.arcs)]):
        ends = [] if graph.is_closed(i) else [int(graph.arcs[i][0]), int(graph.arcs[i][-1])]
        compare(f"arc_list[{i}].nodes", arc["nodes"], ends)
        compare(f"arc_list[{i}].length", arc["length"], graph.length(i), 1e-9 * size)
        compare(f"arc_list[{i}].place", arc["place"], graph.half_way(i), 1e-6 * size)
        compare(f"arc_list[{i}].type", arc["type"], TYPES[graph.arrays["type"][i]])
        compare(f"arc_list[{i}].index", arc["index"], graph.arrays["index"][i])
        compare(f"arc_list[{i}].verdict", arc["verdict"], graph.arc_verdict(i))
        compare(f"arc_list[{i}].oblique_length", arc["oblique_length"], graph.arrays["oblique_length"][i])
        compare(f"arc_list[{i}].on_boundary", arc["on_boundary"], any(bool(on_boundary[end]) for end in ends))
        compare(f"on_boundary[{i}]", bool(graph.arrays["on_boundary"][i]), arc["on_boundary"])
        compare(f"closed[{i}]", bool(graph.arrays["closed"][i]), not ends)
    for k, node in enumerate(section["node_list"][: len(graph.nodes)]):
        compare(f"node_list[{k}].place", node["place"], graph.points[k], 1e-12 * size)
        compare(f"node_list[{k}].on_boundary", node["on_boundary"], bool(on_boundary[k]))
        compare(f"node_list[{k}].arcs", node["arcs"], graph.arcs_at(k))
        compare(f"node_list[{k}].degree", graph.arrays["node_degree"][k], len(graph.arcs_at(k)))
        compare(f"node_list[{k}].verdict", node["verdict"], graph.node_verdict(k) or node["verdict"])
        compare(f"node_verdict[{k}]", VERDICTS[graph.arrays["node_verdict"][k]], node["verdict"])
    verdicts = [graph.arc_verdict(i) for i in range(len(graph.arcs))]
    node_verdicts = [node["verdict"] for node in section["node_list"]]
    compare("boundary_ends", section["boundary_ends"], int(on_boundary[: len(graph.nodes)].sum()))
    compare("nodes", section["nodes"], sum(len(graph.arcs_at(k)) > 1 for k in range(len(graph.nodes))))
    compare("not_meshable_arcs", section["not_meshable_arcs"], verdicts.count("not_meshable"))
    compare("not_meshable_nodes", section["not_meshable_nodes"], node_verdicts.count("not_meshable"))
    compare("undecided_nodes", section["undecided_nodes"], node_verdicts.count("undecided"))
    compare("verdict", section["verdict"], worst(verdicts + node_verdicts))
    return faults

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Counts the different singular graphs of a part over resolutions, and over rotations at 128 cells (docs/notes/solver.md).

    topologies.py PROGRAM MODEL...           one row for each model: classes of equal graphs, energies, processor seconds
    topologies.py PROGRAM --list MODEL...    and one for each solve, with the arcs that differ from the largest class

Graphs are equal if their arcs can be paired: the same index, closed or not, and ends within two cells of the coarser
result. Before, nodes within a cell of each other are merged. Rotations are made of triangles with numpy and of CAD files
with gmsh (Debian package gmsh).
"""

import json
import resource
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from scipy.optimize import linear_sum_assignment

SIZES = (64, 96, 128, 160, 192, 256, 320)
ROTATIONS = 5
ROTATED_SIZE = 128
SEED = 7
CAD = (".step", ".stp", ".iges", ".igs", ".brep")
REACH_CELLS = 2
MERGED_CELLS = 1


class Graph:
    """Singular lines of a result: ends of arcs (n, 2, 3), nan where closed, their indices and lengths."""

    def __init__(self, report, turn):
        singularity = report["singularity"]
        nodes = np.array([node["place"] for node in singularity["node_list"]]).reshape(-1, 3) @ turn
        box = [report["model"]["bounding_box"][key] for key in ("low", "high")]
        self.cell = np.ptp(box, axis=0).max() / report["resolution"]
        merged = merged_nodes(nodes, MERGED_CELLS * self.cell)
        self.ends, self.kinds, self.lengths = [], [], []
        for arc in singularity["arc_list"]:
            ends = [merged[node] for node in arc["nodes"]]
            if len(ends) == 2 and ends[0] is ends[1] and arc["length"] < 3 * self.cell:
                continue
            self.ends.append(np.array(ends) if ends else np.full((2, 3), np.nan))
            self.kinds.append((arc["index"], arc["type"], not ends))
            self.lengths.append(arc["length"])

    def same_as(self, other):
        return not any(self.differences(other))

    def differences(self, other):
        """How many arcs of each have no partner in the other."""
        return tuple(map(len, self.unpaired(other)))

    def unpaired(self, other):
        """The numbers of the arcs of each that have no partner in the other."""
        reach = REACH_CELLS * max(self.cell, other.cell)
        allowed = np.zeros((len(self.ends), len(other.ends)), bool)
        for i, (a, kind) in enumerate(zip(self.ends, self.kinds)):
            for j, (b, other_kind) in enumerate(zip(other.ends, other.kinds)):
                if kind != other_kind:
                    continue
                if kind[2]:
                    allowed[i, j] = abs(self.lengths[i] - other.lengths[j]) < 0.2 * max(self.lengths[i], other.lengths[j])
                    continue
                apart = min(np.linalg.norm(a - b, axis=1).max(), np.linalg.norm(a - b[::-1], axis=1).max())
                allowed[i, j] = apart <= reach
        rows, columns = linear_sum_assignment(~allowed)
        paired = allowed[rows, columns]
        return (sorted(set(range(len(self.ends))) - set(rows[paired])),
                sorted(set(range(len(other.ends))) - set(columns[paired])))

    def arc_text(self, arc):
        ends = " to ".join("(" + ", ".join(f"{x:.1f}" for x in end) + ")" for end in self.ends[arc])
        index, kind, closed = self.kinds[arc]
        return f"{kind} {index} {'closed' if closed else ends}, length {self.lengths[arc]:.1f}"


def merged_nodes(nodes, reach):
    """For each node the mean place of those it is merged with, the same object for all of them."""
    group = list(range(len(nodes)))

    def root(i):
        while group[i] != i:
            i = group[i]
        return i

    for i in range(len(nodes)):
        for j in range(i):
            if np.linalg.norm(nodes[i] - nodes[j]) <= reach:
                group[root(i)] = root(j)
    roots = [root(i) for i in range(len(nodes))]
    means = {r: nodes[[s == r for s in roots]].mean(axis=0) for r in set(roots)}
    return [means[r] for r in roots]


def rotation(random):
    w, x, y, z = (lambda q: q / np.linalg.norm(q))(random.normal(size=4))
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def read_triangles(path):
    """Corners of all triangles, (n, 3, 3)."""
    if path.suffix.lower() == ".stl":
        facet = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
        return np.frombuffer(path.read_bytes(), facet, offset=84)["corners"].astype(float)
    if path.suffix.lower() == ".ply":
        header, _, body = path.read_bytes().partition(b"end_header\n")
        counts = [int(line.split()[2]) for line in header.decode().splitlines() if line.startswith("element")]
        if b"format ascii" not in header:
            vertices = np.frombuffer(body, "<f4", 3 * counts[0]).reshape(-1, 3)
            face = np.dtype([("count", "u1"), ("corners", "<i4", 3)])
            return vertices[np.frombuffer(body, face, counts[1], 12 * counts[0])["corners"]].astype(float)
        rows = body.decode().splitlines()
        vertices = np.array([row.split()[:3] for row in rows[:counts[0]]], float)
        return vertices[np.array([row.split()[1:4] for row in rows[counts[0]:counts[0] + counts[1]]], int)]
    sys.exit(f"{path}: cannot be rotated here")


def write_rotated(path, turn, folder):
    """The file of the rotated model."""
    if path.suffix.lower() in CAD:
        angle = np.arccos(np.clip((np.trace(turn) - 1) / 2, -1, 1))
        axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]])
        script, result = folder / "turn.geo", folder / "turned.brep"
        script.write_text(f'SetFactory("OpenCASCADE");\nv() = ShapeFromFile("{path.resolve()}");\nRotate {{{{{axis[0]}, {axis[1]}, '
                          f'{axis[2]}}}, {{0, 0, 0}}, {angle}}} {{ Volume{{v()}}; }}\n')
        subprocess.run(["gmsh", script, "-0", "-o", result, "-format", "brep"], check=True, capture_output=True)
        return result
    corners = read_triangles(path) @ turn.T
    records = np.zeros(len(corners), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")]))
    records["corners"] = corners
    result = folder / "turned.stl"
    result.write_bytes(bytes(80) + struct.pack("<I", len(records)) + records.tobytes())
    return result


def solved(program, model, size, turn, folder):
    before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
    cell = ["--resolution", str(size)] if isinstance(size, int) else ["--cell-size", repr(size)]
    run = subprocess.run([program, "solve", model, *cell, "-o", folder / "out", "--quiet", "--no-report"], check=False)
    if run.returncode not in (0, 5):
        sys.exit(f"{model}: exit code {run.returncode}")
    seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
    report = json.loads((folder / "out" / "report.json").read_text())
    return Graph(report, turn), report, seconds


def classes(graphs):
    """Numbers the graphs so that equal ones have the same number, the largest class first."""
    same = np.array([[a.same_as(b) for b in graphs] for a in graphs])
    left, number = set(range(len(graphs))), [0] * len(graphs)
    for label in range(len(graphs)):
        if not left:
            break
        centre = max(sorted(left), key=lambda i: sum(same[i, j] for j in left))
        members = {j for j in left if same[centre, j]}
        for j in members:
            number[j] = label
        left -= members
    return number


def row(program, model, listed):
    random = np.random.default_rng(SEED)
    with tempfile.TemporaryDirectory(prefix="crossgrain-topologies-") as name:
        folder = Path(name)
        results = [solved(program, model, size, np.eye(3), folder) for size in SIZES]
        cell = results[SIZES.index(ROTATED_SIZE)][0].cell
        for _ in range(ROTATIONS):
            turn = rotation(random)
            results.append(solved(program, write_rotated(model, turn, folder), float(cell), turn, folder))
    graphs = [graph for graph, _, _ in results]
    size_classes = classes(graphs[:len(SIZES)])
    standing_classes = classes([graphs[SIZES.index(ROTATED_SIZE)], *graphs[len(SIZES):]])
    arcs = [len(graph.ends) for graph in graphs]
    print(f"| {model.stem} | {size_classes.count(0)} of {len(SIZES)}: {letters(size_classes)}, arcs {text(arcs[:len(SIZES)])} | "
          f"{standing_classes.count(0)} of {1 + ROTATIONS}: {letters(standing_classes)}, arcs {text(arcs[len(SIZES):])} | "
          f"{sum(seconds for _, _, seconds in results):.1f} |", flush=True)
    if listed:
        names = [*SIZES, *(f"turned {k}" for k in range(ROTATIONS))]
        centre = graphs[size_classes.index(0)]
        for label, (graph, report, seconds) in zip(names, results):
            energy = report["energy"]
            print(f"    {label}: arcs {len(graph.ends)}, not paired {graph.differences(centre)}, energy {energy['total']:.4f}, "
                  f"verdict {report['verdict']}, walls {report['walls'].get('thin_share', 0)}, {seconds:.2f} s", flush=True)
            for side, owner, arcs in zip(("here", "there"), (graph, centre), graph.unpaired(centre)):
                for arc in arcs:
                    print(f"        only {side}: {owner.arc_text(arc)}", flush=True)


def letters(numbers):
    return "".join(chr(ord("a") + number) for number in numbers)


def text(numbers):
    return " ".join(map(str, numbers))


def main():
    arguments = [argument for argument in sys.argv[1:] if argument != "--list"]
    if len(arguments) < 2:
        sys.exit(__doc__.strip())
    print("| part | sizes 64 to 320 | at 128 and rotated | processor s |\n|---|---|---|---|")
    for model in arguments[1:]:
        row(arguments[0], Path(model), "--list" in sys.argv)


if __name__ == "__main__":
    main()

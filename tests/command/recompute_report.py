#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Recomputes the numbers of a report.json from the model (a binary STL file) and field.vtu, with code of its own.

    recompute_report.py MODEL.stl DIR        with CROSSGRAIN_PROGRAM naming the program

The frames between cells come from `crossgrain sample`. Not recomputed, since the files do not tell: what happened on
levels between the coarsest and the finest, and times, which are only checked for being possible.
"""

import json
import sys
from collections import Counter
from pathlib import Path

import numpy as np
from creases import Creases
from field_reader import FACES, Field
from frame_math import (boundary_form, coefficients, cubic_spectrum, deviation, frame_product, least_near, matching,
                        normal_energy)
from program import run
from recompute_contacts import Turn, contacts
from recompute_singularity import graph_faults
from surface_pieces import Surface, pieces_by_cell

# Constants of the program that the report's numbers depend on.
BOUNDARY_WEIGHT = 10
CREASE_WEIGHT = 0.25
DIAGONAL_SHARE = 0.2
SAME_NORMAL = 3e-12
SAME_EIGENVALUE, FITS = 0.1, 0.15
FACE_SAMPLES = 4
CLASSES = ("", "plane", "axis", "frame", "free", "conflicted")  # of constraint_class in field.vtu
TIE = 0.5 / FACE_SAMPLES**2
STARTS = [np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0] for seed in range(4)]
WALL_CELLS, WALL_COSINE, SHEET_AREA = 4, 0.5, 0.1
UNRESOLVED_SHARE, DECIDING_WALL_CELLS, THIN_SHARE = 0.02, 2.5, 0.02


class Recomputation:
    def __init__(self, model, folder):
        self.folder = Path(folder)
        self.field = Field(self.folder / "field.vtu")
        self.surface = Surface(model)
        self.pieces = pieces_by_cell(self.surface, self.field.low, self.field.size)
        self.inside = self.surface.inside(self.field.centre)
        self.creases = Creases(self.surface)
        self.tangents = self.creases.by_cell(self.field.low, self.field.size)
        self.boundary = [i for i in range(len(self.field)) if self.pieces[i]]
        self.classes = {i: self.constraint_class(i) for i in self.boundary}
        faces, self.ties = self.connect()
        self.edges = self.with_diagonals(faces)

    def normals_and_areas(self, i):
        triangles, areas, _ = zip(*self.pieces[i])
        return self.surface.normals[list(triangles)], np.array(areas)

    def directions_and_areas(self, i):
        """What frames are to have an axis along: normals of surface and tangents of creases."""
        normals, areas = self.normals_and_areas(i)
        tangents = [tangent for tangent, _ in self.tangents[i]]
        return np.vstack([normals, *tangents]), np.append(areas, [CREASE_WEIGHT * area for _, area in self.tangents[i]])

    def has_single_normal(self, i):
        normals, _ = self.normals_and_areas(i)
        return not self.tangents[i] and (np.cross(normals, normals[0]) ** 2).sum(axis=1).max() <= SAME_NORMAL

    def largest(self, i):
        return max(self.pieces[i], key=lambda piece: piece[1])

    def constraint_class(self, i):
        if self.has_single_normal(i):
            return "plane"
        eigenvalues = cubic_spectrum(*self.directions_and_areas(i))
        multiplicity = int((eigenvalues <= eigenvalues[0] + SAME_EIGENVALUE).sum())
        fits = eigenvalues[0] <= FITS
        return {(7, True): "free", (7, False): "free", (2, True): "plane", (2, False): "axis",
                (1, True): "frame"}.get((multiplicity, fits), "conflicted")

    # The graph of cells.

    def open_fraction(self, i, face):
        """Of a face, by what the segments from the centre to a grid of points on it cross."""
        axis, sign = FACES[face]
        steps = (np.arange(FACE_SAMPLES) + 0.5) / FACE_SAMPLES - 0.5
        offsets = np.empty((FACE_SAMPLES**2, 3))
        offsets[:, axis] = 0.5 * sign
        offsets[:, (axis + 1) % 3] = np.repeat(steps, FACE_SAMPLES)
        offsets[:, (axis + 2) % 3] = np.tile(steps, FACE_SAMPLES)
        chosen = [triangle for triangle, _, _ in self.pieces[i]]
        entered = self.surface.entered_along(chosen, self.field.centre[i], self.field.size[i] * offsets)
        return np.mean(self.inside[i] + entered > 0)

    def connect(self):
        """[(i, j, weight)] and how many of them are ties of cells without an open face."""
        edges, ties = [], 0
        field = self.field
        for i in range(len(field)):
            for face, (_, sign) in enumerate(FACES):
                said = field.open_faces[i] >> face & 1
                j = field.neighbour(i, face)
                if j is None:
                    assert not said
                    continue
                same = field.depth[i] == field.depth[j]
                fraction = 0.0
                if not (same and sign < 0):
                    fraction = self.open_fraction(i, face) if self.pieces[i] and self.pieces[j] else 1.0
                assert said or fraction == 0, f"cell {i}, face {face}: open, but field.vtu says closed"
                if said and fraction == 0:
                    ties += 1
                    fraction = TIE
                if said:
                    edges.append((i, j, fraction * self.weight(i, face, j)))
        return edges, ties

    def weight(self, i, face, j):
        field = self.field
        weight = field.size[i] ** 2 / (0.5 * (field.size[i] + field.size[j]))
        siblings = field.depth[i] == field.depth[j] and all(
            a >> 1 == b >> 1 for a, b in zip(field.place[i], field.place[j]))
        if siblings:
            beside = [field.neighbour(i, other) for other in range(6) if FACES[other][0] != FACES[face][0]]
            weight *= 1 - sum(k is not None and field.depth[k] < field.depth[i] for k in beside) / 3
        return weight

    def with_diagonals(self, edges):
        """Takes weight off the faces around every edge where four cells of equal size are joined all around, and
        gives it to the diagonals: DIAGONAL_SHARE of the smallest weight."""
        field = self.field
        at = {(int(field.depth[i]), tuple(int(x) for x in field.place[i])): i for i in range(len(field))}
        faces = {frozenset(edge[:2]): (k, edge[2]) for k, edge in enumerate(edges)}
        given = np.zeros(len(edges))
        diagonals = []
        for (depth, place), i in at.items():
            for a, b in ((0, 1), (0, 2), (1, 2)):
                step_a, step_b = np.eye(3, dtype=int)[[a, b]]
                ring = [at.get((depth, tuple(place + step))) for step in (0 * step_a, step_a, step_a + step_b, step_b)]
                sides = [faces.get(frozenset((ring[k], ring[k - 1]))) for k in range(4)]
                if None in ring or None in sides:
                    continue
                share = DIAGONAL_SHARE * min(weight for _, weight in sides)
                given[[k for k, _ in sides]] += share
                diagonals += [(ring[0], ring[2], share), (ring[1], ring[3], share)]
        return [(i, j, weight - less) for (i, j, weight), less in zip(edges, given)] + diagonals

    # Sections of the report; each gives {key: (value, tolerance)}.

    def model(self):
        watertight, components = self.surface.topology()
        points = self.surface.triangles.reshape(-1, 3)
        return {"triangles": (len(self.surface.triangles), 0), "watertight": (watertight, 0),
                "components": (components, 0), "bounding_box.low": (points.min(axis=0), 0),
                "bounding_box.high": (points.max(axis=0), 0)}

    def energy(self):
        field = self.field
        i, j, weight = (np.array(column) for column in zip(*self.edges))
        change = weight * (1 - frame_product(field.axes[i], field.axes[j]))
        density = (np.bincount(i, change, len(field)) + np.bincount(j, change, len(field))) / (2 * field.size**3)
        np.testing.assert_allclose(field.arrays["energy_density"], density, rtol=2e-4,
                                   atol=1e-5 * density.max() + 1e-12 / field.size.min() ** 2)
        constraints = {i: self.directions_and_areas(i) for i in self.boundary}
        boundary = sum(BOUNDARY_WEIGHT / field.size[i] * area * normal_energy(direction, field.axes[i])
                       for i in self.boundary for direction, area in zip(*constraints[i]))
        smoothness = change.sum()
        unavoidable = sum(BOUNDARY_WEIGHT / field.size[i] * self.least_boundary_energy(i) for i in self.boundary)
        boundary -= unavoidable
        # Where a frame fits, all of this is rounding of numbers about 1.
        rounding = 1e-12 * sum(BOUNDARY_WEIGHT / field.size[i] * constraints[i][1].sum() for i in self.boundary)
        return {"smoothness": (smoothness, 1e-4 * smoothness + rounding),
                "boundary": (boundary, 1e-4 * boundary + 1e-6 * unavoidable + rounding),
                "unavoidable": (unavoidable, 1e-4 * unavoidable + rounding),
                "total": (smoothness + boundary, 1e-4 * (smoothness + boundary) + 1e-6 * unavoidable + rounding),
                "deviation_max": self.largest_deviation()}

    def least_boundary_energy(self, i):
        if self.has_single_normal(i):
            return 0
        form = boundary_form(*self.directions_and_areas(i))
        return max(0, min(least_near(form, axes) for axes in (self.field.axes[i], *STARTS)))

    def largest_deviation(self):
        written = self.field.arrays["coefficients"].astype(float)
        degree = (written.shape[1] - 1) // 2
        expected = coefficients(degree, self.field.axes)
        if degree == 3:
            expected *= np.sign((expected * written).sum(axis=1, keepdims=True))
        np.testing.assert_allclose(written, expected, rtol=0, atol=1e-6)
        of_cells = deviation(degree, written)
        # Differences of numbers about 10 that agree in half of their digits, then squared.
        np.testing.assert_allclose(self.field.arrays["deviation"], of_cells, rtol=1e-5, atol=1e-18)
        return of_cells.max(), 1e-5 * of_cells.max()

    def sampled(self, points):
        """The axes of the frames there, of which none is outside."""
        text = "\n".join(" ".join(map(repr, map(float, point))) for point in points)
        result = run("sample", self.folder, "-", stdin=text.encode())
        assert result.stderr.startswith(f"crossgrain: 0 of {len(points)} "), result.stderr
        return np.loadtxt(result.stdout.splitlines()).reshape(-1, 3, 3)

    def alignment_deg(self):
        pieces = [(i, *piece) for i in self.boundary for piece in self.pieces[i]]
        owner, triangle, area, centroid = (np.array(column) for column in zip(*pieces))
        angle = nearest_axis_deg(self.sampled(centroid), self.surface.normals[triangle])
        cell_area = np.bincount(owner, area, len(self.field))
        mean = np.bincount(owner, area * angle, len(self.field)) / np.where(cell_area > 0, cell_area, 1)
        np.testing.assert_allclose(self.field.arrays["alignment_deg"], mean, rtol=0, atol=2e-3)
        kept = np.array([self.classes[i] in ("plane", "frame") for i in owner])
        mean, p95, most = weighted_statistics(angle[kept], area[kept])
        return {"mean": (mean, 1e-3), "p95": (p95, 2e-3), "max": (most, 2e-3),
                "excluded_share": (1 - area[kept].sum() / area.sum(), 1e-5)}

    def spectrum(self):
        written = self.field.arrays["constraint_class"]
        np.testing.assert_array_equal(written, [CLASSES.index(self.classes.get(i, "")) for i in range(len(self.field))])
        count = Counter(self.classes.values())
        return {name: (count[name], 0) for name in ("plane", "axis", "frame", "free", "conflicted")}

    def singularity(self):
        edges = {edge: turn for i in range(len(self.field)) for edge, turn in self.singular_edges_of(i)}
        unit = self.field.arrays["root_cube"].ravel()[3] / 2.0**19
        length = unit * sum(width for _, _, width in edges)
        return {"edges": (len(edges), 0), "length": (length, 1e-9 * length),
                "unresolved_loops": (small_loops(edges), 0), "contacts": (contacts(self.field, edges), 0)}

    def singular_edges_of(self, i):
        """((start, axis, width), turn), in units of the smallest possible cell."""
        field = self.field
        width = 1 << (19 - int(field.depth[i]))
        low = [x * width for x in field.place[i]]
        for axis in range(3):
            b, c = (axis + 1) % 3, (axis + 2) % 3
            for db, dc in ((0, 0), (0, 1), (1, 0), (1, 1)):
                start = list(low)
                start[b] += db * width
                start[c] += dc * width
                ring = self.cells_around(start, axis, width)
                turn = self.turn_around(ring, b, c) if ring else np.eye(3)
                if not np.array_equal(turn, np.eye(3)):
                    yield (tuple(start), axis, width), Turn(turn, [field.axes[cell] for cell in ring])

    def cells_around(self, start, axis, width):
        """The cells in the four quadrants, in turn; empty where one is missing or smaller than the edge."""
        b, c = (axis + 1) % 3, (axis + 2) % 3
        ring = []
        for sb, sc in ((-1, -1), (0, -1), (0, 0), (-1, 0)):
            corner = list(start)
            corner[b] += sb * width
            corner[c] += sc * width
            if min(corner) < 0 or max(corner) >= 1 << 19:
                return []
            i = self.field.containing(19 - width.bit_length() + 1, [x // width for x in corner])
            if i is None:
                return []
            ring.append(i)
        return ring

    def turn_around(self, ring, b, c):
        turn = np.eye(3)
        for k, face in enumerate((2 * b + 1, 2 * c + 1, 2 * b, 2 * c)):
            i, j = ring[k], ring[(k + 1) % 4]
            if i == j:
                continue
            if not self.field.joined(i, face, j):
                return np.eye(3)
            axes = self.field.axes
            step = matching(axes[i], axes[j]) if i < j else matching(axes[j], axes[i]).T
            turn = step @ turn
        return turn

    def walls(self):
        finest = self.field.size.min()
        area, walls = 0.0, []
        thinnest, two_sheets = np.inf, 0
        for i in self.boundary:
            normals, areas = self.normals_and_areas(i)
            triangle, _, centroid = self.largest(i)
            inward = -self.surface.orientation * self.surface.normals[triangle]
            thickness, other = self.surface.first_hit(centroid, inward, 1e-6 * self.field.size[i])
            if other is None or self.surface.orientation * self.surface.normals[other] @ inward < WALL_COSINE:
                thickness = np.inf
            area += areas.sum()
            walls.append((thickness, areas.sum()))
            thinnest = min(thinnest, thickness)
            cosine = normals @ self.surface.normals[triangle]
            sheets = areas[cosine > WALL_COSINE].sum(), areas[cosine < -WALL_COSINE].sum()
            two_sheets += min(sheets) > SHEET_AREA * self.field.size[i] ** 2
        thinnest = thinnest / finest if np.isfinite(thinnest) else 0
        thickness, areas = np.array(sorted(walls)).T
        share = {cells: areas[thickness < cells * finest].sum() / area for cells in (WALL_CELLS, DECIDING_WALL_CELLS)}

        def thickness_of_all_but(spared):
            return thickness[np.searchsorted(np.cumsum(areas), spared * area, side="right")]

        deciding = thickness_of_all_but(THIN_SHARE) / finest if share[DECIDING_WALL_CELLS] > THIN_SHARE else 0
        needed = 0
        if share[WALL_CELLS] > UNRESOLVED_SHARE:
            extent = np.ptp(self.surface.triangles.reshape(-1, 3), axis=0).max()
            needed = np.ceil(WALL_CELLS * extent / thickness_of_all_but(UNRESOLVED_SHARE / 2) * (1 + 1e-6))
        return {"cells_wanted": (WALL_CELLS, 0), "thin_share": (share[WALL_CELLS], 1e-6),
                "unresolved_share": (share[DECIDING_WALL_CELLS], 1e-6), "deciding_cells": (deciding, 1e-6 * deciding),
                "resolution_needed": (needed, 0), "thinnest_cells": (thinnest, 1e-6 * thinnest), "two_sheet_cells": (two_sheets, 0),
                "tied_cells": (self.ties, 0)}

    def crease_section(self):
        creases = self.creases
        crowded = sum(edges > 3 for edges in creases.corners.values())
        section = {"curves": (creases.curves, 0), "length": (creases.length(), 1e-9 * creases.length()),
                   "corners": (len(creases.corners), 0), "crowded_corners": (crowded, 0),
                   "knife_edges": (len(creases.knives), 0),
                   "crowded_corner_places": (sorted(p for p, edges in creases.corners.items() if edges > 3)[:100], 1e-9),
                   "knife_edge_places": (creases.knives[:100], 1e-9)}
        places = list(creases.places(self.field.size.min()))
        if places:
            points, tangents, lengths = (np.array(column) for column in zip(*places))
            mean, p95, most = weighted_statistics(nearest_axis_deg(self.sampled(points), tangents), lengths)
            section |= {"tangent_deg.mean": (mean, 1e-3), "tangent_deg.p95": (p95, 2e-3), "tangent_deg.max": (most, 2e-3)}
        return section

    def active_at(self, depth):
        """The active cells of the uniform level of a depth no finer than any cell of the field."""
        field = self.field
        held = {tuple(x >> (field.depth[i] - depth) for x in field.place[i]) for i in self.boundary}
        root = field.arrays["root_cube"].ravel()
        others = [place for place in np.ndindex(*[2**depth] * 3) if place not in held]
        centres = root[:3] + root[3] / 2.0**depth * (np.array(others).reshape(-1, 3) + 0.5)
        return held | {place for place, inside in zip(others, self.surface.inside(centres)) if inside}


def nearest_axis_deg(axes, directions):
    cosine = np.abs(np.einsum("pak,pk->pa", axes, directions)).max(axis=1)
    return np.degrees(np.arccos(np.minimum(cosine, 1)))


def weighted_statistics(angle, weight):
    """Mean, 95th percentile and largest."""
    order = np.argsort(angle)
    share = np.cumsum(weight[order]) / weight.sum()
    return (angle * weight).sum() / weight.sum(), angle[order][np.searchsorted(share, 0.95)], angle.max()


def complete_leaves(cells):
    """Leaves of the octree, cells outside counted too, whose active leaves are these (depth, place): every cell that
    was split made eight of one, and only cells with an active leaf below were."""
    split = set()
    for depth, place in cells:
        while depth > 0 and (depth - 1, tuple(x >> 1 for x in place)) not in split:
            depth, place = depth - 1, tuple(x >> 1 for x in place)
            split.add((depth, place))
    return 1 + 7 * len(split)


def small_loops(edges):
    """How many closed lines of at most six edges there are where nothing else arrives."""
    joined = {}
    for start, axis, width in edges:
        end = tuple(x + width * (k == axis) for k, x in enumerate(start))
        joined.setdefault(start, []).append(end)
        joined.setdefault(end, []).append(start)
    seen, loops = set(), 0
    for vertex in joined:
        component, waiting = {vertex}, [] if vertex in seen else [vertex]
        while waiting:
            for other in joined[waiting.pop()]:
                if other not in component:
                    component.add(other)
                    waiting.append(other)
        loops += vertex not in seen and all(len(joined[v]) == 2 for v in component) and len(component) <= 6
        seen |= component
    return loops


def value_at(section, path):
    for key in path.split("."):
        section = section[key]
    return section


# Keys of `singularity` on a grid that are not recomputed; judge_of_tets.py does it on tets.
IN_NO_WAY = {"unresolved_stubs", "crease_hooks", "short_arcs", "crease_list", "corner_list"}

# Keys that are compared elsewhere, or not always there.
IN_OTHER_WAYS = {"model": {"path"}, "creases": {"tangent_deg"},
                 "singularity": {"arcs", "nodes", "boundary_ends", "verdict", "not_meshable_arcs", "not_meshable_nodes",
                                 "undecided_nodes", "arc_list", "node_list", *IN_NO_WAY}}


def disagreements(model, folder):
    """One line for each number of the report that is not what the files say."""
    report = json.loads((Path(folder) / "report.json").read_text())
    recomputation = Recomputation(model, folder)
    field = recomputation.field
    faults = []

    def compare(name, reported, expected, tolerance):
        if not np.all(np.abs(np.asarray(reported, float) - np.asarray(expected, float)) <= tolerance):
            faults.append(f"{name}: {reported} in the report, {expected} recomputed")

    sections = {"creases": recomputation.crease_section()}
    for name in ("model", "energy", "alignment_deg", "spectrum", "singularity", "walls"):
        sections[name] = getattr(recomputation, name)()
    for name, expected in sections.items():
        for path, (value, tolerance) in expected.items():
            reported = value_at(report[name], path)
            compare(f"{name}.{path}", sorted(reported) if path.endswith("_places") else reported, value, tolerance)
        known = {path.split(".")[0] for path in expected} | IN_OTHER_WAYS.get(name, set())
        if set(report[name]) != known:
            faults.append(f"{name}: keys {sorted(set(report[name]) ^ known)}")

    faults += graph_faults("singularity", report["singularity"], Path(folder) / "singularities.vtu")
    compare("model.path", report["model"]["path"] == str(model), True, 0)
    # Of a closed surface, the only ones that tests ask this of, nothing is left out, and nothing found but this.
    watertight, components = recomputation.surface.topology()
    if watertight:
        turned = components if recomputation.surface.orientation < 0 else 0
        compare("input.triangles_solved", report["input"]["triangles_solved"], len(recomputation.surface.triangles), 0)
        compare("input.closed", report["input"]["closed"], True, 0)
        compare("input.findings", [finding["count"] for finding in report["input"]["findings"]], [turned] if turned else [], 0)
    compare("degree", report["degree"], field.arrays["degree"][0], 0)
    extent = np.ptp(recomputation.surface.triangles.reshape(-1, 3), axis=0).max()
    compare("resolution", report["resolution"], extent / field.size.min(), 1e-9 * report["resolution"])
    first, last = report["levels"][0], report["levels"][-1]
    coarsest = recomputation.active_at(first["depth"])
    compare("coarsest active cells", first["active_cells"], len(coarsest), 0)
    compare("coarsest cells", first["cells"], complete_leaves((first["depth"], place) for place in coarsest), 0)
    compare("cells", last["cells"], complete_leaves(field.index), 0)
    compare("active cells", last["active_cells"], len(field), 0)
    compare("depth", last["depth"], field.depth.max(), 0)
    compare("depths", [level["depth"] for level in report["levels"]], range(first["depth"], last["depth"] + 1), 0)
    compare("energy of the last level", last["energy"], report["energy"]["total"], 0)
    compare("is_boundary", field.arrays["is_boundary"], [bool(pieces) for pieces in recomputation.pieces], 0)
    compare("version", "crossgrain " + report["version"] == run("--version").stdout.splitlines()[0], True, 0)
    return faults


if __name__ == "__main__":
    found = disagreements(sys.argv[1], sys.argv[2])
    print("\n".join(found) or "the report says what the files say")
    sys.exit(1 if found else 0)

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Whether our hexahedra are those of libHexEx and libHexHex on the same maps.

    same_hexahedra.py --program CROSSGRAIN --built BUILT --out FOLDER [--cells 10,20] [--seconds 300] MODEL...
    same_hexahedra.py --built BUILT --maps FOLDER [NAME...]

BUILT is the folder of build.sh's programs. Models, which may be packed with xz, are meshed by `crossgrain hex --write hexex`, and the others read
the map that it leaves, unless --out, which may be that of hex_comparison.py, has it already; --maps takes NAME.hexex and NAME.mesh of bench/grid_maps. Prints a row for each map:

    flipped, flat      tets of the map, with positive volume of the model
    exact              whether faces of the surface are on integer planes to the bit, and all others have one whole motion that takes the
                       coordinates on one side to those on the other to the bit: how many are and have not
    hexahedra, vertices    ours, of libHexEx and of libHexHex, which refuses maps with such tets
    the same           whether libHexEx's mesh has the connectivity of ours: a walk from one hexahedron to its neighbours finds all hexahedra of
                       both, with one vertex of theirs for each of ours. Otherwise the number that the best of some walks finds.
    closed             ours, libHexEx's: hex_mesh.judged
"""

import argparse
import json
import re
import subprocess
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from hex_judges import ended, euler_of_surface
from hex_mesh import FACES, judged, read_hexahedra, unpacked

HEXEX_SECONDS = 120
NOT_ALL_HEX = 6
ENOUGH = 0.9
STARTS, NEAREST = 60, 8  # walks begin at so many hexahedra of ours, if need be, each at so many of theirs


def read_map(path):
    """Points, tets, and the coordinates of their corners."""
    words = path.read_text().split()
    count = int(words[0])
    points = np.array(words[1:1 + 3 * count], float).reshape(-1, 3)
    rows = np.array(words[2 + 3 * count:], float).reshape(int(words[1 + 3 * count]), 16)
    return points, rows[:, :4].astype(int), rows[:, 4:].reshape(-1, 4, 3)


def six_volumes(corners):
    return np.linalg.det(corners[:, 1:] - corners[:, :1])


def rotations():
    """The 24 of a cube, as matrices."""
    found = []
    for order in np.array(np.meshgrid(*[range(3)] * 3)).T.reshape(-1, 3):
        for signs in np.array(np.meshgrid(*[(-1, 1)] * 3)).T.reshape(-1, 3):
            rotation = np.zeros((3, 3), int)
            rotation[range(3), order] = signs
            if round(np.linalg.det(rotation)) == 1:
                found.append(rotation)
    return np.array(found)


def inexact_faces(tets, coordinates):
    """The number of faces of the surface off integer planes, and of other faces that are not glued by one whole motion."""
    corners = np.array([(1, 2, 3), (0, 2, 3), (0, 1, 3), (0, 1, 2)])
    faces, places = tets[:, corners].reshape(-1, 3), coordinates[:, corners].reshape(-1, 3, 3)
    order = np.argsort(faces, axis=1)
    faces, places = np.take_along_axis(faces, order, 1), np.take_along_axis(places, order[:, :, None], 1)
    _, first, inverse, count = np.unique(faces, axis=0, return_index=True, return_inverse=True, return_counts=True)
    outer = places[first[count == 1]]
    on_plane = (np.ptp(outer, axis=1) == 0) & (outer[:, 0] == np.round(outer[:, 0]))
    by_face = np.argsort(inverse.ravel(), kind="stable")
    pairs = places[by_face[count[inverse.ravel()[by_face]] == 2]].reshape(-1, 2, 3, 3)
    turned = np.einsum("rij,fkj->rfki", rotations(), pairs[:, 0])
    motions = pairs[None, :, 1] - turned
    glued = (motions == motions[:, :, :1]).all(axis=(2, 3)) & (motions == np.round(motions)).all(axis=(2, 3))
    return int((~on_plane.any(axis=1)).sum()), int((glued.sum(axis=0) != 1).sum())


def symmetries():
    """The 24 ways to number the corners of a hexahedron anew that keep its faces and their sense."""
    places = np.array([(x, y, z) for z in (0, 1) for x, y in ((0, 0), (1, 0), (1, 1), (0, 1))])
    found = []
    for rotation in rotations():
        turned = (2 * places - 1) @ rotation.T
        found.append([int(np.flatnonzero((2 * places - 1 == corner).all(axis=1))[0]) for corner in turned])
    return found


SYMMETRIES = symmetries()


class Neighbours:
    """The hexahedra of a mesh with those behind their faces."""

    def __init__(self, mesh):
        self.hexahedra = mesh.hexahedra.tolist()
        self.centres = mesh.points[mesh.hexahedra].mean(axis=1)
        at_face = {}
        for h, corners in enumerate(self.hexahedra):
            for face in FACES.tolist():
                at_face.setdefault(frozenset(corners[k] for k in face), []).append(h)
        self.beside = {face: hexahedra for face, hexahedra in at_face.items() if len(hexahedra) == 2}

    def behind(self, h, face):
        """The hexahedron behind a face, given by its vertices; none at the boundary and where more than two meet."""
        pair = self.beside.get(face)
        return None if pair is None else pair[pair[0] == h]


def walk(ours, theirs, start, other, symmetry):
    """The hexahedra found alike from a pair on, with their corners in an order; and whether nothing spoke against it."""
    named, taken = {}, {}
    agrees = True

    def name(h, g, order):
        pairs = list(zip(ours.hexahedra[h], (theirs.hexahedra[g][k] for k in order)))
        if any(named.get(a, b) != b or taken.get(b, a) != a for a, b in pairs):
            return False
        named.update(pairs)
        taken.update((b, a) for a, b in pairs)
        return True

    if not name(start, other, symmetry):
        return 0, False
    found, queue = {start: other}, [start]
    for h in queue:
        for face in FACES.tolist():
            vertices = [ours.hexahedra[h][k] for k in face]
            next_one = ours.behind(h, frozenset(vertices))
            next_other = theirs.behind(found[h], frozenset(named[v] for v in vertices))
            if (next_one is None) != (next_other is None):
                agrees = False
            if next_one is None or next_other is None or next_one in found:
                continue
            corners, others = ours.hexahedra[next_one], theirs.hexahedra[next_other]
            order = next((s for s in SYMMETRIES if all(named[v] == others[s[corners.index(v)]] for v in vertices)), None)
            if order is None or not name(next_one, next_other, order):
                agrees = False
                continue
            found[next_one] = next_other
            queue.append(next_one)
    return len(found), agrees


def alike(ours, theirs):
    """Whether two meshes have one connectivity, and the number of hexahedra that the best walk finds in both."""
    if not len(ours.hexahedra) or not len(theirs.hexahedra):
        return False, 0
    one, other = Neighbours(ours), Neighbours(theirs)
    sizes = {len(ours.hexahedra), len(theirs.hexahedra)}
    places, best = cKDTree(other.centres), 0
    starts = np.linspace(0, len(one.hexahedra) - 1, min(STARTS, len(one.hexahedra))).astype(int).tolist()
    for start in starts:
        for near in np.atleast_1d(places.query(one.centres[start], min(NEAREST, len(other.hexahedra)))[1]).tolist():
            for symmetry in SYMMETRIES:
                count, agrees = walk(one, other, start, near, symmetry)
                best = max(best, count)
                if agrees and sizes == {count}:
                    return True, count
                # Meshes of different sizes are not alike, so that a walk that finds most is enough.
                if len(sizes) == 2 and best > ENOUGH * min(sizes):
                    return False, best
    return False, best


def of_hexhex(built, path):
    """The mesh of libHexHex, and what it says if there is none."""
    made, log = path.with_suffix(".hexhex.mesh"), path.with_suffix(".hexhex.log")
    made.unlink(missing_ok=True)
    fault = ended([built / "hexhex", "-i", path, "-o", made], HEXEX_SECONDS, log)
    tets = re.search(r"(\d+) Flipped and (\d+) Degenerate", log.read_text())
    if tets and tets.groups() != ("0", "0"):
        return None, "refused"
    return (None, fault or "no mesh") if fault or not made.exists() else (read_hexahedra(made), "")


def row_of(built, path, mesh):
    """Of a map and our hexahedra."""
    made = path.with_suffix(".ovm")
    made.unlink(missing_ok=True)
    points, tets, coordinates = read_map(path)
    volumes = six_volumes(coordinates)
    outer, inner = inexact_faces(tets, coordinates)
    flips = f"{(volumes < 0).sum()}, {(volumes == 0).sum()} | {'yes' if outer + inner == 0 else f'{outer}, {inner}'}"
    ours = read_hexahedra(mesh)
    fault = ended([built / "hexex", path, made], HEXEX_SECONDS, path.with_suffix(".hexex.log"))
    if fault:
        return f"{flips} | {len(ours.hexahedra)} | libHexEx: {fault} | | | |"
    theirs = read_hexahedra(made)
    third, said = of_hexhex(built, path)
    volume, euler = six_volumes(points[tets]).sum() / 6, euler_of_surface(tets)
    closed = ", ".join("yes" if judged(one, volume, euler)["closed"] else "no" for one in (ours, theirs))

    def counts(one):
        return f"{len(one.hexahedra) + one.others}, {len(np.unique(one.hexahedra))}"

    def verdict(one):
        same, common = alike(ours, one)
        return "the same" if same else f"{common} found"

    return (f"{flips} | {counts(ours)} | {counts(theirs)} | {verdict(theirs)} | "
            f"{f'{counts(third)} | {verdict(third)}' if third else f'{said} |'} | {closed}")


def made_by_program(options, model, cells):
    folder = options.out / f"{model.name.split('.')[0]}-{cells}"
    if not (folder / "hexahedra.hexex").exists():
        make(options, model, cells, folder)
    return folder, json.loads((folder / "report.json").read_text())["hexahedra"]["outcome"]


def make(options, model, cells, folder):
    command = [options.program, "hex", model, "--cells", cells, "-o", folder, "--write", "hexex", "--inverted", "--no-report", "--quiet", "--force"]
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=options.seconds, check=False)
    if result.returncode not in (0, NOT_ALL_HEX):
        raise ValueError(result.stderr.strip())


def of_models(options):
    options.out.mkdir(parents=True, exist_ok=True)
    for model in options.models:
        model = unpacked(model, options.out)
        for cells in map(int, options.cells.split(",")):
            begin = f"| {model.name.split('.')[0]} | {cells} |"
            try:
                folder, outcome = made_by_program(options, model, cells)
                mesh = next(path for path in folder.glob("hexahedra*.mesh"))
                print(f"{begin} {outcome} | {row_of(options.built, folder / 'hexahedra.hexex', mesh)} |", flush=True)
            except (ValueError, subprocess.TimeoutExpired) as fault:
                print(f"{begin} {fault} |", flush=True)


def of_maps(options):
    for path in [options.maps / f"{name}.hexex" for name in options.models] or sorted(options.maps.glob("*.hexex")):
        print(f"| {path.stem} | | | {row_of(options.built, path, path.with_suffix('.mesh'))} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("models", nargs="*", type=Path)
    parser.add_argument("--built", required=True, type=Path, help="the folder of build.sh's programs")
    parser.add_argument("--program", type=Path, help="crossgrain")
    parser.add_argument("--out", type=Path)
    parser.add_argument("--maps", type=Path, help="a folder of bench/grid_maps instead")
    parser.add_argument("--cells", default="10,20", help="hexahedra along the longest side, a table row for each number")
    parser.add_argument("--seconds", default=300, type=int, help="for each model and number of cells")
    options = parser.parse_args()
    if not options.maps and not (options.program and options.out and options.models):
        parser.error("give --program, --out and models, or --maps")
    print("| model | cells | outcome | flipped, flat tets | exact | ours: hexahedra, vertices | libHexEx | beside ours | libHexHex | beside ours | "
          "closed, ours and libHexEx |\n|---|---|---|---|---|---|---|---|---|---|---|")
    of_maps(options) if options.maps else of_models(options)


if __name__ == "__main__":
    main()

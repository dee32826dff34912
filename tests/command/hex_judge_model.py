# SPDX-License-Identifier: Apache-2.0
"""The surface of a model as oriented triangles: of a CAD file as gmsh meshes it, of a tet mesh its boundary, or of a file of triangles."""

import lzma
import subprocess
import tempfile
from pathlib import Path

import meshio
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import breadth_first_order

from hex_judge_mesh import LINE, TRIANGLE, ClosedSurface, GmshFile, edges_of

CAD_ENDINGS = (".step", ".stp", ".igs", ".iges", ".brep")
FINE = 40  # triangles of CAD faces are no longer than the longest side over this,
AROUND = 32  # and at least as many around a full turn
GMSH_SECONDS = 600
TET_FACES = np.array([(1, 2, 3), (0, 3, 2), (0, 1, 3), (0, 2, 1)])  # outward of positive tets


class Model:
    """`points`, `triangles` outward; `numbers`, of the face of each triangle (0: none); `has_numbers`: the faces are those of the file;
    `lines` (k, 2) of curves that the file names, and `line_curves`, their numbers; `is_cad`."""

    def __init__(self, points, triangles, numbers=None, lines=(), line_curves=(), is_cad=False):
        used, index = np.unique(np.asarray(triangles, int), return_inverse=True)
        self.points, triangles = np.asarray(points, float)[used], index.reshape(-1, 3)
        self.triangles = outward(self.points, triangles)
        self.has_numbers = numbers is not None
        self.numbers = np.zeros(len(triangles), int) if numbers is None else np.asarray(numbers, int)
        place = np.full(len(points), -1)
        place[used] = np.arange(len(used))
        lines = place[np.asarray(lines, int).reshape(-1, 2)]
        is_on_surface = (lines >= 0).all(axis=1)
        self.lines, self.line_curves = lines[is_on_surface], np.asarray(line_curves, int)[is_on_surface]
        self.is_cad = is_cad
        crosses = np.cross(*(self.corners()[:, k] - self.corners()[:, 0] for k in (1, 2)))
        self.areas = np.linalg.norm(crosses, axis=1) / 2
        self.normals = crosses / np.maximum(2 * self.areas, 1e-300)[:, None]
        self.topology = ClosedSurface(self.triangles)
        self.longest = np.ptp(self.points, axis=0).max()

    def corners(self):
        return self.points[self.triangles]

    def volume(self):
        return signed_volume(self.corners() - self.points.mean(axis=0))

    @classmethod
    def read(cls, path, cache=None):
        """`cache`: a folder that keeps what gmsh makes of CAD files."""
        path = Path(path)
        with tempfile.TemporaryDirectory(prefix="crossgrain-model-") as folder:
            if path.suffix == ".xz":
                unpacked = Path(folder) / path.stem
                unpacked.write_bytes(lzma.decompress(path.read_bytes()))
                path = unpacked
            if path.suffix.lower() in CAD_ENDINGS:
                return cls.of_cad(path, Path(cache or folder))
            if path.suffix.lower() == ".msh":
                file = GmshFile(path)
                tags = file.entities.get(TRIANGLE)
                return cls.of_tets(file.points, file.elements[4], file.elements.get(TRIANGLE), tags, file.elements.get(LINE, ()))
            file = meshio.read(path)
        tags = file.cell_data.get("medit:ref", file.cell_data.get("CellEntityIds"))
        cells = {block.type: (block.data, tags[k] if tags else None) for k, block in enumerate(file.cells)}
        if "tetra" in cells:
            triangles, numbers = cells.get("triangle", (None, None))
            return cls.of_tets(file.points, cells["tetra"][0], triangles, numbers, cells["line"][0] if "line" in cells else ())
        polygons = [row for block in file.cells if block.data.shape[1] > 2 for row in block.data]
        return cls.of_surface(file.points, [(row[0], row[k], row[k + 1]) for row in polygons for k in range(1, len(row) - 1)])

    @classmethod
    def of_cad(cls, path, folder):
        """Faces of one solid each: those between two are inside."""
        made = folder / f"{path.stem}.model.msh"
        if not made.exists():
            making = folder / f"{path.stem}.making.msh"  # so that a run that was killed leaves no half of it
            run_gmsh(path, making, 1e22, "-1")
            longest = np.ptp(GmshFile(making).points, axis=0).max()
            run_gmsh(path, making, longest / FINE)
            making.replace(made)
        file = GmshFile(made)
        faces, count = np.unique([face for volume in file.volumes for face in volume], return_counts=True)
        is_outside = np.isin(file.entities[TRIANGLE], faces[count == 1]) & are_solid(file.points[file.elements[TRIANGLE]])
        return cls(file.points, file.elements[TRIANGLE][is_outside], file.entities[TRIANGLE][is_outside],
                   file.elements[LINE], file.entities[LINE], is_cad=True)

    @classmethod
    def of_tets(cls, points, tets, triangles=None, tags=None, lines=()):
        """Faces have numbers where the file tags all triangles of the boundary, with at least two and not each with its own."""
        a, b, c, d = (points[tets[:, k]] for k in range(4))
        tets = np.where((np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) < 0)[:, None], tets[:, [0, 2, 1, 3]], tets)
        faces = tets[:, TET_FACES].reshape(-1, 3)
        _, first, count = np.unique(np.sort(faces, axis=1), axis=0, return_index=True, return_counts=True)
        faces = faces[first[count == 1]]
        numbers = None
        if triangles is not None and tags is not None:
            tag_of = dict(zip(map(tuple, np.sort(triangles, axis=1).tolist()), np.ravel(tags).tolist()))
            found = [tag_of.get(key) for key in map(tuple, np.sort(faces, axis=1).tolist())]
            if None not in found and 1 < len(set(found)) < len(faces) // 2:
                numbers = found
        return cls(points, faces, numbers, lines, np.zeros(len(lines), int))

    @classmethod
    def of_surface(cls, points, triangles):
        """Vertices of the same coordinates are one."""
        points, index = np.unique(np.asarray(points, float) + 0.0, axis=0, return_inverse=True)
        triangles = index[np.asarray(triangles, int)]
        is_whole = (triangles != np.roll(triangles, 1, axis=1)).all(axis=1)
        return cls(points, triangles[is_whole])


def run_gmsh(path, made, longest_edge, dimension="-2"):
    command = ["gmsh", path, dimension, "-clmax", repr(float(longest_edge)), "-clcurv", str(AROUND), "-format", "msh41", "-save_all",
               "-nt", "1", "-v", "1", "-o", made]
    done = subprocess.run(command, capture_output=True, text=True, timeout=GMSH_SECONDS, check=False)
    if not made.exists():
        raise ValueError(f"gmsh makes no mesh of {path}: {done.stdout}{done.stderr}")


def are_solid(corners):
    """False for triangles that are a line, which gmsh makes at the tip of a cone."""
    edges = corners - np.roll(corners, 1, axis=1)
    areas = np.linalg.norm(np.cross(edges[:, 0], edges[:, 1]), axis=1)
    return areas > 1e-12 * (edges ** 2).sum(axis=(1, 2))


def signed_volume(corners):
    return np.einsum("ij,ij->", corners[:, 0], np.cross(corners[:, 1], corners[:, 2])) / 6


def outward(points, triangles):
    """The same triangles, all looking out of the solid: neighbours agree, and a shell inside an odd number of others looks inward."""
    edges = edges_of(triangles)
    owner = np.repeat(np.arange(len(triangles)), 3)
    keys = np.sort(edges, axis=1)
    _, inverse, count = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
    order = np.argsort(inverse, kind="stable")
    starts = (np.cumsum(count) - count)[count == 2]
    one, other = order[starts], order[starts + 1]
    agree = (edges[one, 0] != edges[other, 0]).astype(int)
    graph = coo_matrix((np.ones(2 * len(one)), (np.r_[owner[one], owner[other]], np.r_[owner[other], owner[one]])),
                       shape=(len(triangles),) * 2).tocsr()
    agrees = dict(zip(zip(owner[one].tolist(), owner[other].tolist()), agree.tolist()))
    is_turned, shells, seen = np.zeros(len(triangles), bool), [], np.zeros(len(triangles), bool)
    while not seen.all():
        reached, before = breadth_first_order(graph, int(np.flatnonzero(~seen)[0]), directed=False)
        for triangle in reached[1:].tolist():
            pair = (int(before[triangle]), triangle)
            same = agrees[pair] if pair in agrees else agrees[pair[::-1]]
            is_turned[triangle] = is_turned[pair[0]] != (not same)
        seen[reached] = True
        shells.append(reached)
    triangles = np.where(is_turned[:, None], triangles[:, ::-1], triangles)
    for shell in shells:
        depth = sum(is_inside(points[triangles[shell[0]]].mean(axis=0), points[triangles[other]]) for other in shells if other is not shell)
        corners = points[triangles[shell]]
        if (signed_volume(corners - corners.mean(axis=(0, 1))) < 0) == (depth % 2 == 0):
            triangles[shell] = triangles[shell][:, ::-1]
    return triangles


def is_inside(point, corners):
    """Whether triangles wind around a point, by the solid angles that they are seen in (van Oosterom, Strackee)."""
    a, b, c = np.moveaxis(corners - point, 1, 0)
    la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    above = np.einsum("ij,ij->i", a, np.cross(b, c))
    below = la * lb * lc + (a * b).sum(axis=1) * lc + (b * c).sum(axis=1) * la + (c * a).sum(axis=1) * lb
    return abs(np.arctan2(above, below).sum()) > np.pi

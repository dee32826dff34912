# SPDX-License-Identifier: Apache-2.0
"""Hexahedral meshes as other programs write them, and what is wrong with them."""

import lzma
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "command"))
from poisson_map import medit_sections  # noqa: E402

# Corners of a hexahedron: a quadrilateral 0 1 2 3, and 4 5 6 7 opposite. At each corner its three neighbours, right-handed.
CORNERS = np.array([(1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3)])
FACES = np.array([(0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)])  # outward
GEOGRAM_HEXAHEDRON, GEOGRAM_CORNERS = 1, np.array([0, 1, 3, 2, 4, 5, 7, 6])  # its corners count in binary
VOLUME_TOLERANCE = 0.1  # corners cut off by flat faces of ten hexahedra along a sphere are 5 % of its volume


def unpacked(model, folder):
    """The model itself, or what an .xz file has inside, in a folder."""
    if model.suffix != ".xz":
        return model
    path = folder / model.stem
    path.write_bytes(lzma.decompress(model.read_bytes()))
    return path


class HexMesh:
    """`points`, `hexahedra` (n, 8) of positive volume in the median, and the number of cells that are no hexahedra."""

    def __init__(self, points, hexahedra, others):
        self.points, self.others = np.array(points, float).reshape(-1, 3), others
        self.hexahedra = np.array(hexahedra, int).reshape(-1, 8)
        if len(self.hexahedra) and np.median(self.volumes()) < 0:
            self.hexahedra = self.hexahedra[:, [0, 3, 2, 1, 4, 7, 6, 5]]

    def volumes(self):
        """Of trilinear hexahedra: their faces are bilinear, which is the mean of both ways to cut them into triangles."""
        a, b, c, d = np.moveaxis(self.points[self.hexahedra[:, FACES]], 2, 0)
        triple = sum(np.linalg.det(np.stack(t, axis=2)) for t in ((a, b, c), (a, c, d), (a, b, d), (b, c, d)))
        return triple.sum(axis=1) / 12

    def scaled_jacobians(self):
        """The least of the eight corners of each."""
        corners = self.points[self.hexahedra]
        edges = corners[:, CORNERS] - corners[:, :, None]
        lengths = np.linalg.norm(edges, axis=3).prod(axis=2)
        return (np.linalg.det(edges) / np.maximum(lengths, 1e-300)).min(axis=1)

    def boundary(self):
        """Quadrilaterals of one hexahedron, outward, and whether no quadrilateral has more than two."""
        quads = self.hexahedra[:, FACES].reshape(-1, 4)
        _, first, count = np.unique(np.sort(quads, axis=1), axis=0, return_index=True, return_counts=True)
        return quads[first[count == 1]], bool((count <= 2).all())


def fan_count(quads):
    """The number of fans of quadrilaterals around all vertices together; that of vertices if the surface is a manifold."""
    root = {}

    def find(key):
        while root.setdefault(key, key) != key:
            root[key] = root[root[key]]
            key = root[key]
        return key

    at_edge = {}
    for i, quad in enumerate(quads.tolist()):
        for k in range(4):
            find((i, quad[k]))
            at_edge.setdefault(frozenset((quad[k], quad[k - 1])), []).append(i)
    for edge, around in at_edge.items():
        for vertex in edge:
            for other in around[1:]:
                root[find((around[0], vertex))] = find((other, vertex))
    return len({find(key) for key in list(root)})


def is_closed_manifold(quads):
    edges = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    _, count = np.unique(edges, axis=0, return_counts=True)
    return bool((count == 2).all()) and fan_count(quads) == len(np.unique(quads))


def euler_number(faces):
    """Vertices - edges + faces of a surface."""
    edges = np.sort(np.stack([faces, np.roll(faces, -1, axis=1)], axis=2).reshape(-1, 2), axis=1)
    return len(np.unique(faces)) - len(np.unique(edges, axis=0)) + len(faces)


def judged(mesh, volume, euler):
    """What there is to say of a mesh that should fill a solid of this volume and Euler number of its surface.

    closed: its boundary is a manifold without boundary, of this Euler number. valid: closed, of hexahedra only, all scaled
    Jacobians above 0, and its volume the solid's to VOLUME_TOLERANCE.
    """
    if not len(mesh.hexahedra):
        return {"hexahedra": 0, "others": mesh.others, "share": 0.0, "least": 0.0, "mean": 0.0, "inverted": 0, "closed": False,
                "valid": False}
    quads, at_most_two = mesh.boundary()
    jacobians = mesh.scaled_jacobians()
    share = float(mesh.volumes().sum() / volume)
    closed = at_most_two and is_closed_manifold(quads) and euler_number(quads) == euler
    valid = closed and not mesh.others and jacobians.min() > 0 and abs(share - 1) < VOLUME_TOLERANCE
    return {"hexahedra": len(mesh.hexahedra), "others": mesh.others, "share": round(share, 3),
            "least": round(float(jacobians.min()), 3), "mean": round(float(jacobians.mean()), 3),
            "inverted": int((jacobians <= 0).sum()), "closed": closed, "valid": bool(valid)}


def read_hexahedra(path):
    """The HexMesh of a file in ASCII of OVM, Medit or geogram."""
    if Path(path).suffix == ".geogram_ascii":
        return read_geogram_hexahedra(path)
    return read_ovm(path) if Path(path).suffix == ".ovm" else read_medit_hexahedra(path)


def read_ovm(path):
    lines = iter(Path(path).read_text().split("\n"))
    found = {}
    for line in lines:
        if line.strip() in ("Vertices", "Edges", "Faces", "Polyhedra"):
            found[line.strip()] = [next(lines).split() for _ in range(int(next(lines)))]
    edges = [[int(v) for v in row[:2]] for row in found["Edges"]]
    ways = [pair for a, b in edges for pair in ((a, b), (b, a))]
    faces = [[ways[int(h)][0] for h in row[1:]] for row in found["Faces"]]
    hexahedra, others = [], 0
    for row in found["Polyhedra"]:
        corners = corners_of([faces[int(h) // 2][::1 if int(h) % 2 == 0 else -1] for h in row[1:]])
        if corners:
            hexahedra.append(corners)
        else:
            others += 1
    return HexMesh([row[:3] for row in found["Vertices"]], hexahedra, others)


def corners_of(faces):
    """Eight corners in order, of six quadrilaterals; None if they are not a hexahedron."""
    if len(faces) != 6 or any(len(set(face)) != 4 for face in faces):
        return None
    beside = {}
    for face in faces:
        for k in range(4):
            beside.setdefault(face[k], set()).update((face[k - 1], face[(k + 1) % 4]))
    first = faces[0]
    opposite = [beside[v] - set(first) for v in first]
    if len(beside) != 8 or any(len(others) != 1 for others in opposite):
        return None
    return first + [others.pop() for others in opposite]


def read_medit_hexahedra(path):
    found = medit_sections(path)
    others = sum(len(found.get(kind, ())) for kind in ("Tetrahedra", "Prisms", "Pyramids"))
    return HexMesh(found["Vertices"][:, :3], found.get("Hexahedra", np.zeros((0, 9)))[:, :8].astype(int) - 1, others)


def read_geogram_hexahedra(path):
    from geogram_hexdom import GeogramText  # noqa: PLC0415, which needs packages that other judges do not
    text, cells = GeogramText(Path(path)), "GEO::Mesh::cells"
    points = text.numbers("point", 3)
    if text.start(f"{cells}::cell_type", cells) is None:  # tets only
        return HexMesh(points, [], text.count_of(cells))
    start = text.numbers(f"{cells}::cell_ptr", 1, cells)[:, 0].astype(int)
    is_hexahedron = text.numbers(f"{cells}::cell_type", 1, cells)[:, 0] == GEOGRAM_HEXAHEDRON
    corners = text.numbers("GEO::Mesh::cell_corners::corner_vertex", 1, "GEO::Mesh::cell_corners")[:, 0].astype(int)
    hexahedra = corners[start[is_hexahedron][:, None] + GEOGRAM_CORNERS]
    return HexMesh(points, hexahedra, int((~is_hexahedron).sum()))

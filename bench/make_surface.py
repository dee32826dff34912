#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a torus of 2 N^2 triangles in the format of the file's extension: STL (also as .ascii.stl), OBJ, PLY (also as
.ascii.ply), OFF.

Usage: make_surface.py N FILE...     N = 707 gives 999,698 triangles.
"""

import struct
import sys

import numpy as np


def torus(n):
    """Returns vertices in single precision, and triangles."""
    angle = 2 * np.pi * np.arange(n) / n
    ring = 1 + 0.4 * np.cos(angle)
    points = np.stack([np.cos(angle)[:, None] * ring, np.sin(angle)[:, None] * ring,
                       np.broadcast_to(0.4 * np.sin(angle), (n, n))], axis=2)
    i, j = (grid.ravel() for grid in np.meshgrid(np.arange(n), np.arange(n), indexing="ij"))
    a, b = i * n + j, (i + 1) % n * n + j
    c, d = (i + 1) % n * n + (j + 1) % n, i * n + (j + 1) % n
    return points.reshape(-1, 3).astype(np.float32), np.stack([a, b, c, a, c, d], axis=1).reshape(-1, 3)


def ply_header(kind, vertices, triangles):
    properties = "".join(f"property float {axis}\n" for axis in "xyz")
    return (f"ply\nformat {kind} 1.0\nelement vertex {len(vertices)}\n{properties}element face {len(triangles)}\n"
            "property list uchar int vertex_indices\nend_header\n").encode()


def rows(template, numbers):
    return (template * len(numbers) % tuple(numbers.ravel().tolist())).encode()


def binary_stl(vertices, triangles):
    records = np.zeros(len(triangles), np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("zero", "<u2")]))
    records["corners"] = vertices[triangles]
    return b"\0" * 80 + struct.pack("<I", len(triangles)) + records.tobytes()


def binary_ply(vertices, triangles):
    faces = np.zeros(len(triangles), np.dtype([("count", "u1"), ("corners", "<i4", 3)]))
    faces["count"], faces["corners"] = 3, triangles
    return ply_header("binary_little_endian", vertices, triangles) + vertices.astype("<f4").tobytes() + faces.tobytes()


WRITERS = {
    ".ascii.stl": lambda v, t: b"solid torus\n" + rows(
        "facet normal 0 0 0\nouter loop\n" + "vertex %.9g %.9g %.9g\n" * 3 + "endloop\nendfacet\n", v[t])
    + b"endsolid torus\n",
    ".stl": binary_stl,
    ".obj": lambda v, t: rows("v %.9g %.9g %.9g\n", v) + rows("f %d %d %d\n", t + 1),
    ".ascii.ply": lambda v, t: ply_header("ascii", v, t) + rows("%.9g %.9g %.9g\n", v) + rows("3 %d %d %d\n", t),
    ".ply": binary_ply,
    ".off": lambda v, t: f"OFF\n{len(v)} {len(t)} 0\n".encode() + rows("%.9g %.9g %.9g\n", v)
    + rows("3 %d %d %d\n", t),
}


def main():
    vertices, triangles = torus(int(sys.argv[1]))
    for path in sys.argv[2:]:
        write = next(write for ending, write in WRITERS.items() if path.endswith(ending))
        with open(path, "wb") as out:
            out.write(write(vertices, triangles))


main()

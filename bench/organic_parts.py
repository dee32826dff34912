# SPDX-License-Identifier: Apache-2.0
"""Parts without flat faces, for hex_features.py --organic: a scan of 100,000 triangles, a cross of pipes, and a stirrer of thin
blades."""

import struct
import subprocess
import sys

import numpy as np

PIPES = ("Cylinder(1)={-12,0,0,24,0,0,4}; Cylinder(2)={0,-12,0,0,24,0,4}; Cylinder(3)={0,0,-12,0,0,24,3};"
         "BooleanUnion(10)={Volume{1};Delete;}{Volume{2,3};Delete;};"
         "Cylinder(4)={-13,0,0,26,0,0,2.8}; Cylinder(5)={0,-13,0,0,26,0,2.8}; Cylinder(6)={0,0,-13,0,0,26,2};"
         "BooleanUnion(11)={Volume{4};Delete;}{Volume{5,6};Delete;};"
         "BooleanDifference(12)={Volume{10};Delete;}{Volume{11};Delete;};")
BLADE = ("Box({0})={{1,-2.5,{2},9,5,.5}}; Rotate{{{{1,0,0}},{{0,0,{2}}},Pi/5}}{{Volume{{{0}}};}} Rotate{{{{0,0,1}},{{0,0,0}},{1}*Pi/3}}{{Volume{{{0}}};}}")
STIRRER = ("Cylinder(1)={0,0,0,0,0,30,1.6};" + "".join(BLADE.format(2 + k, 2 * k, 4 if k < 3 else 12) for k in range(6)) +
           "BooleanUnion(10)={Volume{1};Delete;}{Volume{2:7};Delete;};")
CAD = {"pipe_cross": PIPES, "stirrer": STIRRER}
NAMES = ("scan", *CAD)


def sphere(times):
    """Corners and triangles of an icosahedron, each triangle cut into 4 so many times."""
    golden = (1 + 5 ** 0.5) / 2
    points = np.array([(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0), (0, -1, golden), (0, 1, golden), (0, -1, -golden),
                       (0, 1, -golden), (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)])
    points = points / np.linalg.norm(points, axis=1, keepdims=True)
    faces = np.array([(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
                      (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)])
    triangles = points[faces]
    for _ in range(times):
        a, b, c = np.moveaxis(triangles, 1, 0)
        ab, bc, ca = ((p + q) / np.linalg.norm(p + q, axis=1, keepdims=True) for p, q in ((a, b), (b, c), (c, a)))
        triangles = np.concatenate([np.stack(corners, axis=1) for corners in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
    return triangles


def scan():
    """A sphere of 81,920 triangles with waves of five lengths at random directions, and the roughness of a scanner, 1/5000 of its size."""
    triangles = sphere(6)
    points, back = np.unique(np.round(triangles.reshape(-1, 3), 12), axis=0, return_inverse=True)
    random = np.random.default_rng(11)
    radii = np.full(len(points), 10.0)
    for length, height in ((2.0, 1.8), (1.2, 1.0), (0.7, 0.5), (0.4, 0.2), (0.2, 0.05)):
        for _ in range(6):
            way = random.normal(size=3)
            radii += height / 2 * np.cos(2 * np.pi / length * points @ (way / np.linalg.norm(way)) + random.uniform(0, 2 * np.pi))
    radii += 0.004 * random.normal(size=len(points))
    return (points * radii[:, None])[back.ravel()].reshape(-1, 3, 3)


def make(name, folder):
    """The path of a part, made unless it is there."""
    path = folder / (f"{name}.stl" if name == "scan" else f"{name}.step")
    if path.exists():
        return path
    if name == "scan":
        triangles = scan()
        records = np.zeros(len(triangles), dtype=[("normal", "<3f4"), ("corners", "<9f4"), ("attributes", "<u2")])
        records["corners"] = triangles.reshape(-1, 9)
        path.write_bytes(b"\0" * 80 + struct.pack("<I", len(triangles)) + records.tobytes())
        return path
    script = folder / f"{name}.geo"
    script.write_text(f'SetFactory("OpenCASCADE");\n{CAD[name]}\nSave "{path.name}";\n')
    made = subprocess.run(["gmsh", "-0", script, "-o", folder / f"{name}.brep"], capture_output=True, text=True, check=False)
    if not path.exists():
        sys.exit(f"gmsh does not make {path}: {made.stdout}{made.stderr}")
    return path

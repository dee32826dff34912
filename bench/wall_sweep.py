#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Chooses kWallCells (docs/notes/verdict.md): the singular lines and the alignment of thin parts by the cells across their wall.

    bench/wall_sweep.py PROGRAM

A plate with a hole, an angle and a ring, turned at random against the grid, walls of 1/20 of the length; the lines are compared with those at 8 cells.
"""

import json
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

CELLS = (1, 1.5, 2, 2.5, 3, 3.5, 4, 6, 8)
WALL = 0.05
TURNS = ((0, 0, 0), (0.4, 0.7, -0.2), (1.1, -0.3, 0.5))


def rotation(vector):
    angle = np.linalg.norm(vector)
    if angle == 0:
        return np.eye(3)
    x, y, z = np.array(vector) / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def swept(outer, inner, height):
    """Triangles of the prism between two closed polygons of equal length; `inner` may be None for a full one of four corners."""
    triangles = []
    n = len(outer)
    low, high = (lambda p: (*p, 0.0)), (lambda p: (*p, height))
    for k in range(n):
        a, b = outer[k], outer[(k + 1) % n]
        triangles += [(low(a), low(b), high(b)), (low(a), high(b), high(a))]
        if inner is None:
            continue
        c, d = inner[k], inner[(k + 1) % n]
        triangles += [(low(d), low(c), high(c)), (low(d), high(c), high(d))]
        triangles += [(high(a), high(b), high(d)), (high(a), high(d), high(c)), (low(b), low(a), low(c)), (low(b), low(c), low(d))]
    if inner is None:
        for k in range(1, n - 1):
            triangles += [(high(outer[0]), high(outer[k]), high(outer[k + 1])), (low(outer[0]), low(outer[k + 1]), low(outer[k]))]
    return np.array(triangles)


def plate_with_hole():
    angles = np.linspace(0, 2 * np.pi, 64, endpoint=False) + np.pi / 4
    circle = 0.2 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    square = circle / np.abs(circle).max(axis=1, keepdims=True) * 0.5
    return swept(square, circle, WALL)


def angle_profile():
    return swept(np.array([(WALL, WALL), (WALL, 1), (0, 1), (0, 0), (1, 0), (1, WALL)]), None, 0.5)


def ring():
    angles = np.linspace(0, 2 * np.pi, 96, endpoint=False)
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    return swept(0.5 * circle, (0.5 - WALL) * circle, 0.4)


def stl(triangles):
    triangles = triangles.astype("<f4")
    return bytes(80) + struct.pack("<I", len(triangles)) + b"".join(bytes(12) + t.tobytes() + bytes(2) for t in triangles)


def solved(program, triangles, cells):
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "part.stl").write_bytes(stl(triangles))
        subprocess.run([program, "solve", "part.stl", "-o", "out", "--cell-size", str(WALL / cells), "--quiet"], cwd=folder, check=True)
        return json.loads((Path(folder) / "out" / "report.json").read_text())


def main():
    print("| part | turned | " + " | ".join(f"{cells:g}" for cells in CELLS) + " |")
    for name, part in (("plate", plate_with_hole()), ("angle", angle_profile()), ("ring", ring())):
        for turn in TURNS:
            reports = [solved(sys.argv[1], part @ rotation(turn).T, cells) for cells in CELLS]
            entries = [f"{r['singularity']['arcs']}, {r['alignment_deg']['mean'] or 0:.2g}°" for r in reports]
            print(f"| {name} | {turn} | " + " | ".join(entries) + " |", flush=True)


if __name__ == "__main__":
    main()

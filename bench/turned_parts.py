#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the energies of a part in random rotations, relative to that of the part as given (docs/notes/solver.md).

    turned_parts.py PROGRAM PART.stl [CELLS] [ROTATIONS] [SIZES]

PROGRAM is the built command line program, PART a binary STL file, CELLS along its longest side as given (default
64); all rotations are solved on cells of the same size.

With SIZES above 1 each energy is the mean over so many cell sizes, from about CELLS - SIZES / 2 to CELLS + SIZES / 2
cells across, followed by the smallest and largest relative to the mean. Creases along the axes of the grid cut all
their cells alike, so one size is not representative of the part as given.
"""

import json
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
SEED = 7


def rotation(random):
    w, x, y, z = (lambda q: q / np.linalg.norm(q))(random.normal(size=4))
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


KEYS = ("total", "smoothness", "boundary")


def energies(program, facets, turn, cell_sizes):
    """Returns one row of KEYS for each cell size."""
    turned = facets.copy()
    turned["corners"] = facets["corners"].astype(float) @ turn.T
    with tempfile.TemporaryDirectory() as folder:
        model = Path(folder) / "turned.stl"
        model.write_bytes(bytes(80) + struct.pack("<I", len(turned)) + turned.tobytes())
        result = Path(folder) / "out"
        rows = []
        for cell_size in cell_sizes:
            subprocess.run([program, "solve", model, "--cell-size", str(cell_size), "-o", result, "--quiet"], check=True)
            energy = json.loads((result / "report.json").read_text())["energy"]
            rows.append([energy[key] for key in KEYS])
    return np.array(rows)


def print_ratios(rows, upright):
    means = rows.mean(axis=0)
    for key, ratio, low, high in zip(KEYS, means / upright, rows.min(axis=0) / means, rows.max(axis=0) / means):
        spread = f" ({low:.3f} to {high:.3f})" if len(rows) > 1 else ""
        print(f"{key} {ratio:.3f}{spread}  ", end="")
    print(flush=True)


def main():
    program, part = sys.argv[1:3]
    cells = float(sys.argv[3]) if len(sys.argv) > 3 else 64
    count = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    facets = np.frombuffer(Path(part).read_bytes(), FACET, offset=84)
    sizes = int(sys.argv[5]) if len(sys.argv) > 5 else 1
    extent = float(np.ptp(facets["corners"].reshape(-1, 3), axis=0).max())
    cell_sizes = [extent / (cells + k - (sizes - 1) // 2) for k in range(sizes)]
    random = np.random.default_rng(SEED)
    upright = energies(program, facets, np.eye(3), cell_sizes)
    if sizes > 1:
        print_ratios(upright, upright.mean(axis=0))
    for _ in range(count):
        print_ratios(energies(program, facets, rotation(random), cell_sizes), upright.mean(axis=0))


if __name__ == "__main__":
    main()

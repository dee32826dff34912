#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The energies of a part turned by random rotations, over that of the part as it stands (docs/solver.md).

    turned_parts.py PROGRAM PART.stl [CELLS] [ROTATIONS]

PROGRAM is the built command line program, PART a binary STL file, CELLS along its longest side as it stands (default
64); all rotations are solved on cells of the same size.
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


def energies(program, facets, turn, cell_size):
    turned = facets.copy()
    turned["corners"] = facets["corners"].astype(float) @ turn.T
    with tempfile.TemporaryDirectory() as folder:
        model = Path(folder) / "turned.stl"
        model.write_bytes(bytes(80) + struct.pack("<I", len(turned)) + turned.tobytes())
        result = Path(folder) / "out"
        subprocess.run([program, "solve", model, "--cell-size", str(cell_size), "-o", result, "--quiet"], check=True)
        return json.loads((result / "report.json").read_text())["energy"]


def main():
    program, part = sys.argv[1:3]
    cells = float(sys.argv[3]) if len(sys.argv) > 3 else 64
    count = int(sys.argv[4]) if len(sys.argv) > 4 else 3
    facets = np.frombuffer(Path(part).read_bytes(), FACET, offset=84)
    cell_size = float(np.ptp(facets["corners"].reshape(-1, 3), axis=0).max()) / cells
    random = np.random.default_rng(SEED)
    upright = energies(program, facets, np.eye(3), cell_size)
    for _ in range(count):
        turned = energies(program, facets, rotation(random), cell_size)
        print("  ".join(f"{key} {turned[key] / upright[key]:.3f}" for key in ("total", "smoothness", "boundary")), flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Whether our hexahedra are those of libHexEx on the same maps.

    same_hexahedra.py BUILT FOLDER [NAME...]

BUILT is the folder of build.sh's programs, FOLDER that of bench/grid_maps: NAME.hexex and NAME.mesh. Vertices are the same if they lie within
LARGEST_DISTANCE of a hexahedron's size, hexahedra if they have the same eight of them. Prints a row for each map.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from hex_judges import euler_of_surface
from hex_mesh import judged, read_hexahedra

LARGEST_DISTANCE = 1e-3
SECONDS = 120


def read_map(path):
    words = path.read_text().split()
    count = int(words[0])
    points = np.array(words[1:1 + 3 * count], float).reshape(-1, 3)
    tets = np.array(words[2 + 3 * count:], float).reshape(int(words[1 + 3 * count]), 16)[:, :4].astype(int)
    return points, tets


def common(ours, theirs):
    """The number of hexahedra that both have."""
    if not len(ours.hexahedra) or not len(theirs.hexahedra):
        return 0
    used = np.unique(theirs.hexahedra)
    distance, nearest = cKDTree(ours.points).query(theirs.points[used])
    name = {vertex: other if near < LARGEST_DISTANCE else -1 - vertex for vertex, other, near in zip(used.tolist(), nearest.tolist(), distance)}
    return len({frozenset(h) for h in ours.hexahedra.tolist()} & {frozenset(name[v] for v in h) for h in theirs.hexahedra.tolist()})


def main(built, folder, names):
    print("| map | ours | libHexEx | in common | closed, ours and libHexEx | least scaled Jacobian | share of volume |\n|---|---|---|---|---|---|---|")
    for path in [folder / f"{name}.hexex" for name in names] or sorted(folder.glob("*.hexex")):
        made = path.with_suffix(".ovm")
        made.unlink(missing_ok=True)
        subprocess.run([built / "hexex", path, made], capture_output=True, timeout=SECONDS, check=False)
        points, tets = read_map(path)
        volume = np.linalg.det(points[tets][:, 1:] - points[tets][:, :1]).sum() / 6
        ours, theirs = read_hexahedra(path.with_suffix(".mesh")), read_hexahedra(made)
        one, other = (judged(mesh, volume, euler_of_surface(tets)) for mesh in (ours, theirs))
        print(f"| {path.stem} | {one['hexahedra']} | {other['hexahedra']} | {common(ours, theirs)} | {one['closed']}, {other['closed']} | "
              f"{one['least']} | {one['share']} |", flush=True)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3:])

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Compares what CubeCover and mouette find in the written files with the files' own matchings, face by face and edge by edge.

    matchings.py BUILT MOUETTE FOLDER...

BUILT is the folder of build.sh's programs, MOUETTE a checkout of mouette. FOLDER is what `crossgrain solve --write fra,perm,frame`
wrote, with its mesh as tets.mesh (hex_judges.py leaves such folders) or onto.mesh. One row of a table for each folder:

    faces              inner faces
    not nearest        of these, where CubeCover's matching of the frames is not that of onto.perm: 0 but after repairs
    given, own         singular edges by CubeCover from onto.perm, from its own matchings; in brackets how many edges are
                       singular for one of CubeCover and seamless_map.py only
    mouette            singular edges by mouette from onto.frame, the same in brackets against the nearest frames

Exits with 1 where a number in brackets is not 0.
"""

import subprocess
import sys
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "command"))
from poisson_map import read_field  # noqa: E402


def lines_of(*command):
    finished = subprocess.run([str(part) for part in command], capture_output=True, text=True, check=False)
    if finished.returncode:
        raise ValueError(f"{command[0]}: exit code {finished.returncode}: {finished.stderr.strip()[-300:]}")
    return [line.split() for line in finished.stdout.splitlines()]


def edges_of(lines, name):
    return {tuple(sorted(map(int, line[1:3]))) for line in lines if line[0] == name}


def singular_edges(field):
    return {tuple(field.edges[e].tolist()) for e in field.singular_edges()}


def given_matchings(folder):
    rows = np.loadtxt(folder / "onto.perm", dtype=int, skiprows=2, ndmin=2).tolist()
    return {(a, b): images for a, b, *images in rows}


def inverse(images):
    """The matching from b to a, where `images` is that from a to b."""
    result = [0, 0, 0]
    for k, image in enumerate(images):
        result[abs(image) - 1] = (k + 1) if image > 0 else -(k + 1)
    return result


def row_of(built, mouette, folder):
    """Cells of the table, and whether all agree."""
    mesh = folder / "tets.mesh" if (folder / "tets.mesh").exists() else folder / "onto.mesh"
    fra, perm = folder / "onto.fra", folder / "onto.perm"
    lines = lines_of(built / "cubecover_matchings", mesh, fra, perm)
    given, nearest = singular_edges(read_field(mesh, fra, perm)), singular_edges(read_field(mesh, fra))
    rows, faces, differ = given_matchings(folder), 0, 0
    for name, a, b, *images in lines:
        if name == "face":
            a, b, images = int(a), int(b), list(map(int, images))
            expected = rows.get((a, b)) or inverse(rows.get((b, a), [1, 2, 3]))
            faces, differ = faces + 1, differ + (images != expected)
    pairs = [(edges_of(lines, "given"), given), (edges_of(lines, "own"), nearest)]
    if mouette.is_dir():
        script = Path(__file__).with_name("mouette_singular_edges.py")
        pairs.append((edges_of(lines_of(sys.executable, script, mouette, mesh, folder / "onto.frame"), "own"), nearest))
    cells = [folder.name, faces, differ, *(f"{len(found)} ({len(found ^ expected)})" for found, expected in pairs)]
    return cells, all(found == expected for found, expected in pairs)


def main(built, mouette, *folders):
    print("| field | faces | not nearest | given | own | mouette |\n|---|---|---|---|---|---|")
    agreed = True
    for folder in map(Path, folders):
        cells, same = row_of(Path(built), Path(mouette), folder)
        print("| " + " | ".join(map(str, cells)) + " |", flush=True)
        agreed &= same
    return 0 if agreed else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if len(sys.argv) > 3 else __doc__)

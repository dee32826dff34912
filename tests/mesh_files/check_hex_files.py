#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Has another program read files of hexahedra.

    check_hex_files.py gmsh|meshio|calculix FOLDER

FOLDER has beam.msh, beam.mesh and beam.inp of a beam of 80 x 10 x 10 in 8 x 2 x 2 hexahedra, whose sides have the tags 11 and 12
(across x), 13 and 14 (y), 15 and 16 (z) and whose halves along x are the regions 1 and 2; and untagged.inp, the same without tags
and regions. Exits with 1 and a message where the program does not see all of this, with 77 where it is not installed.
"""
import importlib.util
import re
import shutil
import subprocess
import sys
from pathlib import Path

NOT_INSTALLED = 77
LENGTH, SIDE = 80.0, 10.0
NODES, HEXAHEDRA = 9 * 3 * 3, 8 * 2 * 2
FACES = {11: 4, 12: 4, 13: 16, 14: 16, 15: 16, 16: 16}  # quadrilaterals of each tag
YOUNG, POISSON = 210000.0, 0.3


def output_of(folder, *command):
    result = subprocess.run(command, cwd=folder, capture_output=True, timeout=120, check=False, text=True, errors="replace")
    assert result.returncode == 0, " ".join(command) + ": " + result.stdout + result.stderr
    return result.stdout + result.stderr


def has_module(name):
    return importlib.util.find_spec(name) is not None


def check_gmsh(folder):
    for name in ("beam.msh", "beam.mesh"):
        output = output_of(folder, "gmsh", name, "-check")
        assert "Error" not in output and "Warning" not in output, output
        assert f"{NODES} nodes" in output and f"coherence ({HEXAHEDRA + 72} elements)" in output, output
    # What gmsh has read, in its simplest format: each element with the number of its group.
    output_of(folder, "gmsh", "beam.msh", "-save", "-format", "msh2", "-o", "again.msh")
    text = (folder / "again.msh").read_text()
    names = re.search(r"\$PhysicalNames\n\d+\n(.*?)\$End", text, re.S).group(1).splitlines()
    expected = {f'2 {tag} "face {tag}"' for tag in FACES} | {f'3 {region} "region {region}"' for region in (1, 2)}
    assert set(names) == expected, names
    counts = {}
    for line in re.search(r"\$Elements\n\d+\n(.*?)\$End", text, re.S).group(1).splitlines():
        _, kind, _, group, *_ = map(int, line.split())
        counts[kind, group] = counts.get((kind, group), 0) + 1
    assert counts == {**{(3, tag): count for tag, count in FACES.items()}, (5, 1): 16, (5, 2): 16}, counts


def check_meshio(folder):
    import meshio

    faces = {f"face {tag}": count for tag, count in FACES.items()}
    mesh = meshio.read(folder / "beam.msh")
    groups = {name: {kind: len(cells) for kind, cells in of_kinds.items() if len(cells)} for name, of_kinds in mesh.cell_sets_dict.items()
              if not name.startswith("gmsh:")}
    expected = {**{name: {"quad": count} for name, count in faces.items()}, **{f"region {k}": {"hexahedron": 16} for k in (1, 2)}}
    assert groups == expected, groups
    assert {name: tuple(data) for name, data in mesh.field_data.items()} == {
        **{f"face {tag}": (tag, 2) for tag in FACES}, "region 1": (1, 3), "region 2": (2, 3)}, mesh.field_data

    medit = meshio.read(folder / "beam.mesh")
    references = medit.cell_data_dict["medit:ref"]
    assert {tag: int((references["quad"] == tag).sum()) for tag in FACES} == FACES
    assert [int((references["hexahedron"] == k).sum()) for k in (1, 2)] == [16, 16]

    inp = meshio.read(folder / "beam.inp")
    assert set(inp.point_sets) == {f"FACE_{tag}" for tag in FACES}, inp.point_sets
    assert {name: sum(map(len, sets)) for name, sets in inp.cell_sets.items()} == {"ALL": 32, "REGION_1": 16, "REGION_2": 16}
    for tag, axis, place in ((11, 0, 0), (12, 0, LENGTH), (13, 1, 0), (14, 1, SIDE), (15, 2, 0), (16, 2, SIDE)):
        nodes = inp.point_sets[f"FACE_{tag}"]
        assert (inp.points[nodes, axis] == place).all() and len(nodes) == (9 if axis == 0 else 27), tag
    assert (medit.points == inp.points).all()


def displacements(folder, mesh, sections, constraints, loads):
    """Of a static step, by node."""
    (folder / "run.inp").write_text("\n".join([
        f"*INCLUDE, INPUT={mesh}", "*MATERIAL, NAME=STEEL", "*ELASTIC", f"{YOUNG}, {POISSON}",
        *(f"*SOLID SECTION, ELSET={name}, MATERIAL=STEEL" for name in sections),
        "*BOUNDARY", *constraints, "*STEP", "*STATIC", *loads, "*NODE PRINT, NSET=ALL", "U", "*END STEP", ""]))
    output = output_of(folder, "ccx", "run")
    assert "ERROR" not in output and "WARNING" not in output and "Job finished" in output, output
    rows = [line.split() for line in (folder / "run.dat").read_text().splitlines()]
    moved = {int(row[0]): [float(word) for word in row[1:]] for row in rows if len(row) == 4 and row[0].isdigit()}
    assert len(moved) == NODES, moved
    return moved


def places(folder):
    text = (folder / "beam.inp").read_text()
    lines = re.search(r"\*NODE, NSET=ALL\n(.*?)\*", text, re.S).group(1).splitlines()
    return {int(line.split(",")[0]): [float(word) for word in line.split(",")[1:]] for line in lines}


def check_calculix(folder):
    # A cantilever: P L^3 / 3 E I.
    force = 9 * 10.0
    moved = displacements(folder, "beam.inp", ["REGION_1", "REGION_2"], ["FACE_11, 1, 3"], ["*CLOAD", "FACE_12, 3, -10."])
    expected = -force * LENGTH**3 / (3 * YOUNG * SIDE**4 / 12)
    tip = moved[NODES][2]
    assert abs(tip / expected - 1) < 0.05, (tip, expected)

    # Under pressure from all sides a body shrinks evenly, if the loads are on its surface and nowhere else.
    at = places(folder)
    numbers = {tuple(place): number for number, place in at.items()}
    constraints = [f"{numbers[0, 0, 0]}, 1, 3", f"{numbers[LENGTH, 0, 0]}, 2, 3", f"{numbers[0, SIDE, 0]}, 3, 3"]
    shrinking = -100 * (1 - 2 * POISSON) / YOUNG
    for mesh, surfaces in (("beam.inp", [f"FACE_{tag}" for tag in FACES]), ("untagged.inp", ["BOUNDARY"])):
        moved = displacements(folder, mesh, ["ALL"], constraints, ["*DLOAD", *(f"{name}, P, 100." for name in surfaces)])
        for number, place in at.items():
            for coordinate, way in zip(place, moved[number]):
                assert abs(way - shrinking * coordinate) < 1e-5 * abs(shrinking) * LENGTH, (mesh, number, moved[number])


CHECKS = {"gmsh": (lambda: shutil.which("gmsh"), check_gmsh), "meshio": (lambda: has_module("meshio"), check_meshio),
          "calculix": (lambda: shutil.which("ccx"), check_calculix)}


def main(program, folder):
    is_installed, check = CHECKS[program]
    if not is_installed():
        sys.exit(NOT_INSTALLED)
    check(Path(folder))


if __name__ == "__main__":
    main(*sys.argv[1:])

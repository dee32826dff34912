#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes docs/gallery.md and its pictures anew, from models of other people's collections.

Usage: docs/gallery/make.py PROGRAM MODELS

PROGRAM is the program `crossgrain`, MODELS the folder that holds the models and MANIFEST.tsv, which says where they are from. Takes a
minute. Times in the table are those of one run on the machine at hand; all other numbers come out the same anywhere.
"""

import csv
import json
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SIZE = "1000x750"

# File, what it shows, further arguments of `render`.
FIELDS = [
    ("featuretype.STEP", "A CAD part with nine handles: four lines of index -1/4 around each hole.", ["--colour", "alignment"]),
    ("i10o_simp.step", "A bracket with a slanted hole, cut open. Where three of its planes meet the cut askew, so do the frames.", ["--cut", "z"]),
    ("i02o_m2.step", "MAMBO's M2. Two lines, in crimson, turn across themselves: no hexahedral mesh can have them.", []),
    ("s11o_cube_cyl.stp", "A cylinder on a cube, cut open: the round part's lines bend out to its edge.", ["--cut", "x"]),
    ("base_interface_AP214.STEP", "A thin plate with holes, cut along its middle.", ["--cut", "z", "--view", "-60,40"]),
    ("1002_tray_bottom.STL", "A tray of sheet metal with 23 handles, far thinner than wide.", ["--view", "-60,40"]),
    ("platonic_shelf.obj", "Five solids in one file, most of them with no right angle: what their surfaces ask of each cell.", ["--colour", "class"]),
    ("spot.ply", "An animal, without any flat face. Five lines, in crimson, no hexahedral mesh can have.",
     ["--up", "y", "--view", "40,15"]),
    ("torus.obj", "A torus, cut open: four closed lines along it.", ["--cut", "y"]),
    ("sphere_r0.12.mesh", "A ball of tets: twelve lines, like the edges of a cube blown up to touch the surface.", []),
]


def sources(models):
    with (models / "MANIFEST.tsv").open(encoding="utf-8", newline="") as lines:
        return {row["file"]: row for row in csv.DictReader(lines, delimiter="\t")}


def verdict(singularity):
    if singularity["meshable"]:
        return "yes"
    faults = singularity["not_meshable_arcs"], singularity["not_meshable_nodes"]
    words = [f"{count} {name}{'s' if count > 1 else ''}" for count, name in zip(faults, ("line", "node")) if count]
    return "no: " + " and ".join(words)


def make(program, models, file, arguments, folder):
    """Solves, draws, and gives the report."""
    result = folder / Path(file).stem
    subprocess.run([program, "solve", models / file, "-o", result, "--quiet", "--no-report"], check=True, stderr=subprocess.DEVNULL)
    subprocess.run([program, "render", result, "-o", HERE / f"{Path(file).stem}.png", "--size", SIZE, *arguments], check=True,
                   stdout=subprocess.DEVNULL)
    return json.loads((result / "report.json").read_text())


def section(file, caption, arguments, report, source):
    name = Path(file).stem
    where, licence = source["source"].split(" ")[0], source["licence"].split(" (")[0]
    singularity, alignment = report["singularity"], report["alignment_deg"]
    numbers = [
        ("cells", f"{report['levels'][-1]['active_cells']:,}"),
        ("energy", f"{report['energy']['total']:.4g}"),
        ("off the surface, mean, 95 %", f"{alignment['mean']:.2f}°, {alignment['p95']:.2f}°"),
        ("singular lines, nodes, ends", f"{singularity['arcs']}, {singularity['nodes']}, {singularity['boundary_ends']}"),
        ("a hexahedral mesh can have them", verdict(singularity)),
        ("seconds", f"{report['seconds']['total']:.1f}"),
    ]
    table = "| " + " | ".join(key for key, _ in numbers) + " |\n" + "|---" * len(numbers) + "|\n| " + " | ".join(value for _, value in numbers) + " |"
    command = " ".join(["crossgrain render", f"{name}.frames", *arguments])
    return f"## {file}\n\n![{caption}](gallery/{name}.png)\n\n{caption} `{command}`\n\n{table}\n\nModel: {where}, {licence}.\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, models = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    manifest = sources(models)
    with tempfile.TemporaryDirectory() as folder:
        sections = [section(file, caption, arguments, make(program, models, file, arguments, Path(folder)), manifest[file])
                    for file, caption, arguments in FIELDS]
    head = ("# Gallery\n\nTen fields on models of other people, as `crossgrain solve MODEL` finds them at the default resolution, drawn by `crossgrain render`.\n"
            "Singular lines are blue where three hexahedra would meet, orange for five, green for six, and crimson where none can. [pictures.md](pictures.md) says what else\n"
            "is to be seen, [report.md](report.md) what the numbers are. All of this page is made by `docs/gallery/make.py PROGRAM MODELS`.\n\n")
    (HERE.parent / "gallery.md").write_text(head + "\n".join(sections), encoding="utf-8")


if __name__ == "__main__":
    main()

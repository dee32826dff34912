#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes docs/gallery.md and its pictures, from models of other authors.

Usage: docs/gallery/make.py PROGRAM MODELS

PROGRAM is the program `crossgrain`, MODELS the folder of the models and MANIFEST.tsv, which names their sources. Takes a
minute. Times in the table are those of one run on this machine; all other numbers are the same on any machine.
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
    ("i10o_simp.step", "A bracket with a slanted hole, cut open.", ["--cut", "z"]),
    ("i02o_m2.step", "MAMBO's M2. Frames rotate about an axis across the two crimson lines: no hexahedral mesh can have them.", []),
    ("s11o_cube_cyl.stp", "A cylinder on a cube, cut open: the lines of the cylinder bend outwards to its edge.", ["--cut", "x"]),
    ("base_interface_AP214.STEP", "A thin plate with holes, cut along its middle.", ["--cut", "z", "--view", "-60,40"]),
    ("1002_tray_bottom.STL", "A tray of thin sheet metal with 23 handles.", ["--view", "-60,40"]),
    ("platonic_shelf.obj", "Five solids in one file, most without right angles, coloured by the class of the constraints.", ["--colour", "class"]),
    ("spot.ply", "An animal without flat faces. No hexahedral mesh can have the two lines in crimson.", ["--up", "y", "--view", "40,15"]),
    ("torus.obj", "A torus, cut open: four closed lines along it.", ["--cut", "y"]),
    ("sphere_r0.12.mesh", "A ball of tets: twelve lines, like the edges of a cube that touches the surface.", []),
]

HEAD = """# Gallery

Ten models of other authors, as `crossgrain solve MODEL` solves them at the default resolution and `crossgrain render` draws them. Singular lines are blue where three hexahedra would meet, orange for five, green for six, and crimson
if no hexahedral mesh can have them. [pictures.md](pictures.md) and [report.md](report.md) explain pictures and numbers.

"""

TAIL = "`docs/gallery/make.py PROGRAM MODELS` makes this page.\n"

COLUMNS = ["model", "cells", "energy", "alignment, mean and 95 %", "lines, nodes, ends", "hexahedra", "seconds"]


def sources(models):
    with (models / "MANIFEST.tsv").open(encoding="utf-8", newline="") as lines:
        return {row["file"]: row for row in csv.DictReader(lines, delimiter="\t")}


def make(program, models, file, arguments, folder):
    """Solves a model, draws it, and returns the report."""
    result = folder / Path(file).stem
    subprocess.run([program, "solve", models / file, "-o", result, "--quiet", "--no-report"], check=True, stderr=subprocess.DEVNULL)
    subprocess.run([program, "render", result, "-o", HERE / f"{Path(file).stem}.png", "--size", SIZE, *arguments], check=True,
                   stdout=subprocess.DEVNULL)
    return json.loads((result / "report.json").read_text())


def row(file, report):
    """The cells of a model's row in the table."""
    singularity, alignment = report["singularity"], report["alignment_deg"]
    return [f"[{file}](#{anchor(file)})", f"{report['levels'][-1]['active_cells']:,}", f"{report['energy']['total']:.4g}",
            f"{alignment['mean']:.2f}°, {alignment['p95']:.2f}°",
            f"{singularity['arcs']}, {singularity['nodes']}, {singularity['boundary_ends']}", report["verdict"].replace("_", " "),
            f"{report['seconds']['total']:.1f}"]


def anchor(heading):
    return "".join(letter for letter in heading.lower() if letter.isalnum() or letter in "-_")


def table(rows):
    return "".join(f"| {' | '.join(cells)} |\n" for cells in [COLUMNS, ["---"] * len(COLUMNS), *rows])


def section(file, caption, arguments, source):
    name = Path(file).stem
    where, licence = source["source"].split(" ")[0], source["licence"].split(" (")[0]
    command = " ".join(["crossgrain render", f"{name}.frames", *arguments])
    return f"## {file}\n\n![{caption}](gallery/{name}.png)\n\n{caption} `{command}`\n\nModel: {where}, {licence}.\n\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, models = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    manifest = sources(models)
    with tempfile.TemporaryDirectory() as folder:
        reports = [make(program, models, file, arguments, Path(folder)) for file, _, arguments in FIELDS]
    rows = [row(file, report) for (file, _, _), report in zip(FIELDS, reports)]
    sections = [section(file, caption, arguments, manifest[file]) for file, caption, arguments in FIELDS]
    (HERE.parent / "gallery.md").write_text(HEAD + table(rows) + "\n" + "".join(sections) + TAIL, encoding="utf-8")


if __name__ == "__main__":
    main()

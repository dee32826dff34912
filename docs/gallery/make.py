#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes docs/gallery.md and its pictures, from models of other authors.

Usage: docs/gallery/make.py PROGRAM MODELS

PROGRAM is the program `crossgrain`, MODELS a folder with models/good/ and hexme/, each with a MANIFEST.tsv, which names the
sources of its models. Takes a minute. Times in the table are those of one run on this machine; all other numbers are the same on any machine.
"""

import csv
import json
import lzma
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
SIZE = "1000x750"

# File, what it shows, further arguments of `render`.
FIELDS = [
    ("models/good/featuretype.STEP", "A CAD part with nine handles: four lines of index -1/4 around each hole.", ["--colour", "alignment"]),
    ("hexme/i10c_simp.vtk.xz", "A bracket with a slanted hole, as tets, cut open along the hole.", ["--cut", "y"]),
    ("models/good/i02o_m2.step", "MAMBO's M2.", []),
    ("models/good/s11o_cube_cyl.stp", "A cylinder on a cube, cut open: the lines of the cylinder bend outwards to its edge.", ["--cut", "x"]),
    ("models/good/base_interface_AP214.STEP", "A thin plate with holes, cut along its middle.", ["--cut", "z"]),
    ("models/good/1002_tray_bottom.STL", "A tray of thin sheet metal with 23 handles.", ["--view", "-60,40"]),
    ("hexme/s17c_sphere.vtk.xz", "A ball of tets, coloured by energy: a frame changes most along the twelve lines.", ["--cut", "x", "--colour", "energy"]),
    ("models/good/spot.ply", "An animal without flat faces, cut along its middle.", ["--up", "y", "--cut", "x"]),
    ("models/good/torus.obj", "A torus, cut open: four closed lines along it.", ["--cut", "y"]),
    ("models/good/sphere_r0.12.mesh", "A ball of tets, cut open: twelve lines, like the edges of a cube that touches the surface.", ["--cut", "z"]),
]

HEAD = """# Gallery

Ten models of other authors, as `crossgrain solve MODEL` solves them at the default resolution and `crossgrain render` draws them. [pictures.md](pictures.md) explains the marks, [report.md](report.md) the numbers.

"""

# Hexahedra of 20 cells, with what the pictures show; their names end in _before and _after.
HEXAHEDRA = [
    ("wedge.step", "Wedge: the map cuts its edges and the rim of the countersink off, and leaves out 35 cells."),
    ("housing.step", "Housing: the map has no quads on eight fillets, and cuts its bosses off."),
    ("pillow_block.step", "Pillow block: the map cuts its fillets and the ends of its slots off. Red are the ends of fillets that run out between two planes."),
    ("hexme/n03c_skijump_box_cyl.vtk.xz", "Ski jump of box and cylinder: the map rounds creases off, by up to 1.2 hexahedra."),
    ("models/good/featuretype.STEP", "Part with nine handles: the map loses two corners and six creases."),
]
HEXAHEDRA_SIZE = "700x525"

HEXAHEDRA_HEAD = """## Hexahedra before and after they keep the part

`crossgrain hex MODEL --cells 20`, drawn by `crossgrain render`; colours are scaled Jacobians. First what the map alone gives, by a program that ends
before vertices are moved onto features; then the result.

"""

TAIL = "`docs/gallery/make.py PROGRAM MODELS` makes this page.\n"

COLUMNS = ["model", "cells", "tets", "energy", "off the surface, mean and 95 %", "lines, nodes, ends", "hexahedra", "seconds"]


def sources(models):
    """The rows of both manifests, by path."""
    rows = {}
    for folder in ("models/good", "hexme"):
        with (models / folder / "MANIFEST.tsv").open(encoding="utf-8", newline="") as lines:
            rows.update({f"{folder}/{row['file']}": row for row in csv.DictReader(lines, delimiter="\t")})
    return rows


def name_of(file):
    return Path(file).name.removesuffix(".xz")


def make(program, models, file, arguments, folder):
    """Solves a model, draws it, and returns the report."""
    model, result = folder / name_of(file), folder / f"{Path(name_of(file)).stem}.frames"
    given = models / file
    model.write_bytes(lzma.open(given).read() if given.suffix == ".xz" else given.read_bytes())
    subprocess.run([program, "solve", model, "-o", result, "--quiet", "--no-report"], check=True, stderr=subprocess.DEVNULL)
    subprocess.run([program, "render", result, "-o", HERE / f"{Path(name_of(file)).stem}.png", "--size", SIZE, *arguments], check=True,
                   stdout=subprocess.DEVNULL)
    return json.loads((result / "report.json").read_text())


def row(file, report):
    """The cells of a model's row in the table."""
    onto = report.get("onto")
    singularity = (onto or report)["singularity"]
    alignment = onto["normal_deg"] if onto else report["alignment_deg"]
    return [f"[{name_of(file)}](#{anchor(name_of(file))})", f"{report['levels'][-1]['active_cells']:,}", f"{onto['tets']:,}" if onto else "",
            f"{report['energy']['total']:.4g}", f"{alignment['mean']:.2f}°, {alignment['p95']:.2f}°",
            f"{singularity['arcs']}, {singularity['nodes']}, {singularity['boundary_ends']}", report["verdict"].replace("_", " "),
            f"{report['seconds']['total']:.1f}"]


def anchor(heading):
    return "".join(letter for letter in heading.lower() if letter.isalnum() or letter in "-_")


def table(rows):
    return "".join(f"| {' | '.join(cells)} |\n" for cells in [COLUMNS, ["---"] * len(COLUMNS), *rows])


def section(file, caption, arguments, source):
    name = Path(name_of(file)).stem
    where, licence = source["source"].split(" ")[0], source["licence"].split(" (")[0]
    command = " ".join(["crossgrain render", f"{name}.frames", *arguments])
    return f"## {name_of(file)}\n\n![{caption}](gallery/{name}.png)\n\n{caption} `{command}`\n\nModel: {where}, {licence}.\n\n"


def hexahedra(program, models, file, caption, folder):
    """Makes and draws hexahedra, and returns their pictures beside those of the map, which are made by hand."""
    model, name = folder / name_of(file), Path(name_of(file)).stem
    given = models / file if "/" in file else HERE.parents[1] / "models" / file
    model.write_bytes(lzma.open(given).read() if given.suffix == ".xz" else given.read_bytes())
    result = folder / f"{name}.hexahedra"
    subprocess.run([program, "hex", model, "--cells", "20", "-o", result, "--quiet", "--no-report", "--accept", "approximate"], check=True, stderr=subprocess.DEVNULL)
    subprocess.run([program, "render", result, "-o", HERE / f"{name}_after.png", "--hexahedra", "--without", "legend", "--size", HEXAHEDRA_SIZE], check=True,
                   stdout=subprocess.DEVNULL)
    report = json.loads((result / "report.json").read_text())["hexahedra"]
    number = f"{report['hexahedra']:,} hexahedra, worst scaled Jacobian {report['scaled_jacobian']['min']:.2f}"
    return f"{caption} ({report['outcome']}; {number})\n\n![As mapped](gallery/{name}_before.png)\n![The result](gallery/{name}_after.png)\n\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, models = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    manifest = sources(models)
    with tempfile.TemporaryDirectory() as folder:
        reports = [make(program, models, file, arguments, Path(folder)) for file, _, arguments in FIELDS]
        pairs = [hexahedra(program, models, file, caption, Path(folder)) for file, caption in HEXAHEDRA]
    rows = [row(file, report) for (file, _, _), report in zip(FIELDS, reports)]
    sections = [section(file, caption, arguments, manifest[file]) for file, caption, arguments in FIELDS]
    (HERE.parent / "gallery.md").write_text(HEAD + table(rows) + "\n" + "".join(sections) + HEXAHEDRA_HEAD + "".join(pairs) + TAIL, encoding="utf-8")


if __name__ == "__main__":
    main()

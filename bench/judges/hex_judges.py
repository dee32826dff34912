#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes hexahedra of our frames with programs of others, and says how good they are: CubeCover, then libHexEx.

    hex_judges.py --program CROSSGRAIN --built BUILT --out FOLDER [--cells 10,20] [--solve "--repair ..."] MODEL...

BUILT is the folder of build.sh's programs. Models may be packed with xz. FOLDER/MODEL has the solve with its mesh as tets.mesh,
and the files of the other programs; a solve that is there is used again if --keep is given. Each mesh is scaled so that --cells
hexahedra of the frames' size fit along its longest side. Prints a table, a row for each model and number of cells:

    flips, share       of the seamless map without integers (tests/command/poisson_map.py)
    CubeCover          C, the distance from its own constraints, or how it ended
    hexahedra, others  cells of libHexEx; others are not hexahedra
    volume             of the hexahedra, as a share of the tets' volume
    least, mean        scaled Jacobian; `inverted` counts those of 0 and below
    closed, valid      hex_mesh.judged
    HexHex             hexahedra of libHexHex, which takes only maps without flips; otherwise the tets that are flipped and flat

and last how many meshes are closed and valid. Nothing is smoothed.
"""

import argparse
import re
import shlex
import subprocess
import sys
from pathlib import Path

import numpy as np

from hex_mesh import euler_number, judged, read_hexahedra, unpacked

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "command"))
from poisson_map import figures_of, read_field, read_tets  # noqa: E402
from program import medit_text  # noqa: E402

COLUMNS = ("model", "cells", "tets", "flips", "share", "CubeCover", "hexahedra", "others", "volume", "least", "mean", "inverted",
           "closed", "valid", "HexHex")
CUBECOVER_SECONDS, HEXEX_SECONDS = 300, 120


def ended(command, seconds, log):
    """How a command ended: "" if well."""
    with open(log, "w", encoding="utf-8") as output:
        try:
            code = subprocess.run(list(map(str, command)), stdout=output, stderr=output, timeout=seconds, check=False).returncode
        except subprocess.TimeoutExpired:
            return f"over {seconds} s"
    return f"exit code {code}" if code else ""


def solved(options, model):
    """The folder with the field of a model, and its tets as CubeCover reads them; raises ValueError where there is none."""
    folder = options.out / model.name.split(".")[0]
    if options.keep and (folder / "tets.mesh").exists():
        return folder
    folder.mkdir(parents=True, exist_ok=True)
    model = unpacked(model, options.out)
    command = [options.program, "solve", model, "-o", folder, "--force", "--write", options.write, "--no-report", "--quiet",
               *shlex.split(options.solve)]
    fault = ended(command, 600, options.out / f"{folder.name}.solve.log")
    if fault:
        raise ValueError(f"solve: {fault}")
    written = folder / "onto.mesh"
    points, tets = read_tets(written if written.exists() else folder / "onto.vtu")
    (folder / "tets.mesh").write_text(medit_text(points, tets))
    return folder


def made_of(options, folder, cells, points, tets):
    """Figures of the hexahedra that the programs make."""
    volume = np.linalg.det(points[tets][:, 1:] - points[tets][:, :1]).sum() / 6
    scale = cells / np.ptp(points, axis=0).max()
    stem = folder / f"cells{cells}"
    paths = {kind: stem.with_suffix(f".{kind}") for kind in ("mesh", "hexex", "ovm")}
    for path in paths.values():
        path.unlink(missing_ok=True)
    paths["mesh"].write_text(medit_text(points * scale, tets))
    command = [options.built / "cubecover_integergrid", paths["mesh"], folder / "onto.fra", folder / "onto.perm", paths["hexex"]]
    log = stem.with_suffix(".cubecover.log")
    fault = ended(command, CUBECOVER_SECONDS, log)
    if fault or not paths["hexex"].exists():
        return {"CubeCover": fault or "no map"}
    distance = [float(line.split()[1]) for line in log.read_text().splitlines() if line.startswith("C: ")]
    said = {"CubeCover": f"{distance[-1]:.0e}" if distance else "no C"}
    fault = ended([options.built / "hexex", paths["hexex"], paths["ovm"]], HEXEX_SECONDS, stem.with_suffix(".hexex.log"))
    if fault:
        return {**said, "hexahedra": f"HexEx: {fault}"}
    said["HexHex"] = said_by_hexhex(options, paths["hexex"], stem)
    figures = judged(read_hexahedra(paths["ovm"]), volume * scale**3, euler_of_surface(tets))
    return {**said, **figures, "volume": figures["share"]}


def said_by_hexhex(options, hexex, stem):
    program, made, log = options.built / "hexhex", stem.with_suffix(".hexhex.mesh"), stem.with_suffix(".hexhex.log")
    if not program.exists():
        return "not built"
    fault = ended([program, "-i", hexex, "-o", made], HEXEX_SECONDS, log)
    if fault:
        return fault
    tets = re.search(r"(\d+) Flipped and (\d+) Degenerate", log.read_text())
    if tets and tets.groups() != ("0", "0"):
        return "{} flipped, {} flat".format(*tets.groups())
    return len(read_hexahedra(made).hexahedra)


def euler_of_surface(tets):
    faces = np.sort(tets[:, [(1, 2, 3), (0, 2, 3), (0, 1, 3), (0, 1, 2)]].reshape(-1, 3), axis=1)
    unique, count = np.unique(faces, axis=0, return_counts=True)
    return euler_number(unique[count == 1])


def missing_programs(options):
    programs = [options.program, options.built / "cubecover_integergrid", options.built / "hexex"]
    return [str(path) for path in programs if not path.exists()]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("models", nargs="+", type=Path)
    parser.add_argument("--program", required=True, type=Path, help="crossgrain")
    parser.add_argument("--built", required=True, type=Path, help="the folder of build.sh's programs")
    parser.add_argument("--out", required=True, type=Path)
    parser.add_argument("--cells", default="10,20", help="hexahedra along the longest side, a table row for each number")
    parser.add_argument("--solve", default="", help="further options of crossgrain solve")
    parser.add_argument("--write", default="fra,perm,frame", help="what solve writes")
    parser.add_argument("--keep", action="store_true", help="use the solves that are in --out")
    return parser.parse_args()


def main(options):
    missing = missing_programs(options)
    if missing:
        sys.exit(f"missing: {', '.join(missing)}; bench/judges/build.sh builds the programs of others")
    options.out.mkdir(parents=True, exist_ok=True)
    print("| " + " | ".join(COLUMNS) + " |\n|" + "---|" * len(COLUMNS))
    total = closed = valid = 0
    for model in options.models:
        try:
            folder = solved(options, model)
            points, tets = read_tets(folder / "tets.mesh")
            figures = figures_of(read_field(folder / "tets.mesh", folder / "onto.fra", folder / "onto.perm"))
        except ValueError as fault:
            print(f"| {model.name.split('.')[0]} | {fault} |", flush=True)
            continue
        for cells in map(int, options.cells.split(",")):
            made = made_of(options, folder, cells, points, tets)
            row = {"model": folder.name, "cells": cells, "tets": figures["tets"], "flips": figures["flips"], **made,
                   "share": figures["flipped_share"]}
            print("| " + " | ".join(str(row.get(column, "")) for column in COLUMNS) + " |", flush=True)
            total, closed, valid = total + 1, closed + made.get("closed", False), valid + made.get("valid", False)
    print(f"\n{total} meshes, {closed} closed, {valid} valid")


if __name__ == "__main__":
    main(arguments())

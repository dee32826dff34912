#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints a table of hexahedra as the judge of the tests (tests/command/hex_judge.py) sees them: validity, corners, creases, faces, distances.

    hex_features.py --program CROSSGRAIN --out FOLDER [--cells 10,20,30] [--lattice] [--fifth] [--beside FOLDER|PROGRAM] [MODEL...]

The set: meshes of ../shared/hexme, STEP files of models/ and ../shared/models/good, and parts of cad_parts.py. FOLDER gets MODEL-CELLS with the
results and judged.json of each; with --judge only results that are there are judged again. --beside names the FOLDER of an earlier run, or
another program, which is run too: then columns and totals compare numbers of hexahedra and worst shapes. --lattice runs `hex --lattice`, on the
set that lattices are judged by: all meshes of the c series, all closed solids, the five parts, and those of cad_parts.py; --organic the same with
those of organic_parts.py.
"""

import argparse
import json
import lzma
import statistics
import subprocess
import sys
import time
from pathlib import Path

import cad_parts
import organic_parts

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / "tests" / "command"))
from hex_judge import Verdict  # noqa: E402
from hex_judge_mesh import HexFile  # noqa: E402
from hex_judge_model import Model  # noqa: E402

# The curvature-adapted meshes that had maps at 10 and 20 before features were fitted.
MESHES = ("s01c_cube", "s02c_prism", "s03c_pentagon", "s04c_tetrahedron", "s05c_cube_sphere", "s08c_cross_cyls_dr", "s10c_cyl_cutsphere",
          "s11c_cube_cyl", "s12c_cube_rounded_1", "s14c_cube_corner_sub_sphere", "s15c_cylinder", "s17c_sphere", "n03c_skijump_box_cyl",
          "n07c_anti_pyramid", "n09c_pyramid", "i25c_s40")
GOOD = ("s11o_cube_cyl.stp", "i02o_m2.step", "featuretype.STEP")
MODELS = ("housing.step", "pillow_block.step", "wedge.step")
MORE_MODELS = ("bracket.step", "pipe_branch.step")
FIFTH = 5
GOOD_SHAPE, FAIR_SHAPE, LEAST_SHAPE, OF_BOUND = 0.2, 0.1, 0.02, 0.6  # scaled Jacobians, and the share of what features' angles allow


def paths_of(shared, out, of_lattices, are_organic):
    """{name: path} of the set; packed meshes are unpacked into a folder, parts are made there."""
    out.mkdir(parents=True, exist_ok=True)
    found = {}
    meshes, models, good = MESHES, MODELS, [shared / "models" / "good" / name for name in GOOD]
    if of_lattices:
        meshes = sorted(path.name.removesuffix(".vtk.xz") for path in shared.glob("hexme/*c_*.vtk.xz"))
        models += MORE_MODELS
        good = sorted(path for path in (shared / "models" / "good").iterdir() if path.suffix != ".tsv")
    for name in meshes:
        packed, found[name] = shared / "hexme" / f"{name}.vtk.xz", out / f"{name}.vtk"
        if packed.exists() and not found[name].exists():
            found[name].write_bytes(lzma.decompress(packed.read_bytes()))
    for path in [*(ROOT / "models" / name for name in models), *good]:
        found[path.stem + ("_ply" if path.suffix == ".ply" else "")] = path
    for name in cad_parts.PARTS:
        found[name] = out / f"{name}.step"
        if not found[name].exists():
            cad_parts.make(name, out)
    if are_organic:
        found.update({name: organic_parts.make(name, out) for name in organic_parts.NAMES})
    return {name: path for name, path in found.items() if path.exists()}


def run(program, path, cells, folder, options):
    """Seconds taken, and why there is no report if there is none."""
    command = [program, "hex", path, "--cells", str(cells), "-o", folder, "--force", "--no-report", "--quiet", *(["--lattice"] if options.lattice else [])]
    start = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=options.seconds)
        fault = "" if (folder / "report.json").exists() else done.stderr.strip() or f"exit status {done.returncode}"
    except subprocess.TimeoutExpired:
        fault = f"longer than {options.seconds} s"
    return time.monotonic() - start, fault


def judge(path, cells, folder, models):
    """Figures of the judge, with the program's own `said` outcome; of an empty mesh where there is none."""
    said, mesh = "failed", HexFile([], [])
    model = Model.read(path, models)
    size = model.longest / cells
    if (folder / "report.json").exists():
        report = json.loads((folder / "report.json").read_text())["hexahedra"]
        said, size = report["outcome"].replace("-", "_"), report["size"]
        files = [folder / name for name in ("hexahedra.msh", "hexahedra.partial.msh") if (folder / name).exists()]
        mesh = HexFile.read(files[0]) if files else mesh
    return {**Verdict(mesh, model, size).figures, "said": said}


def row_of(name, cells, found, beside, seconds):
    corners, creases, faces = (found[part] for part in ("corners", "creases", "faces"))
    shape = found.get("scaled_jacobian")
    far = found.get("distances", {})
    ratio = f" ({found['hexahedra'] / beside['hexahedra']:.2f})" if beside and beside["hexahedra"] else ""
    length = 100 * creases["kept_length"] / creases["length"] if creases["length"] else 100
    return " | ".join([
        f"| {name}", str(cells), found["said"], found["outcome"], f"{found['hexahedra']}{ratio}",
        f"{shape['min']:.3f} of {shape['bound']:.2f}" if shape else "", f"{corners['kept']}/{corners['number']}",
        f"{creases['kept']}/{creases['number']}, {length:.1f} %", f"{faces['kept']}/{faces['number']}",
        *[f"{way['most']:.2f}, {way['excess_most']:.2f}, {way['excess_p99']:.2f}" for way in far.values()], *[""] * (2 - len(far)),
        f"{100 * found['volume']:+.1f} %" if "volume" in found else "", f"{seconds:.0f}" if seconds else "",
        "; ".join([*found["reasons"][:3], *(["..."] if len(found["reasons"]) > 3 else [])])]) + " |"


def share(count, number):
    return f"{count} of {number}" + (f", {100 * count / number:.1f} %" if number else "")


def totals(results, beside):
    """Rows of what the issue of features asks for, over {(name, cells): figures}."""
    rows = []
    for cells in sorted({cells for _, cells in results}):
        of_cells = [found for (_, at), found in results.items() if at == cells]
        rows.append((f"all-hex at {cells}", share(sum(found["outcome"] == "all_hex" for found in of_cells), len(of_cells))))
    good = {key: found for key, found in results.items() if found["outcome"] == "all_hex"}
    said = {key for key, found in results.items() if found["said"] == "all_hex"}
    rows.append(("said to be all-hex that are", share(len(said & good.keys()), len(said))))
    shapes = [(found["scaled_jacobian"]["min"], found["scaled_jacobian"]["bound"]) for found in good.values()]
    for least in (GOOD_SHAPE, FAIR_SHAPE, LEAST_SHAPE):
        rows.append((f"of them worst scaled Jacobian at least {least:g}, or {OF_BOUND:g} of what angles allow",
                     share(sum(worst >= min(least, OF_BOUND * bound) for worst, bound in shapes), len(shapes))))
    for part in ("corners", "faces"):
        rows.append((f"{part} kept", share(sum(found[part]["kept"] for found in results.values()), sum(found[part]["number"] for found in results.values()))))
    lengths = [(found["creases"]["kept_length"] / found["size"], found["creases"]["length"] / found["size"]) for found in results.values()]
    rows.append(("creases kept, in hexahedra of length", share(round(sum(kept for kept, _ in lengths)), round(sum(all_ for _, all_ in lengths)))))
    both = [key for key in results if key in beside and beside[key]["hexahedra"] and results[key]["hexahedra"]]
    if both:
        rows.append(("hexahedra beside the others', median", f"{statistics.median(results[k]['hexahedra'] / beside[k]['hexahedra'] for k in both):.2f}"))
        rows.append(("all-hex of the same, of the others", share(sum(beside[key]["outcome"] == "all_hex" for key in both), len(both))))
        rows.append((f"worst above {GOOD_SHAPE:g} before, below now, without more features", ", ".join(map(worse_name, filter(
            lambda key: is_worse(results[key], beside[key]), both))) or "none"))
    return rows


def is_worse(found, before):
    kept = [sum(figures[part]["kept"] for part in ("corners", "creases", "faces")) for figures in (found, before)]
    return found["scaled_jacobian"]["min"] < GOOD_SHAPE <= before["scaled_jacobian"]["min"] and kept[0] <= kept[1]


def worse_name(key):
    return f"{key[0]} at {key[1]}"


def results_of(program, out, tasks, options):
    """Yields (name, cells), figures and seconds; runs the program unless results are only to be judged again."""
    for name, path, cells in tasks:
        folder, seconds, fault = out / f"{name}-{cells}", 0, ""
        if program and not options.judge:
            seconds, fault = run(program, path, cells, folder, options)
        found = judge(path, cells, folder, options.out)
        if fault:
            found["reasons"] = [fault]
        folder.mkdir(exist_ok=True)
        (folder / "judged.json").write_text(json.dumps(found, indent=1))
        yield (name, cells), found, seconds


def beside_of(options, tasks):
    """{(name, cells): figures} of the other run; the other program is run here."""
    if not options.beside:
        return {}
    if options.beside.is_file():
        folder = options.out / "beside"
        folder.mkdir(exist_ok=True)
        return {key: found for key, found, _ in results_of(options.beside, folder, tasks, options)}
    files = {(name, cells): options.beside / f"{name}-{cells}" / "judged.json" for name, _, cells in tasks}
    return {key: json.loads(file.read_text()) for key, file in files.items() if file.exists()}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=Path)
    parser.add_argument("--out", required=True, type=Path)
    parser.add_argument("--shared", type=Path, default=ROOT.parent / "shared")
    parser.add_argument("--cells", default="10,20,30")
    parser.add_argument("--lattice", action="store_true", help="hexahedra of lattices, on the set that these are judged by")
    parser.add_argument("--organic", action="store_true", help="with a scan, a cross of pipes and a stirrer")
    parser.add_argument("--fifth", action="store_true", help="every fifth run of the set, always the same")
    parser.add_argument("--beside", type=Path)
    parser.add_argument("--judge", action="store_true", help="judge the results in FOLDER again, without the program")
    parser.add_argument("--seconds", type=float, default=900, help="limit for each run (default 900)")
    parser.add_argument("models", nargs="*", metavar="MODEL")
    options = parser.parse_args()
    if not options.program and not options.judge:
        parser.error("--program is needed, or --judge")
    paths = paths_of(options.shared, options.out, options.lattice, options.organic)
    if unknown := set(options.models) - set(paths):
        parser.error(f"no such model: {', '.join(sorted(unknown))}; there are {', '.join(paths)}")
    tasks = [(name, paths[name], int(cells)) for name in options.models or paths for cells in options.cells.split(",")]
    tasks = tasks[::FIFTH] if options.fifth else tasks
    if options.judge:
        tasks = [task for task in tasks if (options.out / f"{task[0]}-{task[2]}" / "report.json").exists()]
    beside, results = beside_of(options, tasks), {}
    print("Distances: most, beyond what straight edges cut off, and the 99th percentile of that; in hexahedra of the size asked for.\n")
    print("| model | cells | said | judged | hexahedra | worst shape | corners | creases | faces | mesh to model | model to mesh | volume | s | lacks |")
    print("|" + "---|" * 14)
    for key, found, seconds in results_of(options.program, options.out, tasks, options):
        results[key] = found
        print(row_of(*key, found, beside.get(key), seconds), flush=True)
    print("\n| over all | |\n|---|---|\n" + "\n".join(f"| {name} | {value} |" for name, value in totals(results, beside)))


if __name__ == "__main__":
    main()

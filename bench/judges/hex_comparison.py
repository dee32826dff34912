#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Hexahedra of `crossgrain hex` beside those that programs of others make on the same frames: the table of docs/comparison.md.

    hex_comparison.py --program CROSSGRAIN --built BUILT --out FOLDER [--cells 10,20] [--seconds 120] MODEL...

BUILT is the folder of build.sh's programs. Models may be packed with xz. For each model and number of hexahedra along its longest side:

    crossgrain hex           from the file to the mesh; *before* is the worst scaled Jacobian before smoothing
    CubeCover + libHexEx     on the tets, frames and matchings that it leaves (onto.mesh, .fra, .perm), or `solve --prepare --repair` if it takes
                             too long, for the same size; not smoothed
    hexdom of geogram        on the same tets and their onto.frames, for the same size; hex-dominant

Each may take --seconds in all; the seconds of the other programs are those after the field. hex_mesh.judged says what valid means, for all
three alike, but the surface of the model may be at most LARGEST_GAP sizes of hexahedra off that of the mesh. FOLDER/MODEL-CELLS keeps their files, and seconds in
figures.json; those that are there are judged, not made again.
"""

import argparse
import json
import shutil
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from geogram_hexdom import fault_of_our_start, fault_of_stages
from hex_judges import ended, euler_of_surface
from hex_mesh import judged, read_hexahedra, unpacked

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "command"))
from poisson_map import read_tets  # noqa: E402
from program import medit_text  # noqa: E402

MESHES = {"crossgrain": ("hexahedra*.mesh", False), "cubecover": ("cubecover/map.ovm", True),
          "hexdom": ("geogram/ours/hexdom.geogram_ascii", False)}  # and whether in sizes of hexahedra
PROGRAMS = tuple(MESHES)
NOT_ALL_HEX = 6
LARGEST_GAP = 1.5  # of a valid mesh, as HexTuning::largest_gap
LARGE_GAP = 0.5  # a gap that is worth a word
SAMPLES = 9  # of a quadrilateral, each way


class Model:
    """What a solve of ours left in a folder: tets.mesh and frames."""

    def __init__(self, folder, cells):
        self.folder = folder
        self.points, self.tets = read_tets(folder / "onto.mesh")
        shutil.copy(folder / "onto.mesh", folder / "tets.mesh")
        self.size = np.ptp(self.points, axis=0).max() / cells
        self.volume = np.linalg.det(self.points[self.tets][:, 1:] - self.points[self.tets][:, :1]).sum() / 6
        self.euler = euler_of_surface(self.tets)

    def judged(self, path, scale=1):
        """hex_mesh.judged, and the gap; the file's coordinates are these times a scale."""
        mesh = read_hexahedra(path)
        figures = judged(mesh, self.volume * scale**3, self.euler)
        if figures["valid"]:
            figures["gap"] = self.gap(mesh, scale)
            figures["valid"] = figures["gap"] <= LARGEST_GAP
        return figures

    def gap(self, mesh, scale):
        """The distance that the surface of the model reaches from that of hexahedra, in their size, to half the SAMPLES of a side."""
        faces = np.sort(self.tets[:, [(1, 2, 3), (0, 2, 3), (0, 1, 3), (0, 1, 2)]].reshape(-1, 3), axis=1)
        unique, count = np.unique(faces, axis=0, return_counts=True)
        corners = self.points[unique[count == 1]]
        places = np.concatenate([corners.reshape(-1, 3), corners.mean(axis=1)])
        a, b, c, d = np.moveaxis(mesh.points[mesh.boundary()[0]] / scale, 1, 0)
        samples = [(1 - x) * (1 - y) * a + x * (1 - y) * b + x * y * c + (1 - x) * y * d
                   for x in np.linspace(0, 1, SAMPLES) for y in np.linspace(0, 1, SAMPLES)]
        return float(cKDTree(np.concatenate(samples)).query(places)[0].max() / self.size)


def fault_of_program(options, *arguments):
    command = [options.program, *arguments, "--no-report", "--quiet", "--force"]
    try:
        result = subprocess.run(list(map(str, command)), capture_output=True, text=True, timeout=options.seconds, check=False)
    except subprocess.TimeoutExpired:
        return f"over {options.seconds} s"
    return "" if result.returncode in (0, NOT_ALL_HEX) else result.stderr.strip()


def ours(options, model, cells, folder):
    """What crossgrain hex said, with its files in the folder."""
    start = time.monotonic()
    fault = fault_of_program(options, "hex", model, "--cells", cells, "-o", folder, "--write", "mesh,fra,perm,hexex", "--inverted")
    seconds = time.monotonic() - start
    if fault:
        # The others shall have frames nevertheless.
        fault_of_program(options, "solve", model, "--prepare", "--repair", "-o", folder, "--write", "mesh,fra,perm")
        return {"fault": fault}
    said = json.loads((folder / "report.json").read_text())["hexahedra"]
    return {"seconds": seconds, "before": said.get("scaled_jacobian_before", {}).get("min"), "size": said["used_size"] / said["size"],
            "said": said["outcome"]}


def by_cubecover(options, model):
    folder, start = model.folder / "cubecover", time.monotonic()
    folder.mkdir(exist_ok=True)
    mesh, hexex, made = (folder / f"map.{kind}" for kind in ("mesh", "hexex", "ovm"))
    for path in (hexex, made):
        path.unlink(missing_ok=True)
    mesh.write_text(medit_text(model.points / model.size, model.tets))
    begun = time.monotonic()
    command = [options.built / "cubecover_integergrid", mesh, model.folder / "onto.fra", model.folder / "onto.perm", hexex]
    fault = ended(command, options.seconds, folder / "cubecover.log") or ("" if hexex.exists() else "no map")
    if not fault:
        left = max(1, options.seconds - (time.monotonic() - begun))
        fault = ended([options.built / "hexex", hexex, made], left, folder / "hexex.log")
        fault = fault and f"libHexEx: {fault}"
    if fault:
        return {"fault": f"over {options.seconds} s" if "over" in fault else fault}
    return {"seconds": time.monotonic() - start}


def by_hexdom(options, model):
    program, start = (options.built / "hexdom_pipeline").resolve(), time.monotonic()
    fault = fault_of_our_start(program, model.folder, model.size)
    made = model.folder / "geogram" / "ours"
    fault = fault or fault_of_stages(program, made, start + options.seconds)
    seconds = time.monotonic() - start
    return {"fault": fault} if fault else {"seconds": seconds}


def figures_of(options, model, cells):
    """What happened, and what the meshes are like; only the latter is found anew where a run left its files."""
    folder = options.out / f"{model.name.split('.')[0]}-{cells}"
    kept = folder / "figures.json"
    if not kept.exists():
        make(options, model, cells, folder)
    figures = json.loads(kept.read_text())
    for name, (mesh, scale) in MESHES.items():
        if "fault" not in figures[name]:
            left = Model(folder, cells)
            figures[name].update(left.judged(next(folder.glob(mesh)), 1 / left.size if scale else 1))
    return figures


def make(options, model, cells, folder):
    figures = {"crossgrain": ours(options, model, cells, folder)}
    if (folder / "onto.mesh").exists():
        left = Model(folder, cells)
        figures["cubecover"] = by_cubecover(options, left)
        figures["hexdom"] = by_hexdom(options, left)
    else:
        figures.update({name: {"fault": "no frames"} for name in PROGRAMS[1:]})
    folder.mkdir(exist_ok=True)
    (folder / "figures.json").write_text(json.dumps(figures))


def text_of(name, figures):
    if "fault" in figures:
        return figures["fault"]
    if not figures["hexahedra"]:
        return "none"
    parts = [f"{figures['hexahedra']}", f"{figures['least']:.2f} / {figures['mean']:.2f}"]
    if name == "hexdom":
        parts.insert(0, f"{100 * figures['share']:.0f} %")
    elif not figures["valid"]:
        parts.insert(0, reason_of(figures))
    if "gap" in figures and figures["gap"] > LARGE_GAP:
        parts.append(f"{figures['gap']:.1f} off the surface")
    if name == "crossgrain" and figures["size"] < 1:
        parts.append(f"size {figures['size']:.2f}")
    text = ", ".join([*parts, f"{figures['seconds']:.1f} s"])
    return f"**{text}**" if figures["valid"] else text


def reason_of(figures):
    if "gap" in figures:
        return "cut off"
    if figures["closed"] and figures["inverted"]:
        return f"{figures['inverted']} inverted"
    if figures["closed"] and not figures["others"]:
        return f"{100 * figures['share']:.0f} % of the volume"
    return "open"


def summary(rows):
    lines = [f"\n{len(rows)} meshes"]
    for name in PROGRAMS:
        valid = [row[name] for row in rows if row[name].get("valid")]
        worst = [figures["least"] for figures in valid]
        lines.append(f"{name}: {len(valid)} valid; worst scaled Jacobian in the median {np.median(worst) if worst else 0:.3f}, at least .2 on "
                     f"{sum(x >= 0.2 for x in worst)}; {sum(row[name].get('closed', False) for row in rows)} closed")
    for name in PROGRAMS[1:]:
        pairs = [(row["crossgrain"], row[name]) for row in rows if row["crossgrain"].get("valid") and row[name].get("valid")]
        lines.append(f"valid by both crossgrain and {name}: {len(pairs)}; ours has the better worst element on "
                     f"{sum(a['least'] > b['least'] + 5e-4 for a, b in pairs)}, before smoothing on "
                     f"{sum(a['before'] > b['least'] + 5e-4 for a, b in pairs)}, the worse one on "
                     f"{sum(a['least'] < b['least'] - 5e-4 for a, b in pairs)}, before smoothing on "
                     f"{sum(a['before'] < b['least'] - 5e-4 for a, b in pairs)}")
    return "\n".join(lines)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("models", nargs="+", type=Path)
    parser.add_argument("--program", required=True, type=Path, help="crossgrain")
    parser.add_argument("--built", required=True, type=Path, help="the folder of build.sh's programs")
    parser.add_argument("--out", required=True, type=Path)
    parser.add_argument("--cells", default="10,20", help="hexahedra along the longest side, a table row for each number")
    parser.add_argument("--seconds", default=120, type=int, help="for each mesh and program")
    return parser.parse_args()


def main(options):
    options.out.mkdir(parents=True, exist_ok=True)
    print("| model | cells | `crossgrain hex` | worst before smoothing | CubeCover + libHexEx | hexdom: volume in hexahedra |\n"
          "|---|---|---|---|---|---|")
    rows = []
    for model in options.models:
        model = unpacked(model, options.out)
        for cells in map(int, options.cells.split(",")):
            row = figures_of(options, model, cells)
            rows.append(row)
            before = row["crossgrain"].get("before")
            print(f"| {model.name.split('.')[0]} | {cells} | {text_of('crossgrain', row['crossgrain'])} | "
                  f"{'' if before is None else f'{before:.2f}'} | {text_of('cubecover', row['cubecover'])} | "
                  f"{text_of('hexdom', row['hexdom'])} |", flush=True)
    print(summary(rows))


if __name__ == "__main__":
    main(arguments())

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The tables of docs/comparison.md and docs/degrees.md, as Markdown on standard output.

    comparison.py tets PROGRAM MESH...      our rows: energies of ten seeds, seconds, memory
    comparison.py degrees PROGRAM FILE...   degree 3 against degree 4, on tet meshes and surfaces

PROGRAM is the built command line program. Fields on tets are evaluated by tests/command/recompute_onto.py.
MESH is a Medit .mesh file, or one packed as .mesh.xz; FILE is one too, or a surface, which is solved 64 cells across.
Seconds are medians of five whole runs with two threads, memory is the highest of those runs.
"""

import json
import lzma
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "command"))
from recompute_onto import OntoRecomputation  # noqa: E402

SEEDS = 10
RUNS = 5
SURFACE_OPTIONS = ["--resolution", "64"]


class Run:
    """Runs the program once; returns its report and the evaluation of its field on tets."""

    def __init__(self, program, model, folder, *options):
        command = [program, "solve", model, "-o", folder, "--threads", "2", "--quiet", "--no-report", *options]
        begin = time.perf_counter()
        subprocess.run(list(map(str, command)), check=True)
        self.seconds = time.perf_counter() - begin
        self.report = json.loads((Path(folder) / "report.json").read_text())
        self.megabytes = self.report["peak_memory_bytes"] / 2**20


def unpacked(path, folder):
    """Returns the mesh, or an unpacked copy of a packed one."""
    if path.suffix != ".xz":
        return path
    copy = Path(folder) / path.stem
    if not copy.exists():
        copy.write_bytes(lzma.open(path).read())
    return copy


def timed(program, model, folder, *options):
    runs = [Run(program, model, folder, *options) for _ in range(RUNS)]
    return statistics.median(run.seconds for run in runs), max(run.megabytes for run in runs)


def tets_row(program, mesh, folder, mode):
    name = mesh.name.split(".")[0]
    options = ["--boundary", mode]
    energies = []
    for seed in range(SEEDS):
        energies.append(Run(program, mesh, folder, "--seed", seed, *options).report["onto"]["dirichlet"])
    seconds, megabytes = timed(program, mesh, folder, *options)
    verdict = OntoRecomputation(mesh, folder).evaluation()
    singular = verdict["singular"]["interior_faces"]
    crease = verdict["crease_deg"]["mean"]
    print(f"| {name} | {mode} | {verdict['dirichlet']:.2f} ({verdict['edge_sum']:.0f}) [{singular}] | "
          f"{100 * (max(energies) / min(energies) - 1):.2f} | {seconds:.2f} / {megabytes:.0f} | "
          f"{'-' if crease is None else f'{crease:.2f}'} |", flush=True)
    return name, mode, energies


def tets(program, paths):
    print("| mesh | boundary | Dirichlet (edge sum) [singular interior faces] | ten seeds within, % | seconds / peak MB | "
          "mean crease angle, degrees |\n|---|---|---|---|---|---|")
    seeds = []
    with tempfile.TemporaryDirectory() as folder:
        for path in paths:
            mesh = unpacked(path, folder)
            for mode in ("all", "smooth-only"):
                seeds.append(tets_row(program, mesh, Path(folder) / "out", mode))
    print("\n| mesh | boundary |" + "".join(f" seed {seed} |" for seed in range(SEEDS)) + "\n|---|---|" + "---|" * SEEDS)
    for name, mode, energies in seeds:
        print(f"| {name} | {mode} | " + " | ".join(f"{energy:.2f}" for energy in energies) + " |")


def degrees(program, paths):
    print("| file | energy, degree 4 | degree 3 | seconds | | peak MB | | singular edges or faces | | ends | |\n"
          "|---|---|---|---|---|---|---|---|---|---|---|\n| | | | 4 | 3 | 4 | 3 | 4 | 3 | 4 | 3 |")
    with tempfile.TemporaryDirectory() as folder:
        for path in paths:
            model = unpacked(path, folder)
            is_mesh = model.suffix == ".mesh"
            rows = []
            for degree in (4, 3):
                options = ["--degree", degree, *([] if is_mesh else SURFACE_OPTIONS)]
                seconds, megabytes = timed(program, model, Path(folder) / "out", *options)
                report = json.loads((Path(folder) / "out" / "report.json").read_text())
                if is_mesh:
                    verdict = OntoRecomputation(model, Path(folder) / "out").evaluation()
                    energy, singular = verdict["dirichlet"], verdict["singular"]["interior_faces"]
                    ends = verdict["singular"]["boundary_faces"]
                else:
                    energy, singular = report["energy"]["total"], report["singularity"]["edges"]
                    ends = report["singularity"]["boundary_ends"]
                rows.append((energy, seconds, megabytes, singular, ends))
            four, three = rows
            print(f"| {model.stem if is_mesh else model.name} | {four[0]:.5g} | {100 * (three[0] / four[0] - 1):+.2f} % | "
                  f"{four[1]:.2f} | {three[1]:.2f} | {four[2]:.0f} | {three[2]:.0f} | {four[3]} | {three[3]} | {four[4]} | {three[4]} |",
                  flush=True)


def main():
    tables = {"tets": tets, "degrees": degrees}
    if len(sys.argv) < 4 or sys.argv[1] not in tables:
        sys.exit(__doc__.strip())
    tables[sys.argv[1]](sys.argv[2], [Path(name) for name in sys.argv[3:]])


if __name__ == "__main__":
    main()

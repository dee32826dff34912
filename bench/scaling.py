#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the cost of whole solves of the bracket, a sphere and a thin-walled tube at increasing resolutions.

    scaling.py PROGRAM [--most CELLS] [--threads N] [--part NAME]... [--figure PNG]
    scaling.py PROGRAM --pairs [CELLS]

PROGRAM is the built command line program. The first form prints a Markdown table, one row per run, and draws seconds
and bytes per cell over cells. Resolutions are chosen so that the numbers of active cells come near 10,000, 32,000, 100,000
and so on, up to CELLS. The second form solves each part once with about CELLS cells (default a million) on one thread
and on two, alternating, and prints the speedup of each phase; the fastest of three rounds counts.

Analysis is the rest of the total: alignment, singular arcs and walls for the report. Memory is the peak of the whole
process, including program and input. Fields are written to a temporary folder and removed after each run. Runs
that fail, or would not fit into memory judging by the previous run, are named on standard error.
"""

import argparse
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np

ROOT = Path(__file__).resolve().parent.parent
FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
PHASES = ("read", "grid", "solve", "analysis", "write")

FEWEST_CELLS = 10_000
FACTOR = math.sqrt(10)
PAIR_ROUNDS = 3
# The resolution of pairs is found by trials, until the number of cells is within 15 %.
NEAR = 0.15
MOST_TRIALS = 6

# Resolution of the first guess, too small for a row.
PROBE_RESOLUTION = 32
# Power of the resolution with which cells grow, before two runs determine it: between 2 of a surface and 3 of a solid.
FIRST_POWER, LEAST_POWER, MOST_POWER = 2.2, 1.7, 3.0
# Largest share of the free memory that a run may be expected to take.
MEMORY_SHARE = 0.9


def sphere(subdivisions=6):
    """Returns the corners of the triangles of a unit sphere, a repeatedly subdivided octahedron."""
    x, y, z = np.eye(3)
    corners = np.array([[sx * x, sy * y, sz * z] if sx * sy * sz > 0 else [sy * y, sx * x, sz * z]
                        for sx in (1, -1) for sy in (1, -1) for sz in (1, -1)])
    for _ in range(subdivisions):
        a, b, c = corners.transpose(1, 0, 2)
        ab, bc, ca = a + b, b + c, c + a
        corners = np.concatenate([np.stack(t, axis=1) for t in ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
        corners /= np.linalg.norm(corners, axis=2, keepdims=True)
    return corners


def tube(wall=0.03, segments=256):
    """Returns the corners of the triangles of an open tube, 1 long and 1 across, with a wall of 3 % of that."""
    outline = np.array([[0.5, -0.5], [0.5, 0.5], [0.5 - wall, 0.5], [0.5 - wall, -0.5]])  # radius, height
    angle = 2 * np.pi * np.arange(segments) / segments
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points = np.stack([np.column_stack([radius * ring, np.full(segments, height)]) for radius, height in outline])
    here, above = points, np.roll(points, -1, axis=0)
    right, across = np.roll(here, -1, axis=1), np.roll(above, -1, axis=1)
    triangles = [np.stack(t, axis=2).reshape(-1, 3, 3) for t in ((here, right, across), (here, across, above))]
    return np.concatenate(triangles)


def write_stl(path, corners):
    facets = np.zeros(len(corners), FACET)
    facets["corners"] = corners
    path.write_bytes(bytes(80) + len(facets).to_bytes(4, "little") + facets.tobytes())


def models(folder, names):
    """Returns {name: path of its surface} for the requested parts; writes generated ones to `folder`."""
    generated = {"sphere": sphere, "tube": tube}
    for name in names:
        if name in generated:
            write_stl(folder / f"{name}.stl", generated[name]())
    return {name: folder / f"{name}.stl" if name in generated else ROOT / "models" / f"{name}.stl" for name in names}


@dataclass
class Run:
    """The numbers of one solve from its report."""

    resolution: int
    cells: int
    seconds: dict
    bytes_per_cell: float
    energy: float

    @staticmethod
    def of(report, resolution):
        seconds = dict(report["seconds"])
        seconds["analysis"] = seconds["total"] - sum(seconds[phase] for phase in PHASES if phase != "analysis")
        cells = report["levels"][-1]["active_cells"]
        return Run(resolution, cells, seconds, report["peak_memory_bytes"] / cells, report["energy"]["total"])


class Solver:
    """The program, with options that reduce its output."""

    def __init__(self, program, folder, output_level):
        self.program, self.output = program, folder / "field"
        usage = subprocess.run([program, "solve", "--help"], check=True, capture_output=True, text=True).stdout
        self.options = ["--quiet", "--no-report"]
        if "--output-level" in usage:
            self.options += ["--output-level", str(output_level)]

    def run(self, model, resolution, threads):
        """Returns the Run; prints a message and returns None if the program failed."""
        command = [self.program, "solve", model, "-o", self.output, "--resolution", resolution, "--threads", threads]
        try:
            done = subprocess.run(list(map(str, command + self.options)), capture_output=True, text=True, check=False)
            if done.returncode == 0:
                return Run.of(json.loads((self.output / "report.json").read_text()), resolution)
        finally:
            shutil.rmtree(self.output, ignore_errors=True)
        reason = done.stderr.strip() or f"ended by signal {-done.returncode}, for want of memory perhaps"
        say(f"{model.name} at {resolution}: skipped: {reason}")
        return None


def say(message):
    print(message, file=sys.stderr, flush=True)


def resolution_for(cells, runs):
    """Returns the resolution for about this number of cells, from the runs so far."""
    power = FIRST_POWER
    if len(runs) > 1 and runs[-1].resolution != runs[-2].resolution:
        power = math.log(runs[-1].cells / runs[-2].cells) / math.log(runs[-1].resolution / runs[-2].resolution)
    # Two runs close to each other tell little.
    power = min(max(power, LEAST_POWER), MOST_POWER)
    return round(runs[-1].resolution * (cells / runs[-1].cells) ** (1 / power))


def available_bytes():
    """Returns the available memory, including the file cache; infinite if the system does not provide it."""
    try:
        lines = Path("/proc/meminfo").read_text().splitlines()
    except OSError:
        return math.inf
    return next((1024 * int(line.split()[1]) for line in lines if line.startswith("MemAvailable:")), math.inf)


def series(solver, model, most, threads):
    """Yields a Run for each size up to `most` cells."""
    runs = [solver.run(model, PROBE_RESOLUTION, threads)]
    if runs[0] is None:
        return
    cells = FEWEST_CELLS
    while cells <= 1.001 * most:
        resolution = resolution_for(cells, runs)
        expected = cells * runs[-1].bytes_per_cell
        if expected > MEMORY_SHARE * available_bytes():
            say(f"{model.name} at {resolution}: skipped: would take about {expected / 1e9:.1f} GB, more than is free")
            return
        run = solver.run(model, resolution, threads)
        if run is None:
            return
        runs.append(run)
        yield run
        cells *= FACTOR


def print_series(solver, parts, most, threads):
    """Prints the table and returns {part: its runs}."""
    print("| part | N | active cells | " + " | ".join(PHASES) + " | total | us a cell | bytes a cell | energy |\n"
          "|---|---|---|" + "---|" * len(PHASES) + "---|---|---|---|", flush=True)
    runs = {}
    for name, model in parts.items():
        runs[name] = []
        for run in series(solver, model, most, threads):
            runs[name].append(run)
            print(f"| {name} | {run.resolution} | {run.cells:,} | "
                  + " | ".join(f"{run.seconds[phase]:.2f}" for phase in PHASES)
                  + f" | {run.seconds['total']:.2f} | {1e6 * run.seconds['total'] / run.cells:.2f} | "
                  f"{run.bytes_per_cell:.0f} | {run.energy:.6g} |", flush=True)
    return runs


def run_near(solver, model, cells):
    """Returns a run of about this number of cells; None if a run fails."""
    runs = [solver.run(model, PROBE_RESOLUTION, 2)]
    while runs[-1] is not None and len(runs) < MOST_TRIALS and abs(math.log(runs[-1].cells / cells)) > NEAR:
        runs.append(solver.run(model, resolution_for(cells, runs), 2))
    return runs[-1]


def fastest_seconds(solver, model, resolution):
    """Returns {threads: fastest seconds of each phase} for one thread and two; None if a run fails."""
    fastest = {}
    for _ in range(PAIR_ROUNDS):
        for threads in (1, 2):
            run = solver.run(model, resolution, threads)
            if run is None:
                return None
            best = fastest.setdefault(threads, run.seconds)
            fastest[threads] = {phase: min(best[phase], run.seconds[phase]) for phase in (*PHASES, "total")}
    return fastest


def print_pairs(solver, parts, cells):
    print("Seconds on one thread / on two, and how many times as fast two are:\n\n"
          "| part | active cells | " + " | ".join((*PHASES, "total")) + " |\n|---|---|" + "---|" * (len(PHASES) + 1), flush=True)
    for name, model in parts.items():
        run = run_near(solver, model, cells)
        fastest = run and fastest_seconds(solver, model, run.resolution)
        if fastest is None:
            continue
        one, two = fastest[1], fastest[2]
        entries = (f"{one[phase]:.2f} / {two[phase]:.2f}: {one[phase] / max(two[phase], 1e-9):.2f}"
                   for phase in (*PHASES, "total"))
        print(f"| {name} | {run.cells:,} | " + " | ".join(entries) + " |", flush=True)


def draw(runs, path):
    """Draws seconds and bytes per cell over cells, both axes logarithmic."""
    try:
        import matplotlib
    except ImportError:
        say(f"{path}: not drawn: matplotlib is missing; run cmake/install_packages.sh bench")
        return
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (time, memory) = plt.subplots(1, 2, figsize=(9, 3.8), layout="constrained")
    for (name, of_part), colour, marker in zip(runs.items(), ("#0072b2", "#d55e00", "#009e73"), "os^"):
        cells = [run.cells for run in of_part]
        style = {"color": colour, "marker": marker, "markersize": 5, "label": name}
        time.plot(cells, [run.seconds["total"] for run in of_part], **style)
        memory.plot(cells, [run.bytes_per_cell for run in of_part], **style)
    everything = [run for of_part in runs.values() for run in of_part]
    if everything:
        first, last = (choose(run.cells for run in everything) for choose in (min, max))
        slowest = max(run.seconds["total"] / run.cells for run in everything if run.cells > last / 4)
        time.plot([first, last], [first * slowest, last * slowest], color="0.6", linestyle=":", label="in proportion")
    for axes, title in ((time, "seconds, total"), (memory, "bytes of peak memory a cell")):
        axes.set(xscale="log", yscale="log", xlabel="active cells", title=title)
        axes.grid(which="both", color="0.9")
        axes.legend(frameon=False)
    figure.savefig(path, dpi=130)
    plt.close(figure)


def parsed_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path, help="the built command line program")
    parser.add_argument("--most", type=float, default=2e7, metavar="CELLS", help="end near this many (default 20 million)")
    parser.add_argument("--threads", type=int, default=os.cpu_count(), help="default all there are")
    parser.add_argument("--part", action="append", metavar="NAME",
                        help="bracket or another part of models/, sphere, tube (default bracket, sphere and tube)")
    parser.add_argument("--figure", type=Path, default=ROOT / "docs/figures/scaling.png", help="default docs/figures/scaling.png")
    parser.add_argument("--pairs", type=float, nargs="?", const=1e6, metavar="CELLS", help="compare two threads with one")
    parser.add_argument("--output-level", type=int, default=8,
                        help="passed on to `solve` where it has this option, so that large runs write little (default 8)")
    return parser.parse_args()


def main():
    arguments = parsed_arguments()
    with tempfile.TemporaryDirectory() as folder:
        parts = models(Path(folder), arguments.part or ["bracket", "sphere", "tube"])
        solver = Solver(arguments.program.resolve(), Path(folder), arguments.output_level)
        if arguments.pairs:
            print_pairs(solver, parts, arguments.pairs)
        else:
            draw(print_series(solver, parts, arguments.most, arguments.threads), arguments.figure)


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Measures crossgrain-mpi, and compares a cost model with it (docs/several-machines.md).

    several_machines.py PROGRAM MODEL [RESOLUTION...]     by default 512 640 768 1230

A process of a run on P processes with N cells takes, in processor seconds outside calls of MPI,

    start + shared N / P + ghost G + first F      the first
    other + shared N / P + ghost G                each other one

with G = spread sqrt(N / P) ghosts, none if P = 1, and F cells of the first level that is shared, which the first process makes. The constants
are fitted to all runs but those at the largest resolution, which are predicted.
"""

import json
import os
import subprocess
import sys
import tempfile

import numpy as np
from scipy.optimize import nnls

PROCESSES = (1, 2, 4, 8)
FEWEST_SHARED = 200000
ENVIRONMENT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def measured(program, model, resolution, processes):
    """Cells, those of the first shared level, ghosts of a process in the mean, processor seconds outside MPI of the first process and of the
    others in the mean."""
    with tempfile.TemporaryDirectory(prefix="crossgrain-machines-") as folder:
        run = subprocess.run(["mpirun", "-q", "--oversubscribe", "--bind-to", "none", "-n", str(processes), program, "solve", model,
                              "--resolution", str(resolution), "-o", folder + "/out", "--threads", "1", "--no-report", "--verbose"],
                             capture_output=True, text=True, check=True, env=ENVIRONMENT)
        with open(folder + "/out/report.json", encoding="utf-8") as file:
            levels = [level["active_cells"] for level in json.load(file)["levels"]]
    rows = [list(map(float, line.split())) for line in run.stdout.splitlines()[-processes:]]
    seconds = [row[3] - row[4] for row in rows]
    first_shared = next(cells for cells in levels if cells >= FEWEST_SHARED)
    return levels[-1], first_shared, np.mean([row[2] for row in rows]), seconds[0], np.mean(seconds[1:]) if processes > 1 else 0


def equations(cells, first_shared, processes, spread):
    """Rows of coefficients of (start, other, shared, ghost, first) for the first process and for the others."""
    ghosts = spread * np.sqrt(cells / processes) if processes > 1 else 0
    # A process that is alone makes the first shared level as all others.
    made_alone = first_shared if processes > 1 else 0
    return [[1, 0, cells / processes, ghosts, made_alone], [0, 1, cells / processes, ghosts, 0]]


def main():
    program, model = sys.argv[1:3]
    resolutions = list(map(int, sys.argv[3:])) or [512, 640, 768, 1230]
    runs = {(r, p): measured(program, model, r, p) for r in resolutions for p in PROCESSES}
    fitted = {run: values for run, values in runs.items() if run[0] < max(resolutions)}
    spread = np.mean([ghosts / np.sqrt(cells / p) for (_, p), (cells, _, ghosts, _, _) in fitted.items() if p > 1])
    matrix, seconds = [], []
    for (_, processes), (cells, first_shared, _, first, others) in fitted.items():
        matrix += equations(cells, first_shared, processes, spread)[: 2 if processes > 1 else 1]
        seconds += [first, others][: 2 if processes > 1 else 1]
    # Each row counts by its relative error.
    weights = 1 / np.array(seconds)
    constants = nnls(np.array(matrix) * weights[:, None], np.array(seconds) * weights)[0]
    start, other, shared, ghost, made = constants
    print(f"start {start:.2f} s, other {other:.2f} s; microseconds: {shared * 1e6:.2f} a cell, {ghost * 1e6:.2f} a ghost, {made * 1e6:.2f} a cell of the "
          f"first shared level; {spread:.0f} sqrt(cells) ghosts\n")
    print("| cells | processes | ghosts | first: measured | model | others: measured | model | all together, beside one process |\n"
          "|---|---|---|---|---|---|---|---|")
    for (resolution, processes), (cells, first_shared, ghosts, first, others) in runs.items():
        model_first, model_others = np.array(equations(cells, first_shared, processes, spread)) @ constants
        together = (first + (processes - 1) * others) / runs[resolution, 1][3]
        print(f"| {cells} | {processes} | {ghosts:.0f} | {first:.1f} | {model_first:.1f} | {others:.1f} | "
              f"{model_others * (processes > 1):.1f} | {together:.2f} |")
    billion = 1e9
    one = (np.array(equations(billion, 4 * FEWEST_SHARED, 1, spread)) @ constants)[0]
    for processes in (4, 64, 1024):
        whole = (np.array(equations(billion, 4 * FEWEST_SHARED, processes, spread)) @ constants)[0]
        print(f"\na billion cells on {processes} processes: {whole:.0f} s, efficiency {one / processes / whole:.2f}", end="")
    print()


if __name__ == "__main__":
    main()

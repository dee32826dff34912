#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Measures crossgrain-mpi, and compares a cost model with it (docs/several-machines.md).

    several_machines.py PROGRAM MODEL [RESOLUTION...]     by default 512 640 768 1230

A run on P processes with N cells takes, in processor seconds outside calls of MPI,

    first process    start + (shared / P + alone) N
    each other one   other + shared N / P

The constants are fitted to all runs but those at the largest resolution, which are predicted.
"""

import os
import subprocess
import sys
import tempfile

import numpy as np
from scipy.optimize import nnls

PROCESSES = (1, 2, 4)
ENVIRONMENT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def measured(program, model, resolution, processes):
    """Cells, and processor seconds outside MPI of the first process and of the others in the mean."""
    with tempfile.TemporaryDirectory(prefix="crossgrain-machines-") as folder:
        run = subprocess.run(["mpirun", "-q", "--oversubscribe", "--bind-to", "none", "-n", str(processes), program, "solve", model,
                              "--resolution", str(resolution), "-o", folder + "/out", "--threads", "1", "--no-report", "--verbose"],
                             capture_output=True, text=True, check=True, env=ENVIRONMENT)
    lines = run.stdout.splitlines()
    cells = int(next(line for line in lines if line.startswith("cells")).split()[1])
    rows = [list(map(float, line.split())) for line in lines[-processes:]]
    seconds = [row[3] - row[4] for row in rows]
    return cells, seconds[0], np.mean(seconds[1:]) if processes > 1 else 0


def equations(cells, processes):
    """Rows of coefficients of (start, other, shared, alone) for the first process and for the others."""
    return [[1, 0, cells / processes, cells], [0, 1, cells / processes, 0]]


def main():
    program, model = sys.argv[1:3]
    resolutions = list(map(int, sys.argv[3:])) or [512, 640, 768, 1230]
    runs = {(r, p): measured(program, model, r, p) for r in resolutions for p in PROCESSES}
    matrix, seconds = [], []
    for (resolution, processes), (cells, first, others) in runs.items():
        if resolution < max(resolutions):
            matrix += equations(cells, processes)[: 2 if processes > 1 else 1]
            seconds += [first, others][: 2 if processes > 1 else 1]
    start, other, shared, alone = constants = nnls(np.array(matrix), np.array(seconds))[0]
    print(f"start {start:.2f} s, other {other:.2f} s; microseconds a cell: shared {shared * 1e6:.2f}, alone {alone * 1e6:.2f}\n")
    print("| cells | processes | first: measured | model | others: measured | model | all together, beside one process |\n|---|---|---|---|---|---|---|")
    for (resolution, processes), (cells, first, others) in runs.items():
        model_first, model_others = np.array(equations(cells, processes)) @ constants
        together = (first + (processes - 1) * others) / runs[resolution, 1][1]
        print(f"| {cells} | {processes} | {first:.1f} | {model_first:.1f} | {others:.1f} | {model_others * (processes > 1):.1f} | {together:.2f} |")
    billion = 1e9
    one = start + (shared + alone) * billion
    for processes in (4, 64):
        whole = start + (shared / processes + alone) * billion
        print(f"\na billion cells on {processes} processes: {whole:.0f} s, efficiency {one / processes / whole:.2f}", end="")
    print()


if __name__ == "__main__":
    main()

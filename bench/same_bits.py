#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Compares crossgrain-mpi on several numbers of processes with crossgrain (docs/several-machines.md).

    same_bits.py CROSSGRAIN CROSSGRAIN_MPI RESOLUTION MODEL...     MODEL may end with :3 for degree 3

Solves each model alone and on 1, 2, 3, 5 and 8 processes, and compares the reports without times and forecasts. Among their entries is
`solve`, a sum of all cells, frames and other arrays of the field (docs/report.md). Prints a line for each model; exits with 1 if any differs.
"""

import json
import os
import subprocess
import sys
import tempfile

PROCESSES = (1, 2, 3, 5, 8)
OF_THE_RUN = ("seconds", "expected", "threads", "peak_memory_bytes")
ENVIRONMENT = os.environ | {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}


def same_in_all_runs(value):
    if isinstance(value, dict):
        return {key: same_in_all_runs(item) for key, item in value.items() if key not in OF_THE_RUN}
    return [same_in_all_runs(item) for item in value] if isinstance(value, list) else value


def report_of(start, model, degree, resolution):
    with tempfile.TemporaryDirectory(prefix="crossgrain-bits-") as folder:
        subprocess.run([*start, "solve", model, "--degree", degree, "--resolution", resolution, "-o", folder + "/out", "--no-report", "--quiet"],
                       check=True, env=ENVIRONMENT)
        with open(folder + "/out/report.json", encoding="utf-8") as file:
            return same_in_all_runs(json.load(file))


def main():
    alone, together, resolution, *models = sys.argv[1:]
    failed = False
    for name in models:
        model, _, degree = name.partition(":")
        expected = report_of([alone], model, degree or "4", resolution)
        cells = expected["levels"][-1]["active_cells"]
        differ = [n for n in PROCESSES if expected != report_of(
            ["mpirun", "-q", "--oversubscribe", "--bind-to", "none", "-n", str(n), together], model, degree or "4", resolution)]
        print(f"{name}, {cells} cells: " + (f"differs on {differ}" if differ else "the same on " + ", ".join(map(str, PROCESSES))), flush=True)
        failed = failed or bool(differ)
    sys.exit(failed)


if __name__ == "__main__":
    main()

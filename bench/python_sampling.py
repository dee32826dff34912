#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Times sampling in Python beside sampling in C++, in turns, on as many threads.

Usage: PYTHONPATH=build/release/python bench/python_sampling.py build/release/bench/sampling_time [MODEL] [POINTS] [ROUNDS]
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import crossgrain as cg
import numpy as np


def main():
    program = sys.argv[1]
    model = sys.argv[2] if len(sys.argv) > 2 else Path(__file__).parents[1] / "models" / "bracket.stl"
    count, rounds = (int(sys.argv[i]) if len(sys.argv) > i else default for i, default in ((3, 5_000_000), (4, 3)))
    field = cg.solve(model)
    rng = np.random.default_rng(0)
    # Inside the solid: any cell, anywhere in it.
    chosen = rng.integers(0, len(field), count)
    points = field.centers[chosen] + (rng.random((count, 3)) - 0.5) * field.sizes[chosen, None]
    with tempfile.TemporaryDirectory() as folder:
        field.write(f"{folder}/field", page=False)
        points.tofile(f"{folder}/points")
        field.sample(points[:1])
        print("threads  C++ s  Python s  ratio")
        for threads in (1, 2):
            times = []
            for _ in range(rounds):
                printed = subprocess.run([program, f"{folder}/field", f"{folder}/points", str(threads)], capture_output=True, text=True, check=True)
                start = time.perf_counter()
                field.sample(points, threads=threads)
                times.append((float(printed.stdout), time.perf_counter() - start))
            cpp, python = np.median(times, axis=0)
            print(f"{threads:7} {cpp:6.2f} {python:9.2f} {np.median([p / c for c, p in times]):6.2f}")


if __name__ == "__main__":
    main()

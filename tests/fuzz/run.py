#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the fuzz targets and prints a table of what they did; docs/fuzzing.md tells what to do with a crash.

Usage: tests/fuzz/run.py [--seconds N] [--jobs N] [--build DIR] [--work DIR] [--shared DIR] [READER...]

Seeds are the inputs that once broke the reader, those that crossgrain_fuzz_seeds makes, and the files of the
format in SHARED/models, read in place (of large ones the beginning). What a run finds worth keeping stays in
WORK/READER/corpus, from which the next one goes on; inputs that break the reader are in WORK/READER/crashes.
Exits with 1 where there is any.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent

# Which files of SHARED/models are seeds of a reader. Those of CAD are long, and what is looked at in them short:
# the reader of CAD files is seeded with made ones.
EXTENSIONS = {
    "gzip": {".gz"},
    "zip": {".3mf", ".FCStd"},
    "stl": {".stl"},
    "obj": {".obj"},
    "ply": {".ply"},
    "off": {".off"},
    "medit": {".mesh"},
    "medit_binary": {".meshb"},
    "gmsh": {".msh"},
    "vtk": {".vtk"},
    "vtu": {".vtu"},
    "hex_medit": {".mesh"},
    "hex_gmsh": {".msh"},
    "hex_vtk": {".vtk"},
    "abaqus": {".inp"},
}

# Readers go on as they began: longer files take time and show nothing more. A field needs more than the others.
LONGEST_INPUT = 8192
LONGEST_INPUTS = {"field": 32768}

# A small input that takes more of either is a finding. Wall time, and the machine may be busy.
MEMORY_LIMIT_MB = 512
SECONDS_FOR_AN_INPUT = 20

# A target ends with its first crash; it is started again for the rest of its time, so often.
STARTS = 10


def readers(build):
    return sorted(path.name[len("fuzz_") :] for path in (build / "tests/fuzz").glob("fuzz_*") if path.is_file())


def link_seeds(reader, folder, shared):
    """Links to the models and to the inputs that once broke the reader."""
    sources = sorted((HERE / "regression" / reader).glob("*"))
    for path in sorted((shared / "models").glob("*/*")):
        if path.suffix.lower() in EXTENSIONS.get(reader, ()) and path.stat().st_size > 0:
            sources.append(path)
    for path in sources:
        link = folder / path.name
        if not link.exists():
            link.symlink_to(path)


def run_once(reader, seconds, options, memory_folder, log_path):
    """Seconds of the processor that one start of the target took."""
    work = options.work / reader
    command = [
        str(options.build / "tests/fuzz" / f"fuzz_{reader}"),
        f"-max_total_time={max(1, round(seconds))}",
        f"-max_len={LONGEST_INPUTS.get(reader, LONGEST_INPUT)}",
        f"-rss_limit_mb={MEMORY_LIMIT_MB}",
        f"-malloc_limit_mb={MEMORY_LIMIT_MB}",
        f"-timeout={SECONDS_FOR_AN_INPUT}",
        f"-artifact_prefix={work}/crashes/",
        "-print_final_stats=1",
        str(work / "corpus"),
        str(options.work / "seeds" / reader),
    ]
    dictionary = HERE / "dictionaries" / f"{reader}.dict"
    if reader.startswith("hex_") and not dictionary.exists():
        dictionary = HERE / "dictionaries" / f"{reader.removeprefix('hex_')}.dict"
    if dictionary.exists():
        command.insert(1, f"-dict={dictionary}")
    # The quarantine of freed memory would count as memory of the reader.
    environment = dict(os.environ, TMPDIR=memory_folder, ASAN_OPTIONS="quarantine_size_mb=16")
    with open(log_path, "wb") as log:
        process = subprocess.Popen(
            ["nice", "-n", "15", *command], stdout=log, stderr=subprocess.STDOUT, env=environment
        )
        _, _, usage = os.wait4(process.pid, 0)
    return usage.ru_utime + usage.ru_stime


def figures_of(log_path):
    """Runs and edges that a log tells of."""
    text = log_path.read_text(encoding="utf-8", errors="replace")
    runs = re.findall(r"^stat::number_of_executed_units: (\d+)", text, re.MULTILINE)
    edges = re.findall(r"\bcov: (\d+)", text)
    return int(runs[-1]) if runs else 0, max(map(int, edges), default=0)


def fuzz(reader, options):
    work = options.work / reader
    for name in ("corpus", "crashes"):
        (work / name).mkdir(parents=True, exist_ok=True)
    (options.work / "seeds" / reader).mkdir(parents=True, exist_ok=True)
    link_seeds(reader, options.work / "seeds" / reader, options.shared)
    before = set((work / "crashes").iterdir())
    begin = time.monotonic()
    processor, runs, edges = 0.0, 0, 0
    with tempfile.TemporaryDirectory(dir=options.memory) as memory_folder:
        for start in range(STARTS):
            left = options.seconds - (time.monotonic() - begin)
            if left < 1:
                break
            log_path = work / f"log-{start}"
            processor += run_once(reader, left, options, memory_folder, log_path)
            more_runs, here = figures_of(log_path)
            runs, edges = runs + more_runs, max(edges, here)
    crashes = sorted(path.name for path in set((work / "crashes").iterdir()) - before)
    row = (reader, time.monotonic() - begin, processor, runs, edges, len(crashes))
    print(f"{reader}: {row[1]:.0f} s, {runs} runs, {edges} edges, {len(crashes)} crashes", file=sys.stderr)
    return row, crashes


def print_table(rows):
    print("| reader | seconds | of the processor | runs | edges | crashes |")
    print("| --- | ---: | ---: | ---: | ---: | ---: |")
    for reader, seconds, processor, runs, edges, crashes in rows:
        print(f"| {reader} | {seconds:.0f} | {processor:.0f} | {runs} | {edges} | {crashes} |")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=600, help="for each reader (default 600)")
    parser.add_argument("--jobs", type=int, default=2, help="targets at a time (default 2)")
    parser.add_argument("--build", type=Path, default=ROOT / "build/fuzz", help="default build/fuzz")
    parser.add_argument("--work", type=Path, help="default BUILD/fuzzing")
    parser.add_argument("--shared", type=Path, default=Path(os.environ.get("CROSSGRAIN_SHARED", ROOT / "../shared")))
    parser.add_argument("readers", nargs="*", metavar="READER", help="default: all that are built")
    options = parser.parse_args()
    options.build = options.build.resolve()
    options.shared = options.shared.resolve()
    options.work = (options.work or options.build / "fuzzing").resolve()
    options.memory = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
    return options


def main():
    options = parse_arguments()
    built = readers(options.build)
    if not built:
        sys.exit(f"no fuzz target in {options.build}; cmake --preset fuzz && cmake --build --preset fuzz")
    unknown = set(options.readers) - set(built)
    if unknown:
        sys.exit(f"no fuzz target of {', '.join(sorted(unknown))}; there are {', '.join(built)}")
    shutil.rmtree(options.work / "seeds", ignore_errors=True)
    subprocess.run([options.build / "tests/fuzz/crossgrain_fuzz_seeds", options.work / "seeds"], check=True)
    with ThreadPoolExecutor(options.jobs) as pool:
        results = list(pool.map(lambda reader: fuzz(reader, options), options.readers or built))
    print_table([row for row, _ in results])
    for row, crashes in results:
        for name in crashes:
            print(options.work / row[0] / "crashes" / name)
    return 1 if any(crashes for _, crashes in results) else 0


if __name__ == "__main__":
    sys.exit(main())

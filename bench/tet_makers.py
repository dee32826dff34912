#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Makes tets of models with each program that can and prints a table of docs/notes/tets.md, as Markdown: failures, tets, shapes,
seconds.

    tet_makers.py PROGRAM MODEL... [--options "--edges 30"]

PROGRAM is the built command line program. Shapes are measured from the written files: mean ratios and radius ratios, 1 for regular
tets. Seconds are of the whole run, the least of three.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "tests" / "command"))
from tagged_mesh import TaggedMesh  # noqa: E402

MAKERS = ["gmsh", "netgen"]
RUNS = 3


def made(program, model, maker, options, path):
    """The seconds that it took, nothing if it failed; and what it said."""
    begin = time.perf_counter()
    command = [program, "tets", model, "-o", path, "--by", maker, "--quiet", *options]
    result = subprocess.run(list(map(str, command)), capture_output=True, text=True, check=False)
    seconds = time.perf_counter() - begin
    return (seconds if result.returncode == 0 else None), result.stderr.strip()


def row(program, model, maker, options, folder):
    path = Path(folder) / "tets.mesh"
    runs = [made(program, model, maker, options, path) for _ in range(RUNS)]
    said = runs[0][1].split(f"{model}: ")[-1]
    if runs[0][0] is None:
        return [model.name, maker, said, *[""] * 6]
    mesh = TaggedMesh(path)
    ratios = mesh.mean_ratios()
    failure = said if "made in another way" in said else ""
    return [model.name, maker, failure, f"{len(mesh.tets):,}", f"{len(mesh.triangles):,}", f"{ratios.min():.2f}",
            f"{ratios.mean():.2f}", f"{mesh.radius_ratios().min():.2f}", f"{min(seconds for seconds, _ in runs):.1f}"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=Path)
    parser.add_argument("models", type=Path, nargs="+")
    parser.add_argument("--options", default="", help="more options of `crossgrain tets`")
    arguments = parser.parse_args()
    print("| model | by | failure | tets | triangles | worst mean ratio | mean | worst radius ratio | seconds |")
    print("|---|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        for model in arguments.models:
            for maker in MAKERS:
                cells = row(arguments.program.resolve(), model, maker, arguments.options.split(), folder)
                print("| " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()

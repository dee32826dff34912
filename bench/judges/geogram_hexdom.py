#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs geogram's hex-dominant pipeline with its own field and with ours: the share of the volume in hexahedra.

    geogram_hexdom.py BUILT FOLDER...

BUILT is the folder of build.sh's programs, FOLDER what hex_judges.py left: tets.mesh, and onto.frames of its vertices. The pipeline's
files go into FOLDER/geogram. It makes hexahedra of the mean edge's size.
"""

import math
import re
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "tests" / "command"))
from frame_math import CUBE_ROTATIONS  # noqa: E402
from poisson_map import read_medit  # noqa: E402

AFTER_FIELD = ("Parameterization", "HexCandidates", "QuadDominant", "Hexahedrons", "Cavity", "HexDominant")
SECONDS = 300  # of each stage
FREE_WEIGHT = 1e-3  # of axes that geogram does not lock, against 1


class GeogramText:
    """A .geogram_ascii file whose attributes may be read, and those of vertices replaced.

    An attribute is a line [ATTR], then element, name, type, bytes and numbers in an item, with comments from a #; then a line for
    each item.
    """

    def __init__(self, path):
        self.lines = path.read_text().split("\n")
        self.count = self.count_of("GEO::Mesh::vertices")

    def count_of(self, element):
        return next((int(self.value(i + 2)) for i, line in enumerate(self.lines)
                     if line == "[ATTS]" and self.value(i + 1) == element), 0)

    def value(self, line):
        return self.lines[line].split("#")[0].strip().strip('"')

    def start(self, name, element="GEO::Mesh::vertices"):
        """The line of the first item; none without the attribute."""
        return next((i + 6 for i, line in enumerate(self.lines)
                     if line == "[ATTR]" and (self.value(i + 1), self.value(i + 2)) == (element, name)), None)

    def numbers(self, name, width, element="GEO::Mesh::vertices"):
        start, values, count = self.start(name, element), [], self.count_of(element)
        for line in self.lines[start:]:
            if len(values) >= count * width:
                break
            values += map(float, line.split())
        return np.array(values).reshape(count, width)

    def replace(self, name, rows):
        start = self.start(name)
        self.lines[start:start + self.count] = [" ".join(f"{x:.17g}" for x in row) for row in rows]


def with_our_frames(text, points, frames, size=None):
    """Puts our frames into B: as columns, of the length that is there or of a size, their names so that locked columns stay near."""
    _, own = cKDTree(points).query(text.numbers("point", 3))  # geogram has sorted its vertices
    theirs, locked = text.numbers("B", 9).reshape(-1, 3, 3), text.numbers("lockU", 3) != 0
    length = np.linalg.norm(theirs[:, :, 0], axis=1) if size is None else np.full(len(own), size)
    named = np.swapaxes(CUBE_ROTATIONS[:, None] @ frames[own], 2, 3)
    weight = np.where(locked, 1, FREE_WEIGHT)
    nearest = np.argmax(np.einsum("gnij,nij,nj->gn", named, theirs, weight), axis=0)
    text.replace("B", (named[nearest, np.arange(len(own))] * length[:, None, None]).reshape(-1, 9))


def fault_of_stages(program, folder, deadline=math.inf):
    """Where the stages after the field end with folder/FF.geogram_ascii; "" if they make hexdom.geogram_ascii."""
    for stage in AFTER_FIELD:
        fault = run(program, folder, f"hexdom:stage={stage}", seconds=min(SECONDS, max(0, deadline - time.monotonic())))
        if fault:
            return f"{stage}: {fault}"
    return "" if (folder / "hexdom.geogram_ascii").exists() else "no mesh"


def share_of_hexahedra(program, folder):
    """The percentage that the stages after the field reach with folder/FF.geogram_ascii, or where they end."""
    fault = fault_of_stages(program, folder)
    if fault:
        return fault
    run(program, folder, "stats_only=true", "hexdom.geogram_ascii")
    return float(re.search(r"Hex proportion=([\d.]+)%", (folder / "log").read_text()).group(1))


def run(program, folder, *options, seconds=SECONDS):
    """How a run ended: "" if well. Its output is in folder/log."""
    with open(folder / "log", "w", encoding="utf-8") as log:
        try:
            code = subprocess.run([program, *options, "ASCII=true"], cwd=folder, stdout=log, stderr=log, timeout=seconds,
                                  check=False).returncode
        except subprocess.TimeoutExpired:
            return "took too long"
    return f"exit code {code}" if code else ""


def fault_of_our_start(program, folder, size=None):
    """Makes folder/geogram/ours/FF.geogram_ascii with our frames, and folder/geogram/own without a field; why not, or ""."""
    own, ours = folder / "geogram" / "own", folder / "geogram" / "ours"
    for path in (own, ours):
        path.mkdir(parents=True, exist_ok=True)
        for old in path.glob("*.geogram_ascii"):
            old.unlink()
    fault = run(program, own, "hexdom:stage=SetConstraints", f"hexdom:tets={folder.resolve() / 'tets.mesh'}")
    if fault or not (own / "input.geogram_ascii").exists():
        return f"SetConstraints: {fault or 'no output'}"
    text = GeogramText(own / "input.geogram_ascii")
    with_our_frames(text, read_medit(folder / "tets.mesh")[0], np.loadtxt(folder / "onto.frames").reshape(-1, 3, 3), size)
    (ours / "FF.geogram_ascii").write_text("\n".join(text.lines))
    return ""


def shares(program, folder):
    """Percentages by geogram's field and by ours."""
    own, ours = folder / "geogram" / "own", folder / "geogram" / "ours"
    fault = fault_of_our_start(program, folder)
    if fault:
        return (fault,) * 2
    fault = run(program, own, "hexdom:stage=FrameField", "FrameField:smooth=true")
    return f"FrameField: {fault}" if fault else share_of_hexahedra(program, own), share_of_hexahedra(program, ours)


def main(built, *folders):
    print("| field | geogram's, % | ours, % |\n|---|---|---|")
    for folder in map(Path, folders):
        print(f"| {folder.name} | {' | '.join(map(str, shares((Path(built) / 'hexdom_pipeline').resolve(), folder)))} |", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:]) if len(sys.argv) > 2 else sys.exit(__doc__)

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that binary STL files are closed, consistently oriented surfaces that enclose a positive volume.

Usage: watertight.py FILE...     Prints a line of facts for each and exits with 1 where one is not.

Corners are the same vertex where their three floats are equal to the bit: nothing is repaired by a tolerance.
"""

import sys
from pathlib import Path

import numpy

TRIANGLE = numpy.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
HEADER_BYTES = 84


def corners_of(path):
    """The corners of a binary STL file, an array of shape (triangles, 3, 3)."""
    data = path.read_bytes()
    count = int.from_bytes(data[80:HEADER_BYTES], "little")
    if len(data) != HEADER_BYTES + count * TRIANGLE.itemsize:
        raise ValueError(f"{len(data)} bytes do not hold {count} triangles")
    return numpy.frombuffer(data, TRIANGLE, count, HEADER_BYTES)["corners"]


def faults_of(corners):
    """What keeps a triangle soup from being the boundary of a solid."""
    _, index = numpy.unique(corners.reshape(-1, 3), axis=0, return_inverse=True)
    triangles = index.reshape(-1, 3)
    if (triangles == numpy.roll(triangles, 1, axis=1)).any():
        yield "a triangle has two equal corners"
    edges = numpy.stack([triangles, numpy.roll(triangles, -1, axis=1)], axis=-1).reshape(-1, 2)
    unique_edges, uses = numpy.unique(edges, axis=0, return_counts=True)
    if (uses > 1).any():
        yield f"{(uses > 1).sum()} edges are used twice in the same direction"
    reversed_edges = numpy.unique(edges[:, ::-1], axis=0)
    if not numpy.array_equal(unique_edges, reversed_edges):
        yield "some edges have no opposite: the surface is open or not oriented"
    if volume_of(corners) <= 0:
        yield "the enclosed volume is not positive: the surface is inside out"


def volume_of(corners):
    a, b, c = numpy.moveaxis(corners.astype(float), 1, 0)
    return float(numpy.einsum("ij,ij->", a, numpy.cross(b, c))) / 6


def main():
    failed = len(sys.argv) < 2  # no file is no proof
    for name in sys.argv[1:]:
        corners = corners_of(Path(name))
        size = numpy.ptp(corners.reshape(-1, 3), axis=0)
        faults = list(faults_of(corners))
        failed = failed or bool(faults)
        print(f"{name}: {len(corners)} triangles, {size[0]:.1f} x {size[1]:.1f} x {size[2]:.1f},"
              f" volume {volume_of(corners):.0f}: {'; '.join(faults) or 'watertight'}")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())

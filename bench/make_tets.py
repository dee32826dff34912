#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a cube of tets as a Medit mesh in text, six tets in each of N x N x N cells.

Usage: make_tets.py N FILE.mesh     N = 55 gives 998,250 tets.
"""

import itertools
import sys


def main():
    cells, path = int(sys.argv[1]), sys.argv[2]
    side = cells + 1
    # Each cell's tets go along its diagonal, one for each order of the three axes.
    steps = (1, side, side * side)
    paths = []
    for order in itertools.permutations(steps):
        corners = [0, order[0], order[0] + order[1], sum(order)]
        paths.append(corners)
    with open(path, "w", encoding="ascii") as out:
        out.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{side**3}\n")
        for z in range(side):
            for y in range(side):
                out.write("".join(f"{x / cells:.15g} {y / cells:.15g} {z / cells:.15g} 0\n" for x in range(side)))
        out.write(f"Tetrahedra\n{6 * cells**3}\n")
        for z in range(cells):
            for y in range(cells):
                for x in range(cells):
                    first = 1 + x + side * (y + side * z)
                    for a, b, c, d in paths:
                        out.write(f"{first + a} {first + b} {first + c} {first + d} 1\n")
        out.write("End\n")


main()

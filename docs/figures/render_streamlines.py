#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws streamlines inside their part: blue, orange and green by the direction in which they mostly run.

    docs/figures/render_streamlines.py bracket.frames/streamlines.vtu models/bracket.stl docs/figures/streamlines.png

Red balls are ends at singular arcs. Needs Debian's python3-numpy and nothing else.
"""

import argparse

import numpy as np

from canvas import Camera, Canvas, downsample, write_png
from field_file import read_stl, read_vtu
from part import normals_of, sharp_edges
from render_field import EDGE, SINGULAR, STEEL, SUPERSAMPLING, draw_edges, draw_triangles

COLOURS = np.array([[0.10, 0.33, 0.66], [0.93, 0.50, 0.10], [0.25, 0.58, 0.30]])  # along x, y and z
AT_ARC = 1  # docs/streamlines.md
FRONT_OPACITY = 0.12


def lines_of(arrays):
    """(points, ends at arcs) of each line."""
    stops = arrays["offsets"].astype(int)
    for points, first, last in zip(np.split(arrays["points"], stops[:-1]), arrays["first_end"], arrays["last_end"]):
        yield points, [point for point, end in ((points[0], first), (points[-1], last)) if end == AT_ARC]


def picture(arrays, corners, view, size, width):
    low, high = corners.reshape(-1, 3).min(axis=0), corners.reshape(-1, 3).max(axis=0)
    camera = Camera(view, low, high, *size)
    normals = normals_of(corners)
    facing = normals @ camera.axes[2] > 0
    canvas = Canvas(*size)
    draw_triangles(canvas, camera, corners[~facing], STEEL, -normals[~facing])
    for points, at_arc in lines_of(arrays):
        projected = camera.project(points)
        # By every piece's own direction: around a bend a line passes from one colour to another.
        colours = COLOURS[np.abs(np.diff(points, axis=0)).argmax(axis=1)]
        for start, end, colour in zip(projected[:-1], projected[1:], colours):
            canvas.rod(start, end, width / 2, colour)
        for point in at_arc:
            canvas.ball(camera.project(point), 1.6 * width, SINGULAR)
    front = Canvas(*size)
    draw_triangles(front, camera, corners[facing], STEEL, normals[facing])
    canvas.blend(front, FRONT_OPACITY)
    draw_edges(canvas, camera, sharp_edges(corners), 1.2 * SUPERSAMPLING, np.inf, EDGE)
    return canvas.colour


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("lines", help="the file that 'crossgrain streamlines' wrote")
    parser.add_argument("model", help="the binary STL file it was solved for")
    parser.add_argument("picture", help="the PNG file to write")
    parser.add_argument("--view", type=float, nargs=3, default=[-0.55, -0.75, 0.5], metavar=("X", "Y", "Z"),
                        help="from the part to the viewer")
    parser.add_argument("--width", type=float, default=1.6, help="of lines, in pixels")
    parser.add_argument("--size", type=int, nargs=2, default=[1000, 800], metavar=("WIDTH", "HEIGHT"))
    options = parser.parse_args()
    size = [SUPERSAMPLING * side for side in options.size]
    colour = picture(read_vtu(options.lines), read_stl(options.model), np.array(options.view), size,
                     SUPERSAMPLING * options.width)
    write_png(options.picture, downsample(colour, SUPERSAMPLING))


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Draws a frame field: left the part with frames on its surface and its singular cells shining through, right
the octree and the frames on a cut.

    docs/figures/render_field.py bracket.frames/field.vtu models/bracket.stl docs/figures/bracket.png

Needs Debian's python3-numpy and nothing else.
"""

import argparse

import numpy as np

from canvas import Camera, Canvas, downsample, light, unit, write_png
from field_file import Field, read_stl
from part import clipped, contour, normals_of, sharp_edges, spread_points

STEEL = np.array([0.84, 0.87, 0.91])
EDGE = np.array([0.22, 0.25, 0.30])
TANGENT_AXIS = np.array([0.10, 0.33, 0.66])
NORMAL_AXIS = np.array([0.93, 0.50, 0.10])
CUT_AXIS = np.array([0.12, 0.30, 0.55])
SINGULAR = np.array([0.85, 0.10, 0.16])
CELL_EDGE = np.array([0.48, 0.52, 0.60])

# The fill of cells on the cut, from the finest level to the coarsest.
FINEST_CELL, COARSEST_CELL = np.array([0.995, 0.985, 0.955]), np.array([0.90, 0.93, 0.96])

SUPERSAMPLING = 2
SURFACE_OPACITY = 0.55


def singular_cells(field, threshold):
    """Cells whose energy density times their squared size, about the squared turn of the frame across them,
    exceeds the threshold: those around singular curves."""
    return field.energy_density * field.size**2 > threshold


def draw_triangles(canvas, camera, corners, colour, normals):
    projected = camera.project(corners)
    for triangle, brightness in zip(projected, camera.shade(normals)):
        canvas.triangle(triangle, brightness * colour)


def draw_edges(canvas, camera, segments, width, lift, colour=EDGE):
    for start, end in camera.project(segments):
        canvas.rod(start, end, width / 2, colour, lift)


def draw_frame(canvas, camera, centre, axes, half_length, radius, colours, lift):
    for axis, colour in zip(axes, colours):
        start, end = camera.project([centre - half_length * axis, centre + half_length * axis])
        canvas.rod(start, end, radius, colour, lift)


def surface_panel(field, corners, options, size):
    """The part, translucent, with crosses on its surface and its singular cells inside."""
    low, high = corners.reshape(-1, 3).min(axis=0), corners.reshape(-1, 3).max(axis=0)
    camera = Camera(options.view, low, high, *size)
    normals = normals_of(corners)
    facing = normals @ camera.axes[2] > 0
    spacing = options.spacing * np.linalg.norm(high - low)

    canvas = Canvas(*size)
    draw_triangles(canvas, camera, corners[~facing], STEEL, -normals[~facing])
    inner = singular_cells(field, options.singular_threshold) & ~field.is_boundary
    for centre, cell in zip(field.low[inner] + field.size[inner, None] / 2, field.size[inner]):
        canvas.ball(camera.project(centre), 0.6 * cell * camera.scale, SINGULAR)

    front = Canvas(*size)
    draw_triangles(front, camera, corners[facing], STEEL, normals[facing])
    canvas.blend(front, SURFACE_OPACITY)
    drawn = np.isfinite(front.depth)
    canvas.depth[drawn] = front.depth[drawn]
    draw_edges(canvas, camera, sharp_edges(corners), 1.6 * SUPERSAMPLING, 4 * SUPERSAMPLING)

    points, point_normals = spread_points(corners, spacing)
    # A little below the surface, where no rounding moves a point out of its cell.
    cells = field.cells_at(points - 0.1 * field.size.min() * point_normals)
    # At a grazing angle a cross is a smudge.
    visible = (cells >= 0) & (point_normals @ camera.axes[2] > 0.12)
    for point, normal, cell in zip(points[visible], point_normals[visible], cells[visible]):
        draw_surface_frame(canvas, camera, point, normal, field.frames[cell], spacing)
    return canvas.colour


def draw_surface_frame(canvas, camera, point, normal, frame, spacing):
    """The two axes along the surface as a cross, and a stub of the third, nearest to the normal."""
    alignment = frame @ normal
    upward = np.argmax(np.abs(alignment))
    radius = 0.045 * spacing * camera.scale
    tangents = [axis for i, axis in enumerate(frame) if i != upward]
    draw_frame(canvas, camera, point, tangents, 0.40 * spacing, radius, [TANGENT_AXIS] * 2, 2 * radius)
    tip = point + np.copysign(0.42 * spacing, alignment[upward]) * frame[upward]
    start, end = camera.project([point, tip])
    canvas.rod(start, end, radius, NORMAL_AXIS, 2 * radius)


class Cut:
    """The plane that a cut is made in; what lies before it (on the side of `normal`) is taken away."""

    def __init__(self, axis, fraction, viewer, low, high):
        self.normal = np.zeros(3)
        self.normal[axis] = np.sign(viewer[axis]) or 1.0
        # Off by a hair, so that the plane meets no vertex and no face between cells.
        position = low[axis] + (fraction + 1.7e-5) * (high[axis] - low[axis])
        self.offset = self.normal[axis] * position
        self.in_plane = [other for other in range(3) if other != axis]


def cut_panel(field, corners, options, size):
    """What is left of the part behind a plane, with the octree and its frames on the cut."""
    low, high = corners.reshape(-1, 3).min(axis=0), corners.reshape(-1, 3).max(axis=0)
    cut = Cut("xyz".index(options.cut), options.cut_at, options.view, low, high)
    sideways = unit(np.asarray(options.view) - (options.view @ cut.normal) * cut.normal)
    camera = Camera(cut.normal + np.tan(np.radians(options.cut_tilt)) * sideways, low, high, *size)
    pixel = 1 / camera.scale

    canvas = Canvas(*size)
    pieces, origin = clipped(corners, cut.normal, cut.offset)
    normals = normals_of(corners)[origin]
    facing = normals @ camera.axes[2] > 0
    draw_triangles(canvas, camera, pieces[facing], STEEL, normals[facing])
    edges = sharp_edges(corners)
    behind = (edges @ cut.normal < cut.offset).all(axis=1)
    draw_edges(canvas, camera, edges[behind], 1.4 * SUPERSAMPLING, 3 * SUPERSAMPLING)

    outline = contour(corners, cut.normal, cut.offset)
    inside = even_odd_mask(camera.project(outline)[..., :2], canvas.depth.shape)
    points, depth = points_on_plane(camera, cut, inside)
    colours = cell_colours(field, points, cut, options.singular_threshold, 0.5 * SUPERSAMPLING * pixel)
    canvas.colour[inside], canvas.depth[inside] = colours, depth
    draw_edges(canvas, camera, outline, 2.4 * SUPERSAMPLING, 3 * SUPERSAMPLING)

    pitch = options.cut_spacing * np.linalg.norm(high - low)
    nodes = [np.arange(low[k] + pitch / 2, high[k], pitch) for k in cut.in_plane]
    places = np.zeros((len(nodes[0]) * len(nodes[1]), 3))
    places[:, cut.in_plane] = np.array(np.meshgrid(*nodes)).reshape(2, -1).T
    places += (cut.offset - places @ cut.normal)[:, None] * cut.normal
    x, y = np.round(camera.project(places)[:, :2] - 0.5).astype(int).T
    kept = inside[np.clip(y, 0, size[1] - 1), np.clip(x, 0, size[0] - 1)]
    places = places[kept]
    for place, cell in zip(places, field.cells_at(places)):
        if cell >= 0:
            draw_frame(canvas, camera, place, field.frames[cell], 0.34 * pitch, 0.045 * pitch * camera.scale,
                       [CUT_AXIS] * 3, pitch * camera.scale)
    return canvas.colour


def even_odd_mask(segments, shape):
    """The pixels that closed polygons, given as loose segments in pixels, enclose."""
    toggles = np.zeros((shape[0], shape[1] + 1), np.uint8)
    for (x0, y0), (x1, y1) in segments:
        if y0 > y1:
            x0, y0, x1, y1 = x1, y1, x0, y0
        rows = np.arange(max(int(np.ceil(y0 - 0.5)), 0), min(int(np.ceil(y1 - 0.5)), shape[0]))
        if len(rows):
            crossings = x0 + (rows + 0.5 - y0) * (x1 - x0) / (y1 - y0)
            columns = np.clip(np.ceil(crossings - 0.5), 0, shape[1]).astype(int)
            toggles[rows, columns] ^= 1
    return np.cumsum(toggles, axis=1)[:, :-1] % 2 == 1


def points_on_plane(camera, cut, inside):
    """Where the rays through the masked pixels meet the cut, and the depth there."""
    y, x = np.nonzero(inside)
    flat = (np.stack([x + 0.5, y + 0.5, np.zeros(len(x))], axis=1) - camera.shift) / camera.flip
    points = flat @ camera.axes
    travel = (cut.offset - points @ cut.normal) / (camera.axes[2] @ cut.normal)
    return points + travel[:, None] * camera.axes[2], travel * camera.scale


def cell_colours(field, points, cut, singular_threshold, half_line):
    """The colour of the cell around each point: its level, redder with its energy, with a line along its faces."""
    cells = field.cells_at(points)
    size, low = field.size[cells], field.low[cells]
    finest, coarsest = field.size.min(), field.size.max()
    level = np.log2(size / finest) / max(np.log2(coarsest / finest), 1)
    colours = FINEST_CELL + level[:, None] * (COARSEST_CELL - FINEST_CELL)
    strength = np.clip(field.energy_density[cells] * size**2 / singular_threshold, 0, 1)[:, None] ** 2
    colours += strength * (SINGULAR - colours)
    offset = (points - low)[:, cut.in_plane]
    on_line = (np.minimum(offset, size[:, None] - offset) < half_line).any(axis=1)
    colours[on_line] = 0.45 * colours[on_line] + 0.55 * CELL_EDGE
    colours[cells < 0] = STEEL
    return colours * min(light(np.array([0, 0, 1.0])) + 0.25, 1)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("field", help="field.vtu")
    parser.add_argument("model", help="the binary STL file it was solved for")
    parser.add_argument("picture", help="the PNG file to write")
    parser.add_argument("--view", type=float, nargs=3, default=[-0.55, -0.75, 0.5], metavar=("X", "Y", "Z"),
                        help="from the part to the viewer")
    parser.add_argument("--cut", choices="xyz", default="y", help="axis that the cut is square to")
    parser.add_argument("--cut-at", type=float, default=0.5, help="where along it, 0 to 1")
    parser.add_argument("--cut-tilt", type=float, default=24, help="degrees between the cut's normal and the view")
    parser.add_argument("--spacing", type=float, default=0.028, help="of frames on the surface, in diagonals")
    parser.add_argument("--cut-spacing", type=float, default=0.024, help="of frames on the cut, in diagonals")
    parser.add_argument("--singular-threshold", type=float, default=0.2,
                        help="energy density times squared cell size from which a cell counts as singular")
    parser.add_argument("--size", type=int, nargs=2, default=[1600, 800], metavar=("WIDTH", "HEIGHT"))
    options = parser.parse_args()
    options.view = unit(options.view)
    return options


def main():
    options = arguments()
    field, corners = Field(options.field), read_stl(options.model)
    panel = (options.size[0] // 2 * SUPERSAMPLING, options.size[1] * SUPERSAMPLING)
    panels = [draw(field, corners, options, panel) for draw in (surface_panel, cut_panel)]
    write_png(options.picture, downsample(np.concatenate(panels, axis=1), SUPERSAMPLING))


if __name__ == "__main__":
    main()

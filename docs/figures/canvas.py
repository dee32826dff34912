# SPDX-License-Identifier: Apache-2.0
"""A z-buffer: triangles, rods and balls under an orthographic camera, smoothed by supersampling, saved as PNG.

World coordinates are the model's. A camera maps them to (x, y, depth) in subpixels: x to the right, y down,
and of two points the one with the larger depth is nearer to the viewer.
"""

import struct
import zlib

import numpy as np

# Towards two lamps, in camera axes (right, up, to the viewer): a key light from the upper left, a weak fill.
KEY_LIGHT = np.array([-0.45, 0.62, 0.64])
FILL_LIGHT = np.array([0.75, 0.10, 0.65])
AMBIENT, KEY, FILL = 0.46, 0.50, 0.14


def unit(vector):
    return np.asarray(vector, float) / np.linalg.norm(vector)


class Camera:
    """Looks along -`towards_viewer` with z up, so that the box `low` to `high` fills the canvas but `margin`."""

    def __init__(self, towards_viewer, low, high, width, height, margin=0.04):
        viewer = unit(towards_viewer)
        right = unit(np.cross([0, 0, 1], viewer))
        self.axes = np.array([right, np.cross(viewer, right), viewer])
        corners = np.array(np.meshgrid(*zip(low, high))).reshape(3, -1).T @ self.axes.T
        extent = np.ptp(corners, axis=0)
        self.scale = (1 - 2 * margin) * min(width / extent[0], height / extent[1])
        middle = (corners.min(axis=0) + corners.max(axis=0)) / 2
        self.shift = np.array([width / 2 - self.scale * middle[0], height / 2 + self.scale * middle[1], 0])
        self.flip = np.array([self.scale, -self.scale, self.scale])

    def project(self, points):
        return (np.asarray(points) @ self.axes.T) * self.flip + self.shift

    def shade(self, normals):
        """Brightness of surfaces with these unit normals (in world coordinates), 0.46 to about 1."""
        return light(np.asarray(normals) @ self.axes.T)


def light(normals):
    """Brightness for unit normals in camera axes."""
    key = np.maximum(normals @ unit(KEY_LIGHT), 0)
    fill = np.maximum(normals @ unit(FILL_LIGHT), 0)
    return AMBIENT + KEY * key + FILL * fill


class Canvas:
    def __init__(self, width, height, background=(1.0, 1.0, 1.0)):
        self.colour = np.tile(np.asarray(background, np.float32), (height, width, 1))
        self.depth = np.full((height, width), -np.inf, np.float32)

    def copy(self):
        other = Canvas.__new__(Canvas)
        other.colour, other.depth = self.colour.copy(), self.depth.copy()
        return other

    def window(self, low, high):
        """Slices and pixel centres of the part of the canvas between two corners; None where it is empty."""
        height, width = self.depth.shape
        x0, y0 = max(int(np.floor(low[0])), 0), max(int(np.floor(low[1])), 0)
        x1, y1 = min(int(np.ceil(high[0])), width), min(int(np.ceil(high[1])), height)
        if x0 >= x1 or y0 >= y1:
            return None
        y, x = np.mgrid[y0:y1, x0:x1] + 0.5
        return (slice(y0, y1), slice(x0, x1)), x, y

    def put(self, area, inside, depth, colour):
        nearer = inside & (depth > self.depth[area])
        self.depth[area][nearer] = depth[nearer]
        self.colour[area][nearer] = colour[nearer] if np.ndim(colour) > 1 else colour

    def triangle(self, corners, colour):
        """A flat triangle; `corners` are projected."""
        window = self.window(corners.min(axis=0), corners.max(axis=0))
        (a, b, c) = corners
        area2 = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        if window is None or area2 == 0:
            return
        area, x, y = window
        v = ((x - a[0]) * (c[1] - a[1]) - (y - a[1]) * (c[0] - a[0])) / area2
        w = ((b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])) / area2
        # The slack closes the hairlines between neighbours that rounding leaves.
        inside = (v >= -1e-9) & (w >= -1e-9) & (v + w <= 1 + 1e-9)
        self.put(area, inside, a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2]), colour)

    def rod(self, start, end, radius, colour, lift=0.0):
        """A round bar between projected points, lit as a cylinder, drawn `lift` nearer than it is."""
        low, high = np.minimum(start, end)[:2] - radius, np.maximum(start, end)[:2] + radius
        window = self.window(low, high)
        if window is None:
            return
        area, x, y = window
        along = (end - start)[:2]
        length2 = max(along @ along, 1e-12)
        t = np.clip(((x - start[0]) * along[0] + (y - start[1]) * along[1]) / length2, 0, 1)
        dx, dy = x - start[0] - t * along[0], y - start[1] - t * along[1]
        height2 = radius**2 - dx**2 - dy**2
        height = np.sqrt(np.maximum(height2, 0))
        normals = np.stack([dx, -dy, height], axis=-1) / radius
        depth = start[2] + t * (end[2] - start[2]) + height + lift
        self.put(area, height2 > 0, depth, light(normals)[..., None] * colour)

    def ball(self, centre, radius, colour):
        self.rod(centre, centre, radius, colour)

    def blend(self, front, opacity):
        """Lays a canvas over this one, translucent where something is drawn on it."""
        drawn = np.isfinite(front.depth)
        self.colour[drawn] = (1 - opacity) * self.colour[drawn] + opacity * front.colour[drawn]


def downsample(colour, factor):
    height, width, _ = colour.shape
    return colour.reshape(height // factor, factor, width // factor, factor, 3).mean(axis=(1, 3))


def write_png(path, colour):
    """Writes an image of floats in [0, 1] as 8-bit RGB."""
    pixels = (np.clip(colour, 0, 1) * 255 + 0.5).astype(np.uint8)
    height, width, _ = pixels.shape
    rows = np.concatenate([np.zeros((height, 1), np.uint8), pixels.reshape(height, -1)], axis=1)

    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header))
        file.write(chunk(b"IDAT", zlib.compress(rows.tobytes(), 9)) + chunk(b"IEND", b""))

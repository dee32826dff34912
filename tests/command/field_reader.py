# SPDX-License-Identifier: Apache-2.0
"""Reads field.vtu with code of its own: the arrays, and the octree that they make up."""

import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

import numpy as np

TYPES = {"Int8": "<i1", "Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "Int64": "<i8", "UInt8": "<u1", "UInt32": "<u4",
         "UInt64": "<u8"}
VTK_HEXAHEDRON = 12
FACES = [(axis, sign) for axis in range(3) for sign in (-1, 1)]  # in the order of the bits of open_faces


def read_arrays(path):
    """{name: values} of all arrays of the file."""
    data = Path(path).read_bytes()
    tag = data.index(b"<AppendedData")
    start = data.index(b"_", tag) + 1
    root = ElementTree.fromstring(data[:tag] + b"</VTKFile>")
    assert root.get("compressor") == "vtkZLibDataCompressor" and root.get("header_type") == "UInt64"
    arrays = {}
    for element in root.iter("DataArray"):
        at = start + int(element.get("offset"))
        blocks = int(np.frombuffer(data, "<u8", 1, at)[0])
        ends = at + 24 + 8 * blocks + np.cumsum([0, *np.frombuffer(data, "<u8", blocks, at + 24).astype(int)])
        raw = b"".join(zlib.decompress(data[a:b]) for a, b in zip(ends[:-1], ends[1:]))
        values = np.frombuffer(raw, TYPES[element.get("type")])
        components = int(element.get("NumberOfComponents"))
        arrays[element.get("Name")] = values.reshape(-1, components) if components > 1 else values
    return arrays


def decoded(address):
    """Depth of a cell, and its low corner in units of its own width (docs/field-file.md)."""
    depth, code = address & 31, address >> 5
    corner = [sum((code >> (3 * bit + axis) & 1) << bit for bit in range(19)) for axis in range(3)]
    return depth, tuple(x >> (19 - depth) for x in corner)


class Field:
    """The active cells: `low` corners, `size`, `axes` (cell, axis, component), `depth`, `place` in cells of that depth."""

    def __init__(self, path):
        self.arrays = arrays = read_arrays(path)
        assert (arrays["types"] == VTK_HEXAHEDRON).all()
        corners = arrays["Points"][arrays["connectivity"].reshape(-1, 8)]
        self.low = corners[:, 0]
        self.size = (corners[:, 6] - corners[:, 0])[:, 0]
        self.centre = 0.5 * (corners[:, 0] + corners[:, 6])
        # Orthonormal again after their rounding to single precision.
        left, _, right = np.linalg.svd(np.stack([arrays[f"axis_{name}"] for name in "uvw"], axis=1).astype(float))
        self.axes = left @ right
        cells = [decoded(int(address)) for address in arrays["cell_address"]]
        self.depth = np.array([depth for depth, _ in cells])
        self.place = [place for _, place in cells]
        self.index = {cell: i for i, cell in enumerate(cells)}
        self.open_faces = arrays["open_faces"]
        self.check_points(corners)

    def __len__(self):
        return len(self.size)

    def check_points(self, corners):
        """Points are shared, and every cell is the cube that its address says."""
        points = self.arrays["Points"]
        assert len(np.unique(points, axis=0)) == len(points)
        assert (self.arrays["offsets"] == 8 * np.arange(1, len(self) + 1)).all()
        root = self.arrays["root_cube"].ravel()
        size = root[3] / 2.0**self.depth
        offsets = np.array([[k % 4 in (1, 2), k % 4 >= 2, k >= 4] for k in range(8)])
        expected = root[:3] + size[:, None, None] * (np.array(self.place)[:, None, :] + offsets)
        np.testing.assert_allclose(corners, expected, rtol=0, atol=1e-12 * (np.abs(root[:3]).max() + root[3]))
        assert (self.arrays["level"] == self.depth).all()

    def containing(self, depth, place):
        """The cell that is or contains an address; None where there is none."""
        for up in range(depth + 1):
            i = self.index.get((depth - up, tuple(x >> up for x in place)))
            if i is not None:
                return i
        return None

    def neighbour(self, i, face):
        """The cell of the same size or larger across a face."""
        axis, sign = FACES[face]
        place = list(self.place[i])
        place[axis] += sign
        if not 0 <= place[axis] < 1 << self.depth[i]:
            return None
        return self.containing(int(self.depth[i]), place)

    def joined(self, i, face, j):
        """Whether the face between two cells is open: the smaller of them says so, or either of two equal ones."""
        forth = self.depth[i] >= self.depth[j] and self.open_faces[i] >> face & 1
        back = self.depth[j] >= self.depth[i] and self.open_faces[j] >> (face ^ 1) & 1
        return bool(forth or back)

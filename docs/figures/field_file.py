# SPDX-License-Identifier: Apache-2.0
"""Reads what the pictures are made of: the field in field.vtu and the triangles of a binary STL file."""

import sys
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

import numpy as np

TYPES = {"Float32": "<f4", "Float64": "<f8", "Int8": "<i1", "UInt8": "<u1", "Int32": "<i4", "UInt32": "<u4",
         "Int64": "<i8", "UInt64": "<u8"}

# VTK's number of a cell type, and the place of the highest corner in its list of corners.
HIGHEST_CORNER = {11: 7, 12: 6}  # VTK_VOXEL, VTK_HEXAHEDRON


def read_vtu(path):
    """{array name in lower case: values} of a VTU file (appended raw zlib data, UInt64 headers), cells and points too."""
    data = Path(path).read_bytes()
    tag = data.index(b"<AppendedData")
    start = data.index(b"_", data.index(b">", tag)) + 1
    root = ElementTree.fromstring(data[:tag] + b"</VTKFile>")
    if root.get("header_type") != "UInt64" or root.get("compressor") != "vtkZLibDataCompressor":
        raise ValueError(f"{path}: not zlib data with UInt64 headers")
    arrays = {}
    for element in root.iter("DataArray"):
        if element.get("type") not in TYPES:
            continue
        values = np.frombuffer(inflated(data, start + int(element.get("offset"))), TYPES[element.get("type")])
        components = int(element.get("NumberOfComponents", 1))
        arrays[element.get("Name").lower()] = values.reshape(-1, components) if components > 1 else values
    return arrays


def inflated(data, start):
    """The bytes of one appended array: block count, block size, last block's size, compressed sizes, blocks."""
    blocks = int(np.frombuffer(data, "<u8", 1, start)[0])
    sizes = np.frombuffer(data, "<u8", blocks, start + 24).astype(int)
    ends = start + 24 + 8 * blocks + np.cumsum(sizes)
    return b"".join(zlib.decompress(data[end - size : end]) for size, end in zip(sizes, ends))


class Field:
    """The active cells of a field: `low`, `size`, `frames` (cells x 3 axes x 3), `energy_density`."""

    def __init__(self, path):
        arrays = read_vtu(path)
        corners = arrays["connectivity"].reshape(-1, 8)
        highest = HIGHEST_CORNER[int(arrays["types"][0])]
        self.low = arrays["points"][corners[:, 0]].astype(float)
        self.size = (arrays["points"][corners[:, highest]].astype(float) - self.low)[:, 0]
        self.frames = np.stack([arrays[f"axis_{axis}"] for axis in "uvw"], axis=1).astype(float)
        self.energy_density = arrays["energy_density"].astype(float).reshape(-1)
        self.is_boundary = arrays["is_boundary"].reshape(-1) != 0
        self.index_by_size = self.make_index()

    def make_index(self):
        """For each cell size: sorted integer addresses and the cells that have them."""
        self.origin = self.low[np.argmax(self.size)]
        finest = self.size.min()
        depth = np.round(np.log2(self.size / finest)).astype(int)
        index = []
        for level in np.unique(depth):
            cells = np.flatnonzero(depth == level)
            size = finest * 2.0**level
            keys = address_key(np.round((self.low[cells] - self.origin) / size).astype(np.int64))
            order = np.argsort(keys)
            index.append((size, keys[order], cells[order]))
        return index

    def cells_at(self, points):
        """The active cell that holds each point; -1 where there is none."""
        found = np.full(len(points), -1)
        for size, keys, cells in self.index_by_size:
            wanted = address_key(np.floor((points - self.origin) / size).astype(np.int64))
            place = np.minimum(np.searchsorted(keys, wanted), len(keys) - 1)
            hit = keys[place] == wanted
            found[hit] = cells[place[hit]]
        return found


def address_key(address):
    """One integer for three, of up to 20 bits and a sign each."""
    shifted = address + (1 << 20)
    return (shifted[:, 0] << 42) | (shifted[:, 1] << 21) | shifted[:, 2]


def read_stl(path):
    """The corners of a binary STL file's triangles, an array of shape (triangles, 3, 3)."""
    data = Path(path).read_bytes()
    triangle = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
    count = int.from_bytes(data[80:84], "little")
    if len(data) != 84 + count * triangle.itemsize:
        sys.exit(f"{path}: is no binary STL file; export it as one")
    return np.frombuffer(data, triangle, count, 84)["corners"].astype(float)

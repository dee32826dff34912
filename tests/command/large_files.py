#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes large files of one format: tests/command/large_files.py FORMAT FILE [SIZE_MB]

The surfaces are a sphere with bumps, the tets fill a box; their number follows from SIZE_MB (500 by default). Arrays
of zeros in `bomb.vtu` inflate to a thousand times its size.
"""

import base64
import struct
import sys
import zlib

import numpy as np

# Bytes of a triangle, with its half of a vertex, or of a tet with its sixth of one.
BYTES = {"stl": 50, "text.stl": 260, "obj": 56, "ply": 19, "text.ply": 56, "off": 56, "mesh": 40, "msh": 44,
         "vtk": 29, "vtu": 48}


def sphere(triangles):
    """Vertices and triangles of a closed sphere with bumps: rings of equal numbers of points between two poles."""
    rings = max(3, int(round((triangles / 4) ** 0.5)))
    around = 2 * rings
    theta = np.pi * (np.arange(rings) + 0.5) / rings
    phi = 2 * np.pi * np.arange(around) / around
    radius = 1 + 0.05 * np.sin(9 * theta)[:, None] * np.cos(7 * phi)[None]
    points = np.stack([radius * np.sin(theta)[:, None] * np.cos(phi), radius * np.sin(theta)[:, None] * np.sin(phi),
                       radius * np.cos(theta)[:, None]], axis=2).reshape(-1, 3)
    points = np.concatenate([points, [[0, 0, 1], [0, 0, -1]]])
    i, j = np.meshgrid(np.arange(rings - 1), np.arange(around), indexing="ij")
    a, b = i * around + j, i * around + (j + 1) % around
    c, d = a + around, b + around
    north, south = len(points) - 2, len(points) - 1
    first, last = np.arange(around), (rings - 1) * around + np.arange(around)
    faces = [np.stack([a, c, d], 2).reshape(-1, 3), np.stack([a, d, b], 2).reshape(-1, 3),
             np.stack([np.full(around, north), first, np.roll(first, -1)], 1),
             np.stack([np.full(around, south), np.roll(last, -1), last], 1)]
    return points.astype(np.float32), np.concatenate(faces).astype(np.int32)


def box(tets):
    """Vertices and tets of a box cut into cubes, each of six tets around a diagonal."""
    n = max(1, int(round((tets / 6) ** (1 / 3))))
    grid = np.stack(np.meshgrid(*[np.arange(n + 1)] * 3, indexing="ij"), 3)[:, :, :, ::-1].reshape(-1, 3)
    steps = np.array([1, n + 1, (n + 1) ** 2])
    corner = np.stack(np.meshgrid(*[np.arange(n)] * 3, indexing="ij"), 3).reshape(-1, 3) @ steps[::-1]
    cells = []
    for i, j, k in [(0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (1, 0, 2), (2, 1, 0)]:
        tet = [corner, corner + steps[i], corner + steps[i] + steps[j], corner + steps.sum()]
        cells.append(np.stack(tet if (j - i) % 3 == 1 else [tet[0], tet[1], tet[3], tet[2]], 1))
    return grid.astype(np.float64) / n, np.concatenate(cells).astype(np.int32)


def write_rows(out, pattern, rows):
    """Rows of numbers as text, in pieces that fit into memory."""
    for begin in range(0, len(rows), 1 << 18):
        piece = rows[begin:begin + (1 << 18)]
        out.write(("".join([pattern] * len(piece)) % tuple(piece.reshape(-1).tolist())).encode())


def write_stl(out, points, faces):
    out.write(bytes(80) + struct.pack("<I", len(faces)))
    kind = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("zero", "<u2")])
    for begin in range(0, len(faces), 1 << 20):
        piece = faces[begin:begin + (1 << 20)]
        records = np.zeros(len(piece), kind)
        records["corners"] = points[piece]
        out.write(records.tobytes())


def write_text_stl(out, points, faces):
    out.write(b"solid large\n")
    write_rows(out, "facet normal 0 0 0\n outer loop\n" + "  vertex %.9g %.9g %.9g\n" * 3 + " endloop\nendfacet\n",
               points[faces].reshape(-1, 9))
    out.write(b"endsolid large\n")


def write_obj(out, points, faces):
    write_rows(out, "v %.9g %.9g %.9g\n", points)
    write_rows(out, "f %d %d %d\n", faces + 1)


def write_off(out, points, faces):
    out.write(f"OFF\n{len(points)} {len(faces)} 0\n".encode())
    write_rows(out, "%.9g %.9g %.9g\n", points)
    write_rows(out, "3 %d %d %d\n", faces)


def ply_header(encoding, points, faces):
    return (f"ply\nformat {encoding} 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n").encode()


def write_ply(out, points, faces):
    out.write(ply_header("binary_little_endian", points, faces) + points.astype("<f4").tobytes())
    records = np.zeros(len(faces), np.dtype([("n", "u1"), ("corners", "<i4", 3)]))
    records["n"], records["corners"] = 3, faces
    out.write(records.tobytes())


def write_text_ply(out, points, faces):
    out.write(ply_header("ascii", points, faces))
    write_rows(out, "%.9g %.9g %.9g\n", points)
    write_rows(out, "3 %d %d %d\n", faces)


def write_mesh(out, points, tets):
    out.write(f"MeshVersionFormatted 2\nDimension 3\nVertices\n{len(points)}\n".encode())
    write_rows(out, "%.9g %.9g %.9g 0\n", points)
    out.write(f"Tetrahedra\n{len(tets)}\n".encode())
    write_rows(out, "%d %d %d %d 1\n", tets + 1)
    out.write(b"End\n")


def write_msh(out, points, tets):
    """MSH 2 in binary, its nodes numbered backwards."""
    numbers = np.arange(len(points), 0, -1)
    out.write(b"$MeshFormat\n2.2 1 8\n" + struct.pack("<i", 1) + b"\n$EndMeshFormat\n$Nodes\n%d\n" % len(points))
    nodes = np.zeros(len(points), np.dtype([("number", "<i4"), ("position", "<f8", 3)]))
    nodes["number"], nodes["position"] = numbers, points
    out.write(nodes.tobytes() + b"\n$EndNodes\n$Elements\n%d\n" % len(tets) + struct.pack("<3i", 4, len(tets), 2))
    elements = np.ones((len(tets), 7), "<i4")
    elements[:, 3:] = numbers[tets]
    out.write(elements.tobytes() + b"\n$EndElements\n")


def write_vtk(out, points, tets):
    out.write(b"# vtk DataFile Version 3.0\nlarge\nBINARY\nDATASET UNSTRUCTURED_GRID\nPOINTS %d double\n" % len(points))
    out.write(points.astype(">f8").tobytes() + b"\nCELLS %d %d\n" % (len(tets), 5 * len(tets)))
    cells = np.full((len(tets), 5), 4, ">i4")
    cells[:, 1:] = tets
    out.write(cells.tobytes() + b"\nCELL_TYPES %d\n" % len(tets) + np.full(len(tets), 10, ">i4").tobytes() + b"\n")


def vtu_array(kind, name, components, data):
    block = 1 << 20
    blocks = [zlib.compress(data[i:i + block], 1) for i in range(0, len(data), block)]
    head = struct.pack("<3Q", len(blocks), block, len(data) % block) + struct.pack(f"<{len(blocks)}Q", *map(len, blocks))
    return (f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="binary">'.encode() +
            base64.b64encode(head) + base64.b64encode(b"".join(blocks)) + b"</DataArray>\n")


def write_vtu(out, points, tets):
    out.write(b'<VTKFile type="UnstructuredGrid" byte_order="LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor">\n')
    out.write(f'<UnstructuredGrid><Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(tets)}">\n<Points>'.encode())
    out.write(vtu_array("Float64", "Points", 3, points.astype("<f8").tobytes()) + b"</Points>\n<Cells>")
    out.write(vtu_array("Int32", "connectivity", 1, tets.astype("<i4").tobytes()))
    out.write(vtu_array("Int32", "offsets", 1, (4 * np.arange(1, len(tets) + 1, dtype="<i4")).tobytes()))
    out.write(vtu_array("UInt8", "types", 1, np.full(len(tets), 10, "u1").tobytes()))
    out.write(b"</Cells>\n</Piece></UnstructuredGrid></VTKFile>\n")


def write_bomb(out, size):
    """Points of zeros; `size` is that of the file."""
    block = bytes(1 << 24)
    packed = zlib.compress(block, 9)
    blocks = max(1, size * 3 // 4 // len(packed)) // 3 * 3
    points = blocks * len(block) // 24
    head = struct.pack("<3Q", blocks, len(block), 0) + struct.pack("<Q", len(packed)) * blocks
    out.write(b'<VTKFile type="UnstructuredGrid" byte_order="LittleEndian" header_type="UInt64" compressor="vtkZLibDataCompressor">\n')
    out.write(f'<UnstructuredGrid><Piece NumberOfPoints="{points}" NumberOfCells="1">\n<Points>'.encode())
    out.write(b'<DataArray type="Float64" Name="Points" NumberOfComponents="3" format="binary">')
    out.write(base64.b64encode(head) + base64.b64encode(packed * blocks) + b"</DataArray></Points>\n<Cells>")
    out.write(vtu_array("Int32", "connectivity", 1, struct.pack("<4i", 0, 1, 2, 3)))
    out.write(vtu_array("Int32", "offsets", 1, struct.pack("<i", 4)) + vtu_array("UInt8", "types", 1, b"\x0a"))
    out.write(b"</Cells>\n</Piece></UnstructuredGrid></VTKFile>\n")


def write_json(out, size):
    """Constraints: a list of points with axes."""
    row = b'{"at": [0.1, 0.2, 0.3], "axis": [0, 0, 1]},\n'
    out.write(b'{"schema": 1, "points": [\n' + row * (size // len(row)) + row[:-2] + b"]}\n")


def write_large(kind, out, size):
    if kind == "bomb.vtu":
        return write_bomb(out, size)
    if kind == "json":
        return write_json(out, size)
    made = (box if kind in ("mesh", "msh", "vtk", "vtu") else sphere)(size / BYTES[kind])
    globals()["write_" + "_".join(kind.split("."))](out, *made)


if __name__ == "__main__":
    with open(sys.argv[2], "wb") as file:
        write_large(sys.argv[1], file, int(1e6 * float(sys.argv[3] if len(sys.argv) > 3 else 500)))

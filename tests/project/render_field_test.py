#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""docs/figures reads the files that it draws and shows in them what it should."""

import struct
import sys
import tempfile
import unittest
import zlib
from pathlib import Path
from unittest import mock

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2] / "docs" / "figures"))
sys.dont_write_bytecode = True
import field_file  # noqa: E402
import part  # noqa: E402
import render_field  # noqa: E402
import render_streamlines  # noqa: E402

CORNERS = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)])  # in VTK_VOXEL's order
CUBE_FACES = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
CUBE = CORNERS[CUBE_FACES[:, [0, 1, 2, 0, 2, 3]].reshape(-1, 3)].astype(float) * 4
CELLS = np.array([[x, y, z] for x in range(4) for y in range(4) for z in range(4)])
COLUMN = (CELLS[:, 0] == 1) & (CELLS[:, 1] == 2)  # the cells that are called singular


def write_stl(path, corners):
    triangles = b"".join(struct.pack("<12fH", 0, 0, 0, *triangle.ravel(), 0) for triangle in corners)
    path.write_bytes(bytes(80) + struct.pack("<I", len(corners)) + triangles)


def write_vtu(path, arrays):
    """{name: values} as appended zlib data in blocks of 100 bytes, small to have many of them."""
    header, blob, block = "", b"", 100
    names = {"f4": "Float32", "f8": "Float64", "i8": "Int64", "u1": "UInt8"}
    for name, values in arrays.items():
        raw = values.tobytes()
        blocks = [zlib.compress(raw[i : i + block]) for i in range(0, len(raw), block)]
        components = 1 if values.ndim == 1 else values.shape[1]
        header += (f'<DataArray type="{names[values.dtype.str[1:]]}" Name="{name}" format="appended"'
                   f' NumberOfComponents="{components}" offset="{len(blob)}"/>')
        blob += struct.pack(f"<{3 + len(blocks)}Q", len(blocks), block, len(raw) % block, *map(len, blocks))
        blob += b"".join(blocks)
    text = ('<VTKFile type="UnstructuredGrid" header_type="UInt64" compressor="vtkZLibDataCompressor">'
            f'<UnstructuredGrid>{header}</UnstructuredGrid><AppendedData encoding="raw">_')
    path.write_bytes(text.encode() + blob + b"</AppendedData></VTKFile>")


def write_field(path, singular_energy):
    """A cube of 4 x 4 x 4 unit cells with a column of the given energy density, frames along the axes."""
    axes = {f"axis_{name}": np.tile(np.eye(3, dtype="f4")[i], (len(CELLS), 1)) for i, name in enumerate("uvw")}
    write_vtu(path, {
        "Points": (CELLS[:, None] + CORNERS).reshape(-1, 3).astype("f8"),
        "connectivity": np.arange(8 * len(CELLS)),
        "types": np.full(len(CELLS), 11, "u1"),
        **axes,
        "energy_density": np.where(COLUMN, singular_energy, 0).astype("f4"),
        "is_boundary": ((CELLS == 0) | (CELLS == 3)).any(axis=1).astype("u1"),
    })


class Figures(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def picture(self, singular_energy):
        """The pixels of a picture of the cube, read back from the PNG file."""
        write_field(self.folder / "field.vtu", singular_energy)
        return self.pixels(render_field, "field.vtu", "--spacing", "0.1")

    def picture_of_a_line(self, last_end):
        """The same of a line along y through the middle of the cube."""
        write_vtu(self.folder / "lines.vtu", {
            "Points": np.array([[2, 0, 2], [2, 1.5, 2], [2, 3, 2]], "f8"),
            "offsets": np.array([3]),
            "first_end": np.array([0], "u1"),
            "last_end": np.array([last_end], "u1"),
        })
        return self.pixels(render_streamlines, "lines.vtu", "--width", "4")

    def pixels(self, renderer, file, *options):
        model, picture = self.folder / "cube.stl", self.folder / "cube.png"
        write_stl(model, CUBE)
        arguments = [renderer.__name__, str(self.folder / file), str(model), str(picture), "--size", "200", "100"]
        with mock.patch.object(sys, "argv", [*arguments, *options]):
            renderer.main()
        data = picture.read_bytes()
        start = data.index(b"IDAT")
        size = int.from_bytes(data[start - 4 : start], "big")
        rows = np.frombuffer(zlib.decompress(data[start + 4 : start + 4 + size]), np.uint8).reshape(100, -1)
        return rows[:, 1:].reshape(100, 200, 3).astype(int)

    def test_what_is_written_is_read_back(self):
        write_field(self.folder / "field.vtu", 1)
        field = field_file.Field(self.folder / "field.vtu")
        np.testing.assert_array_equal(field.low, CELLS)
        np.testing.assert_array_equal(field.frames, np.tile(np.eye(3), (len(CELLS), 1, 1)))
        np.testing.assert_array_equal(field.energy_density > 0, COLUMN)

    def test_a_point_is_found_in_its_cell_and_outside_in_none(self):
        write_field(self.folder / "field.vtu", 1)
        field = field_file.Field(self.folder / "field.vtu")
        np.testing.assert_array_equal(field.cells_at(CELLS + 0.3), np.arange(len(CELLS)))
        self.assertEqual(field.cells_at(np.array([[-0.5, 1, 1]]))[0], -1)

    def test_singular_cells_are_red_in_both_panels(self):
        def red(pixels):
            return (pixels[..., 0] - pixels[..., 1:].max(axis=-1) > 60).reshape(100, 2, 100).sum(axis=(0, 2))

        with_column, without = red(self.picture(1.0)), red(self.picture(0.0))
        self.assertEqual(without[1], 0)
        self.assertGreater(with_column[1], 20)
        # On the left the orange stubs of the normals count as red, too.
        self.assertGreater(with_column[0], without[0] + 20)

    def test_a_line_is_drawn_in_the_colour_of_its_direction_and_its_end_at_an_arc_as_a_ball(self):
        def like(pixels, colour):
            return (np.abs(pixels - 255 * np.array(colour)).max(axis=-1) < 90).sum()

        orange, red = render_streamlines.COLOURS[1], render_field.SINGULAR
        at_boundary, at_arc = self.picture_of_a_line(0), self.picture_of_a_line(1)
        self.assertGreater(like(at_boundary, orange), 40)
        self.assertGreater(like(at_arc, red), like(at_boundary, red) + 10)

    def test_a_cube_has_twelve_sharp_edges(self):
        self.assertEqual(len(part.sharp_edges(CUBE)), 12)

    def test_a_cut_in_the_middle_leaves_half_the_side_faces_and_a_square(self):
        pieces, _ = part.clipped(CUBE, np.array([0, 0, 1.0]), 2.0)
        areas = np.linalg.norm(np.cross(pieces[:, 1] - pieces[:, 0], pieces[:, 2] - pieces[:, 0]), axis=1) / 2
        self.assertAlmostEqual(areas.sum(), 16 + 4 * 8)
        segments = part.contour(CUBE, np.array([0, 0, 1.0]), 2.0)
        self.assertAlmostEqual(np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1).sum(), 16)

    def test_spread_points_keep_their_distance_and_leave_no_wide_gap(self):
        points, _ = part.spread_points(CUBE, 0.8)
        distances = np.linalg.norm(points[:, None] - points, axis=-1) + 1e9 * np.eye(len(points))
        self.assertGreaterEqual(distances.min(), 0.8)
        self.assertLess(distances.min(axis=1).max(), 1.6)


if __name__ == "__main__":
    unittest.main()

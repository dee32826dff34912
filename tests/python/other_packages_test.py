# SPDX-License-Identifier: Apache-2.0
"""The Python package beside meshio, VTK and tqdm; skipped where they are missing, unless CROSSGRAIN_ALL_PACKAGES is set."""

import contextlib
import importlib
import importlib.util
import io
import os
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import crossgrain as cg
import numpy as np
from solids import ball, box, cube_of_tets


def imported(test, name):
    try:
        return importlib.import_module(name)
    except ImportError:
        if os.environ.get("CROSSGRAIN_ALL_PACKAGES"):
            raise
        return test.skipTest(f"{name} is not installed")


class Meshio(unittest.TestCase):
    def setUp(self):
        self.meshio = imported(self, "meshio")
        temporary = tempfile.TemporaryDirectory(prefix="crossgrain-python-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def assert_like_the_file(self, mesh, name, **options):
        """A mesh in memory and the file of it give the same field."""
        mesh.write(self.folder / name, **options)
        read = self.meshio.read(self.folder / name)
        np.testing.assert_array_equal(cg.solve(read, resolution=8).quaternions, cg.solve(str(self.folder / name), resolution=8).quaternions)

    def test_surfaces_are_solved_as_they_are(self):
        vertices, triangles = ball(6)
        mesh = self.meshio.Mesh(vertices, [("triangle", triangles)])
        np.testing.assert_array_equal(cg.solve(mesh, resolution=8).quaternions, cg.solve(vertices, triangles, resolution=8).quaternions)
        self.assert_like_the_file(mesh, "ball.ply")

    def test_quads_are_cut(self):
        vertices, _ = box()
        quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
        field = cg.solve(self.meshio.Mesh(vertices, [("quad", np.array(quads))]), resolution=8)
        self.assertGreater(np.abs(field.frames).max(axis=-1).min(), 0.9999)

    def test_tets_with_tags_are_those_of_their_files(self):
        points, cells = cube_of_tets(4)
        left = points[cells].mean(axis=1)[:, 0] < 0.5
        inner = np.array([(i, i + 25, i + 5) for i in (2, 7)])  # in the plane x = 0.5
        for key in ("medit:ref", "gmsh:physical"):
            mesh = self.meshio.Mesh(points, [("tetra", cells), ("triangle", inner), ("line", np.array([(0, 1), (1, 2)]))], cell_data={
                key: [np.where(left, 1, 2), np.array([5, 5]), np.array([7, 7])]})
            with self.subTest(key=key):
                if key == "medit:ref":
                    self.assert_like_the_file(mesh, "cube.mesh")
                else:
                    mesh.cell_data["gmsh:geometrical"] = mesh.cell_data[key]
                    self.assert_like_the_file(mesh, "cube.msh", file_format="gmsh22", binary=False)

    def test_hexahedra_are_refused(self):
        with self.assertRaisesRegex(cg.InputError, "hexahedron"):
            cg.solve(self.meshio.Mesh(box()[0], [("hexahedron", [[0, 1, 3, 2, 4, 5, 7, 6]])]))
        with self.assertRaisesRegex(cg.InputError, "polygon"):
            cg.solve(self.meshio.Mesh(box()[0], [("triangle", box()[1][:10]), ("polygon", box()[1][10:])]))
        with self.assertRaisesRegex(cg.InputError, "no tets"):
            cg.solve_onto(self.meshio.Mesh(box()[0], [("triangle", box()[1])]))

    def test_fields_become_meshes(self):
        field = cg.solve(*box(), resolution=8)
        mesh = field.to_meshio()
        self.assertEqual(len(mesh.cells[0].data), len(field))
        np.testing.assert_allclose(mesh.points[mesh.cells[0].data].mean(axis=1), field.centers, atol=1e-12)
        mesh.write(self.folder / "field.vtu")
        tets = cg.solve_onto(*cube_of_tets(3)).to_meshio()
        tets.write(self.folder / "tets.vtu")
        written = self.meshio.read(self.folder / "tets.vtu").cells[0].data
        np.testing.assert_array_equal(np.sort(written, axis=1), np.sort(cube_of_tets(3)[1], axis=1))


class Vtk(unittest.TestCase):
    def setUp(self):
        imported(self, "vtkmodules.vtkCommonDataModel")
        self.to_numpy = imported(self, "vtkmodules.util.numpy_support").vtk_to_numpy

    def test_grids_have_the_cells_and_numbers_of_the_field(self):
        field = cg.solve(*ball(), resolution=64)
        self.assertGreater(len(np.unique(field.levels)), 1)
        grid = field.to_vtk()
        self.assertEqual(grid.GetNumberOfCells(), len(field))
        for i in range(0, len(field), 97):
            bounds = np.array(grid.GetCell(i).GetBounds()).reshape(3, 2)
            np.testing.assert_allclose(bounds.mean(axis=1), field.centers[i], atol=1e-12)
            np.testing.assert_allclose(bounds[:, 1] - bounds[:, 0], field.sizes[i], atol=1e-12)
        np.testing.assert_array_equal(self.to_numpy(grid.GetCellData().GetArray("axis_v")), field.frames[:, 1])
        self.assertLess(grid.GetNumberOfPoints(), 2 * len(field))

    def test_cells_have_their_volume(self):
        quality = imported(self, "vtkmodules.vtkFiltersVerdict")
        field, tets = cg.solve(*ball(6), resolution=10), cg.solve_onto(*cube_of_tets(3))
        for grid, expected in ((field.to_vtk(), field.sizes**3), (tets.to_vtk(), np.full(len(tets), 1 / 162))):
            measure = quality.vtkCellSizeFilter()
            measure.SetInputData(grid)
            measure.Update()
            np.testing.assert_allclose(self.to_numpy(measure.GetOutput().GetCellData().GetArray("Volume")), expected, rtol=1e-6)

    def test_lines_and_arcs_are_polylines(self):
        field = cg.solve(*ball(), resolution=20)
        arcs, lines = field.singularities.to_vtk(), field.streamlines(count=4).to_vtk()
        self.assertEqual(arcs.GetNumberOfLines(), len(field.singularities.arcs))
        self.assertEqual(arcs.GetCell(0).GetNumberOfPoints(), len(field.singularities.arcs[0].points))
        self.assertEqual(lines.GetCellData().GetArray("axis").GetNumberOfTuples(), lines.GetNumberOfLines())

    def test_data_are_taken_by_pyvista(self):
        pyvista = imported(self, "pyvista") if importlib.util.find_spec("pyvista") else self.skipTest("pyvista is not installed")
        self.assertEqual(pyvista.wrap(cg.solve(*box(), resolution=8).to_vtk()).n_cells, len(cg.solve(*box(), resolution=8)))


class FilesInOtherPackages(unittest.TestCase):
    """meshio and VTK open every kind of .vtu that is written, and find the same in it."""

    #: Types of the cells in VTK, and those that meshio has; it knows no polylines (4).
    TYPES = {"field.vtu": ([12], ["hexahedron"]), "surface.vtu": ([4, 5], ["triangle"]), "singularities.vtu": ([4], []),
             "streamlines.vtu": ([4], []), "onto.vtu": ([10], ["tetra"]),
             "hexahedra.vtu": ([12], ["hexahedron"]), "hexahedra_map.vtu": ([10], ["tetra"])}

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix="crossgrain-python-")
        cls.addClassCleanup(temporary.cleanup)
        folder = Path(temporary.name)
        field = cg.solve(*ball(), resolution=16)
        field.write(folder / "grid", page=False)
        for ending in ("vtu", "vtp"):
            field.streamlines(count=5).write(folder / "grid" / f"streamlines.{ending}")
        cg.hex(*cube_of_tets(4), size=0.25).write_folder(folder / "hex", page=False, formats=["map"])
        # The cube has no singular arcs, and meshio fails on a file without a cell.
        cls.paths = [path for path in folder.glob("*/*.vtu") if "singularities" not in path.name or path.parent.name == "grid"]

    def opened_by_vtk(self, path):
        reader = imported(self, "vtkmodules.vtkIOXML").vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(path))
        reader.Update()
        return reader.GetOutput()

    def test_every_kind_is_there(self):
        self.assertEqual({path.name for path in self.paths}, set(self.TYPES))

    def test_meshio_opens_them(self):
        meshio = imported(self, "meshio")
        for path in self.paths:
            with self.subTest(path.name), contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                mesh = meshio.read(path)
                self.assertGreater(len(mesh.points), 0)
                found = {block.type for block in mesh.cells}
                self.assertLessEqual(found, set(self.TYPES[path.name][1]))
                self.assertEqual(bool(found), bool(self.TYPES[path.name][1]))
                for block in mesh.cells:
                    self.assertLess(block.data.max(), len(mesh.points))

    def test_cells_of_a_field_are_cubes_in_meshio(self):
        meshio = imported(self, "meshio")
        mesh = meshio.read(next(path for path in self.paths if path.name == "field.vtu"))
        corners = mesh.points[mesh.cells[0].data]
        # The edges from corner 0 span the cube, right-handed.
        sides = corners[:, [1, 3, 4]] - corners[:, :1]
        sizes = np.cbrt(np.linalg.det(sides))
        np.testing.assert_allclose(sides, sizes[:, None, None] * np.eye(3), atol=1e-9)
        np.testing.assert_allclose(corners[:, 6] - corners[:, 0], sizes[:, None] * np.ones(3), atol=1e-9)

    def test_vtk_opens_streamlines_as_poly_data_too(self):
        to_numpy = imported(self, "vtkmodules.util.numpy_support").vtk_to_numpy
        path = next(path for path in self.paths if path.name == "streamlines.vtu")
        reader = imported(self, "vtkmodules.vtkIOXML").vtkXMLPolyDataReader()
        reader.SetFileName(str(path.with_suffix(".vtp")))
        reader.Update()
        lines, grid = reader.GetOutput(), self.opened_by_vtk(path)
        self.assertEqual(lines.GetNumberOfLines(), grid.GetNumberOfCells())
        for ours, theirs in ((lines.GetPointData(), grid.GetPointData()), (lines.GetCellData(), grid.GetCellData())):
            names = [ours.GetArrayName(i) for i in range(ours.GetNumberOfArrays())]
            self.assertEqual(names, [theirs.GetArrayName(i) for i in range(theirs.GetNumberOfArrays())])
            for name in names:
                np.testing.assert_array_equal(to_numpy(ours.GetArray(name)), to_numpy(theirs.GetArray(name)))
        for i in range(grid.GetNumberOfCells()):
            points = [to_numpy(data.GetCell(i).GetPoints().GetData()) for data in (lines, grid)]
            np.testing.assert_array_equal(*points)

    def test_vtk_opens_them(self):
        to_numpy = imported(self, "vtkmodules.util.numpy_support").vtk_to_numpy
        for path in self.paths:
            with self.subTest(path.name):
                grid = self.opened_by_vtk(path)
                self.assertGreater(grid.GetNumberOfCells(), 0)
                self.assertLessEqual({grid.GetCellType(i) for i in range(grid.GetNumberOfCells())}, set(self.TYPES[path.name][0]))
                if importlib.util.find_spec("meshio"):
                    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
                        points = imported(self, "meshio").read(path).points
                    np.testing.assert_array_equal(to_numpy(grid.GetPoints().GetData()), points)


class Tqdm(unittest.TestCase):
    def test_bar_shows_the_levels_if_it_is_asked_for(self):
        imported(self, "tqdm")
        from crossgrain import _progress
        _progress._DELAY_SECONDS = 0
        printed = io.StringIO()
        with contextlib.redirect_stderr(printed):
            cg.solve(*ball(), resolution=32, progress=True)
        self.assertIn("level", printed.getvalue())
        printed = io.StringIO()
        with contextlib.redirect_stderr(printed):
            cg.solve(*ball(), resolution=16)
            cg.solve(*ball(), resolution=16, progress=False)
        self.assertEqual(printed.getvalue(), "")


if __name__ == "__main__":
    unittest.main()

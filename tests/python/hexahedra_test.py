# SPDX-License-Identifier: Apache-2.0
"""Hexahedra by the Python package. What makes tets or needs other packages is skipped where these are missing."""

import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import crossgrain as cg
import numpy as np
from package_test import INTERRUPTED
from solids import ball_of_tets, box, cube_of_tets, medit_text, stl_bytes

CAD_FILES = os.environ.get("CROSSGRAIN_CAD_FILES", "")
needs_gmsh = unittest.skipUnless(shutil.which("gmsh"), "gmsh is not installed")

# Of every corner its three neighbours, right-handed.
NEIGHBOURS = np.array([(1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3)])


def scaled_jacobians(points, cells):
    corners = points[cells]
    edges = corners[:, NEIGHBOURS] - corners[:, :, None]
    return np.linalg.det(edges / np.linalg.norm(edges, axis=-1, keepdims=True)).min(axis=1)


def volume_within(points, faces):
    """The volume inside quadrilaterals that point outward."""
    a, b, c, d = (points[faces[:, k]] for k in range(4))
    return (np.linalg.det(np.stack([a, b, c], 1)) + np.linalg.det(np.stack([a, c, d], 1))).sum() / 6


class WithFolder(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="crossgrain-python-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)


class Hexahedra(WithFolder):
    @classmethod
    def setUpClass(cls):
        cls.cube = cg.hex(*cube_of_tets(3), size=0.25)
        cls.ball = cg.hex(*ball_of_tets(4), cells=6)

    def test_fill_a_cube(self):
        mesh = self.cube
        self.assertTrue(mesh.is_all_hex)
        self.assertEqual((mesh.outcome, mesh.reason, len(mesh)), ("all-hex", "", 64))
        self.assertEqual((mesh.points.shape, mesh.cells.shape, mesh.faces.shape, mesh.tags.shape), ((125, 3), (64, 8), (96, 4), (96,)))
        np.testing.assert_allclose(mesh.points * 4, np.rint(mesh.points * 4), atol=1e-6)
        self.assertIsNone(mesh.regions)
        self.assertIn("all-hex: 64 hexahedra, mean edge 0.25", str(mesh))
        self.assertEqual(mesh.report["hexahedra"]["hexahedra"], 64)
        self.assertEqual([attempt["kind"] for attempt in mesh.report["hexahedra"]["attempts"]], ["repair"])

    def test_have_the_quality_of_their_corners(self):
        np.testing.assert_allclose(self.ball.quality, scaled_jacobians(self.ball.points, self.ball.cells), atol=1e-12)
        self.assertAlmostEqual(self.ball.quality.min(), self.ball.report["hexahedra"]["scaled_jacobian"]["min"], 12)
        self.assertGreater(self.ball.quality.min(), 0)

    def test_lie_within_their_faces(self):
        self.assertAlmostEqual(volume_within(self.cube.points, self.cube.faces), 1, 9)
        self.assertAlmostEqual(volume_within(self.ball.points, self.ball.faces), self.ball.report["hexahedra"]["volume"], 2)

    def test_have_the_field_that_they_follow(self):
        field = self.ball.field
        self.assertIsInstance(field, cg.TetField)
        self.assertEqual(field.report["onto"]["repair"]["faults"], 0)
        self.assertEqual(field.report["hexahedra"], self.ball.report["hexahedra"])

    def test_give_arrays_that_are_read_only_and_outlive_them(self):
        mesh = cg.hex(*cube_of_tets(2), cells=2)
        arrays = [mesh.points, mesh.cells, mesh.quality, mesh.faces, mesh.tags]
        for array in arrays:
            self.assertFalse(array.flags.writeable)
        copies = [array.copy() for array in arrays]
        del mesh
        for array, copy in zip(arrays, copies):
            np.testing.assert_array_equal(array, copy)

    def test_are_written_by_extension(self):
        for ending in ("vtu", "mesh", "msh", "inp"):
            self.cube.write(self.folder / f"cube.{ending}")
            self.assertGreater((self.folder / f"cube.{ending}").stat().st_size, 1000)
        with self.assertRaisesRegex(cg.UsageError, "cube.stl"):
            self.cube.write(self.folder / "cube.stl")

    def test_are_written_with_their_field(self):
        report = self.cube.write_folder(self.folder / "cube.hexahedra", page=False)
        names = {path.name for path in (self.folder / "cube.hexahedra").iterdir()}
        self.assertLessEqual({"hexahedra.vtu", "hexahedra.inp", "onto.vtu", "report.json"}, names)
        self.assertEqual(report["hexahedra"]["outcome"], "all-hex")
        again = cg.read(self.folder / "cube.hexahedra")
        self.assertEqual(again.report["hexahedra"]["hexahedra"], 64)

    def test_are_written_with_their_map(self):
        self.cube.write_folder(self.folder / "cube.hexahedra", page=False, formats=["hexex", "map"])
        names = {path.name for path in (self.folder / "cube.hexahedra").iterdir()}
        self.assertLessEqual({"hexahedra.hexex", "hexahedra_seamless.hexex", "hexahedra_map.vtu"}, names)
        with self.assertRaisesRegex(cg.UsageError, "hexex"):
            self.cube.field.write(self.folder / "cube.field", page=False, formats=["hexex"])

    def test_keep_regions(self):
        points, cells = cube_of_tets(4)
        regions = 3 + (points[cells].mean(axis=1)[:, 0] > 0.5)
        mesh = cg.hex(cg.TetMesh(points, cells, regions=regions), size=0.25)
        middles = mesh.points[mesh.cells].mean(axis=1)
        np.testing.assert_array_equal(mesh.regions, 3 + (middles[:, 0] > 0.5))

    def test_follow_a_field_that_is_there(self):
        field = cg.solve_onto(*cube_of_tets(3), prepare=True)
        mesh = field.hexahedra(size=0.25)
        np.testing.assert_array_equal(mesh.points, self.cube.points)
        np.testing.assert_array_equal(mesh.cells, self.cube.cells)
        self.assertEqual(len(field.hexahedra(cells=3)), 27)

    def test_do_not_depend_on_threads(self):
        one, four = (cg.hex(*ball_of_tets(4), cells=6, threads=threads) for threads in (1, 4))
        np.testing.assert_array_equal(one.points, four.points)
        np.testing.assert_array_equal(one.cells, four.cells)

    def test_of_a_file_are_those_of_the_program(self):
        program = os.environ.get("CROSSGRAIN_PROGRAM")
        if not program:
            self.skipTest("CROSSGRAIN_PROGRAM is not set")
        path = self.folder / "ball.mesh"
        path.write_text(medit_text(*ball_of_tets(4)))
        mesh = cg.hex(path, cells=6)
        mesh.write(self.folder / "mine.mesh")
        subprocess.run([program, "hex", path, "--cells", "6", "-o", self.folder / "out", "--quiet", "--no-report", "--accept", "approximate"], check=True)
        # Only files in a folder name their solve.
        lines = [[line for line in file.read_text().splitlines() if not line.startswith("# solve")]
                 for file in (self.folder / "mine.mesh", self.folder / "out" / "hexahedra.mesh")]
        self.assertEqual(*lines)

    def test_become_meshes_of_other_packages(self):
        if importlib.util.find_spec("meshio"):
            mesh = self.cube.to_meshio()
            self.assertEqual([(block.type, len(block.data)) for block in mesh.cells], [("hexahedron", 64), ("quad", 96)])
            np.testing.assert_array_equal(mesh.cell_data["scaled_jacobian"][0], self.cube.quality)
        if importlib.util.find_spec("vtkmodules"):
            self.assertEqual(self.cube.to_vtk().GetNumberOfCells(), 64)


class HexahedraOfOtherMeshers(WithFolder):
    def setUp(self):
        super().setUp()
        places = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
        number = np.arange(5 * 3 * 4).reshape(5, 3, 4)
        self.points = np.stack(np.meshgrid(*[np.arange(n) / 2 for n in (5, 3, 4)], indexing="ij"), axis=-1).reshape(-1, 3) * 0.94 + 0.03
        self.cells = np.array([number[tuple((places + place).T)] for place in np.ndindex(4, 2, 3)])
        vertices, triangles = box()
        self.model = self.folder / "box.obj"
        self.model.write_text("".join("v %r %r %r\n" % tuple(map(float, v)) for v in vertices)
                              + "".join("f %d %d %d\n" % tuple(t + 1) for t in np.asarray(triangles)))

    def test_are_put_onto_a_part_and_keep_their_order(self):
        mesh = cg.fit((self.points, self.cells), self.model, threads=1)
        self.assertTrue(mesh.is_all_hex, str(mesh))
        np.testing.assert_array_equal(mesh.cells, self.cells)
        self.assertAlmostEqual(volume_within(mesh.points, mesh.faces), 3, 9)
        kept = mesh.features
        self.assertEqual((kept["corners"], kept["creases"]), ({"all": 8, "kept": 8}, {"all": 12, "kept": 12}))
        with self.assertRaisesRegex(cg.UsageError, "follow no field"):
            mesh.field  # pylint: disable=pointless-statement

    def test_are_the_same_from_arrays_files_folders_and_meshio(self):
        mesh = cg.fit((self.points, self.cells), self.model)
        mesh.write_folder(self.folder / "fitted")
        self.assertTrue((self.folder / "fitted" / "report.html").exists())
        self.assertFalse((self.folder / "fitted" / "onto.vtu").exists())
        meshes = [self.folder / "fitted", self.folder / "fitted" / "hexahedra.inp", mesh]
        if importlib.util.find_spec("meshio"):
            meshes.append(mesh.to_meshio())
        for given in meshes:
            np.testing.assert_allclose(cg.fit(given, self.model).points, mesh.points, atol=1e-12)

    def test_that_are_none_are_refused(self):
        with self.assertRaisesRegex(TypeError, r"cells: an array \(m, 8\) of whole numbers is needed"):
            cg.fit((self.points, self.cells[:, :4]), self.model)
        with self.assertRaisesRegex(TypeError, "corners that are none of the 60 points"):
            cg.fit((self.points, self.cells + 1), self.model)
        with self.assertRaisesRegex(TypeError, "a file of hexahedra, points and cells"):
            cg.fit(3, self.model)
        with self.assertRaisesRegex(cg.InputError, "give both in the same unit and place"):
            cg.fit((1000 * self.points, self.cells), self.model)


@needs_gmsh
class HexahedraOfModels(WithFolder):
    def test_fill_a_box_of_triangles_and_know_its_faces(self):
        mesh = cg.hex(*box(), size=0.5)
        self.assertEqual(len(mesh), 4 * 2 * 3)
        self.assertAlmostEqual(volume_within(mesh.points, mesh.faces), 3, 9)
        self.assertEqual(sorted(np.bincount(mesh.tags)), [0, 6, 6, 8, 8, 12, 12])
        for tag in range(1, 7):
            self.assertEqual((np.ptp(mesh.points[mesh.faces[mesh.tags == tag]].reshape(-1, 3), axis=0) < 1e-9).sum(), 1)
        tets, repair = mesh.report["hexahedra"]["attempts"]
        self.assertEqual((tets["kind"], repair["kind"], repair["outcome"]), ("tets", "repair", "all-hex"))
        self.assertAlmostEqual(tets["tet_size"], 1.4 * 2 / 20)

    def test_are_the_same_from_files_and_arrays_and_surfaces(self):
        vertices, triangles = box()
        path = self.folder / "box.stl"
        path.write_bytes(stl_bytes(vertices, triangles))
        meshes = [cg.hex(model, tet_size=0.3, cells=4) for model in (path, cg.read_surface(path))]
        for mesh in meshes:
            np.testing.assert_array_equal(mesh.points, meshes[0].points)
            np.testing.assert_array_equal(mesh.cells, meshes[0].cells)
        self.assertEqual(len(cg.hex(vertices, triangles, tet_size=0.3, cells=4)), len(meshes[0]))

    @unittest.skipUnless(CAD_FILES, "CROSSGRAIN_CAD_FILES is not set")
    def test_fill_a_part_in_a_step_file(self):
        subprocess.run([CAD_FILES, self.folder], check=True, stdout=subprocess.DEVNULL)
        mesh = cg.hex(self.folder / "cylinder.step", cells=8, tet_size=3)
        self.assertIn(mesh.outcome, ("all-hex", "approximate"))
        self.assertEqual((set(mesh.tags), mesh.unit), ({1, 2, 3}, "mm"))

    def test_have_the_unit_that_the_caller_names(self):
        points, cells = cube_of_tets(3)
        self.assertEqual(cg.hex(cg.TetMesh(points, cells, unit="m"), cells=4).unit, "m")
        path = self.folder / "cube.mesh"
        path.write_text(medit_text(points, cells))
        options = cg.HexMeshingOptions(tets=cg.TetMakingOptions(unit="inch"))
        self.assertEqual(cg.hex(path, cells=4, options=options).unit, "inch")
        self.assertEqual(cg.read_tets(path, unit="um").boundary.unit, "um")
        surface = self.folder / "box.stl"
        surface.write_bytes(stl_bytes(*box()))
        self.assertEqual(cg.read_surface(surface, cg.ReadOptions(unit="cm")).unit, "cm")
        self.assertEqual(cg.Surface(*box(), unit="mm").unit, "mm")
        with self.assertRaisesRegex(cg.UsageError, "unit takes one of none, um"):
            cg.read_surface(surface, cg.ReadOptions(unit="yard"))

    def test_larger_than_the_model_are_refused_with_its_size(self):
        with self.assertRaisesRegex(cg.UsageError, "hexahedra of 1000 are too large for the part, which is 1 across"):
            cg.hex(*cube_of_tets(3), size=1000)

    def test_are_a_lattice_where_that_is_asked_for(self):
        points, triangles = box()
        mesh = cg.hex(points, triangles, cells=4, lattice=True)
        self.assertTrue(mesh.is_all_hex)
        self.assertEqual(len(mesh.cells), len(mesh.quality))
        self.assertIn("by a lattice", str(mesh))
        with self.assertRaises(cg.UsageError):
            mesh.field  # pylint: disable=pointless-statement

    def test_that_do_not_fill_the_model_say_why(self):
        angles = 2 * np.pi / 5 * np.arange(5)
        points = np.vstack([[[0, 0, 1.5], [0, 0, 0]], np.c_[np.cos(angles), np.sin(angles), 0 * angles]])
        mesh = cg.hex(points, [[0, 1, 2 + k, 2 + (k + 1) % 5] for k in range(5)],
                      options=cg.HexMeshingOptions(hexahedra=cg.HexOptions(cells=3, preference="map_only")))
        self.assertFalse(mesh.is_all_hex)
        self.assertTrue(mesh.reason)
        self.assertIn(mesh.report["hexahedra"]["reason"], str(mesh))


class Failures(WithFolder):
    def test_of_arguments_say_what_is_wrong(self):
        points, cells = cube_of_tets(2)
        for kind, wrong in ((cg.UsageError, dict(size=1, cells=3)), (cg.UsageError, dict(size=-1)), (cg.UsageError, dict(cells=0)),
                            (cg.UsageError, dict(size="x")), (TypeError, dict(options=cg.SolveOptions()))):
            with self.subTest(wrong=wrong), self.assertRaises(kind):
                cg.hex(points, cells, **wrong)
        with self.assertRaisesRegex(TypeError, r"\(m, 3\) or tets \(m, 4\)"):
            cg.hex(points, [[0, 1]])
        with self.assertRaises(TypeError):
            cg.solve_onto(points, cells).hexahedra(no_option=1)

    def test_name_the_file(self):
        with self.assertRaisesRegex(cg.InputError, "none.step"):
            cg.hex(self.folder / "none.step")

    @needs_gmsh
    def test_of_a_sheet_say_that_it_encloses_nothing(self):
        vertices, triangles = box()
        with self.assertRaisesRegex(cg.InputError, "encloses nothing"):
            cg.hex(vertices, triangles[:2])

    def test_of_listeners_cancel_and_are_raised(self):
        heard = []

        def stop(progress):
            heard.append(progress.phase)
            if progress.phase == "hexahedra":
                raise LookupError
        with self.assertRaises(LookupError):
            cg.hex(*ball_of_tets(4), cells=6, progress=stop)
        self.assertLessEqual({"solve", "tets", "repair"}, set(heard))

    def test_by_ctrl_c_come_soon(self):
        for after in (0.3, 1.5):
            code = INTERRUPTED.format(tests=str(Path(__file__).parent), before="from solids import ball_of_tets", after=after,
                                      work="cg.hex(*ball_of_tets(24), cells=40)")
            result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=100, check=False)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertNotEqual(result.stdout, "finished\n")
            self.assertLess(float(result.stdout), 5)


if __name__ == "__main__":
    unittest.main()

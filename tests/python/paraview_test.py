# SPDX-License-Identifier: Apache-2.0
"""In ParaView's Python: the package works beside it, and ParaView opens one file of each kind that a field has."""

import os
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import crossgrain as cg
import numpy as np
from solids import ball, box, cube_of_tets

try:
    from paraview import servermanager
    from paraview.simple import OpenDataFile, TrivialProducer
except ImportError:
    if os.environ.get("CROSSGRAIN_ALL_PACKAGES"):
        raise
    OpenDataFile = None

LINE, TRIANGLE, TET, CUBE = 4, 5, 10, 12


def opened(path):
    reader = OpenDataFile(str(path))
    reader.UpdatePipeline()
    return servermanager.Fetch(reader)


def types_in(grid):
    return sorted({grid.GetCellType(i) for i in range(grid.GetNumberOfCells())})


@unittest.skipUnless(OpenDataFile, "ParaView is not installed")
class ParaView(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="crossgrain-python-")
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)

    def test_opens_the_files_of_a_field_on_a_grid(self):
        field = cg.solve(*ball(), resolution=24)
        field.write(self.folder / "field", page=False)
        field.streamlines(count=5).write(self.folder / "field" / "streamlines.vtu")
        kinds = {"field.vtu": [CUBE], "surface.vtu": [TRIANGLE], "singularities.vtu": [LINE], "streamlines.vtu": [LINE]}
        self.assertEqual({path.name for path in (self.folder / "field").glob("*.vtu")}, set(kinds))
        for name, types in kinds.items():
            self.assertEqual(types_in(opened(self.folder / "field" / name)), types, name)
        grid = opened(self.folder / "field" / "field.vtu")
        self.assertEqual(grid.GetNumberOfCells(), len(field))
        axes = grid.GetCellData().GetArray("axis_u")
        np.testing.assert_allclose([axes.GetTuple(i) for i in range(0, len(field), 97)], field.frames[::97, 0], atol=1e-6)
        self.assertEqual(opened(self.folder / "field" / "singularities.vtu").GetNumberOfCells(), len(field.singularities.arcs))

    def test_opens_the_files_of_a_field_on_tets(self):
        field = cg.solve_onto(*cube_of_tets(4))
        field.write(self.folder / "field", page=False, formats=["features"])
        found = {path.name for path in (self.folder / "field").glob("*.vtu")}
        self.assertLessEqual({"field.vtu", "surface.vtu", "onto.vtu", "singularities.vtu", "onto_singularities.vtu"}, found)
        for name in found:
            opened(self.folder / "field" / name)
        onto = opened(self.folder / "field" / "onto.vtu")
        self.assertEqual((onto.GetNumberOfCells(), types_in(onto)), (len(field), [TET]))

    def test_takes_fields_in_memory(self):
        field = cg.solve(*box(), resolution=8)
        producer = TrivialProducer()
        producer.GetClientSideObject().SetOutput(field.to_vtk())
        producer.UpdatePipeline()
        self.assertEqual(servermanager.Fetch(producer).GetNumberOfCells(), len(field))


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: Apache-2.0
"""Opens files as ParaView does and prints, as JSON, what it finds in each. Run by pvpython: open_files.py FILE..."""

import json
import sys

from paraview import servermanager
from paraview.simple import OpenDataFile


def arrays_of(data):
    return {array.GetName(): list(array.GetRange(-1)) for array in map(data.GetArray, range(data.GetNumberOfArrays()))}


def found_in(path):
    reader = OpenDataFile(path)
    reader.UpdatePipeline()
    grid = servermanager.Fetch(reader)
    lengths = sum(bounds[1] - bounds[0] for bounds in [grid.GetBounds()[k:k + 2] for k in (0, 2, 4)])
    return {"class": grid.GetClassName(), "cells": grid.GetNumberOfCells(), "points": grid.GetNumberOfPoints(),
            "extent": lengths, "cell_arrays": arrays_of(grid.GetCellData()), "point_arrays": arrays_of(grid.GetPointData()),
            "types": sorted({grid.GetCellType(i) for i in range(grid.GetNumberOfCells())})}


print(json.dumps({path: found_in(path) for path in sys.argv[1:]}))

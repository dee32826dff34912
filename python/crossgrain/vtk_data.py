# SPDX-License-Identifier: Apache-2.0
"""Objects of VTK. Needs the package vtk, or a ParaView that has its modules."""

from __future__ import annotations

from typing import Any, Dict, Sequence, Tuple

import numpy as np

_VTK_TYPES = {"hexahedron": 12, "tetra": 10}


def _to_vtk(array: np.ndarray, name: str = "") -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtk  # type: ignore[import]
    # VTK knows no bool and keeps no reference to arrays of others that are strided.
    plain = np.ascontiguousarray(array.view(np.uint8) if array.dtype == np.bool_ else array)
    result = numpy_to_vtk(plain, deep=True)
    result.SetName(name)
    return result


def _points(points: np.ndarray) -> Any:
    from vtkmodules.vtkCommonCore import vtkPoints  # type: ignore[import]
    result = vtkPoints()
    result.SetData(_to_vtk(points))
    return result


def _cells(offsets: np.ndarray, connectivity: np.ndarray) -> Any:
    from vtkmodules.util.numpy_support import numpy_to_vtkIdTypeArray  # type: ignore[import]
    from vtkmodules.vtkCommonDataModel import vtkCellArray  # type: ignore[import]
    result = vtkCellArray()
    result.SetData(numpy_to_vtkIdTypeArray(offsets.astype(np.int64), deep=True),
                   numpy_to_vtkIdTypeArray(np.ascontiguousarray(connectivity).ravel().astype(np.int64),
                                           deep=True))
    return result


def _add(data: Any, arrays: Dict[str, np.ndarray]) -> None:
    for name, values in arrays.items():
        data.AddArray(_to_vtk(values, name))


def grid_of(parts: Tuple[np.ndarray, str, np.ndarray], cell_data: Dict[str, np.ndarray],
            point_data: Dict[str, np.ndarray]) -> Any:
    """A vtkUnstructuredGrid."""
    from vtkmodules.vtkCommonDataModel import vtkUnstructuredGrid  # type: ignore[import]
    points, shape, cells = parts
    grid = vtkUnstructuredGrid()
    grid.SetPoints(_points(points))
    grid.SetCells(_VTK_TYPES[shape], _cells(np.arange(len(cells) + 1) * cells.shape[1], cells))
    _add(grid.GetCellData(), cell_data)
    _add(grid.GetPointData(), point_data)
    return grid


def polydata_of(curves: Sequence[np.ndarray], cell_data: Dict[str, np.ndarray]) -> Any:
    """A vtkPolyData with a polyline per curve."""
    from vtkmodules.vtkCommonDataModel import vtkPolyData  # type: ignore[import]
    result = vtkPolyData()
    points = np.concatenate(curves) if curves else np.zeros((0, 3))
    result.SetPoints(_points(points))
    offsets = np.cumsum([0] + [len(curve) for curve in curves])
    result.SetLines(_cells(offsets, np.arange(len(points))))
    _add(result.GetCellData(), cell_data)
    return result

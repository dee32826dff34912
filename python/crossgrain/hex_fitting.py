# SPDX-License-Identifier: Apache-2.0
"""Hexahedra of other meshers, put onto a model."""

from __future__ import annotations

from typing import Any, Optional, Tuple

import numpy as np

from ._arrays import address
from ._library import made, path_bytes
from ._options import handle_of, unless_none, with_changes
from ._progress import ProgressOption, listener
from ._watched import watched
from .models import is_path
from .options import HexFitOptions
from .tet_field import HexMesh


def _arrays_of(mesh: Any) -> Tuple[np.ndarray, np.ndarray]:
    """Points and hexahedra of a mesh in memory."""
    if isinstance(mesh, HexMesh):
        points, cells = mesh.points, mesh.cells
    elif isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        points, cells = mesh
    elif hasattr(mesh, "get_cells_type"):
        points, cells = mesh.points, mesh.get_cells_type("hexahedron")
    else:
        raise TypeError("a file of hexahedra, points and cells, a HexMesh or a mesh of meshio is needed, not "
                        f"{type(mesh).__name__}")
    points, indices = np.ascontiguousarray(points, np.float64), np.asarray(cells)
    if points.ndim != 2 or points.shape[1] != 3:
        raise TypeError(f"points: an array (n, 3) is needed, not one of shape {points.shape}")
    if indices.ndim != 2 or indices.shape[1] != 8 or indices.dtype.kind not in "iu":
        raise TypeError("cells: an array (m, 8) of whole numbers is needed, not one of shape "
                        f"{indices.shape} of {indices.dtype}")
    if indices.size and (indices.min() < 0 or indices.max() >= len(points)):
        raise TypeError(f"cells: they have corners that are none of the {len(points)} points")
    return points, np.ascontiguousarray(indices, np.uint32)


def fit(mesh: Any, model: Any, *, crease_angle_deg: Optional[float] = None, threads: Optional[int] = None,
        max_memory_bytes: Optional[int] = None, options: Optional[HexFitOptions] = None,
        progress: ProgressOption = None) -> HexMesh:
    """Puts hexahedra of any mesher, which roughly fill a model, onto its corners, creases and faces.

    The mesh is a file (Medit, Gmsh, VTK, Abaqus), the folder of a result, a pair of points (n, 3) and cells
    (m, 8) in the order of VTK, a `HexMesh`, or a mesh of meshio. The model is a file: STEP, IGES, BREP,
    FCStd; a closed surface in STL, OBJ, PLY, OFF, 3MF; or tets in Medit, Gmsh, VTK.

    crease_angle_deg:
        smallest angle between normals that makes an edge a crease
    threads, max_memory_bytes:
        as for `solve`
    options:
        all other options; those above replace its members
    progress:
        as for `solve`

    A mesh that lacks features or does not fill the model is returned too, as by `hex`; ``field`` of the
    result raises UsageError, since there is none. Ctrl-C cancels. Experimental: may change from release to
    release.

    Raises InputError for files that cannot be used, for hexahedra whose boundary is no closed surface, and
    for those that are elsewhere than the model or in another unit; UsageError, LimitError, TypeError.
    """
    changes = unless_none(crease_angle_deg=crease_angle_deg, threads=threads,
                          max_memory_bytes=max_memory_bytes)
    handle = handle_of(with_changes(options, HexFitOptions, changes))
    path = path_bytes(model)
    what: Tuple[Any, ...]
    if is_path(mesh):
        name, what = "hexahedra_fit", (path_bytes(mesh),)
    else:
        points, cells = _arrays_of(mesh)
        name, what = "hexahedra_fit_arrays", (address(points), len(points), address(cells), len(cells))
    with listener(progress) as hear:
        fitted = watched(lambda monitor: made("hexahedra", name, *what, path, handle, monitor.handle), hear)
    return HexMesh(fitted, path.decode("utf-8", "surrogateescape"))

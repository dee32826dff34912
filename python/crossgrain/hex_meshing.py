# SPDX-License-Identifier: Apache-2.0
"""From a model to hexahedra."""

from __future__ import annotations

import dataclasses
from typing import Any, Optional

import numpy as np

from ._library import made, path_bytes
from ._options import solve_handle, unless_none, with_changes
from ._progress import ProgressOption, listener
from ._watched import watched
from .errors import naming
from .models import TetMesh, is_of_tets, is_path, surface_of, tets_of
from .options import HexMeshingOptions
from .tet_field import HexMesh, sized


def _chosen(options: Optional[HexMeshingOptions], size: Optional[float], cells: Optional[float],
            tet_size: Optional[float], max_memory_bytes: Optional[int], **of_solve: Any) -> HexMeshingOptions:
    chosen = with_changes(options, HexMeshingOptions, {})
    memory = unless_none(max_memory_bytes=max_memory_bytes)
    return dataclasses.replace(chosen, hexahedra=sized(chosen.hexahedra, size, cells),
                               tets=dataclasses.replace(chosen.tets, **unless_none(size=tet_size), **memory),
                               solve=dataclasses.replace(chosen.solve, **unless_none(**of_solve), **memory))


def _is_tets(model: Any, elements: Any) -> bool:
    if elements is None:
        return is_of_tets(model)
    shape = np.shape(elements)
    if len(shape) != 2 or shape[1] not in (3, 4):
        raise TypeError("elements: triangles (m, 3) or tets (m, 4) are needed, not an array of shape "
                        f"{shape}")
    return shape[1] == 4


def hex(model: Any, elements: Any = None, *,  # pylint: disable=redefined-builtin
        size: Optional[float] = None, cells: Optional[float] = None, tet_size: Optional[float] = None,
        lattice: bool = False, seed: Optional[int] = None, threads: Optional[int] = None,
        max_memory_bytes: Optional[int] = None,
        options: Optional[HexMeshingOptions] = None, progress: ProgressOption = None) -> HexMesh:
    """Meshes a solid with hexahedra that follow a field: cuts it into tets, solves on them and repairs the
    field, maps it to the unit grid and pulls its cells back (docs/hexahedra.md). Where that does not fill the
    model, or does not keep its features, tets of other sizes are tried, and a lattice is put onto the model.

    The model is a file (STEP, IGES, BREP, FCStd; STL, OBJ, PLY, OFF, 3MF; tets in Medit, Gmsh, VTK), two
    arrays (points (n, 3), and triangles (m, 3) or tets (m, 4)), a mesh of meshio or trimesh, a `Surface` or a
    `TetMesh`. Holes of surfaces are filled, and parts that overlap united; tets are made by gmsh or
    Netgen, and a lattice where they make none.

    size:
        edge of the hexahedra, in model units
    cells:
        number of hexahedra along the longest side instead, 20 by default
    tet_size:
        largest edge of the tets that are made; by default that of the hexahedra, at most 1/20 of the longest
        side
    lattice:
        make only a lattice, put onto the model: in seconds, without tets, field and map; ``field`` of the
        result raises UsageError. `HexOptions.preference` tells when one is made otherwise. Arrays must be
        triangles
    seed, threads, max_memory_bytes:
        of the solve, as for `solve`; the memory is that of all steps
    options:
        all other options; those above replace its members
    progress:
        as for `solve`

    A mesh that does not fill the model is returned too: ``is_all_hex`` is False then, and ``print(mesh)``
    says why. The result does not depend on the number of threads. Ctrl-C cancels. Experimental: may change
    from release to release.

    Raises InputError for a model that cannot be used or cut into tets, UsageError for options out of range,
    LimitError, TypeError.
    """
    chosen = _chosen(options, size, cells, tet_size, max_memory_bytes, seed=seed, threads=threads)
    handle = solve_handle(chosen, None, HexMeshingOptions)
    path, read_seconds = "", 0.0
    if elements is None and is_path(model):
        what: Any = path_bytes(model)
        name, path = "hexahedra_make", path_bytes(model).decode("utf-8", "surrogateescape")
    elif not lattice and _is_tets(model, elements):
        has_elements = elements is not None
        given = TetMesh(model, elements, tags_options=chosen.tags) if has_elements else tets_of(model, None)
        what, name = given._handle, "hexahedra_make_in_tets"
        path, read_seconds = given.path, given.read_seconds
    else:
        surface = surface_of(model, elements, lambda: None)
        what, name = surface._handle, "hexahedra_make_inside"
        path, read_seconds = surface.path, surface.read_seconds
    if lattice:
        name = name.replace("make", "lattice")
    with listener(progress) as hear, naming(path):
        mesh = watched(lambda monitor: made("hexahedra", name, what, handle, monitor.handle), hear)
    return HexMesh(mesh, path, read_seconds)

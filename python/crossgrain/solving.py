# SPDX-License-Identifier: Apache-2.0
"""Solving for fields, and reading them."""

from __future__ import annotations

import ctypes
from typing import Any, Optional, Union

from ._library import call, handle_in, made, path_bytes
from ._options import solve_handle, unless_none, with_changes
from ._arrays import integer
from ._progress import ProgressOption, listener
from ._watched import watched
from .constraints import constraints_of
from .errors import UsageError, naming
from .field import Field
from .models import TetMesh, is_of_tets, reading_for, surface_of, tets_of
from .options import MapPreparationOptions, ReadOptions, RepairOptions, SolveOptions
from .tet_field import TetField

Preparation = Union[bool, MapPreparationOptions]
Repair = Union[bool, RepairOptions]


def _prepared(mesh: TetMesh, prepare: Preparation, options: SolveOptions) -> TetMesh:
    if not prepare:
        return mesh
    chosen = MapPreparationOptions(unite_solids=options.unite_solids) if prepare is True else prepare
    return mesh.prepared_for_map(chosen)


def _repaired(field: TetField, repair: Repair, options: SolveOptions) -> TetField:
    if not repair:
        return field
    return field.repaired(options=None if repair is True else repair, threads=options.threads)


def solve(model: Any, triangles: Any = None, *, resolution: Optional[int] = None,
          cell_size: Optional[float] = None, degree: Optional[int] = None, seed: Optional[int] = None,
          threads: Optional[int] = None, max_memory_bytes: Optional[int] = None, constraints: Any = None,
          start: Optional[Field] = None, options: Optional[SolveOptions] = None,
          read_options: Optional[ReadOptions] = None, prepare: Preparation = False, repair: Repair = False,
          progress: ProgressOption = None) -> Union[Field, TetField]:
    """Returns the octahedral frame field inside a solid: smooth, with an axis along the normal of the surface
    (arXiv 2309.13477).

    The model is a file (STL, OBJ, PLY, OFF, 3MF; STEP, IGES, BREP, FCStd), two arrays (vertices (n, 3) and
    triangles (m, 3)), a mesh of meshio or trimesh, or a `Surface`. A model of tets (Medit, Gmsh, VTK, meshio,
    `TetMesh`) is solved as by `solve_onto`.

    resolution:
        cells along the longest side of the bounding box at the finest level, 128 by default
    cell_size:
        size of the finest cells in model units, in place of a resolution
    degree:
        degree of the spherical harmonics, 4 (the default) or 3
    constraints:
        `Constraints`, or a JSON file of them
    start:
        an earlier field, of this or another surface, to start from instead of random frames
    options:
        all other options; those above replace its members
    read_options:
        how a CAD file is read and triangulated; the cells of the solve are known already
    prepare, repair:
        of tets: whether to split them for a map first (`TetMesh.prepared_for_map`), and to repair the field
        (`TetField.repaired`); True, or options for it
    progress:
        a function that is called with a `Progress` on this thread, and may raise to cancel; True for a bar
        (where tqdm is installed), False for none; by default a bar in terminals and notebooks

    The result depends only on the model and the options, bit for bit, not on the number of threads. Other
    threads of Python run meanwhile, solves too. Ctrl-C cancels the solve.

    Raises InputError for a model or constraints that cannot be used, UsageError for options out of range,
    LimitError if the memory does not suffice, TypeError for arrays of another shape or type.
    """
    if triangles is None and is_of_tets(model):
        if read_options is not None:
            raise UsageError("options of reading are for surfaces and CAD files")
        if start is not None:
            raise UsageError("a solve on tets has no start; solve for a field from the start, and carry that "
                             "onto the tets (carry_onto)")
        return solve_onto(model, resolution=resolution, cell_size=cell_size, degree=degree, seed=seed,
                          threads=threads, max_memory_bytes=max_memory_bytes, constraints=constraints,
                          options=options, prepare=prepare, repair=repair, progress=progress)
    if prepare or repair:
        raise UsageError("tets are prepared and fields on tets repaired; carry the field onto tets "
                         "(carry_onto)")
    chosen = with_changes(options, SolveOptions, unless_none(resolution=resolution, cell_size=cell_size,
                                                             degree=degree, seed=seed, threads=threads,
                                                             max_memory_bytes=max_memory_bytes))
    handle = solve_handle(chosen, constraints_of(constraints))
    earlier = handle_in(start, Field, "start")
    surface = surface_of(model, triangles, lambda: reading_for(handle, read_options))
    with listener(progress) as hear, naming(surface.path):
        field = watched(lambda monitor: made("field", "solve", surface._handle, earlier, handle,
                                             monitor.handle), hear)
    return Field(field, surface.path, surface.read_seconds)


def solve_onto(model: Any, cells: Any = None, *, resolution: Optional[int] = None,
               cell_size: Optional[float] = None, degree: Optional[int] = None, seed: Optional[int] = None,
               threads: Optional[int] = None, max_memory_bytes: Optional[int] = None, constraints: Any = None,
               options: Optional[SolveOptions] = None, prepare: Preparation = False, repair: Repair = False,
               progress: ProgressOption = None) -> TetField:
    """Solves inside the boundary of a tet mesh and transfers the field to its vertices and tets, where it is
    finished (docs/solver.md).

    The model is a file (Medit, Gmsh, VTK), two arrays (points (n, 3) and cells (m, 4)), a mesh of meshio, or
    a `TetMesh`. Without a resolution or cell size, the cells of the grid suit the edges of the tets. All else
    is as for `solve`.
    """
    chosen = with_changes(options, SolveOptions, unless_none(resolution=resolution, cell_size=cell_size,
                                                             degree=degree, seed=seed, threads=threads,
                                                             max_memory_bytes=max_memory_bytes))
    handle = solve_handle(chosen, constraints_of(constraints))
    mesh = tets_of(model, cells, chosen.max_memory_bytes)
    with listener(progress) as hear, naming(mesh.path):
        mesh = _prepared(mesh, prepare, chosen)
        field = watched(lambda monitor: made("tet_field", "solve_onto", mesh._handle, handle, monitor.handle),
                        hear)
        return _repaired(TetField(field, mesh.path, mesh.read_seconds), repair, chosen)


def carry_onto(field: Field, model: Any, cells: Any = None, *, threads: Optional[int] = None,
               options: Optional[SolveOptions] = None, prepare: Preparation = False, repair: Repair = False,
               progress: ProgressOption = None) -> TetField:
    """Transfers a field to the vertices and tets of a mesh, given as for `solve_onto`, and finishes it
    there."""
    its_field = handle_in(field, Field, "field")
    if its_field is None:
        raise TypeError("field: a Field is needed, not None")
    chosen = with_changes(options, SolveOptions, unless_none(threads=threads))
    handle = solve_handle(chosen, None)
    mesh = tets_of(model, cells)
    with listener(progress) as hear, naming(mesh.path):
        mesh = _prepared(mesh, prepare, chosen)
        carried = watched(lambda monitor: made("tet_field", "carry_onto", its_field, mesh._handle, handle,
                                               monitor.handle), hear)
        return _repaired(TetField(carried, *field._model), repair, chosen)


def read(folder: Any, *, max_memory_bytes: int = 0) -> Union[Field, TetField]:
    """Reads the field in a folder that `Field.write` or the program has written: on tets if it has them, with
    the field on the grid in ``grid``. Raises InputError."""
    encoded, limit = path_bytes(folder), integer(max_memory_bytes, "max_memory_bytes", 0, 2**63 - 1)
    on_tets = watched(lambda monitor: made("tet_field", "tet_field_read", encoded, limit, monitor.handle))
    if on_tets.address:
        return TetField(on_tets)
    return Field(watched(lambda monitor: made("field", "field_read", encoded, limit, monitor.handle)))


def is_clipped(folder: Any) -> bool:
    """Whether the field in a folder was written with a box, and so lacks cells: nothing to start a solve
    from."""
    out = ctypes.c_int()
    call("is_clipped_field", path_bytes(folder), ctypes.byref(out))
    return bool(out.value)

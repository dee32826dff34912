# SPDX-License-Identifier: Apache-2.0
"""Meshes of hexahedra that follow a field."""

from __future__ import annotations

import dataclasses
import json
from functools import cached_property
from typing import Any, Dict, Optional

import numpy as np

from ._library import Handle, array_view, call, library, made, path_bytes, text_from, view
from ._options import handle_of, solve_handle, unless_none, with_changes
from ._progress import ProgressOption, listener
from ._watched import watched
from .errors import UsageError
from .models import TetMesh, is_of_tets, is_path, surface_of, tets_of
from .options import HexMeshingOptions, HexOptions, OutputOptions
from .solving import naming
from .tet_field import TetField

OUTCOMES = ("all-hex", "partial", "none")
"""Values of ``HexMesh.outcome``."""


class HexMesh:
    """A mesh of hexahedra, with the field that it follows.

    A mesh that does not fill the model is one too: see ``is_all_hex``, and ``str()`` of the mesh for the reason in one line. Arrays are
    read-only views; copy them to change them. Immutable: any number of threads may use a mesh at once.
    """

    def __init__(self, handle: Handle, model: str = "", read_seconds: float = 0.0):
        self._handle, self._model = Handle.of_kind(handle, "hexahedra"), (model, read_seconds)

    def __repr__(self) -> str:
        return f"<crossgrain.HexMesh: {self}>"

    def __str__(self) -> str:
        return library.crossgrain_hexahedra_sentence(self._handle).decode()

    def __len__(self) -> int:
        """Number of hexahedra."""
        return library.crossgrain_hexahedra_count(self._handle)

    @property
    def outcome(self) -> str:
        """``"all-hex"``: they fill the model, and none is inverted; ``"partial"``: some are left out or inverted; ``"none"``."""
        return OUTCOMES[library.crossgrain_hexahedra_outcome(self._handle)]

    @property
    def is_all_hex(self) -> bool:
        """Whether the hexahedra fill the model, and none is inverted."""
        return self.outcome == "all-hex"

    @property
    def reason(self) -> str:
        """Why it is not all-hex, with a place, and what to try; empty if it is."""
        its_report = self.report["hexahedra"]
        return "; try ".join(filter(None, [its_report.get("reason", ""), its_report.get("remedy", "")]))

    @cached_property
    def points(self) -> np.ndarray:
        """All vertices, (n, 3)."""
        count = library.crossgrain_hexahedra_vertex_count(self._handle)
        return array_view(self._handle, library.crossgrain_hexahedra_vertices(self._handle), np.float64, (count, 3))

    @cached_property
    def cells(self) -> np.ndarray:
        """The hexahedra, indices of points, (m, 8), in the order of VTK, gmsh and Abaqus: four around one face, then the four opposite to
        them."""
        return array_view(self._handle, library.crossgrain_hexahedra_corners(self._handle), np.uint32, (len(self), 8))

    @cached_property
    def quality(self) -> np.ndarray:
        """Scaled Jacobian of each hexahedron, (m,): 1 for a cube, 0 or less if it is inverted."""
        return array_view(self._handle, library.crossgrain_hexahedra_scaled_jacobians(self._handle), np.float64, (len(self),))

    @property
    def regions(self) -> Optional[np.ndarray]:
        """Region number of each hexahedron, (m,): the solid of its middle; None if the model has none."""
        return view(self._handle, library.crossgrain_hexahedra_regions(self._handle), np.int32, (len(self),))

    @cached_property
    def faces(self) -> np.ndarray:
        """The boundary: indices of points, (f, 4), outward."""
        count = library.crossgrain_hexahedra_face_count(self._handle)
        return array_view(self._handle, library.crossgrain_hexahedra_faces(self._handle), np.uint32, (count, 4))

    @cached_property
    def tags(self) -> np.ndarray:
        """Number of the face of the model, or tag, that each face of the boundary lies on, (f,); 0 without one."""
        return array_view(self._handle, library.crossgrain_hexahedra_face_tags(self._handle), np.int32, (len(self.faces),))

    @property
    def unit(self) -> str:
        """Unit of the coordinates, such as "mm"; empty if the model does not say."""
        return library.crossgrain_hexahedra_unit(self._handle).decode()

    @cached_property
    def report(self) -> Dict[str, Any]:
        """The content of report.json (docs/report.md): ``report["hexahedra"]`` has the numbers of the mesh, the rest is about its field."""
        return json.loads(text_from("hexahedra_report", self._handle))

    @cached_property
    def field(self) -> TetField:
        """The repaired field on tets that the hexahedra follow; ``field.grid`` is the one on the grid."""
        return TetField(made("tet_field", "hexahedra_field", self._handle), *self._model)

    def write(self, path: Any) -> None:
        """Writes the mesh in the format of the extension (docs/formats.md): .vtu for ParaView, .mesh for Medit, .msh for gmsh, .inp for
        CalculiX and Abaqus. The file appears complete or not at all. Raises OutputError, UsageError for other extensions."""
        encoded = path_bytes(path)
        watched(lambda monitor: call("hexahedra_write", self._handle, encoded, monitor.handle))

    def write_folder(self, folder: Any, *, page: Optional[bool] = None, options: Optional[OutputOptions] = None,
                     **changes: Any) -> Dict[str, Any]:
        """Writes the folder that ``crossgrain hex`` writes: the field on tets (`TetField.write`), and the mesh in all formats; its map
        too with ``formats=["hexex", "map"]`` (docs/formats.md). Returns the report as written."""
        if page is not None or options is None:
            changes["page"] = page is None or page
        handle, encoded = handle_of(with_changes(options, OutputOptions, changes)), path_bytes(folder)
        model, seconds = path_bytes(self._model[0]) or None, self._model[1]
        self.report = json.loads(watched(
            lambda monitor: text_from("hexahedra_write_folder", self._handle, encoded, handle, model, seconds, monitor.handle)))
        return self.report

    def to_vtk(self) -> Any:
        """The mesh as a vtkUnstructuredGrid, which pyvista wraps (``pyvista.wrap``). Needs the package vtk."""
        from .vtk_data import grid_of
        return grid_of((self.points, "hexahedron", self.cells), self._cell_data(), {})

    def to_meshio(self) -> Any:
        """The hexahedra and the faces of the boundary, with regions and tags, as a mesh of meshio. Needs that package."""
        import meshio  # type: ignore[import]
        # Every block needs every array.
        data = {name: [values, np.zeros(len(self.faces), values.dtype)] for name, values in self._cell_data().items()}
        data["tag"] = [np.zeros(len(self), np.int32), self.tags]
        # Its writers do not all know unsigned indices.
        blocks = [("hexahedron", self.cells.astype(np.int64)), ("quad", self.faces.astype(np.int64))]
        return meshio.Mesh(self.points, blocks, cell_data=data)

    def _cell_data(self) -> Dict[str, np.ndarray]:
        data = {"scaled_jacobian": self.quality}
        if self.regions is not None:
            data["region"] = self.regions
        return data


def sized(options: HexOptions, size: Optional[float], cells: Optional[float]) -> HexOptions:
    """The options with an edge of the hexahedra or their number along the longest side."""
    if size is not None and cells is not None:
        raise UsageError("give the size of the hexahedra or their number, not both")
    if cells is not None:
        return dataclasses.replace(options, cells=cells, size=0)
    return options if size is None else dataclasses.replace(options, size=size)


def _chosen(options: Optional[HexMeshingOptions], size: Optional[float], cells: Optional[float], tet_size: Optional[float],
            **of_solve: Any) -> HexMeshingOptions:
    chosen = with_changes(options, HexMeshingOptions, {})
    return dataclasses.replace(chosen, hexahedra=sized(chosen.hexahedra, size, cells),
                               tets=dataclasses.replace(chosen.tets, **unless_none(size=tet_size)),
                               solve=dataclasses.replace(chosen.solve, **unless_none(**of_solve)))


def _is_tets(model: Any, elements: Any) -> bool:
    if elements is None:
        return is_of_tets(model)
    shape = np.shape(elements)
    if len(shape) != 2 or shape[1] not in (3, 4):
        raise TypeError(f"elements: triangles (m, 3) or tets (m, 4) are needed, not an array of shape {shape}")
    return shape[1] == 4


def hex(model: Any, elements: Any = None, *, size: Optional[float] = None, cells: Optional[float] = None,  # pylint: disable=redefined-builtin
        tet_size: Optional[float] = None, seed: Optional[int] = None, threads: Optional[int] = None, max_memory_bytes: Optional[int] = None,
        options: Optional[HexMeshingOptions] = None, progress: ProgressOption = None) -> HexMesh:
    """Meshes a solid with hexahedra that follow a field: cuts it into tets, solves on them and repairs the field, maps it to the unit grid
    and pulls its cells back (docs/hexahedra.md). Where that does not fill the model, tets of other sizes are tried.

    The model is a file (STEP, IGES, BREP; STL, OBJ, PLY, OFF; tets in Medit, Gmsh, VTK), two arrays (points (n, 3), and triangles (m, 3) or
    tets (m, 4)), a mesh of meshio or trimesh, a `Surface` or a `TetMesh`. Surfaces must be closed; tets are made by gmsh or Netgen.

    size:
        edge of the hexahedra, in model units
    cells:
        number of hexahedra along the longest side instead, 20 by default
    tet_size:
        largest edge of the tets that are made; by default that of the hexahedra, at most 1/20 of the longest side
    seed, threads, max_memory_bytes:
        of the solve, as for `solve`; the memory is that of all steps
    options:
        all other options; those above replace its members
    progress:
        as for `solve`

    A mesh that does not fill the model is returned too: ``is_all_hex`` is False then, and ``print(mesh)`` says why. The result does not
    depend on the number of threads. Ctrl-C cancels.

    Raises InputError for a model that cannot be used or cut into tets, UsageError for options out of range, LimitError, TypeError.
    """
    chosen = _chosen(options, size, cells, tet_size, seed=seed, threads=threads, max_memory_bytes=max_memory_bytes)
    handle = solve_handle(chosen, None, HexMeshingOptions)
    path, read_seconds = "", 0.0
    if elements is None and is_path(model):
        what: Any = path_bytes(model)
        name, path = "hexahedra_make", path_bytes(model).decode("utf-8", "surrogateescape")
    elif _is_tets(model, elements):
        given = TetMesh(model, elements, tags_options=chosen.tags) if elements is not None else tets_of(model, None)
        what, name, path, read_seconds = given._handle, "hexahedra_make_in_tets", given.path, given.read_seconds
    else:
        surface = surface_of(model, elements, lambda: None)
        what, name, path, read_seconds = surface._handle, "hexahedra_make_inside", surface.path, surface.read_seconds
    with listener(progress) as hear, naming(path):
        mesh = watched(lambda monitor: made("hexahedra", name, what, handle, monitor.handle), hear)
    return HexMesh(mesh, path, read_seconds)

# SPDX-License-Identifier: Apache-2.0
"""Frame fields on the vertices and tets of a mesh, and the hexahedra that follow them: each gives the other,
so they stand together."""

from __future__ import annotations

import dataclasses
import json
from functools import cached_property
from typing import Any, Dict, Optional, Tuple

import numpy as np

from . import _arrays
from ._library import Handle, array_view, call, frozen, library, made, path_bytes, text_from, view
from ._options import handle_of, unless_none, with_changes
from ._progress import ProgressOption, listener
from ._watched import Progress, watched
from .errors import UsageError
from .field import Field, _AnyField
from .matchings import Matchings
from .models import TetMesh
from .options import HexOptions, OutputOptions, RepairOptions, StreamlineOptions
from .streamlines import Streamlines, traced
from .vtk_data import grid_of

"""Values of ``HexMesh.outcome``."""


class TetField(_AnyField):
    """A frame field on the vertices and tets of a mesh, with the field on the grid from which it started.

    Arrays belong to the vertices (``points``) or tets (``cells``) of the mesh as prepared: tets without
    volume are left out. They are read-only. Immutable: any number of threads may use a field at once.
    """

    _kind = "tet_field"
    _parts = "tets"

    def __init__(self, handle: Handle, model: str = "", read_seconds: float = 0.0):
        self._handle, self._model = Handle.of_kind(handle, "tet_field"), (model, read_seconds)

    def __len__(self) -> int:
        """Number of tets."""
        return len(self.cells)

    @cached_property
    def mesh(self) -> TetMesh:
        """The mesh that the field is on."""
        return TetMesh._of(made("domain", "tet_field_domain", self._handle))

    @property
    def points(self) -> np.ndarray:
        """All vertices, (v, 3)."""
        return self.mesh.points

    @property
    def cells(self) -> np.ndarray:
        """The tets, (n, 4)."""
        return self.mesh.cells

    @property
    def regions(self) -> Optional[np.ndarray]:
        """Region number of each tet; None if there are none."""
        return self.mesh.regions

    @cached_property
    def grid(self) -> Field:
        """The field on the grid from which it started."""
        return Field(made("field", "tet_field_grid", self._handle), *self._model)

    def _filled(self, name: str, count: int) -> np.ndarray:
        array = np.empty((count, 3, 3))
        call(f"tet_field_{name}", self._handle, _arrays.address(array))
        return frozen(array)

    @cached_property
    def frames(self) -> np.ndarray:
        """The frames of the tets, (n, 3, 3): ``frames[i, k]`` is axis k of tet i. Computed at the first
        access."""
        return self._filled("frames", len(self))

    @cached_property
    def vertex_frames(self) -> np.ndarray:
        """The frames of the vertices, (v, 3, 3). At a smooth boundary vertex one axis is the area-weighted
        normal of its faces. Computed at the first access."""
        return self._filled("vertex_frames", len(self.points))

    @property
    def quaternions(self) -> np.ndarray:
        """The frames of the tets as unit quaternions (w, x, y, z), as they are stored, (n, 4): a view."""
        return array_view(self._handle, library.crossgrain_tet_field_quaternions(self._handle), np.float64,
                          (len(self), 4))

    @property
    def vertex_quaternions(self) -> np.ndarray:
        """The frames of the vertices as unit quaternions, (v, 4): a view."""
        return array_view(self._handle, library.crossgrain_tet_field_vertex_quaternions(self._handle),
                          np.float64, (len(self.points), 4))

    @cached_property
    def matchings(self) -> Matchings:
        """How frames of neighbouring tets go on in each other."""
        return Matchings(watched(lambda monitor: made("matchings", "tet_field_matchings", self._handle,
                                                      monitor.handle)))

    def repaired(self, *, threads: int = 0, options: Optional[RepairOptions] = None,
                 **changes: Any) -> TetField:
        """This field with matchings that hexahedra can follow, as far as they were found, and with frames
        smoothed for them.

        ``report["onto"]["repair"]`` tells what has changed. The mesh is the same, but for vertices of one
        that was prepared for a map (`TetMesh.prepared_for_map`), which leaves more room: they may move, so
        that arcs run straight (``moves_vertices``). `changes` replace members of the options. Ctrl-C cancels.
        Raises InputError for a mesh with tets without volume or that overlap, UsageError for a field with
        constraints and for options out of range.
        """
        handle = handle_of(with_changes(options, RepairOptions, changes))
        its_threads = _arrays.integer(threads, "threads")
        field = watched(lambda monitor: made("tet_field", "tet_field_repaired", self._handle, handle,
                                             its_threads, monitor.handle))
        return TetField(field, *self._model)

    def hexahedra(self, *, size: Optional[float] = None, cells: Optional[float] = None,
                  threads: Optional[int] = None, options: Optional[HexOptions] = None,
                  progress: ProgressOption = None, **changes: Any) -> HexMesh:
        """Hexahedra that fill the tets and follow the frames. The field should be on tets that were prepared
        for a map (`TetMesh.prepared_for_map`); it is repaired first, unless it is so already.

        `size` is their edge in model units, `cells` their number along the longest side instead, 20 by
        default; `changes` replace other members of the options. `crossgrain.hex` does all from a model.
        Raises as `repaired`.
        """
        chosen = sized(with_changes(options, HexOptions, unless_none(threads=threads)), size, cells)
        handle = handle_of(with_changes(chosen, HexOptions, changes))
        with listener(progress) as hear:
            made_here = watched(lambda monitor: made("hexahedra", "tet_field_hexahedra", self._handle, handle,
                                                     monitor.handle), hear)
        return HexMesh(made_here, *self._model)

    def streamlines(self, seeds: Any = None, *, on: Optional[str] = None, count: int = 100,
                    position: Optional[float] = None, threads: int = 0,
                    options: Optional[StreamlineOptions] = None, **changes: Any) -> Streamlines:
        """Lines along the axes, as `Field.streamlines`; they end exactly on the boundary of the tets."""
        handle = handle_of(with_changes(options, StreamlineOptions, changes))
        tracer = watched(lambda monitor: made("tracer", "tracer_new_on_tets", self._handle, handle,
                                              monitor.handle))
        return traced(self, tracer, seeds, on, count, position, threads)

    def _points_and_cells(self) -> Tuple[np.ndarray, str, np.ndarray]:
        return self.points, "tetra", self.cells

    def _cell_data(self) -> Dict[str, np.ndarray]:
        data = {f"axis_{name}": self.frames[:, k] for k, name in enumerate("uvw")}
        if self.regions is not None:
            data["region"] = self.regions
        return data

    def _point_data(self) -> Dict[str, np.ndarray]:
        return {f"vertex_axis_{name}": self.vertex_frames[:, k] for k, name in enumerate("uvw")}


class HexMesh:
    """A mesh of hexahedra, with the field that it follows. Experimental: may change from release to release.

    A mesh that does not fill the model is one too: see ``is_all_hex``, and ``str()`` of the mesh for the
    reason in one line. Arrays are read-only views; copy them to change them. Immutable: any number of threads
    may use a mesh at once.
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
        """``"all-hex"``: valid, closed, and they keep the model's features and surface; ``"approximate"``:
        valid and closed, but they lack features or are off the surface; ``"partial"``: some are left out or
        inverted, or solids that touch are meshed apart; ``"none"``."""
        return Progress.OUTCOMES[library.crossgrain_hexahedra_outcome(self._handle)]

    @property
    def is_all_hex(self) -> bool:
        """Whether the outcome is ``"all-hex"``."""
        return self.outcome == "all-hex"

    @property
    def reason(self) -> str:
        """Why it is not all-hex, or what is wrong all the same (bad shapes), with a place
        and what to try; empty if nothing is."""
        its_report = self.report["hexahedra"]
        return "; ".join(filter(None, [its_report.get("reason", ""), its_report.get("next", "")]))

    @cached_property
    def points(self) -> np.ndarray:
        """All vertices, (n, 3)."""
        count = library.crossgrain_hexahedra_vertex_count(self._handle)
        return array_view(self._handle, library.crossgrain_hexahedra_vertices(self._handle), np.float64,
                          (count, 3))

    @cached_property
    def cells(self) -> np.ndarray:
        """The hexahedra, indices of points, (m, 8), in the order of VTK, gmsh and Abaqus: four around one
        face, then the four opposite to them."""
        return array_view(self._handle, library.crossgrain_hexahedra_corners(self._handle), np.uint32,
                          (len(self), 8))

    @cached_property
    def quality(self) -> np.ndarray:
        """Scaled Jacobian of each hexahedron, (m,): 1 for a cube, 0 or less if it is inverted at a corner."""
        return array_view(self._handle, library.crossgrain_hexahedra_scaled_jacobians(self._handle),
                          np.float64, (len(self),))

    @property
    def regions(self) -> Optional[np.ndarray]:
        """Region number of each hexahedron, (m,): the solid of its middle; None if the model has none."""
        return view(self._handle, library.crossgrain_hexahedra_regions(self._handle), np.int32, (len(self),))

    @cached_property
    def faces(self) -> np.ndarray:
        """The boundary: indices of points, (f, 4), outward."""
        count = library.crossgrain_hexahedra_face_count(self._handle)
        return array_view(self._handle, library.crossgrain_hexahedra_faces(self._handle), np.uint32,
                          (count, 4))

    @cached_property
    def tags(self) -> np.ndarray:
        """Number of the face of the model, or tag, that each face of the boundary lies on, (f,); 0 without
        one."""
        return array_view(self._handle, library.crossgrain_hexahedra_face_tags(self._handle), np.int32,
                          (len(self.faces),))

    @property
    def unit(self) -> str:
        """Unit of the coordinates, such as "mm"; empty if the model does not say."""
        return library.crossgrain_hexahedra_unit(self._handle).decode()

    @cached_property
    def report(self) -> Dict[str, Any]:
        """The content of report.json (docs/report.md): ``report["hexahedra"]`` has the numbers of the mesh,
        with the features that it keeps and those that it lacks; the rest is about its field."""
        return json.loads(text_from("hexahedra_report", self._handle))

    @property
    def features(self) -> Optional[Dict[str, Any]]:
        """What the mesh keeps of the model's corners, creases and faces, and what it lacks, with places and
        figures (docs/report.md); None of a partial mesh."""
        return self.report["hexahedra"].get("features")

    @cached_property
    def field(self) -> TetField:
        """The repaired field on tets that the hexahedra follow; ``field.grid`` is the one on the grid.
        Raises UsageError for those of `fit`, which follow none."""
        return TetField(made("tet_field", "hexahedra_field", self._handle), *self._model)

    def write(self, path: Any, *, inverted: bool = False) -> None:
        """Writes the mesh in the format of the extension (docs/formats.md): .vtu for ParaView, .mesh for
        Medit, .msh for gmsh, .inp for CalculiX and Abaqus. The file appears complete or not at all. Raises
        OutputError; UsageError for other extensions, and for inverted hexahedra in any but .vtu unless
        `inverted`, since solvers give wrong results on them without a word."""
        encoded = path_bytes(path)
        watched(lambda monitor: call("hexahedra_write", self._handle, encoded, int(inverted),
                                     monitor.handle))

    def write_folder(self, folder: Any, *, page: Optional[bool] = None,
                     options: Optional[OutputOptions] = None, **changes: Any) -> Dict[str, Any]:
        """Writes the folder that ``crossgrain hex`` or ``fit`` writes: the field on tets if there is one
        (`TetField.write`), and the mesh in all formats; its map too with ``formats=["hexex", "map"]``
        (docs/formats.md). Returns the report as written."""
        if page is not None or options is None:
            changes["page"] = page is None or page
        handle, encoded = handle_of(with_changes(options, OutputOptions, changes)), path_bytes(folder)
        model, seconds = path_bytes(self._model[0]) or None, self._model[1]
        self.report = json.loads(watched(lambda monitor: text_from("hexahedra_write_folder", self._handle,
                                                                   encoded, handle, model, seconds,
                                                                   monitor.handle)))
        return self.report

    def to_vtk(self) -> Any:
        """The mesh as a vtkUnstructuredGrid, which pyvista wraps (``pyvista.wrap``). Needs the package
        vtk."""
        return grid_of((self.points, "hexahedron", self.cells), self._cell_data(), {})

    def to_meshio(self) -> Any:
        """The hexahedra and the faces of the boundary, with regions and tags, as a mesh of meshio. Needs that
        package."""
        import meshio  # type: ignore[import]
        # Every block needs every array.
        data = {name: [values, np.zeros(len(self.faces), values.dtype)]
                for name, values in self._cell_data().items()}
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

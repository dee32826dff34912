# SPDX-License-Identifier: Apache-2.0
"""Frame fields on the vertices and tets of a mesh."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any, Dict, Optional, Tuple

import numpy as np

from . import _arrays
from ._library import Handle, array_view, call, frozen, library, made
from ._options import handle_of, unless_none, with_changes
from ._progress import ProgressOption, listener
from ._watched import watched
from .field import Field, _AnyField
from .models import TetMesh
from .options import HexOptions, RepairOptions, StreamlineOptions
from .streamlines import Streamlines, traced

if TYPE_CHECKING:
    from .hex_mesh import HexMesh


class Matchings:
    """How the axes of the frames of neighbouring tets go on in each other, across each face between two tets, ascending by its vertices."""

    def __init__(self, handle: Handle):
        count = library.crossgrain_matchings_count(Handle.of_kind(handle, "matchings"))
        self.faces: np.ndarray = array_view(handle, library.crossgrain_matchings_faces(handle), np.uint32, (count, 3))
        """Vertices of each face, ascending, (f, 3)."""
        self.tets: np.ndarray = array_view(handle, library.crossgrain_matchings_tets(handle), np.uint32, (count, 2))
        """The two tets, (f, 2)."""
        self.axes: np.ndarray = array_view(handle, library.crossgrain_matchings_axes(handle), np.int8, (count, 3))
        """Axis k of the first tet goes on in the second as its axis ``abs(axes[f, k])``, counted from 1, with the sign of ``axes[f, k]``:
        as in .perm files, (f, 3)."""

    def __len__(self) -> int:
        return len(self.tets)

    @cached_property
    def matrices(self) -> np.ndarray:
        """The same as matrices, (f, 3, 3): ``matrices[f] @ frames[tets[f, 1]]`` are the axes of the second tet in the names of the first."""
        result = np.zeros((len(self), 3, 3))
        rows = np.arange(len(self))[:, None]
        result[rows, np.arange(3)[None], np.abs(self.axes).astype(np.intp) - 1] = np.sign(self.axes)
        return frozen(result)

    @property
    def are_identities(self) -> np.ndarray:
        """Whether each is the identity, (f,)."""
        return (self.axes == np.array([1, 2, 3], np.int8)).all(axis=1)


class TetField(_AnyField):
    """A frame field on the vertices and tets of a mesh, with the field on the grid from which it started.

    Arrays belong to the vertices (``points``) or tets (``cells``) of the mesh as prepared: tets without volume are left out. They are
    read-only. Immutable: any number of threads may use a field at once.
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
        """The frames of the tets, (n, 3, 3): ``frames[i, k]`` is axis k of tet i. Computed at the first access."""
        return self._filled("frames", len(self))

    @cached_property
    def vertex_frames(self) -> np.ndarray:
        """The frames of the vertices, (v, 3, 3). At a smooth boundary vertex one axis is the area-weighted normal of its faces. Computed at
        the first access."""
        return self._filled("vertex_frames", len(self.points))

    @property
    def quaternions(self) -> np.ndarray:
        """The frames of the tets as unit quaternions (w, x, y, z), as they are stored, (n, 4): a view."""
        return array_view(self._handle, library.crossgrain_tet_field_quaternions(self._handle), np.float64, (len(self), 4))

    @property
    def vertex_quaternions(self) -> np.ndarray:
        """The frames of the vertices as unit quaternions, (v, 4): a view."""
        return array_view(self._handle, library.crossgrain_tet_field_vertex_quaternions(self._handle), np.float64, (len(self.points), 4))

    @cached_property
    def matchings(self) -> Matchings:
        """How frames of neighbouring tets go on in each other."""
        return Matchings(watched(lambda monitor: made("matchings", "tet_field_matchings", self._handle, monitor.handle)))

    def repaired(self, *, threads: int = 0, options: Optional[RepairOptions] = None, **changes: Any) -> "TetField":
        """This field with matchings that hexahedra can follow, as far as they were found, and with frames smoothed for them.

        ``report["onto"]["repair"]`` tells what has changed. The mesh is the same, but for vertices of one that was prepared for a map
        (`TetMesh.prepared_for_map`), which leaves more room: they may move, so that arcs run straight (``moves_vertices``). `changes` replace
        members of the options. Ctrl-C cancels. Raises InputError for a mesh with tets without volume or that overlap, UsageError for a field
        with constraints and for options out of range.
        """
        handle = handle_of(with_changes(options, RepairOptions, changes))
        its_threads = _arrays.integer(threads, "threads")
        field = watched(lambda monitor: made("tet_field", "tet_field_repaired", self._handle, handle, its_threads, monitor.handle))
        return TetField(field, *self._model)

    def hexahedra(self, *, size: Optional[float] = None, cells: Optional[float] = None, threads: Optional[int] = None,
                  options: Optional[HexOptions] = None, progress: ProgressOption = None, **changes: Any) -> "HexMesh":
        """Hexahedra that fill the tets and follow the frames. The field should be on tets that were prepared for a map
        (`TetMesh.prepared_for_map`); it is repaired first, unless it is so already.

        `size` is their edge in model units, `cells` their number along the longest side instead, 20 by default; `changes` replace other
        members of the options. `crossgrain.hex` does all from a model. Raises as `repaired`.
        """
        from .hex_mesh import HexMesh, sized
        chosen = with_changes(sized(with_changes(options, HexOptions, unless_none(threads=threads)), size, cells), HexOptions, changes)
        handle = handle_of(chosen)
        with listener(progress) as hear:
            made_here = watched(lambda monitor: made("hexahedra", "tet_field_hexahedra", self._handle, handle, monitor.handle), hear)
        return HexMesh(made_here, *self._model)

    def streamlines(self, seeds: Any = None, *, on: Optional[str] = None, count: int = 100, position: Optional[float] = None,
                    threads: int = 0, options: Optional[StreamlineOptions] = None, **changes: Any) -> Streamlines:
        """Lines along the axes, as `Field.streamlines`; they end exactly on the boundary of the tets."""
        handle = handle_of(with_changes(options, StreamlineOptions, changes))
        tracer = watched(lambda monitor: made("tracer", "tracer_new_on_tets", self._handle, handle, monitor.handle))
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

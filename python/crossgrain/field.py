# SPDX-License-Identifier: Apache-2.0
"""Frame fields on the cells of an octree."""

from __future__ import annotations

import json
from functools import cached_property
from typing import Any, Dict, NamedTuple, Optional, Tuple

import numpy as np

from . import _arrays
from ._library import Handle, array_view, call, frozen, handle_in, library, made, path_bytes, text_from, view
from ._options import handle_of, with_changes
from ._watched import watched
from .models import Surface
from .options import OutputOptions, PictureOptions, StreamlineOptions
from .singularities import Answer, SingularityGraph
from .spectra import coefficients
from .streamlines import Streamlines, traced
from .vtk_data import grid_of

CONSTRAINT_CLASSES = ("no_surface", "plane", "axis", "frame", "free", "conflicted")
"""Names of ``Field.constraint_classes``: what the constraints in a cell determine."""


class Samples(NamedTuple):
    """A field at points."""

    frames: np.ndarray
    """Three unit axes as rows, (n, 3, 3)."""
    in_active_cell: np.ndarray
    """False: the frame is that of the nearest cell, (n,)."""
    deviation: np.ndarray
    """Disagreement of the surrounding cells, (n,): 0 where the frames agree, up to 200/3 on a singular line;
    0 outside."""
    singular_distance: np.ndarray
    """Distance to the nearest arc, (n,); infinity if there are none."""


class _AnyField:
    """What fields on a grid and on tets have in common. ``_kind`` begins the names of the functions of the
    library."""

    _kind: str
    _handle: Handle
    _model: Tuple[str, float]

    def __repr__(self) -> str:
        verdict = self.report["verdict"].replace("_", " ")
        return f"<crossgrain.{type(self).__name__}: {len(self)} {self._parts}, {verdict}>"

    _parts: str

    def __len__(self) -> int:
        raise NotImplementedError

    @cached_property
    def report(self) -> Dict[str, Any]:
        """The content of report.json (docs/report.md). That of the last `write`, with its times, if there was
        one."""
        return json.loads(text_from(f"{self._kind}_report", self._handle))

    @cached_property
    def singularities(self) -> SingularityGraph:
        """The singular graph of the field."""
        return SingularityGraph(watched(lambda monitor: made("graph", f"{self._kind}_singularities",
                                                             self._handle, monitor.handle)))

    def check(self) -> Answer:
        """Whether a hexahedral mesh can follow the field locally, and why not: ``check().verdict``,
        ``print(check())``."""
        return Answer(made("answer", f"{self._kind}_answer", self._handle))

    def write(self, folder: Any, *, page: Optional[bool] = None, options: Optional[OutputOptions] = None,
              **changes: Any) -> Dict[str, Any]:
        """Writes the folder of the field (docs/field-file.md): .vtu files for ParaView, report.json and, with
        `page`, report.html for a browser; by default with it, or as `options` say. All files appear, or none.
        Returns the report as written.

        `changes` are members of OutputOptions: ``field.write("part.frames", level=6)``. Raises OutputError,
        also if the folder has files that Crossgrain did not write, or that were changed since, unless
        ``foreign_files="keep"``, which allows for the former without names of results, or ``"replace"``.
        """
        if page is not None or options is None:
            changes["page"] = page is None or page
        handle, encoded = handle_of(with_changes(options, OutputOptions, changes)), path_bytes(folder)
        model, seconds = path_bytes(self._model[0]) or None, self._model[1]
        written = watched(lambda monitor: text_from(f"{self._kind}_write", self._handle, encoded, handle,
                                                    model, seconds, monitor.handle))
        self.report = json.loads(written)
        return self.report

    def write_page(self, path: Any) -> None:
        """Writes the page that shows the field in a browser as one HTML file that needs no other
        (docs/page.md)."""
        encoded = path_bytes(path)
        watched(lambda monitor: call(f"{self._kind}_write_page", self._handle, encoded, monitor.handle))

    def render(self, path: Any, *, singularities: Optional[SingularityGraph] = None,
               streamlines: Optional[Streamlines] = None, options: Optional[PictureOptions] = None,
               **changes: Any) -> None:
        """Draws the field as a PNG file; needs no display. `changes` are members of PictureOptions:
        ``field.render("part.png", cut="y", colour="energy")``."""
        handle, encoded = handle_of(with_changes(options, PictureOptions, changes)), path_bytes(path)
        graph = handle_in(singularities, SingularityGraph, "singularities")
        lines = handle_in(streamlines, Streamlines, "streamlines")
        watched(lambda monitor: call(f"{self._kind}_render", self._handle, encoded, handle, graph, lines,
                                     monitor.handle))

    def to_vtk(self) -> Any:
        """The cells with their numbers as a vtkUnstructuredGrid, which pyvista wraps (``pyvista.wrap``).
        Needs the package vtk."""
        return grid_of(self._points_and_cells(), self._cell_data(), self._point_data())

    def to_meshio(self) -> Any:
        """The cells with their numbers as a mesh of meshio. Needs that package."""
        import meshio  # type: ignore[import]
        points, shape, cells = self._points_and_cells()
        # Its writers do not all know unsigned indices.
        return meshio.Mesh(points, [(shape, cells.astype(np.int64))],
                           cell_data={name: [values] for name, values in self._cell_data().items()},
                           point_data=self._point_data())

    def _points_and_cells(self) -> Tuple[np.ndarray, str, np.ndarray]:
        raise NotImplementedError

    def _cell_data(self) -> Dict[str, np.ndarray]:
        raise NotImplementedError

    def _point_data(self) -> Dict[str, np.ndarray]:
        return {}


class Field(_AnyField):
    """A solved frame field: one octahedral frame per active cell of an octree, and a frame for any point by
    interpolation.

    A frame is three orthonormal axes, the rows of a 3 x 3 matrix; any of the 24 equivalent ones may represent
    it, and neighbouring cells may differ in that choice. All arrays have one entry per cell, in Morton order,
    and are read-only; copy them to change them. Immutable: any number of threads may use a field at once.
    """

    _kind = "field"
    _parts = "cells"

    def __init__(self, handle: Handle, model: str = "", read_seconds: float = 0.0):
        self._handle, self._model = Handle.of_kind(handle, "field"), (model, read_seconds)

    def __len__(self) -> int:
        """Number of cells."""
        return library.crossgrain_field_size(self._handle)

    @property
    def degree(self) -> int:
        """Degree of the harmonics of the solve, 3 or 4."""
        return library.crossgrain_field_degree(self._handle)

    def _filled(self, name: str, dtype: Any, *shape: int) -> np.ndarray:
        array = np.empty((len(self), *shape), dtype)
        call(f"field_{name}", self._handle, _arrays.address(array))
        return frozen(array)

    def _stored(self, name: str, dtype: Any, *shape: int) -> Optional[np.ndarray]:
        return view(self._handle, getattr(library, f"crossgrain_field_{name}")(self._handle), dtype,
                    (len(self), *shape))

    @cached_property
    def centers(self) -> np.ndarray:
        """Centres of the cells, model units, (n, 3). Computed at the first access."""
        return self._filled("centers", np.float64, 3)

    @cached_property
    def sizes(self) -> np.ndarray:
        """Sides of the cells, model units, (n,). Computed at the first access."""
        return self._filled("sizes", np.float64)

    @cached_property
    def levels(self) -> np.ndarray:
        """Depths in the octree, (n,); the root cube has 0. Computed at the first access."""
        return self._filled("levels", np.int32)

    @cached_property
    def frames(self) -> np.ndarray:
        """The frames, (n, 3, 3): ``frames[i, k]`` is axis k of cell i. Computed at the first access."""
        return self._filled("frames", np.float64, 3, 3)

    @property
    def quaternions(self) -> np.ndarray:
        """The frames as unit quaternions (w, x, y, z), exactly as they are stored, (n, 4): a view.
        v -> q v q* takes the coordinate axes to those of the frame."""
        return array_view(self._handle, library.crossgrain_field_quaternions(self._handle), np.float32,
                          (len(self), 4))

    def coefficients(self, degree: Optional[int] = None) -> np.ndarray:
        """Coefficients of the frames in spherical harmonics, by default of the degree of the solve: (n, 7) or
        (n, 9)."""
        return coefficients(self.frames, degree=degree or self.degree)

    @property
    def on_boundary(self) -> np.ndarray:
        """Whether the cells hold surface, (n,): a view."""
        return array_view(self._handle, library.crossgrain_field_on_boundary(self._handle), np.bool_,
                          (len(self),))

    @property
    def energy_density(self) -> np.ndarray:
        """Smoothness energy per volume, model units to the power of -2, (n,): a view."""
        return array_view(self._handle, library.crossgrain_field_energy_density(self._handle), np.float32,
                          (len(self),))

    @property
    def alignment_deg(self) -> np.ndarray:
        """Mean angle between the surface's normal and the nearest axis, by area, degrees, (n,): a view; 0 in
        cells without surface."""
        return array_view(self._handle, library.crossgrain_field_alignment_deg(self._handle), np.float32,
                          (len(self),))

    @property
    def constraint_classes(self) -> Optional[np.ndarray]:
        """Class of the constraints, (n,), positions in CONSTRAINT_CLASSES: a view. None for a field read from
        files that lack it."""
        return self._stored("constraint_classes", np.uint8)

    @property
    def regions(self) -> Optional[np.ndarray]:
        """Solid that the cell belongs to, (n,): a view. None where there are not several."""
        return self._stored("regions", np.int32)

    def sample(self, points: Any, *, threads: int = 0) -> np.ndarray:
        """The frames at points, (m, 3) to (m, 3, 3), or at one point, (3,) to (3, 3), in model units.

        Inside a cell the coefficients of the surrounding cells are blended and projected to the nearest
        frame; elsewhere the result is the frame of the nearest cell. `threads` is their number, 0 for all
        processors; results do not depend on it. Other threads of Python run meanwhile, and Ctrl-C works.
        """
        rows, is_one = _arrays.points_or_point(points, "points")
        frames = np.empty((len(rows), 3, 3))
        self._sample(rows, threads, frames)
        return frames[0] if is_one else frames

    def sample_all(self, points: Any, *, threads: int = 0) -> Samples:
        """The frames at points, (m, 3), or at one point, (3,), with whether they are in a cell, how far the
        cells around disagree, and the distance to the nearest singular arc."""
        rows, is_one = _arrays.points_or_point(points, "points")
        n = len(rows)
        samples = Samples(np.empty((n, 3, 3)), np.empty(n, np.bool_), np.empty(n), np.empty(n))
        self._sample(rows, threads, *samples)
        return Samples(*(array[0] for array in samples)) if is_one else samples

    def _sample(self, rows: np.ndarray, threads: int, *arrays: np.ndarray) -> None:
        its_threads = _arrays.integer(threads, "threads")

        # Holds the arrays as long as it runs.
        def work(monitor: Any) -> None:
            addresses = [_arrays.address(array) for array in (rows, *arrays)] + [None] * (4 - len(arrays))
            call("field_sample", self._handle, addresses[0], len(rows), its_threads, *addresses[1:],
                 monitor and monitor.handle)

        if len(rows) < _FEW_POINTS:
            work(None)
        else:
            watched(work)

    def streamlines(self, seeds: Any = None, *, on: Optional[str] = None, count: int = 100,
                    position: Optional[float] = None, surface: Optional[Surface] = None, threads: int = 0,
                    options: Optional[StreamlineOptions] = None, **changes: Any) -> Streamlines:
        """Lines along the axes through `seeds`, points (m, 3); or through `count` seeds ``on`` ``"inside"``
        (the default), ``"surface"``, or a cut across ``"x"``, ``"y"`` or ``"z"`` at a `position` along that
        axis, by default the middle.

        Lines end exactly on `surface`, by default that of the field. `changes` are members of
        StreamlineOptions: ``field.streamlines(on="y", count=200, spacing_sides=0.02)``.
        """
        handle = handle_of(with_changes(options, StreamlineOptions, changes))
        its_surface = handle_in(surface, Surface, "surface")
        tracer = watched(lambda monitor: made("tracer", "tracer_new", self._handle, handle, its_surface,
                                              monitor.handle))
        return traced(self, tracer, seeds, on, count, position, threads)

    def _points_and_cells(self) -> Tuple[np.ndarray, str, np.ndarray]:
        points, cells = corners_of(self.centers, self.sizes, self.levels)
        return points, "hexahedron", cells

    def _cell_data(self) -> Dict[str, np.ndarray]:
        data = {f"axis_{name}": self.frames[:, k] for k, name in enumerate("uvw")}
        data.update(level=self.levels, energy_density=self.energy_density, alignment_deg=self.alignment_deg)
        others = {"constraint_class": self.constraint_classes, "region": self.regions}
        data.update({name: values for name, values in others.items() if values is not None})
        return data


# So few take less time than a thread.
_FEW_POINTS = 2000


def corners_of(centers: np.ndarray, sizes: np.ndarray, levels: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Points (p, 3) and hexahedra (n, 8), which share the points where cells have the same corner, in the
    order of VTK."""
    if not len(centers):
        return np.zeros((0, 3)), np.zeros((0, 8), np.int64)
    finest = int(levels.max())
    step = float(sizes[np.argmax(levels)])
    low = (centers - sizes[:, None] / 2).min(axis=0)
    # Integer corners in the smallest cells: exact, since sides are powers of two of them.
    width = np.left_shift(1, finest - levels.astype(np.int64))
    first = np.rint((centers - sizes[:, None] / 2 - low) / step).astype(np.int64)
    offsets = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0),
                        (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)])
    corners = first[:, None, :] + offsets[None] * width[:, None, None]
    keys = (corners[..., 0] << 42) | (corners[..., 1] << 21) | corners[..., 2]
    unique, where = np.unique(keys, return_inverse=True)
    mask = (1 << 21) - 1
    places = np.stack([unique >> 42, (unique >> 21) & mask, unique & mask], axis=1)
    return low + places * step, where.reshape(-1, 8)



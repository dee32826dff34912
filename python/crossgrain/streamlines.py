# SPDX-License-Identifier: Apache-2.0
"""Curves along the axes of a field."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, List, Optional

import numpy as np

from . import _arrays
from ._library import Handle, array_view, call, library, made, path_bytes
from ._watched import watched
from .errors import UsageError
from .vtk_data import polydata_of

ENDS = ("boundary", "singular_arc", "closed", "longest", "ambiguous", "crowded")


@dataclass(frozen=True, eq=False)
class Streamline:
    """A curve along an axis of the field. From point to point it follows the axis nearest to its
    direction."""

    points: np.ndarray
    """(n, 3), at least two; a closed line ends with its first point."""
    tangents: Optional[np.ndarray]
    """Unit vectors, (n, 3); None for lines read from a file."""
    axis: int
    """Name of the axis at the seed: 0 x, 1 y, 2 z; lines side by side along the same axis have the same
    name."""
    length: float
    """Sum of the segments between the points."""
    seed: Optional[int]
    """Index of the seed; None, as all below, for lines read from a file."""
    seed_point: Optional[int]
    """Index of the seed in `points`."""
    first_end: Optional[str]
    """Why it ends at its first point: ``"boundary"``, ``"singular_arc"``, ``"closed"``, ``"longest"``,
    ``"ambiguous"`` or ``"crowded"``."""
    last_end: Optional[str]
    """Why it ends at its last point."""


class Streamlines:
    """Streamlines, sorted by seed, then by axis: ``lines``, and how many seeds gave none."""

    def __init__(self, handle: Handle, field: Any = None):
        self._handle, self._field = Handle.of_kind(handle, "lines"), field
        self.outside_seeds: int = library.crossgrain_lines_outside_seeds(handle)
        """Seeds outside the solid."""
        self.arc_seeds: int = library.crossgrain_lines_arc_seeds(handle)
        """Seeds at a singular arc, where no line starts."""
        self.lines: List[Streamline] = [self._line(i) for i in range(library.crossgrain_lines_count(handle))]

    def _line(self, i: int) -> Streamline:
        line = library.crossgrain_lines_line(self._handle, i).contents
        shape = (line.point_count, 3)
        points = array_view(self._handle, line.points, np.float64, shape)
        if not line.tangents:
            length = float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())
            return Streamline(points, None, line.axis, length, None, None, None, None)
        return Streamline(points, array_view(self._handle, line.tangents, np.float64, shape), line.axis,
                          line.length, line.seed, line.seed_point, ENDS[line.first_end], ENDS[line.last_end])

    def __len__(self) -> int:
        return len(self.lines)

    def __iter__(self) -> Any:
        return iter(self.lines)

    def __getitem__(self, which: Any) -> Any:
        return self.lines[which]

    def __repr__(self) -> str:
        return f"<crossgrain.Streamlines: {len(self.lines)} lines>"

    def write(self, path: Any) -> None:
        """Writes the lines as polylines in the format of the extension (docs/streamlines.md): ``.vtu`` or
        ``.vtp``, which ParaView opens, or ``.obj``. In the folder of their field it is ``streamlines.vtu``;
        write the field first."""
        encoded = path_bytes(path)
        # All files of a result name their solve.
        solve = "" if self._field is None else self._field.report.get("solve", "")
        watched(lambda monitor: call("lines_write", self._handle, encoded, solve.encode() or None,
                                     monitor.handle))

    def to_vtk(self) -> Any:
        """A vtkPolyData with a polyline per line, and the name of its axis as cell data."""
        axes = np.array([line.axis for line in self.lines], np.uint8)
        return polydata_of([line.points for line in self.lines], {"axis": axes})


def read_streamlines(path: Any) -> Streamlines:
    """Reads the lines that were written, for pictures: their points and axes."""
    return Streamlines(made("lines", "lines_read", path_bytes(path)))


def traced(field: Any, tracer: Handle, seeds: Any, on: Optional[str], count: int, position: Optional[float],
           threads: int) -> Streamlines:
    """The lines through seeds, or through `count` seeds inside, on the surface or on a cut."""
    if seeds is not None and (on is not None or position is not None):
        raise UsageError("give either seeds, or where to make some")
    given = None if seeds is None else _arrays.points_or_point(seeds, "seeds")[0]
    its_count, its_threads = _arrays.integer(count, "count", 0, 10**9), _arrays.integer(threads, "threads")
    place = math.nan if position is None else _arrays.number(position, "position")

    def work(monitor: Any) -> Handle:
        if given is not None:
            return made("lines", "tracer_trace", tracer, _arrays.address(given), len(given), 3, its_threads,
                        monitor.handle)
        rows = _seeds(tracer, on or "inside", its_count, place, monitor)
        data, length = library.crossgrain_numbers_data(rows), library.crossgrain_numbers_rows(rows)
        columns = library.crossgrain_numbers_columns(rows)
        return made("lines", "tracer_trace", tracer, data, length, columns, its_threads, monitor.handle)

    return Streamlines(watched(work), field)


def _seeds(tracer: Handle, on: str, count: int, position: float, monitor: Any) -> Handle:
    if on == "inside":
        return made("numbers", "tracer_spread_seeds", tracer, count, monitor.handle)
    if on == "surface":
        return made("numbers", "tracer_surface_seeds", tracer, count, monitor.handle)
    if on not in ("x", "y", "z"):
        raise UsageError(f"seeds are on 'inside', 'surface', 'x', 'y' or 'z', not {on!r}")
    return made("numbers", "tracer_cut_seeds", tracer, "xyz".index(on), position, count, monitor.handle)

# SPDX-License-Identifier: Apache-2.0
"""Curves along the axes of a field."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, List, Optional

import numpy as np

from . import _arrays
from ._library import Handle, array_view, call, library, made, path_bytes, watched

ENDS = ("boundary", "singular_arc", "closed", "longest", "ambiguous", "crowded")


@dataclass(frozen=True, eq=False)
class Streamline:
    """A curve along an axis of the field. From point to point it follows the axis nearest to its direction."""

    points: np.ndarray
    """(n, 3), at least two; a closed line ends with its first point."""
    tangents: Optional[np.ndarray]
    """Unit vectors, (n, 3); None for lines read from a file."""
    axis: int
    """Name of the axis at the seed: 0 x, 1 y, 2 z; lines side by side along the same axis have the same name."""
    length: float
    """Sum of the segments between the points."""
    seed: int
    """Index of the seed."""
    seed_point: int
    """Index of the seed in `points`."""
    first_end: str
    """Why it ends: ``"boundary"``, ``"singular_arc"``, ``"closed"``, ``"longest"``, ``"ambiguous"`` or ``"crowded"``."""
    last_end: str


class Streamlines:
    """Streamlines, sorted by seed, then by axis: ``lines``, and how many seeds gave none."""

    def __init__(self, handle: Handle):
        self._handle = handle
        self.outside_seeds: int = library.crossgrain_lines_outside_seeds(handle)
        """Seeds outside the solid."""
        self.arc_seeds: int = library.crossgrain_lines_arc_seeds(handle)
        """Seeds at a singular arc, where no line starts."""
        self.lines: List[Streamline] = [self._line(i) for i in range(library.crossgrain_lines_count(handle))]

    def _line(self, i: int) -> Streamline:
        line = library.crossgrain_lines_line(self._handle, i).contents
        shape = (line.point_count, 3)
        tangents = array_view(self._handle, line.tangents, np.float64, shape) if line.tangents else None
        return Streamline(array_view(self._handle, line.points, np.float64, shape), tangents, line.axis, line.length, line.seed,
                          line.seed_point, ENDS[line.first_end], ENDS[line.last_end])

    def __len__(self) -> int:
        return len(self.lines)

    def __iter__(self) -> Any:
        return iter(self.lines)

    def __repr__(self) -> str:
        return f"<crossgrain.Streamlines: {len(self.lines)} lines>"

    def write(self, path: Any) -> None:
        """Writes the lines as polylines to a .vtu file, which ParaView opens (docs/streamlines.md)."""
        encoded = path_bytes(path)
        watched(lambda monitor: call("lines_write", self._handle, encoded, None, monitor.handle))

    def to_vtk(self) -> Any:
        """A vtkPolyData with a polyline per line, and the name of its axis as cell data."""
        from .vtk_data import polydata_of_lines
        return polydata_of_lines(self)


def read_streamlines(path: Any) -> Streamlines:
    """Reads the lines that were written, for pictures: their points and axes."""
    return Streamlines(made("lines", "lines_read", path_bytes(path)))


def traced(tracer: Handle, seeds: Any, on: Optional[str], count: int, position: Optional[float], threads: int) -> Streamlines:
    """The lines through seeds, or through `count` seeds inside, on the surface or on a cut."""
    given = None if seeds is None else _arrays.points_or_point(seeds, "seeds")[0]

    def work(monitor: Any) -> Streamlines:
        if given is not None:
            return Streamlines(made("lines", "tracer_trace", tracer, _arrays.address(given), len(given), 3, threads, monitor.handle))
        rows = _seeds(tracer, on or "inside", count, position, monitor)
        data, length = library.crossgrain_numbers_data(rows), library.crossgrain_numbers_rows(rows)
        columns = library.crossgrain_numbers_columns(rows)
        return Streamlines(made("lines", "tracer_trace", tracer, data, length, columns, threads, monitor.handle))

    return watched(work)


def _seeds(tracer: Handle, on: str, count: int, position: Optional[float], monitor: Any) -> Handle:
    if on == "inside":
        return made("numbers", "tracer_spread_seeds", tracer, count, monitor.handle)
    if on == "surface":
        return made("numbers", "tracer_surface_seeds", tracer, count, monitor.handle)
    if on not in ("x", "y", "z"):
        raise ValueError(f"seeds are on 'inside', 'surface', 'x', 'y' or 'z', not {on!r}")
    place = math.nan if position is None else position
    return made("numbers", "tracer_cut_seeds", tracer, "xyz".index(on), place, count, monitor.handle)

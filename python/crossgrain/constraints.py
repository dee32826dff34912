# SPDX-License-Identifier: Apache-2.0
"""Directions to follow besides the surface."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from ._arrays import address, numbers
from ._library import Handle, call, made, path_bytes


def _vector(values: Any, what: str, count: int) -> np.ndarray:
    return numbers(np.reshape(np.asarray(values), (1, -1)), what, count)


def _axes(values: Any) -> np.ndarray:
    array = np.asarray(values)
    return numbers(array.reshape(1, -1) if array.ndim == 1 else array, "axes", 3)


class Constraints:
    """Directions to follow besides the surface. Constraints are soft: each adds to the energy like a piece of surface.

    ``axes`` are one direction, which requests an axis along it, or three orthogonal ones, which request that frame, of any length; their
    signs do not matter. An axis of weight 1 counts in its cell like a piece of surface across the width of the cell with that normal.
    A solve checks them, and raises InputError.
    """

    def __init__(self) -> None:
        self._handle: Handle = made("constraints", "constraints_new")

    def add_point(self, at: Any, axes: Any, weight: float = 1) -> "Constraints":
        """An axis or a frame at a point."""
        place, its_axes = _vector(at, "at", 3), _axes(axes)
        call("constraints_add_point", self._handle, address(place), address(its_axes), len(its_axes), weight)
        return self

    def add_polyline(self, points: Any, axes: Optional[Any] = None, weight: float = 1) -> "Constraints":
        """An axis or a frame along a polyline of at least two points; by default the direction of each segment."""
        its_points = numbers(points, "points", 3)
        its_axes = np.zeros((0, 3)) if axes is None else _axes(axes)
        call("constraints_add_polyline", self._handle, address(its_points), len(its_points), address(its_axes), len(its_axes), weight)
        return self

    def add_face(self, face: int, axes: Optional[Any] = None, weight: float = 1) -> "Constraints":
        """An axis or a frame on all triangles with this number (``Surface.faces``); by default the normal of the face."""
        its_axes = np.zeros((0, 3)) if axes is None else _axes(axes)
        call("constraints_add_face", self._handle, face, address(its_axes), len(its_axes), weight)
        return self

    def add_stress(self, at: Any, tensor: Any, weight: float = 1) -> "Constraints":
        """Axes along the eigenvectors of a symmetric tensor: xx, yy, zz, yz, xz, xy. Those count that are well determined."""
        place, its_tensor = _vector(at, "at", 3), _vector(tensor, "tensor", 6)
        call("constraints_add_stress", self._handle, address(place), address(its_tensor), weight)
        return self


def read_constraints(path: Any) -> Constraints:
    """Reads and checks the constraints in a JSON file (docs/constraints.md)."""
    constraints = Constraints.__new__(Constraints)
    constraints._handle = made("constraints", "constraints_read", path_bytes(path))
    return constraints


def constraints_of(given: Any) -> Optional[Handle]:
    """The constraints that a caller means: an object, a path, or None."""
    if given is None:
        return None
    return (given if isinstance(given, Constraints) else read_constraints(given))._handle

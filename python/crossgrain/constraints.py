# SPDX-License-Identifier: Apache-2.0
"""Directions to follow besides the surface."""

from __future__ import annotations

import threading
from typing import Any, Optional

import numpy as np

from ._arrays import address, integer, number, numbers, points_or_point, vector
from ._library import Handle, call, made, path_bytes


def _axes(values: Any) -> np.ndarray:
    return points_or_point(values, "axes")[0]


class Constraints:
    """Directions to follow besides the surface. Constraints are soft: each adds to the energy like a piece of
    surface.

    ``axes`` are one direction, which requests an axis along it, or three orthogonal ones, which request that
    frame, of any length; their signs do not matter. An axis of weight 1 counts in its cell like a piece of
    surface across the width of the cell with that normal. A solve checks them, and raises InputError.
    """

    def __init__(self) -> None:
        self._handle: Handle = made("constraints", "constraints_new")
        # Of the additions, which threads may make at once.
        self._lock = threading.Lock()

    def _add(self, name: str, *arguments: Any) -> "Constraints":
        with self._lock:
            call(f"constraints_add_{name}", self._handle, *arguments)
        return self

    def add_point(self, at: Any, axes: Any, weight: float = 1) -> "Constraints":
        """An axis or a frame at a point."""
        place, its_axes = vector(at, "at", 3), _axes(axes)
        return self._add("point", address(place), address(its_axes), len(its_axes), number(weight, "weight"))

    def add_polyline(self, points: Any, axes: Optional[Any] = None, weight: float = 1) -> "Constraints":
        """An axis or a frame along a polyline of at least two points; by default the direction of each
        segment."""
        its_points = numbers(points, "points", 3)
        its_axes = np.zeros((0, 3)) if axes is None else _axes(axes)
        return self._add("polyline", address(its_points), len(its_points), address(its_axes), len(its_axes),
                         number(weight, "weight"))

    def add_face(self, face: int, axes: Optional[Any] = None, weight: float = 1) -> "Constraints":
        """An axis or a frame on all triangles with this number (``Surface.faces``); by default the normal of
        the face."""
        its_axes = np.zeros((0, 3)) if axes is None else _axes(axes)
        return self._add("face", integer(face, "face", -2**31), address(its_axes), len(its_axes),
                         number(weight, "weight"))

    def add_stress(self, at: Any, tensor: Any, weight: float = 1) -> "Constraints":
        """Axes along the eigenvectors of a symmetric tensor: xx, yy, zz, yz, xz, xy. Those count that are
        well determined."""
        place, its_tensor = vector(at, "at", 3), vector(tensor, "tensor", 6)
        return self._add("stress", address(place), address(its_tensor), number(weight, "weight"))


def read_constraints(path: Any) -> Constraints:
    """Reads and checks the constraints in a JSON file (docs/constraints.md)."""
    constraints = Constraints()
    constraints._handle = made("constraints", "constraints_read", path_bytes(path))
    return constraints


def constraints_of(given: Any) -> Optional[Constraints]:
    """The constraints that a caller means: an object, a path, or None."""
    return given if given is None or isinstance(given, Constraints) else read_constraints(given)

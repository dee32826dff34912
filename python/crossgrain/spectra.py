# SPDX-License-Identifier: Apache-2.0
"""Forms of normals, and coefficients of frames."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from . import _arrays
from ._library import Handle, array_view, call, library, made, text_bytes


@dataclass(frozen=True, eq=False)
class Spectrum:
    """The quadratic form E(h) = h^T A h - 2 b.h + c of a set of normals: the deviation of coefficients h, in
    the order m = -degree ... degree, from a frame with an axis along each normal (arXiv 2309.13477)."""

    degree: int
    matrix: np.ndarray
    """A, (7, 7) or (9, 9)."""
    eigenvalues: np.ndarray
    """Eigenvalues of A, ascending, not divided by the weight."""
    null_space: np.ndarray
    """After the shift, a row each; degree 4: a point, then orthonormal directions."""
    linear: np.ndarray
    """b; zeros in degree 3."""
    constant: float
    """c; zero in degree 3."""


def _spectrum(handle: Handle) -> Spectrum:
    form = library.crossgrain_spectrum_form(handle).contents
    size = form.size

    def array(at: Any, *shape: int) -> np.ndarray:
        return array_view(handle, at, np.float64, shape)

    return Spectrum(form.degree, array(form.matrix, size, size), array(form.eigenvalues, size),
                    array(form.null_space, form.null_space_count, size), array(form.linear, size),
                    form.constant)


def _degree(degree: Any) -> int:
    return _arrays.integer(degree, "degree", 3, 4)


def spectrum(normals: Any, weights: Optional[Any] = None, *, degree: int = 4) -> Spectrum:
    """The form of a sum of normals, (n, 3), of any length except zero, with positive weights, (n,), by
    default 1; or of a shape: ``"plane"``, ``"cube"``, ``"cylinder"`` or ``"sphere"``."""
    its_degree = _degree(degree)
    if isinstance(normals, str):
        return _spectrum(made("spectrum", "spectrum_of_preset", text_bytes(normals, "normals"), its_degree))
    rows = _arrays.numbers(normals, "normals", 3)
    shape = (len(rows),)
    its_weights = np.ones(shape) if weights is None else _arrays.of_shape(weights, "weights", shape)
    return _spectrum(made("spectrum", "spectrum_of_normals", _arrays.address(rows),
                          _arrays.address(its_weights), len(rows), its_degree))


def coefficients(frames: Any, *, degree: int = 4) -> np.ndarray:
    """The coefficients of frames, (n, 3, 3), in real orthonormal spherical harmonics, in the order m =
    -degree ... degree: (n, 7) in degree 3, (n, 9) in degree 4, of unit length. The 24 ways to name the axes
    of a frame have the same coefficients; in degree 3 up to sign."""
    rows = _arrays.of_shape(frames, "frames", (None, 3, 3))
    its_degree = _degree(degree)
    result = np.empty((len(rows), 7 if its_degree == 3 else 9))
    call("coefficients_of_frames", _arrays.address(rows), len(rows), its_degree, _arrays.address(result))
    return result

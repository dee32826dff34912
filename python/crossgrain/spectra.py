# SPDX-License-Identifier: Apache-2.0
"""Forms of normals, and coefficients of frames."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

import numpy as np

from . import _arrays
from ._library import Handle, array_view, call, library, made


@dataclass(frozen=True, eq=False)
class Spectrum:
    """The quadratic form E(h) = h^T A h - 2 b.h + c of a set of normals: the deviation of coefficients h, in the order m = -degree ...
    degree, from a frame with an axis along each normal (arXiv 2309.13477)."""

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
                    array(form.null_space, form.null_space_count, size), array(form.linear, size), form.constant)


def spectrum(normals: Any, weights: Optional[Any] = None, *, degree: int = 4) -> Spectrum:
    """The form of a sum of normals, (n, 3), of any length except zero, with positive weights, (n,), by default 1; or of a shape:
    ``"plane"``, ``"cube"``, ``"cylinder"`` or ``"sphere"``."""
    if isinstance(normals, str):
        return _spectrum(made("spectrum", "spectrum_of_preset", normals.encode(), degree))
    rows = _arrays.numbers(normals, "normals", 3)
    its_weights = np.ones(len(rows)) if weights is None else _arrays.numbers(np.reshape(weights, (-1, 1)), "weights", 1).ravel()
    if len(its_weights) != len(rows):
        raise TypeError(f"weights: {len(rows)} are needed, these are {len(its_weights)}")
    return _spectrum(made("spectrum", "spectrum_of_normals", _arrays.address(rows), _arrays.address(its_weights), len(rows), degree))


def coefficients(frames: Any, *, degree: int = 4) -> np.ndarray:
    """The coefficients of frames, (n, 3, 3), in real orthonormal spherical harmonics, in the order m = -degree ... degree: (n, 7) in degree
    3, (n, 9) in degree 4, of unit length. The 24 ways to name the axes of a frame have the same coefficients; in degree 3 up to sign."""
    array = np.asarray(frames)
    if array.shape[-2:] != (3, 3):
        raise TypeError(f"frames: an array of shape (..., 3, 3) is needed, this one is {array.shape}")
    rows = _arrays.as_doubles(array.reshape(-1, 9), "frames")
    result = np.empty((len(rows), 7 if degree == 3 else 9))
    call("coefficients_of_frames", _arrays.address(rows), len(rows), degree, _arrays.address(result))
    return result.reshape(array.shape[:-2] + result.shape[1:])

# SPDX-License-Identifier: Apache-2.0
"""Arrays of any dtype, order and stride as the library takes them. What cannot be meant raises a TypeError."""

from __future__ import annotations

from typing import Any, Optional

import numpy as np

from .errors import InputError


def _array(values: Any, what: str) -> np.ndarray:
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise TypeError(f"{what}: masked entries have no value; fill or remove them")
    try:
        array = np.asarray(values)
    except ValueError as error:
        raise TypeError(f"{what}: not an array of numbers: {error}") from None
    if array.dtype == object and array.size == 0:
        array = array.astype(float)
    return array


def _shaped(array: np.ndarray, what: str, columns: int) -> np.ndarray:
    if array.size == 0 and array.ndim <= 2 and array.shape[-1:] in ((0,), (columns,)):
        return array.reshape(0, columns)
    if array.ndim != 2 or array.shape[1] != columns:
        raise TypeError(f"{what}: an array of shape (n, {columns}) is needed, this one is {array.shape}")
    return array


def numbers(values: Any, what: str, columns: int) -> np.ndarray:
    """A contiguous array of doubles of shape (n, columns)."""
    return as_doubles(_shaped(_array(values, what), what, columns), what)


def as_doubles(array: np.ndarray, what: str) -> np.ndarray:
    """The array as contiguous doubles."""
    if array.dtype.kind not in "fiu":
        raise TypeError(f"{what}: real numbers are needed, not {array.dtype}")
    with np.errstate(over="ignore"):
        return np.ascontiguousarray(array, dtype=np.float64)


def points_or_point(values: Any, what: str) -> "tuple[np.ndarray, bool]":
    """A contiguous array of doubles of shape (n, 3), and whether the values are a single point."""
    array = _array(values, what)
    is_one = array.ndim == 1 and array.size > 0
    return numbers(array.reshape(1, -1) if is_one else array, what, 3), is_one


def indices(values: Any, what: str, columns: int) -> np.ndarray:
    """A contiguous array of unsigned 32-bit indices of shape (n, columns). An index out of that range is an InputError; the library
    says which is out of the range of the vertices."""
    array = _shaped(_array(values, what), what, columns)
    if array.size and array.dtype.kind not in "iu":
        raise TypeError(f"{what}: integers are needed, not {array.dtype}")
    if array.size:
        bad = np.argwhere((array < 0) | (array > np.iinfo(np.uint32).max))
        if len(bad):
            row, column = bad[0]
            raise InputError(f"{what}: row {row} (counted from 0): the index {array[row, column]} is out of range",
                             place=f"row {row} (counted from 0)", text=f"the index {array[row, column]} is out of range")
    return np.ascontiguousarray(array, dtype=np.uint32)


def tags(values: Any, what: str, count: int) -> Optional[np.ndarray]:
    """A contiguous array of `count` 32-bit integers; None for None."""
    if values is None:
        return None
    array = _array(values, what)
    if array.shape != (count,):
        raise TypeError(f"{what}: an array of shape ({count},) is needed, this one is {array.shape}")
    if array.size and array.dtype.kind not in "iu":
        raise TypeError(f"{what}: integers are needed, not {array.dtype}")
    limits = np.iinfo(np.int32)
    if array.size and (array.min() < limits.min or array.max() > limits.max):
        raise InputError(f"{what}: numbers of 32 bits are needed")
    return np.ascontiguousarray(array, dtype=np.int32)


def address(array: Optional[np.ndarray]) -> Optional[int]:
    """Where the numbers of a contiguous array are; None for None."""
    return None if array is None else array.ctypes.data

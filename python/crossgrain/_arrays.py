# SPDX-License-Identifier: Apache-2.0
"""Arrays of any dtype, order and stride as the library takes them. What cannot be meant raises a
TypeError."""

from __future__ import annotations

import operator
from typing import Any, Optional

import numpy as np

from .errors import InputError, UsageError


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
    """A contiguous array of unsigned 32-bit indices of shape (n, columns). An index out of that range is an
    InputError; the library says which is out of the range of the vertices."""
    array = _shaped(_array(values, what), what, columns)
    if array.size and array.dtype.kind not in "iu":
        raise TypeError(f"{what}: integers are needed, not {array.dtype}")
    if array.size:
        bad = np.argwhere((array < 0) | (array > np.iinfo(np.uint32).max))
        if len(bad):
            row, column = bad[0]
            place, text = f"row {row} (counted from 0)", f"the index {array[row, column]} is out of range"
            raise InputError(f"{what}: {place}: {text}", place=place, text=text)
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


def integer(value: Any, what: str, low: int = 0, high: int = 2**31 - 1) -> int:
    """The value as an integer, which must be from `low` to `high`."""
    try:
        number = operator.index(value)
    except TypeError:
        # Floats that are integers count, as 1e9 for bytes.
        if not (isinstance(value, (float, np.floating)) and float(value).is_integer()):
            raise TypeError(f"{what}: an integer is needed, not {value!r}") from None
        number = int(value)
    if not low <= number <= high:
        raise UsageError(f"{what}: an integer from {low} to {high} is needed, not {value!r}")
    return number


def number(value: Any, what: str) -> float:
    """The value as a number."""
    try:
        return float(operator.index(value) if hasattr(value, "__index__") else value)
    except (TypeError, ValueError):
        raise TypeError(f"{what}: a number is needed, not {value!r}") from None


def vector(values: Any, what: str, count: int) -> np.ndarray:
    """A contiguous array of doubles of shape (1, count), of `count` numbers."""
    array = _array(values, what)
    if array.shape != (count,):
        raise TypeError(f"{what}: {count} numbers are needed, this is an array of shape {array.shape}")
    return as_doubles(array.reshape(1, -1), what)


def of_shape(values: Any, what: str, shape: "tuple[Any, ...]") -> np.ndarray:
    """A contiguous array of doubles of a shape; None in it stands for any length."""
    array = _array(values, what)
    if len(array.shape) != len(shape) or any(a not in (None, b) for a, b in zip(shape, array.shape)):
        text = f"{what}: an array of shape {shape} is needed, this one is {array.shape}"
        raise TypeError(text.replace("None", "n"))
    return as_doubles(array, what)


def address(array: Optional[np.ndarray]) -> Optional[int]:
    """Where the numbers of a contiguous array are; None for None."""
    return None if array is None else array.ctypes.data

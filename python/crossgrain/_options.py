# SPDX-License-Identifier: Apache-2.0
"""Options of Python as handles of the library."""

from __future__ import annotations

import ctypes
import dataclasses
import math
import numbers
from typing import Any, Iterator, Optional, Tuple

import numpy as np

from . import _interface as c
from ._library import Handle, call, library, made
from .options import OtherStart, SolveOptions

_AXES = {"x": 0, "y": 1, "z": 2}


def flattened(options: Any, prefix: str = "") -> Iterator[Tuple[str, Any]]:
    """(name as in the C interface, value) of each member."""
    for member in dataclasses.fields(options):
        value = getattr(options, member.name)
        if dataclasses.is_dataclass(value) and not isinstance(value, OtherStart):
            yield from flattened(value, f"{prefix}{member.name}.")
        else:
            yield prefix + member.name, value


def _numbers_of(name: str, value: Any) -> Any:
    """The numbers of a value that has several."""
    if name == "cut" and isinstance(value, str):
        value = (value, None)
    if name == "cut":
        axis, position = value
        return [_AXES.get(axis, axis), math.nan if position is None else position]
    if name == "onto.other_starts":
        return [number for start in value for number in (start.cell_size, start.boundary_weight, start.most_vertices)]
    return value


def _set(handle: Handle, name: str, kind: int, value: Any) -> None:
    encoded = name.encode()
    if value is None:
        if kind == c.NUMBERS:
            call("options_set_numbers", handle, encoded, None, 0)
        return
    if kind == c.TEXT:
        text = ",".join(value) if isinstance(value, (list, tuple)) else value
        if not isinstance(text, str):
            raise TypeError(f"the option {name} takes a text, not {value!r}")
        call("options_set_text", handle, encoded, text.encode("utf-8", "surrogateescape"))
    elif kind == c.NUMBERS and not (name == "view" and isinstance(value, str)):
        try:
            array = np.atleast_1d(np.asarray(_numbers_of(name, value), dtype=np.float64)).ravel()
        except (TypeError, ValueError) as error:
            raise TypeError(f"the option {name} takes numbers, not {value!r}") from error
        call("options_set_numbers", handle, encoded, array.ctypes.data, array.size)
    elif isinstance(value, str):
        call("options_set_text", handle, encoded, value.encode())
    elif isinstance(value, (bool, np.bool_, numbers.Integral)):
        if not -2**63 <= int(value) < 2**63:
            raise TypeError(f"the option {name} takes an integer of 64 bits, not {value!r}")
        call("options_set_integer", handle, encoded, int(value))
    elif isinstance(value, numbers.Real):
        call("options_set_number", handle, encoded, float(value))
    else:
        raise TypeError(f"the option {name} takes a number, not {value!r}")


def types_of(kind: int) -> "dict[str, int]":
    """The type of each option of a kind, by name."""
    return {library.crossgrain_options_name(kind, i).decode(): library.crossgrain_options_type(kind, i)
            for i in range(library.crossgrain_options_count(kind))}


def handle_of(options: Any, kind: Optional[type] = None) -> Handle:
    """The options as a handle of the library. With `kind`, no others."""
    if kind is not None and not isinstance(options, kind):
        raise TypeError(f"{kind.__name__} is needed, not {type(options).__name__}")
    handle = made("options", "options_new", options._kind)
    types = types_of(options._kind)
    for name, value in flattened(options):
        _set(handle, name, types[name], value)
    return handle


def with_changes(options: Any, changes: "dict[str, Any]") -> Any:
    """A copy of options with members replaced that are not None. Unknown names raise a TypeError."""
    known = {member.name for member in dataclasses.fields(options)}
    for name in changes:
        if name not in known:
            raise TypeError(f"{type(options).__name__} has no member {name!r}; it has {', '.join(sorted(known))}")
    return dataclasses.replace(options, **{name: value for name, value in changes.items() if value is not None})


def solve_handle(options: SolveOptions, constraints: Any) -> Handle:
    """The options of a solve with constraints, and the forms that the page shows."""
    handle = handle_of(options, SolveOptions)
    if constraints is not None:
        call("options_set_constraints", handle, constraints)
    call("options_keep_forms_for_page", handle)
    return handle


def content(handle: Handle, name: str, kind: int) -> Any:
    """What an option of a handle has: a text or a list of numbers."""
    out = ctypes.c_void_p()
    if kind == c.TEXT:
        call("options_get_text", handle, name.encode(), ctypes.byref(out))
        try:
            return ctypes.cast(out, ctypes.c_char_p).value.decode()  # type: ignore[union-attr]
        finally:
            library.crossgrain_text_free(out)
    rows = made("numbers", "options_get_numbers", handle, name.encode())
    data = library.crossgrain_numbers_data(rows)
    count = library.crossgrain_numbers_rows(rows)
    return list((ctypes.c_double * count).from_address(data)) if count else []

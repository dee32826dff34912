# SPDX-License-Identifier: Apache-2.0
"""Options of Python as handles of the library."""

from __future__ import annotations

import dataclasses
import math
import numbers
from typing import Any, Iterator, Optional, Tuple

import numpy as np

from . import _interface as c
from ._library import Handle, call, library, made, text_bytes
from .options import SolveOptions, refuse_removed

_AXES = {"x": 0, "y": 1, "z": 2}


def flattened(options: Any, prefix: str = "") -> Iterator[Tuple[str, Any]]:
    """(name as in the C interface, value) of each member."""
    for member in dataclasses.fields(options):
        value = getattr(options, member.name)
        name = prefix + member.name
        inner = member.default_factory if dataclasses.is_dataclass(member.default_factory) else None
        if inner is None:
            yield name, value
        elif isinstance(value, inner):  # type: ignore[arg-type]
            yield from flattened(value, f"{name}.")
        else:
            its_type = inner.__name__  # type: ignore[union-attr]
            raise TypeError(f"the option {name} takes {its_type}, not {value!r}")


def _numbers_of(name: str, value: Any) -> Any:
    """The numbers of a value that has several."""
    if name == "cut":
        axis, position = (value, None) if isinstance(value, str) else value
        return [_AXES.get(axis, axis), math.nan if position is None else position]
    return value


def _set(handle: Handle, name: str, kind: int, value: Any) -> None:
    encoded = name.encode()
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if value is None:
        if kind != c.NUMBERS:
            raise TypeError(f"the option {name} takes a value, not None")
        call("options_set_numbers", handle, encoded, None, 0)
    elif kind == c.TEXT or (isinstance(value, str) and name != "cut"):
        text = ",".join(value) if isinstance(value, (list, tuple)) else value
        call("options_set_text", handle, encoded, text_bytes(text, f"the option {name}"))
    elif kind == c.NUMBERS:
        try:
            array = np.atleast_1d(np.asarray(_numbers_of(name, value), dtype=np.float64)).ravel()
        except (TypeError, ValueError) as error:
            raise TypeError(f"the option {name} takes numbers, not {value!r}: {error}") from error
        call("options_set_numbers", handle, encoded, array.ctypes.data, array.size)
    elif isinstance(value, (bool, np.bool_, numbers.Integral)):
        # As text, so that integers of any size come as they are.
        call("options_set_text" if kind != c.NUMBER else "options_set_number", handle, encoded,
             str(int(value)).encode() if kind != c.NUMBER else float(int(value)))
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


def set_changed(handle: Handle, options: Any, kind: type) -> None:
    """Gives a handle those members of options of its kind that are not defaults."""
    if not isinstance(options, kind):
        raise TypeError(f"{kind.__name__} is needed, not {type(options).__name__}")
    defaults, types = dict(flattened(kind())), types_of(kind._kind)  # type: ignore[attr-defined]
    for name, value in flattened(options):
        if value != defaults[name]:
            _set(handle, name, types[name], value)


def with_changes(options: Any, kind: type, changes: "dict[str, Any]") -> Any:
    """A copy of options of a kind, or of the defaults for None, with members replaced."""
    chosen = kind() if options is None else options
    if not isinstance(chosen, kind):
        raise TypeError(f"options: {kind.__name__} is needed, not {type(options).__name__}")
    known = {member.name for member in dataclasses.fields(chosen)}
    for name in changes:
        if name not in known:
            refuse_removed(kind, name)
            raise TypeError(f"{kind.__name__} has no member {name!r}; it has {', '.join(sorted(known))}")
    return dataclasses.replace(chosen, **changes)


def unless_none(**changes: Any) -> "dict[str, Any]":
    """Changes without those that are None."""
    return {name: value for name, value in changes.items() if value is not None}


def solve_handle(options: Any, constraints: Any, kind: type = SolveOptions) -> Handle:
    """The options of a solve, or those of a kind with a solve inside, with constraints, and the forms that
    the page shows."""
    handle = handle_of(options, kind)
    if constraints is not None:
        with constraints._lock:
            call("options_set_constraints", handle, constraints._handle)
    _set(handle, "for_page" if kind is SolveOptions else "solve.for_page", c.FLAG, True)
    return handle

# SPDX-License-Identifier: Apache-2.0
"""The shared library of the C interface: loading it, calling it, and what its handles own."""

from __future__ import annotations

import ctypes
import os
from pathlib import Path
from typing import Any, Optional

import numpy as np

from . import _interface as c
from . import errors

_ERRORS = {c.USAGE: errors.UsageError, c.INPUT: errors.InputError, c.OUTPUT: errors.OutputError,
           c.LIMIT: errors.LimitError, c.INTERRUPTED: errors.Interrupted, c.INTERNAL: errors.InternalError}


def _library_path() -> str:
    """The library inside this package, as in wheels; that of the same prefix, as where CMake installs both;
    or that of the system."""
    package = Path(__file__).resolve().parent
    prefix_libraries = package.parents[2] if len(package.parents) > 2 else package
    for folder in (package / "lib", prefix_libraries, *sorted(prefix_libraries.glob("*-linux-gnu*"))):
        if (folder / c.LIBRARY).is_file():
            return str(folder / c.LIBRARY)
    return c.LIBRARY


def _load() -> ctypes.CDLL:
    name = os.environ.get("CROSSGRAIN_LIBRARY") or _library_path()
    try:
        library = ctypes.CDLL(name)
    except OSError as error:
        raise ImportError(f"crossgrain cannot load its library {name}: {error}") from error
    if library.crossgrain_c_version() != c.C_VERSION:
        raise ImportError(f"{name} has version {library.crossgrain_c_version()} of the C interface, this "
                          f"package needs {c.C_VERSION}; install both from the same release")
    for function, (result, arguments) in c.FUNCTIONS.items():
        getattr(library, function).restype = result
        getattr(library, function).argtypes = arguments
    return library


library = _load()


def _text(encoded: Optional[bytes]) -> str:
    return (encoded or b"").decode("utf-8", "surrogateescape")


def raise_for(status: int, error: ctypes.c_void_p) -> None:
    """Raises the exception of a status that is not OK."""
    if status == c.OK:
        return
    kind = _ERRORS.get(status, errors.InternalError)
    if not error.value:
        raise kind("out of memory" if status == c.LIMIT else "the library failed without a message")
    content = ctypes.cast(error, ctypes.POINTER(c.crossgrain_error)).contents
    names = ("sentence", "file", "place", "text", "remedy", "remedy_name")
    parts = [_text(getattr(content, name)) for name in names]
    library.crossgrain_error_free(error)
    raise kind(*parts)


def call(name: str, *arguments: Any) -> None:
    """Calls crossgrain_NAME with a place for the error, and raises that."""
    error = ctypes.c_void_p()
    try:
        status = getattr(library, f"crossgrain_{name}")(*arguments, ctypes.byref(error))
    except ctypes.ArgumentError as failure:
        raise TypeError(f"{name}: {failure}") from None
    raise_for(status, error)


class Handle:
    """Owns a handle of the library and releases it when it goes."""

    def __init__(self, kind: str, address: Optional[int]):
        self.kind, self.address = kind, address

    def of_kind(self, kind: str) -> "Handle":
        """This handle, which must be of a kind: the library cannot tell."""
        if not isinstance(self, Handle) or self.kind != kind:
            raise TypeError("this class is made by the functions of the package, not by its users")
        return self

    def __del__(self) -> None:
        # At the end of the interpreter the library may be gone before.
        if self.address and library is not None:
            getattr(library, f"crossgrain_{self.kind}_free")(self.address)
            self.address = None

    def __reduce__(self) -> Any:
        raise TypeError("objects of crossgrain cannot be pickled; write them to a folder with write(), and "
                        "read() that")

    @property
    def _as_parameter_(self) -> Optional[int]:
        return self.address


def made(kind: str, name: str, *arguments: Any) -> Handle:
    """The handle that crossgrain_NAME(*arguments, out, error) makes."""
    out = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(out))
    return Handle(kind, out.value)


def text_from(name: str, *arguments: Any) -> str:
    """The text that crossgrain_NAME(*arguments, out, error) returns."""
    out = ctypes.c_void_p()
    call(name, *arguments, ctypes.byref(out))
    try:
        return _text(ctypes.cast(out, ctypes.c_char_p).value)
    finally:
        library.crossgrain_text_free(out)


def text_bytes(text: str, what: str) -> bytes:
    """A text for the library, which ends texts with a zero byte."""
    if not isinstance(text, str):
        raise TypeError(f"{what}: a text is needed, not {text!r}")
    if "\0" in text:
        raise errors.UsageError(f"{what} contains a zero byte")
    return text.encode("utf-8", "surrogateescape")


def path_bytes(path: Any) -> bytes:
    """A path of a file for the library."""
    encoded = os.fsencode(path)
    if b"\0" in encoded:
        raise errors.UsageError("a path contains a zero byte")
    return encoded


def handle_in(value: Any, kind: Any, what: str) -> Optional[Handle]:
    """The handle of an object that must be of a class, or None for None."""
    if value is None:
        return None
    if not isinstance(value, kind):
        raise TypeError(f"{what}: a {kind.__name__} is needed, not {type(value).__name__}")
    return value._handle


class _View:
    """Memory of a handle as NumPy takes it. The array refers to this object, and so keeps the handle."""

    def __init__(self, owner: Any, address: int, dtype: Any, shape: tuple):
        self.owner = owner
        self.__array_interface__ = {"data": (address, True), "typestr": np.dtype(dtype).str, "shape": shape,
                                    "version": 3}


def view(owner: Any, address: Optional[int], dtype: Any, shape: tuple) -> Optional[np.ndarray]:
    """A read-only array of memory that belongs to a handle; None for none. The owner lives as long as the
    array."""
    if not address:
        return None
    return np.asarray(_View(owner, address, dtype, shape))


def array_view(owner: Any, address: Optional[int], dtype: Any, shape: tuple) -> np.ndarray:
    """The same, with an array of no elements for none."""
    array = view(owner, address, dtype, shape)
    return np.zeros(shape, dtype) if array is None else array


def frozen(array: np.ndarray) -> np.ndarray:
    """The array, read-only: it is kept and given to all who ask."""
    array.flags.writeable = False
    return array

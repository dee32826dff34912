# SPDX-License-Identifier: Apache-2.0
"""The shared library of the C interface: loading it, calling it, and what its handles own."""

from __future__ import annotations

import ctypes
import os
import queue
import threading
from pathlib import Path
from typing import Any, Callable, Optional

import numpy as np

from . import _interface as c
from . import errors

_ERRORS = {
    c.USAGE: errors.UsageError, c.INPUT: errors.InputError, c.OUTPUT: errors.OutputError, c.LIMIT: errors.LimitError,
    c.INTERRUPTED: errors.Interrupted, c.INTERNAL: errors.InternalError,
}


def _library_path() -> str:
    """The library inside this package, as in wheels; that of the same prefix, as where CMake installs both; or that of the system."""
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
        raise ImportError(f"{name} has version {library.crossgrain_c_version()} of the C interface, this package needs {c.C_VERSION};"
                          " install both from the same release")
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
    parts = [_text(getattr(content, name)) for name in ("sentence", "file", "place", "text", "remedy", "remedy_name")]
    library.crossgrain_error_free(error)
    raise kind(*parts)


def call(name: str, *arguments: Any) -> None:
    """Calls crossgrain_NAME with a place for the error, and raises that."""
    error = ctypes.c_void_p()
    raise_for(getattr(library, f"crossgrain_{name}")(*arguments, ctypes.byref(error)), error)


class Handle:
    """Owns a handle of the library and releases it when it goes."""

    def __init__(self, kind: str, address: Optional[int]):
        self.kind, self.address = kind, address

    def __del__(self) -> None:
        # At the end of the interpreter the library may be gone before.
        if self.address and library is not None:
            getattr(library, f"crossgrain_{self.kind}_free")(self.address)
            self.address = None

    def __reduce__(self) -> Any:
        raise TypeError("objects of crossgrain cannot be pickled; write them to a folder with write(), and read() that")

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


def path_bytes(path: Any) -> bytes:
    """A path of a file for the library."""
    encoded = os.fsencode(path)
    if b"\0" in encoded:
        raise errors.UsageError("a path contains a zero byte")
    return encoded


class _View:
    """Memory of a handle as NumPy takes it. The array refers to this object, and so keeps the handle."""

    def __init__(self, owner: Any, address: int, dtype: Any, shape: tuple):
        self.owner = owner
        self.__array_interface__ = {"data": (address, True), "typestr": np.dtype(dtype).str, "shape": shape, "version": 3}


def view(owner: Any, address: Optional[int], dtype: Any, shape: tuple) -> Optional[np.ndarray]:
    """A read-only array of memory that belongs to a handle; None for none. The owner lives as long as the array."""
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


class Progress:
    """What a computation is at."""

    PHASES = ("read", "grid", "solve", "analysis", "tets", "write")

    def __init__(self, content: Any):
        self.phase: str = self.PHASES[content.phase]
        self.depth: int = content.depth
        self.level: int = content.level
        self.levels: int = content.levels
        self.sweep: int = content.sweep
        self.cells: int = content.cells
        self.energy: float = content.energy

    def __repr__(self) -> str:
        return f"Progress({self.phase!r}, level={self.level}/{self.levels}, sweep={self.sweep}, cells={self.cells}, energy={self.energy:.6g})"


class Monitor:
    """Hears of a computation on the thread that makes it, and cancels it."""

    def __init__(self, listener: Optional[Callable[[Any], None]]):
        self.failure: Optional[BaseException] = None

        def hear(content: Any, _state: Any) -> int:
            # No exception may pass through the library.
            try:
                if listener is not None:
                    listener(Progress(content.contents))
            except BaseException as failure:  # pylint: disable=broad-except
                self.failure = failure
                return 1
            return 0

        # Refers to the function that the library calls.
        self.heard = c.crossgrain_on_progress(hear)
        self.handle = made("monitor", "monitor_new", self.heard, c.crossgrain_on_expectation(0), None)

    def cancel(self) -> None:
        library.crossgrain_monitor_cancel(self.handle)


def _is_main_thread() -> bool:
    return threading.current_thread() is threading.main_thread()


def watched(work: Callable[[Monitor], Any], progress: Optional[Callable[[Progress], None]] = None) -> Any:
    """Returns work(monitor), a long call of the library, while Ctrl-C works and `progress` is called on this thread.

    Signals reach Python on the main thread only, and not inside a call of C. So a call from there is made on a thread of
    its own, while this one waits for it: Ctrl-C cancels it and raises KeyboardInterrupt once it has ended.
    """
    if not _is_main_thread():
        return _passed_on(Monitor(progress), work)
    events: queue.SimpleQueue = queue.SimpleQueue()
    monitor = Monitor(None if progress is None else events.put)
    result: list = []

    def run() -> None:
        try:
            result.append((work(monitor), None))
        except BaseException as failure:  # pylint: disable=broad-except
            result.append((None, failure))
        events.put(None)

    worker = threading.Thread(target=run, name="crossgrain", daemon=True)
    interruption: Optional[BaseException] = None
    try:
        worker.start()
    except BaseException as failure:  # pylint: disable=broad-except
        # Ctrl-C may come when the thread has been made and has not begun.
        monitor.cancel()
        if not worker.is_alive():
            raise
        interruption = failure
    while True:
        try:
            event = events.get()
            if event is None:
                break
            if interruption is None:
                progress(event)  # type: ignore[misc]
        except BaseException as failure:  # pylint: disable=broad-except
            # Ctrl-C, or a failure of `progress`: the call ends soon, and is waited for.
            interruption = interruption or failure
            monitor.cancel()
    worker.join()
    value, error = result[0]
    if interruption is not None:
        raise interruption
    if error is not None:
        raise error
    return value


def _passed_on(monitor: Monitor, work: Callable[[Monitor], Any]) -> Any:
    try:
        return work(monitor)
    except errors.Interrupted:
        if monitor.failure is not None:
            raise monitor.failure from None
        raise

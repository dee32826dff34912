# SPDX-License-Identifier: Apache-2.0
"""What the library raises for what a user can cause."""

from __future__ import annotations

from contextlib import contextmanager
from typing import Iterator


class Error(Exception):
    """A failure of the library. ``str()`` of it is one line: the file, the place in it, what is wrong and
    what to do."""

    file: str
    """The file that it is about; empty if it is about none."""

    place: str
    """In the file or the object: ``"line 12"``, ``"vertex 7 (counted from 0)"``; empty for all of it."""

    text: str
    """What is wrong."""

    remedy: str
    """What to do about it, in words; may be empty."""

    remedy_name: str
    """The same as a name that does not change with the words: ``"raise_resolution"``."""

    def __init__(self, sentence: str, file: str = "", place: str = "", text: str = "", remedy: str = "",
                 remedy_name: str = ""):
        super().__init__(sentence)
        self.file, self.place, self.text = file, place, text or sentence
        self.remedy, self.remedy_name = remedy, remedy_name


    def with_file(self, file: str) -> "Error":
        """The error with the file that the model came from, which the library does not know for objects in
        memory."""
        if self.file or not file:
            return self
        return type(self)(f"{file}: {self}", file, self.place, self.text, self.remedy, self.remedy_name)


class UsageError(Error, ValueError):
    """An invalid argument or option."""


class InputError(Error, ValueError):
    """A file, mesh or field that cannot be used."""


class OutputError(Error, OSError):
    """A result that cannot be written."""


class LimitError(Error, MemoryError):
    """A stated limit or the memory is exceeded."""


class Interrupted(Error):
    """A computation was stopped or cancelled. Ctrl-C raises KeyboardInterrupt instead."""


class InternalError(Error, RuntimeError):
    """A fault of the library; please report it."""


@contextmanager
def naming(file: str) -> Iterator[None]:
    """Errors about the model name its file."""
    try:
        yield
    except InputError as error:
        raise error.with_file(file) from None

# SPDX-License-Identifier: Apache-2.0
"""Long calls of the library: progress out of them, Ctrl-C into them."""

from __future__ import annotations

import _thread
import atexit
import queue
import threading
from typing import Any, Callable, Optional

from . import _interface as c
from . import errors
from ._library import library, made


class Progress:
    """What a computation is at."""

    PHASES = ("read", "grid", "solve", "analysis", "tets", "write", "make tets", "repair", "map", "hexahedra",
              "smooth")
    OUTCOMES = ("all-hex", "approximate", "partial", "none")  # HexOutcome

    def __init__(self, content: Any):
        self.phase: str = self.PHASES[content.phase]
        self.depth: int = content.depth
        self.level: int = content.level
        self.levels: int = content.levels
        self.sweep: int = content.sweep
        self.cells: int = content.cells
        self.energy: float = content.energy
        # What is done of the phase, from 0 to 1; negative if it is not known.
        self.share: float = content.share
        # Of a search for hexahedra: number of the attempt at a mesh, from 1, 0 outside of one; number of its
        # tets, from 1, and of how many sizes tets are made at most; hexahedra of the best mesh so far, and
        # what it is.
        self.attempt: int = content.attempt
        self.tets: int = content.tets
        self.most_tets: int = content.most_tets
        self.hexahedra: int = content.hexahedra
        self.outcome: str = self.OUTCOMES[content.outcome]
        # Hexahedra that are put onto the model, with their layers; 0 before that is known.
        self.fitted: int = content.fitted

    def __repr__(self) -> str:
        return (f"Progress({self.phase!r}, level={self.level}/{self.levels}, sweep={self.sweep}, "
                f"cells={self.cells}, energy={self.energy:.6g})")


class Monitor:
    """Hears of a computation on the thread that makes it, and cancels it."""

    def __init__(self, listener: Optional[Callable[[Any], None]]):
        self.failure: Optional[BaseException] = None
        self.ended = threading.Event()

        def hear(content: Any, _state: Any) -> int:
            # No exception may pass through the library.
            try:
                listener(Progress(content.contents))  # type: ignore[misc]
            except BaseException as failure:  # pylint: disable=broad-except
                self.failure = failure
                return 1
            return 0

        # Refers to the function that the library calls. Without a listener it calls none, which would ask for
        # the GIL.
        self.heard = c.crossgrain_on_progress(0) if listener is None else c.crossgrain_on_progress(hear)
        self.handle = made("monitor", "monitor_new", self.heard, c.crossgrain_on_expectation(0), None)

    def cancel(self) -> None:
        library.crossgrain_monitor_cancel(self.handle)

    def run(self, work: Callable[["Monitor"], Any]) -> Any:
        """work(self), known to be running until it ends."""
        _running.add(self)
        try:
            return work(self)
        except errors.Interrupted:
            if self.failure is not None:
                raise self.failure from None
            raise
        finally:
            _running.discard(self)
            self.ended.set()


# Computations that go on, on any thread.
_running: "set[Monitor]" = set()

# How long a computation takes to end once it is cancelled, and much more.
_LONGEST_END_SECONDS = 20


@atexit.register
def _end_all() -> None:
    """Ends what daemon threads still compute: a call that came back into an interpreter that is gone would
    crash."""
    for monitor in list(_running):
        monitor.cancel()
    for monitor in list(_running):
        monitor.ended.wait(_LONGEST_END_SECONDS)


class _Worker:
    """A call on a thread of its own: `events` while it goes on, `is_done` once it has ended, with a value or
    an error.

    An exception of a signal handler may come between any two steps of the thread that waits, so that those of
    threading.Thread could lose the thread. Here each step is one of C, and may be repeated.
    """

    def __init__(self, work: Callable[[Monitor], Any], wants_events: bool):
        self.events: queue.SimpleQueue = queue.SimpleQueue()
        self.monitor = Monitor(self.events.put if wants_events else None)
        self.work = work
        self.is_taken = _thread.allocate_lock()
        self.is_done = False
        self.value: Any = None
        self.error: Optional[BaseException] = None

    def start(self) -> None:
        """Starts the thread; called again, one that ends at once."""
        try:
            _thread.start_new_thread(self._run, ())
        except RuntimeError as failure:
            if self.is_taken.acquire(blocking=False):
                self.error, self.is_done = failure, True

    def _run(self) -> None:
        if not self.is_taken.acquire(blocking=False):
            return
        try:
            self.value = self.monitor.run(self.work)
        except BaseException as failure:  # pylint: disable=broad-except
            self.error = failure
        self.is_done = True
        self.events.put(None)


# A wake-up may be lost where Ctrl-C comes just then.
_LOOK_SECONDS = 0.5


def watched(work: Callable[[Monitor], Any], progress: Optional[Callable[[Progress], None]] = None) -> Any:
    """Returns work(monitor), a long call of the library, while Ctrl-C works and `progress` is called on this
    thread.

    Signals reach Python on the main thread only, and not inside a call of C. So a call from there is made on
    a thread of its own, while this one waits for it: Ctrl-C cancels it and raises KeyboardInterrupt once it
    has ended. Nothing but its end leaves the wait, since the call writes to arrays that its caller owns.
    """
    if threading.current_thread() is not threading.main_thread():
        return Monitor(progress).run(work)
    worker = _Worker(work, progress is not None)
    interruption: Optional[BaseException] = None
    is_begun = False
    while not worker.is_done:
        try:
            if not is_begun:
                worker.start()
                is_begun = True
            while not worker.is_done or not worker.events.empty():
                try:
                    event = worker.events.get(timeout=_LOOK_SECONDS)
                except queue.Empty:
                    continue
                if event is not None and progress is not None and interruption is None:
                    progress(event)
        except BaseException as failure:  # pylint: disable=broad-except
            # Ctrl-C, or a failure of `progress`: the call ends soon, and is waited for.
            interruption = interruption or failure
            worker.monitor.cancel()
    if interruption is not None:
        raise interruption
    if worker.error is not None:
        raise worker.error
    return worker.value

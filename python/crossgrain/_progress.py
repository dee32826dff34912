# SPDX-License-Identifier: Apache-2.0
"""The bar that shows how far a solve is, where tqdm is installed."""

from __future__ import annotations

import sys
from contextlib import contextmanager
from typing import Any, Callable, Iterator, Optional, Union

from ._watched import Progress

ProgressOption = Union[None, bool, Callable[[Progress], None]]

# Shorter solves show none.
_DELAY_SECONDS = 1


def _is_watched() -> bool:
    """Whether somebody sees a bar: in a terminal or a notebook."""
    return sys.stderr.isatty() or "ipykernel" in sys.modules


def _tqdm() -> Any:
    """The bar that suits where it is shown; None where tqdm is not installed."""
    try:
        import tqdm
    except ImportError:
        return None
    if "ipykernel" in sys.modules:
        try:
            # What draws the bar of notebooks.
            import ipywidgets  # noqa: F401
            from tqdm.notebook import tqdm as notebook_bar
            return notebook_bar
        except ImportError:
            pass
    return tqdm.tqdm


class _Bar:
    """Levels done, of those expected; beside them what the solve is at."""

    def __init__(self, tqdm: Any):
        self.bar = tqdm(total=1, unit="level", delay=_DELAY_SECONDS, leave=False)

    def __call__(self, progress: Progress) -> None:
        if progress.levels:
            self.bar.total = progress.levels
            self.bar.n = max(self.bar.n, progress.level - 1)
        if progress.phase in ("analysis", "tets", "repair", "map", "hexahedra", "smooth", "write"):
            self.bar.n = self.bar.total
        self.bar.set_description(progress.phase, refresh=False)
        self.bar.set_postfix(cells=progress.cells, sweep=progress.sweep, refresh=False)
        self.bar.update(0)

    def close(self) -> None:
        self.bar.close()


@contextmanager
def listener(progress: ProgressOption) -> Iterator[Optional[Callable[[Progress], None]]]:
    """What hears of the progress: the caller's function, a bar, or nothing. By default a bar where somebody
    sees it."""
    if callable(progress):
        yield progress
        return
    bar = None
    if progress or (progress is None and _is_watched()):
        tqdm = _tqdm()
        bar = tqdm and _Bar(tqdm)
    try:
        yield bar
    finally:
        if bar is not None:
            bar.close()

# SPDX-License-Identifier: Apache-2.0
"""How frames of neighbouring tets go on in each other."""

from __future__ import annotations

from functools import cached_property

import numpy as np

from ._library import Handle, array_view, frozen, library


class Matchings:
    """How the axes of the frames of neighbouring tets go on in each other, across each face between two tets,
    ascending by its vertices."""

    def __init__(self, handle: Handle):
        count = library.crossgrain_matchings_count(Handle.of_kind(handle, "matchings"))
        self.faces: np.ndarray = array_view(handle, library.crossgrain_matchings_faces(handle), np.uint32,
                                            (count, 3))
        """Vertices of each face, ascending, (f, 3)."""
        self.tets: np.ndarray = array_view(handle, library.crossgrain_matchings_tets(handle), np.uint32,
                                           (count, 2))
        """The two tets, (f, 2)."""
        self.axes: np.ndarray = array_view(handle, library.crossgrain_matchings_axes(handle), np.int8,
                                           (count, 3))
        """Axis k of the first tet goes on in the second as its axis ``abs(axes[f, k])``, counted from 1, with
        the sign of ``axes[f, k]``: as in .perm files, (f, 3)."""

    def __len__(self) -> int:
        return len(self.tets)

    @cached_property
    def matrices(self) -> np.ndarray:
        """The same as matrices, (f, 3, 3): ``matrices[f] @ frames[tets[f, 1]]`` are the axes of the second
        tet in the names of the first."""
        result = np.zeros((len(self), 3, 3))
        rows = np.arange(len(self))[:, None]
        result[rows, np.arange(3)[None], np.abs(self.axes).astype(np.intp) - 1] = np.sign(self.axes)
        return frozen(result)

    @property
    def are_identities(self) -> np.ndarray:
        """Whether each is the identity, (f,)."""
        return (self.axes == np.array([1, 2, 3], np.int8)).all(axis=1)

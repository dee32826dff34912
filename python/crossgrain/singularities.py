# SPDX-License-Identifier: Apache-2.0
"""The singular graph of a field, and whether hexahedra can follow it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, List, Optional, Tuple

import numpy as np

from ._library import Handle, _text, array_view, library, made, path_bytes
from .vtk_data import polydata_of

VERDICTS = ("meshable", "not_meshable", "undecided")
ARC_TYPES = ("regular", "changing", "no_axis")
_VALENCES = {0.25: 3, -0.25: 5, 0.5: 2, -0.5: 6}


@dataclass(frozen=True, eq=False)
class Arc:
    """A singular arc: a smooth curve around which frames rotate."""

    points: np.ndarray
    """(n, 3); a closed arc ends with its first point."""

    vertices: np.ndarray
    """The vertex of the tet mesh behind each point, (n,); -1 on grids and at nodes."""

    axes: np.ndarray
    """At each point, the axis about which the frames rotate around the arc, (n, 3): unit, turned along the
    arc; zero where they rotate about no axis of theirs, and if read from a file."""

    turning_points: np.ndarray
    """Indices into `points` where the rotation changes its sense, ascending."""

    type: str
    """``"regular"``: the frames rotate by a quarter or half turn, of one sense along the arc, as in a
    hexahedral mesh; ``"changing"``: of different senses on different parts; ``"no_axis"``: by a third or half
    turn about a diagonal of the frame."""

    index: float
    """Rotation of the frames around the arc in full turns: +1/4 for valence 3, -1/4 for valence 5. 0 unless
    regular."""

    verdict: str
    """``"meshable"``, ``"not_meshable"`` or ``"undecided"``."""

    length: float
    """Length of the smooth curve, model units."""

    length_cells: float
    """Length of its edges in sizes of the cells there; 0 if read from a file."""

    oblique_length: float
    """Length of the part where the axis is more than 45 degrees off the arc."""

    nodes: Optional[Tuple[int, int]]
    """Nodes at the first and the last point; None for a closed arc without nodes."""

    @property
    def is_closed(self) -> bool:
        """Whether it has no ends."""
        return self.nodes is None

    @property
    def valence(self) -> Optional[int]:
        """Number of hexahedra around the arc; None unless regular."""
        return _VALENCES.get(self.index)


@dataclass(frozen=True, eq=False)
class Node:
    """An end of arcs: inside, where several meet, or on the surface."""

    place: np.ndarray
    """(3,)"""

    on_boundary: bool
    """Whether an arc reaches the surface here."""

    verdict: str
    """Whether hexahedra can meet with these arcs."""

    arcs: Tuple[int, ...]
    """Arcs that end here, ascending; one with both ends here is listed twice."""


class SingularityGraph:
    """The singular graph of a field: arcs, and the nodes where they end. The order of the lists depends on
    the field only."""

    def __init__(self, handle: Handle):
        self._handle = Handle.of_kind(handle, "graph")
        summary = library.crossgrain_graph_summary_of(handle).contents
        self.verdict: str = VERDICTS[summary.verdict]
        """The verdict of the worst arc or node."""
        self.edges: int = summary.edges
        """Number of singular edges of the grid or the tets."""
        self.edge_length: float = summary.edge_length
        """Sum of the lengths of the singular edges."""
        self.unresolved_loops: int = summary.unresolved_loops
        """Number of closed arcs too short to be resolved; not among the arcs."""
        self.unresolved_stubs: int = summary.unresolved_stubs
        """Number of short arcs of third turns from surface to surface; not among the arcs."""
        self.crease_hooks: int = summary.crease_hooks
        """Number of short arcs from surface to surface along a crease; not among the arcs."""
        self.contacts: int = summary.contacts
        """Number of places where an arc that runs along the surface touches it."""
        self.arcs: List[Arc] = [self._arc(i) for i in range(summary.arcs)]
        self.nodes: List[Node] = [self._node(i) for i in range(summary.nodes)]

    def _arc(self, i: int) -> Arc:
        arc = library.crossgrain_graph_arc(self._handle, i).contents

        def array(at: Any, dtype: Any, *shape: int) -> np.ndarray:
            return array_view(self._handle, at, dtype, shape)

        return Arc(points=array(arc.points, np.float64, arc.point_count, 3),
                   vertices=array(arc.vertices, np.int64, arc.point_count),
                   axes=array(arc.axes, np.float64, arc.point_count, 3),
                   turning_points=array(arc.turning_points, np.uint32, arc.turning_count),
                   type=ARC_TYPES[arc.type], index=arc.index, verdict=VERDICTS[arc.verdict],
                   length=arc.length, length_cells=arc.length_cells, oblique_length=arc.oblique_length,
                   nodes=None if arc.is_closed else (arc.nodes[0], arc.nodes[1]))

    def _node(self, i: int) -> Node:
        node = library.crossgrain_graph_node(self._handle, i).contents
        arcs = array_view(self._handle, node.arcs, np.uint32, (node.arc_count,))
        return Node(np.array(node.place), bool(node.on_boundary), VERDICTS[node.verdict],
                    tuple(arcs.tolist()))

    def __repr__(self) -> str:
        counts = f"{len(self.arcs)} arcs, {len(self.nodes)} nodes"
        return f"<crossgrain.SingularityGraph: {counts}, {self.verdict}>"

    def to_vtk(self) -> Any:
        """A vtkPolyData with a polyline per arc, its index, type and verdict as cell data."""
        return polydata_of([arc.points for arc in self.arcs], {
            "index": np.array([arc.index for arc in self.arcs], np.float64),
            "type": np.array([ARC_TYPES.index(arc.type) for arc in self.arcs], np.uint8),
            "verdict": np.array([VERDICTS.index(arc.verdict) for arc in self.arcs], np.uint8)})


def read_singularities(path: Any) -> SingularityGraph:
    """Reads the singular graph of a whole field from singularities.vtu or onto_singularities.vtu."""
    return SingularityGraph(made("graph", "graph_read", path_bytes(path)))


@dataclass(frozen=True, eq=False)
class Reason:
    """Why a field is not meshable or undecided."""

    kind: str
    """A name such as ``"knife_edge"`` (docs/report.md)."""
    verdict: str
    """``"not_meshable"`` or ``"undecided"``."""
    count: int
    """Number of places with this fault; 0 if it is about no place."""
    place: Optional[np.ndarray]
    """The first or worst one, (3,); None if it is about no place."""
    text: str
    next: str
    """What to do, in words; may be empty."""
    remedy: str
    """A name for it, such as ``"use_resolution"``; ``"none"`` if there is nothing to do."""
    remedy_number: float
    """The resolution or the length of edges to use; 0 for other remedies."""


class Answer:
    """Whether a hexahedral mesh can follow a field locally: necessary for a mesh, not sufficient. ``str()``
    of it is one line."""

    def __init__(self, handle: Handle):
        self.verdict: str = VERDICTS[library.crossgrain_answer_verdict(Handle.of_kind(handle, "answer"))]
        """``"meshable"``, ``"not_meshable"`` or ``"undecided"``."""
        self.sentence: str = _text(library.crossgrain_answer_sentence(handle))
        """The answer in one line."""
        self.reasons: List[Reason] = []
        """Those of the verdict first; empty if meshable."""
        while True:
            found = library.crossgrain_answer_reason(handle, len(self.reasons))
            if not found:
                break
            reason = found.contents
            self.reasons.append(Reason(_text(reason.kind), VERDICTS[reason.verdict], reason.count,
                                       np.array(reason.place) if reason.count else None, _text(reason.text),
                                       _text(reason.next), _text(reason.remedy), reason.remedy_number))

    def __str__(self) -> str:
        return self.sentence

    def __repr__(self) -> str:
        return f"<crossgrain.Answer: {self.sentence}>"

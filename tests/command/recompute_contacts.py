# SPDX-License-Identifier: Apache-2.0
"""Counts the gaps at the surface of a grid over which singular lines continue (`singularity.contacts`)."""

from itertools import combinations

import numpy as np
from frame_math import matching

# kTouchCells and kTouchAsideCells (singularity/singularity_tuning.hpp), and what docs/singularities.md says of them.
REACH, ASIDE, BEHIND = 3, 1.5, 0.5
LAST_EDGES = 5
DETOUR = 2
ONE_LINE = np.sqrt(0.5)


class Turn:
    """How frames rotate on the way around an edge: `product` of the matchings, seen in the first cell, whose frame has the
    rows `way[0]`; `way` are the axes of the four cells in turn."""

    def __init__(self, product, way):
        self.trace = int(round(np.trace(product)))
        self.is_swap = round(np.linalg.det(np.abs(product))) < 0 and self.trace == -1
        values, vectors = np.linalg.eig(product)
        axis = np.real(vectors[:, np.argmin(abs(values - 1))])
        sense = rotation_vector(product)
        if self.trace == -1:
            self.axis = way[0].T @ axis
            sense = sum(small_turn(way[k], way[(k + 1) % 4]) for k in range(4))
            self.axis *= 1 if sense @ self.axis >= 0 else -1
        else:
            self.axis = way[0].T @ (axis if sense @ axis > 0 else -axis)

    def is_like(self, other, senses):
        """Whether it is the same for directions along the edges that these signs give."""
        return (self.trace, self.is_swap) == (other.trace, other.is_swap) and senses * (self.axis @ other.axis) > ONE_LINE


def rotation_vector(rotation):
    skew = rotation - rotation.T
    return np.array([skew[2, 1], skew[0, 2], skew[1, 0]])


def small_turn(axes_from, axes_to):
    return rotation_vector(axes_to.T @ matching(axes_from, axes_to) @ axes_from)


class Lines:
    """Singular edges {(start, axis, width): Turn}, in units of the smallest possible cell."""

    def __init__(self, edges):
        self.turns = edges
        self.at = {}
        for edge in edges:
            for end in self.ends_of(edge):
                self.at.setdefault(end, []).append(edge)

    @staticmethod
    def ends_of(edge):
        start, axis, width = edge
        return start, tuple(x + width * (k == axis) for k, x in enumerate(start))

    def ends(self):
        return sorted(point for point, edges in self.at.items() if len(edges) == 1)

    def size(self, end):
        return self.at[end][0][2]

    def sense(self, end):
        """1 if the line leaves along its last edge's axis, else -1."""
        return -1 if self.ends_of(self.at[end][0])[0] == end else 1

    def are_alike(self, a, b):
        # A line that arrives at one end leaves from the other.
        return self.turns[self.at[a][0]].is_like(self.turns[self.at[b][0]], -self.sense(a) * self.sense(b))

    def direction(self, end):
        """In which a line leaves, from its last edges."""
        place, edge = end, self.at[end][0]
        for _ in range(LAST_EDGES - 1):
            place = next(x for x in self.ends_of(edge) if x != place)
            if len(self.at[place]) != 2:
                break
            edge = next(x for x in self.at[place] if x != edge)
        return np.subtract(end, place) / np.linalg.norm(np.subtract(end, place))

    def leads(self, end, other):
        gap = np.subtract(other, end) / self.size(end)
        forward = gap @ self.direction(end)
        aside = np.linalg.norm(gap - forward * self.direction(end))
        return forward >= -BEHIND and np.linalg.norm(gap) <= REACH and aside <= ASIDE


def cells_apart(lines, a, b):
    return 2 * np.linalg.norm(np.subtract(a, b)) / (lines.size(a) + lines.size(b))


def is_joined(field, lines, a, b):
    """Whether cells joined through open faces lead from one end to the other, within a box around the two."""
    step = min(lines.size(a), lines.size(b)) // 2 or 1
    low = np.minimum(a, b) - 2 * DETOUR * step
    high = np.maximum(a, b) + 2 * DETOUR * step
    cells = set()
    for place in np.ndindex(*((high - low) // step)):
        corner = low + np.array(place) * step
        if corner.min() >= 0 and corner.max() < 1 << 19:
            cell = field.containing(19 - (step.bit_length() - 1), [int(x) // step for x in corner])
            if cell is not None:
                cells.add(cell)
    reached = {cell for cell in cells if touches(field, cell, a)}
    waiting = list(reached)
    while waiting:
        cell = waiting.pop()
        for other in cells - reached:
            if any(field.neighbour(x, face) == y and field.joined(x, face, y)
                   for x, y in ((cell, other), (other, cell)) for face in range(6)):
                reached.add(other)
                waiting.append(other)
    return any(touches(field, cell, b) for cell in reached)


def touches(field, cell, point):
    width = 1 << (19 - int(field.depth[cell]))
    return all(width * x <= p <= width * (x + 1) for x, p in zip(field.place[cell], point))


def contacts(field, edges):
    """How many pairs of ends are taken, the nearest first and each end once."""
    lines = Lines(edges)
    pairs = [(round(cells_apart(lines, a, b), 9), a, b) for a, b in combinations(lines.ends(), 2)
             if cells_apart(lines, a, b) <= REACH]
    taken = set()
    count = 0
    for _, a, b in sorted(pairs):
        if taken & {a, b} or not (lines.leads(a, b) and lines.leads(b, a) and lines.are_alike(a, b)):
            continue
        if is_joined(field, lines, a, b):
            taken |= {a, b}
            count += 1
    return count

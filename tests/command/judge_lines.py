# SPDX-License-Identifier: Apache-2.0
"""Singular edges of a field on tets: kinds, senses, and what arcs of them mean (docs/singularities.md).

A quarter turn about an axis of the frames, right-handed about the arc, leaves three hexahedra, the other way five; half turns
two and six.
"""

from collections import defaultdict

import numpy as np

from frame_math import CUBE_ROTATIONS
from judge_mesh import unit

SIGN_COSINE, SIGN_CELLS = 0.2, 2
MERGE_CELLS, LOOP_CELLS = 2.5, 6
OBLIQUE_COSINE = np.cos(np.radians(45))
REACH = 2  # edges before and after over which the direction of an arc is taken


def vector_of(rotation):
    """Twice the sine of the angle, along the axis."""
    return np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]])


class Turn:
    """The turn of frames around an edge: `quarters`, 1 or 2, or 0 about a diagonal; `axis` in the world, averaged over the tets
    there, about which it is right-handed."""

    def __init__(self, field, edge, product):
        rotation = CUBE_ROTATIONS[product]
        trace = round(np.trace(rotation))
        self.quarters = {1: 1, -1: 2, 0: 0}[trace]
        axis = vector_of(rotation)
        if trace == -1:
            axis = np.linalg.eigh(rotation)[1][:, -1]
            if np.count_nonzero(np.abs(axis) > 1e-9) == 2:
                self.quarters = 0
        slots = field.way(field.first[edge])
        total, carried = np.zeros(3), unit(axis)
        for slot in slots:
            total += field.frames[slot // 6] @ carried
            carried = CUBE_ROTATIONS[field.turn[slot]] @ carried
        if trace == -1 and total @ small_turns(field, slots) < 0:
            total = -total
        self.axis = unit(total)


def small_turns(field, slots):
    """The sum of the turns of a frame that follows its neighbours around an edge."""
    total = np.zeros(3)
    for slot in slots:
        here, there = field.frames[slot // 6], field.frames[field.after[slot] // 6]
        total += vector_of(there @ CUBE_ROTATIONS[field.turn[slot]] @ here.T)
    return total


def longest(lengths, marks):
    """The longest sum of lengths one after another with this mark; 0 breaks nothing and counts nothing."""
    best, now, mark = defaultdict(float), 0.0, 0
    for length, here in zip(lengths, marks):
        if here:
            now = length + (now if here == mark else 0)
            mark = here
            best[mark] = max(best[mark], now)
    return best


class ArcJudgement:
    """What the edges of an arc say: `cells`, `type`, `index`, `verdict`, and the range of its oblique length."""

    def __init__(self, lines, edges, names, points):
        """edges: one after another, -1 for a gap; names: the vertices between them, one more, -1 where not known; points:
        those of the curve there."""
        steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
        on = [i for i, edge in enumerate(edges) if edge >= 0]
        turns = [lines.turns[edges[i]] for i in on]
        sizes = np.array([lines.field.edge_size[edges[i]] for i in on])
        cosines = np.array([lines.along(edges[i], names, points, i) @ turn.axis for i, turn in zip(on, turns)])
        lengths = steps[on]
        about_axis = np.array([turn.quarters > 0 for turn in turns], bool)
        self.cells = (lengths / sizes).sum()
        self.oblique = [lengths[about_axis & (np.abs(cosines) < OBLIQUE_COSINE + d)].sum() for d in (-0.15, 0.15)]
        cells = lengths / sizes
        third = longest(cells, np.where(about_axis, 2, 1))[1]
        senses = longest(cells, np.where(about_axis & (np.abs(cosines) > SIGN_COSINE), np.sign(cosines), 0))
        self.type, self.index = "regular", 0.0
        if third > MERGE_CELLS or cells[~about_axis].sum() > self.cells / 2:
            self.type = "no_axis"
        elif min(senses[1], senses[-1]) >= SIGN_CELLS:
            self.type = "changing"
        else:
            is_half = cells[[turn.quarters == 2 for turn in turns]].sum() > self.cells / 2
            self.index = (0.5 if is_half else 0.25) * np.sign((lengths * cosines)[about_axis].sum())
        no_sense = self.cells >= 2 * SIGN_CELLS and max(senses.values(), default=0) < SIGN_CELLS
        if third > MERGE_CELLS or self.type == "changing" or self.index == 0.5:
            self.verdict = "not_meshable"
        else:
            self.verdict = "undecided" if self.type == "no_axis" or no_sense else "meshable"


class Lines:
    """All singular edges of a field, {edge: Turn}, and those at each vertex."""

    def __init__(self, field):
        self.field = field
        self.turns = {edge: Turn(field, edge, product) for edge, product in field.singular_edges().items()}
        self.at = defaultdict(set)
        for edge in self.turns:
            for vertex in field.edges[edge].tolist():
                self.at[vertex].add(edge)

    def along(self, edge, names, points, i):
        """The direction of an arc at its edge i, reversed where the arc goes from the higher vertex of the edge to the lower
        one: turns are right-handed about the way from the lower to the higher."""
        low, high = self.field.edges[edge].tolist()
        forward = names[i] == low or names[i + 1] == high
        way = points[min(i + 1 + REACH, len(points) - 1)] - points[max(i - REACH, 0)]
        return unit(way) * (1 if forward else -1) if way.any() else way

    def other_end(self, edge, vertex):
        return int(self.field.edges[edge].sum()) - vertex

# SPDX-License-Identifier: Apache-2.0
"""Creases and corners of the surface of a field on tets: k and F, and whether hexahedra fit (docs/singularities.md)."""

import itertools
from collections import defaultdict

import numpy as np

from frame_math import CUBE_ROTATIONS
from judge_links import has_disc
from judge_mesh import unit

SHARP_DEG, BEND_DEG, ROUNDING_DEG = 30, 45, 5
NEAR_CELLS, MOST_ARCS, SHORT_CELLS = 3.5, 4, 2.5
TIES = (45, 135, 225, 315)
KNIFE_DEG = 45
ROUNDED_DEG = 1e-6  # angles of a file's vertices, to their last digits


class SharpEdge:
    """An edge of the surface: `angle` of the solid in degrees, and k as the frames beside it see it, `seen`."""

    def __init__(self, field, edge, sector, normals):
        """normals: of the faces where the way through the solid begins and ends."""
        self.edge, self.ends, self.length = edge, field.edges[edge], field.length[edge]
        slots = field.way(sector)
        low, high = self.ends
        along = unit(field.points[high] - field.points[low])
        sides = [field.begin[slots[0]], field.end[slots[-1]]]
        first, last = ((x := field.points[side] - field.points[low]) - (x @ along) * along for side in sides)
        self.angle = np.degrees(np.arctan2(np.cross(first, last) @ along, first @ last)) % 360
        self.seen = self.frames_see(field, slots, normals, along)

    def frames_see(self, field, slots, normals, along):
        """The axis nearest to the first normal, carried through the solid, against the one nearest to the second."""
        axes = []
        for slot, normal in zip((slots[0], slots[-1]), normals):
            components = field.frames[slot // 6].T @ normal
            axis = np.zeros(3)
            axis[np.argmax(np.abs(components))] = np.sign(components[np.argmax(np.abs(components))])
            axes.append(axis)
        carried = axes[0]
        for slot in slots[:-1]:
            carried = CUBE_ROTATIONS[field.turn[slot]] @ carried
        cosine = carried @ axes[1]
        if cosine > 0.5:
            return 2
        if cosine < -0.5:
            return 0 if self.angle < 180 else 4
        return 3 if (field.frames[slots[-1] // 6] @ np.cross(carried, axes[1])) @ along > 0 else 1


class Crease:
    """A chain of sharp edges: mean and least angle, k, the share of its length where frames see k, and a verdict."""

    def __init__(self, field, edges, first):
        """first: the vertex where the chain begins."""
        self.edges = edges
        lengths, angles = np.array([e.length for e in edges]), np.array([e.angle for e in edges])
        self.length, self.angle, self.least = lengths.sum(), lengths @ angles / lengths.sum(), angles.min()
        self.middles = field.points[[e.ends for e in edges]].mean(axis=1)
        votes = defaultdict(float)
        for edge in edges:
            votes[edge.seen] += edge.length
        self.options = options_of(self.angle)
        # Exactly where the rounding of angles begins to count: that of numbers decides whether it is listed.
        self.is_tie = 2 in self.options and any(abs(abs(self.angle - tie) - ROUNDING_DEG) < ROUNDED_DEG for tie in TIES)
        self.hexahedra = max(self.options, key=lambda k: votes[k])
        self.followed = votes[self.hexahedra] / self.length
        self.is_short = self.length <= SHORT_CELLS * field.surface_size[first]
        knife = lengths[angles < KNIFE_DEG - ROUNDING_DEG].sum()
        if self.least > KNIFE_DEG + ROUNDING_DEG + ROUNDED_DEG:
            self.verdict = "meshable"
        elif knife >= field.surface_size[edges[int(np.argmin(angles))].ends].mean():
            self.verdict = "not_meshable"
        else:
            self.verdict = "undecided"

    def is_flat(self):
        return self.options == [2]

    def is_listed(self):
        return not self.is_flat() and not self.is_short

    def sharpest_places(self):
        """The middles of the edges of the least angle."""
        return self.middles[[e.angle < self.least + ROUNDED_DEG for e in self.edges]]

    def at(self, vertex):
        """Its edges that end at a vertex."""
        return [e for e in (self.edges[0], self.edges[-1]) if vertex in e.ends]


def options_of(angle):
    """The numbers of hexahedra that an angle may have."""
    nearest = int(np.floor(angle / 90 + 0.5))
    return sorted({nearest} | {k for tie in TIES if abs(angle - tie) < ROUNDING_DEG + ROUNDED_DEG
                               for k in (int(tie // 90), int(tie // 90) + 1)})


class Corner:
    """A vertex where creases end: `creases` in cyclic order around it."""

    def __init__(self, vertex, creases):
        self.vertex, self.creases = vertex, creases
        self.numbers = [c.hexahedra for c in creases]

    def is_listed(self):
        """A short crease that ends alone is none that the cells resolve."""
        alone = len(self.creases) == 1 and self.creases[0].is_short
        return not alone and not all(c.is_flat() for c in self.creases)

    def judge(self, field, ends):
        """Sets `arcs`, F in `hexahedra`, and the verdict. ends: [(place, n)] of arcs that end on the surface."""
        distances = [(np.linalg.norm(place - field.points[self.vertex]), n) for place, n in ends]
        reach = NEAR_CELLS * field.surface_size[self.vertex]
        near = [n for distance, n in sorted(distances) if distance <= reach][:MOST_ARCS]
        fits, self.arcs = fitting_arcs(near, self.numbers)
        self.hexahedra = 4 - sum(4 - n for n in self.arcs) - sum(2 - k for k in self.numbers)
        alone, unresolved = len(self.creases) == 1, any(c.is_short for c in self.creases)
        if fits:
            self.verdict = "meshable"
        elif fits is None or alone or unresolved or self.fits_rounded(near):
            self.verdict = "undecided"
        else:
            self.verdict = "not_meshable"

    def fits_rounded(self, near):
        """Whether another rounding of creases, as a whole or at this end, has a disc."""
        choices = [sorted({c.hexahedra, *c.options, *(k for e in c.at(self.vertex) for k in options_of(e.angle))})
                   for c in self.creases]
        return any(fitting_arcs(near, numbers)[0] is not False for numbers in itertools.product(*choices))


def fitting_arcs(near, numbers):
    """Whether there is a disc with some of the arcs nearby, None if one is too large to tell; and the fewest of these arcs."""
    answer = False
    for count in range(len(near) + 1):
        for some in sorted(set(itertools.combinations(sorted(near), count))):
            found = has_disc(some, numbers)
            if found:
                return True, some
            answer = None if found is None else answer
    return answer, ()


class Surface:
    """All creases and corners of a field's surface. Where creases bend by exactly BEND_DEG, as around an octagon, rounding
    decides, so that `corners` says which of these vertices are corners: their places."""

    def __init__(self, field, corners=()):
        self.field = field
        self.said = {tuple(np.round(place, 6)) for place in corners}
        self.sharp = self.sharp_edges()
        self.fans = defaultdict(list)
        for face in field.surface.tolist():
            for vertex in face:
                self.fans[vertex].append(face)
        self.at = defaultdict(list)
        for edge in self.sharp.values():
            for vertex in edge.ends:
                self.at[int(vertex)].append(edge)
        self.through = {v for v, edges in self.at.items() if len(edges) == 2 and self.continues(v, *edges)}
        self.creases = [Crease(field, chain, first) for first, chain in self.chains()]
        owner = {e.edge: crease for crease in self.creases for e in crease.edges}
        self.corners = [Corner(v, [owner[e] for e in order]) for v in sorted(self.at) if v not in self.through
                        for order in [self.around(v)] if order]

    def sharp_edges(self):
        """{edge: SharpEdge} where two faces meet that turn by more than SHARP_DEG."""
        field = self.field
        _, first, last = field.faces_beside_sectors()
        one, other = field.normals[first], field.normals[last]
        turn = np.degrees(np.arctan2(np.linalg.norm(np.cross(one, other), axis=1), np.einsum("ij,ij->i", one, other)))
        edges = field.edge_of[field.sectors]
        single = np.bincount(edges, minlength=len(field.edges))[edges] == 1
        return {int(edges[i]): SharpEdge(field, int(edges[i]), int(field.sectors[i]), (one[i], other[i]))
                for i in np.flatnonzero((turn > SHARP_DEG) & single)}

    def continues(self, vertex, one, other):
        ways = [unit(self.field.points[e.ends].sum(axis=0) - 2 * self.field.points[vertex]) for e in (one, other)]
        bend = np.degrees(np.arctan2(np.linalg.norm(np.cross(*ways)), -(ways[0] @ ways[1])))
        if abs(bend - BEND_DEG) < ROUNDED_DEG:
            return tuple(np.round(self.field.points[vertex], 6)) not in self.said
        return bend < BEND_DEG

    def chains(self):
        used, chains = set(), []

        def walk(vertex, edge):
            chain = []
            while edge.edge not in used:
                used.add(edge.edge)
                chain.append(edge)
                vertex = int(edge.ends.sum()) - vertex
                if vertex not in self.through:
                    break
                edge = next(e for e in self.at[vertex] if e.edge != edge.edge)
            return chain

        for vertex in sorted(self.at, key=lambda v: (v in self.through, v)):
            chains += [(vertex, walk(vertex, edge)) for edge in self.at[vertex] if edge.edge not in used]
        return chains

    def around(self, vertex):
        """The sharp edges at a vertex in cyclic order; none if its triangles make no single fan."""
        after = {}
        for face in self.fans[vertex]:
            i = face.index(vertex)
            after[face[(i + 1) % 3]] = face[(i + 2) % 3]
        start = now = min(after)
        order = []
        for _ in after:
            edge = self.field.number[tuple(sorted((vertex, now)))]
            if edge in self.sharp:
                order.append(edge)
            now = after.get(now, -1)
            if now in (start, -1):
                break
        return order if now == start and len(self.fans[vertex]) == len(after) else []

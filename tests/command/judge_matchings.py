# SPDX-License-Identifier: Apache-2.0
"""Whether hexahedra can follow frames on tets with given matchings, edge by edge and vertex by vertex, from onto.mesh, onto.fra and
onto.perm alone (`solve X --write mesh,fra,perm`).

The rules are those of docs/singularities.md with matchings in place of nearest frames: the link of a vertex must have a
triangulation in which each singular edge is a vertex of as many triangles as it has hexahedra, and all others inside have four.
Around a vertex of the surface its border has a vertex of k triangles for each crease, and between creases, for a sector of s
quarter turns in the map, s - 1 vertices of two triangles.
"""

from collections import defaultdict
from functools import lru_cache
from pathlib import Path

import numpy as np

from frame_math import CUBE_ROTATIONS
from judge_links import MOST_TRIANGLES, can_fill, has_sphere, least_cyclic
from judge_mesh import IDENTITY, PRODUCTS, TetField, number_of, unit

CONVEX_DEG = 15  # from this turn of the surface on, its geometry says whether an edge is convex
NO_SENSE = 0.25  # cosine between an edge and the axis around it below which the edge has no sense of its own
LONGEST_WAY = 256  # edges along a line, to one with a sense
OPEN_SECTOR_DEG, WHOLE_SECTOR_DEG = 225, 180  # angles of the surface from which a sector may, and must, have four quarters more

POSSIBLE, IMPOSSIBLE, UNKNOWN = "possible", "impossible", "unknown"

INVERSES = number_of(np.swapaxes(CUBE_ROTATIONS, 1, 2))


def read_medit(path):
    """Points, and tets from 0."""
    words = Path(path).read_text().split()
    at = words.index("Vertices") + 1
    count = int(words[at])
    points = np.array(words[at + 1:at + 1 + 4 * count], float).reshape(-1, 4)[:, :3]
    at = words.index("Tetrahedra") + 1
    count = int(words[at])
    return points, np.array(words[at + 1:at + 1 + 5 * count], int).reshape(-1, 5)[:, :4] - 1


def read_frames(path):
    """The axes of each tet as columns."""
    lines = Path(path).read_text().splitlines()
    assert lines[0] == "FRA 1"
    return np.array(" ".join(lines[2:]).split(), float).reshape(-1, 3, 3).transpose(0, 2, 1)


def read_matchings(path):
    """(from, to, axes), one row for each face whose matching is not the identity."""
    lines = Path(path).read_text().splitlines()
    assert lines[0] == "PERM 1"
    return np.array([line.split() for line in lines[2:]], int).reshape(-1, 5)


def rotation_of(axes):
    """The matrix that takes axis k to |axes[k]|, counted from 1, with its sign."""
    matrix = np.zeros((3, 3))
    matrix[np.abs(axes) - 1, range(3)] = np.sign(axes)
    return matrix


def turn_between(one, other):
    """The smallest rotation from a frame to another as a vector: its axis times its angle."""
    rotation = other @ one.T
    skew = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]]) / 2
    sine = np.linalg.norm(skew)
    return skew / max(sine, 1e-300) * np.arctan2(sine, (np.trace(rotation) - 1) / 2)


def quarters(normal, one, other):
    """Quarter turns about an axis, counter-clockwise, from an axis across it to another."""
    return {(1, 0): 0, (0, 1): 1, (-1, 0): 2, (0, -1): 3}[int(one @ other), int(np.cross(normal, one) @ other)]


@lru_cache(maxsize=None)
def link(border, valences):
    """Whether the link with this border and these vertices inside exists; UNKNOWN if it is too large to search."""
    # 3 triangles = border sum + inner sum and Euler's formula give the number of regular vertices inside.
    twice = sum(border) + sum(valences) - 3 * len(border) - 6 * len(valences) + 6
    if twice < 0 or twice % 2:
        return IMPOSSIBLE
    inner = tuple(sorted(valences + (4,) * (twice // 2)))
    if len(border) + 2 * len(inner) - 2 > MOST_TRIANGLES:
        return UNKNOWN
    return POSSIBLE if can_fill(border, inner) else IMPOSSIBLE


def best(states):
    states = list(states)
    return POSSIBLE if POSSIBLE in states else UNKNOWN if UNKNOWN in states else IMPOSSIBLE


class MatchedField(TetField):
    """`turns` has {edge: EdgeTurn} of the singular edges inside, `hexahedra` {edge: k} of the surface."""

    def __init__(self, folder):
        folder = Path(folder)
        self.given = read_matchings(folder / "onto.perm")
        super().__init__(*read_medit(folder / "onto.mesh"), read_frames(folder / "onto.fra"))
        self.turns = {edge: EdgeTurn(self, edge, product) for edge, product in self.singular_edges().items()}
        self.find_hexahedra()
        self.find_rings()
        self.singular_at = defaultdict(list)
        for edge in self.turns:
            for vertex in self.edges[edge].tolist():
                self.singular_at[vertex].append(edge)

    def find_faces(self):
        super().find_faces()
        self.nearest, self.matching = self.matching, np.full_like(self.matching, IDENTITY)
        for one, other, *axes in self.given.tolist():
            forth = np.flatnonzero(self.beside[one] == other)
            back = np.flatnonzero(self.beside[other] == one)
            assert len(forth) == 1 and len(back) == 1, f"tets {one} and {other} have no common face"
            number = number_of(rotation_of(np.array(axes)))
            assert (CUBE_ROTATIONS[number] == rotation_of(np.array(axes))).all(), f"{axes} is no rotation"
            self.matching[one, forth[0]], self.matching[other, back[0]] = number, INVERSES[number]

    def find_hexahedra(self):
        last, self.begin_face, self.end_face = self.faces_beside_sectors()
        product, slot = np.full(len(self.sectors), IDENTITY), self.sectors.copy()
        while (going := self.after[slot] >= 0).any():
            product[going] = PRODUCTS[self.turn[slot[going]], product[going]]
            slot[going] = self.after[slot[going]]
        assert (slot == last).all()
        self.sector_product = product
        edges, count = np.unique(self.edge_of[self.sectors], return_counts=True)
        self.branched = set(edges[count > 1].tolist())  # where the solid touches itself
        self.sector_of = {edge: i for i, edge in enumerate(self.edge_of[self.sectors].tolist()) if edge not in self.branched}
        inside = np.einsum("nij,ni->nj", self.frames[self.surface_tets], self.normals)
        axis = np.abs(inside).argmax(axis=1)
        self.normal_axis = np.zeros((len(inside), 3), int)
        self.normal_axis[range(len(axis)), axis] = np.sign(inside[range(len(axis)), axis])
        self.hexahedra, self.angle = {}, {}
        for edge, i in self.sector_of.items():
            self.hexahedra[edge], self.angle[edge] = self.hexahedra_of(edge, i)

    def hexahedra_of(self, edge, i):
        """Quarter turns of the solid in the map, and its angle."""
        one, other = self.normals[self.begin_face[i]], self.normals[self.end_face[i]]
        a, b = self.edges[edge]
        along = unit(self.points[b] - self.points[a])
        angle = 180 + np.degrees(np.arctan2(np.cross(one, other) @ along, one @ other))
        carried = np.rint(CUBE_ROTATIONS[self.sector_product[i]] @ self.normal_axis[self.begin_face[i]]).astype(int)
        arrives = self.normal_axis[self.end_face[i]]
        if (carried == arrives).all():
            return 2, angle
        if (carried == -arrives).all():
            return (0 if angle < 180 else 4), angle
        if abs(angle - 180) > CONVEX_DEG:
            return (1 if angle < 180 else 3), angle
        axis = self.frames[self.surface_tets[self.end_face[i]]] @ np.cross(carried, arrives)
        return (3 if axis @ along > 0 else 1), angle

    def find_rings(self):
        """rings[v]: (face, edge after it, its direction is away from v), counter-clockwise seen from outside."""
        following = defaultdict(dict)
        pinched = set(self.edges[sorted(self.branched)].ravel().tolist())
        for i, edge in enumerate(self.edge_of[self.sectors].tolist()):
            for away, vertex in zip((True, False), self.edges[edge].tolist()):
                begin, end = (self.begin_face[i], self.end_face[i])[::1 if away else -1]
                if begin in following[vertex]:
                    pinched.add(vertex)
                following[vertex][begin] = (int(end), i, away)
        self.rings = {}
        for vertex, after in following.items():
            face, ring = next(iter(after)), []
            for _ in after if vertex not in pinched else ():
                to, i, away = after[face]
                ring.append((face, i, away))
                face = to
            is_one = len({face for face, _, _ in ring}) == len(after)
            self.rings[vertex] = ring if is_one else None

    def carry(self, step, vector):
        """An axis of the tet before an edge of the ring in that after it."""
        _, i, away = step
        number = self.sector_product[i]
        return np.rint(CUBE_ROTATIONS[number if away else INVERSES[number]] @ vector).astype(int)

    def face_angle(self, face, vertex):
        a, b = (self.points[w] - self.points[vertex] for w in self.surface[face] if w != vertex)
        return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b))

    def borders(self, vertex):
        """All borders that the map may have around a vertex of the surface."""
        ring = self.rings[vertex]
        numbers = [self.hexahedra[int(self.edge_of[self.sectors[i]])] for _, i, _ in ring]
        if 0 in numbers or 4 in numbers:
            return []
        creases = [k for k, n in enumerate(numbers) if n != 2]
        normal = self.normal_axis[ring[0][0]]
        if not creases:
            axis = start = np.roll(normal, 1)
            for step in ring:
                axis = self.carry(step, axis)
            size = 4 - quarters(normal, start, axis)
            return [(2,) * size, (2,) * (size + 4)]
        # Carried along, so that all is in the axes of the tet in which a sector begins.
        ring, numbers = ring[creases[0]:] + ring[:creases[0]], numbers[creases[0]:] + numbers[:creases[0]]
        words = [()]
        for k, number in enumerate(numbers):
            if number == 2:
                continue
            to_next = next(d for d in range(1, len(ring) + 1) if numbers[(k + d) % len(ring)] != 2)
            between = [ring[(k + d) % len(ring)] for d in range(1, to_next + 1)]
            words = [word + (number,) + (2,) * (s - 1) for word in words for s in self.sizes(vertex, ring[k], number, between, numbers)]
        return words

    def direction(self, step, number):
        """The axis along a crease away from the vertex, in the tet after it."""
        face, i, away = step
        carried = self.carry(step, self.normal_axis[face])
        arrives = self.normal_axis[self.end_face[i] if away else self.begin_face[i]]
        return np.cross(carried, arrives) * (1 if number == 3 else -1)

    def sizes(self, vertex, crease, number, between, numbers):
        """Quarter turns that the sector after a crease may have; `between` are the steps up to the next crease, with it."""
        axis = self.direction(crease, number)
        for step in between[:-1]:
            axis = self.carry(step, axis)
        last = between[-1]
        there = self.direction(last, self.hexahedra[int(self.edge_of[self.sectors[last[1]]])])
        normal = self.normal_axis[last[0]]
        _, i, away = last
        back = INVERSES[self.sector_product[i]] if away else self.sector_product[i]
        size = quarters(normal, axis, np.rint(CUBE_ROTATIONS[back] @ there).astype(int))
        angle = sum(self.face_angle(step[0], vertex) for step in between)
        if size == 0 and angle > WHOLE_SECTOR_DEG:
            size = 4
        return [s for s in (size, size + 4 if angle > OPEN_SECTOR_DEG else 0) if s > 0]

    def state(self, vertex):
        """POSSIBLE, IMPOSSIBLE or UNKNOWN: whether hexahedra can meet at a vertex."""
        if vertex in self.rings and self.rings[vertex] is None:
            return UNKNOWN
        choices = [()]
        for edge in self.singular_at[vertex]:
            numbers = self.valences_from(vertex, edge) if self.turns[edge].valences else ()
            choices = [word + (n,) for word in choices for n in numbers]
        if vertex in self.rings:
            borders = self.borders(vertex) if choices else []
            return best(link(least_cyclic(border), tuple(sorted(word))) for word in choices for border in borders if min(word, default=4) > 2)
        return best(self.inner_state(tuple(sorted(word))) for word in choices)

    @staticmethod
    def inner_state(valences):
        if not valences or len(valences) == 2 and valences[0] == valences[1] > 2:
            return POSSIBLE
        if len(valences) < 3 or min(valences) < 3:
            return IMPOSSIBLE
        return {True: POSSIBLE, False: IMPOSSIBLE, None: UNKNOWN}[has_sphere(valences)]

    def valences_from(self, vertex, edge):
        """Of the first edge with a sense on the line that leaves a vertex along an edge; of that edge if there is none."""
        first = edge
        for _ in range(LONGEST_WAY):
            if len(self.turns[edge].valences) == 1:
                return self.turns[edge].valences
            vertex = sum(self.edges[edge].tolist()) - vertex
            if vertex in self.rings or len(self.singular_at[vertex]) != 2:
                break
            edge = sum(self.singular_at[vertex]) - edge
        return self.turns[first].valences

    def faults(self):
        """(edges, vertices) at which there can be no hexahedra."""
        edges = [edge for edge, turn in self.turns.items() if not turn.valences or max(turn.valences) < 3]
        edges += [edge for edge, k in self.hexahedra.items() if k == 0]
        vertices = [v for v in sorted({*self.rings, *self.singular_at}) if self.state(v) == IMPOSSIBLE]
        return edges, vertices


def differences(folder, report):
    """A line for each item of the report of a repaired field that is otherwise here."""
    field, found = MatchedField(folder), []

    def same(name, reported, judged):
        if reported != judged:
            found.append(f"{name}: {reported} in the report, {judged} judged")

    section, (edges, vertices) = report["onto"]["singularity"], field.faults()
    same("edges", section["edges"], len(field.turns))
    same("faults", report["onto"]["repair"]["faults"], len(edges) + len(vertices))
    places = {verdict: sorted(tuple(np.round(c["place"], 6).tolist()) for c in section["corner_list"] if c["verdict"] == verdict)
              for verdict in ("not_meshable", "undecided")}
    for verdict, state in (("not_meshable", IMPOSSIBLE), ("undecided", UNKNOWN)):
        own = [v for v in field.rings if field.state(v) == state]
        same(f"corners {verdict}", places[verdict], sorted(tuple(np.round(field.points[v], 6).tolist()) for v in own))
    if edges or vertices:
        same("verdict", report["verdict"], "not_meshable")
    return found


class EdgeTurn:
    """`valences`: the numbers of hexahedra that a singular edge inside may have; none for a rotation about a diagonal."""

    def __init__(self, field, edge, product):
        rotation = CUBE_ROTATIONS[product]
        trace = round(np.trace(rotation))
        self.valences = ()
        if trace == 0 or (trace == -1 and (rotation != np.diag(np.diag(rotation))).any()):
            return
        a, b = field.edges[edge]
        self.cosine, turn = self.along(field, int(field.first[edge]), unit(field.points[b] - field.points[a]), rotation, trace)
        if trace == -1:
            # A half turn has no sense but that in which the frames turn on their way.
            self.valences = (6,) if turn < 0 and abs(self.cosine) > NO_SENSE else (2,)
        else:
            self.valences = (3, 5) if abs(self.cosine) < NO_SENSE else (3,) if self.cosine > 0 else (5,)

    @staticmethod
    def along(field, first, direction, rotation, trace):
        """The cosine between an edge and the axis around it, averaged over the tets, and the angle by which frames turn about
        the edge on the way around."""
        axis = np.array([rotation[2, 1] - rotation[1, 2], rotation[0, 2] - rotation[2, 0], rotation[1, 0] - rotation[0, 1]]) / 2
        if trace == -1:
            axis = (np.diag(rotation) > 0).astype(float)
        product, sum_of_axes, turn = IDENTITY, np.zeros(3), 0.0
        for slot in field.way(first):
            here = field.frames[slot // 6] @ CUBE_ROTATIONS[product]
            product = PRODUCTS[field.turn[slot], product]
            there = field.frames[field.after[slot] // 6] @ CUBE_ROTATIONS[product]
            sum_of_axes += there @ axis
            turn += turn_between(here, there) @ direction
        return float(unit(sum_of_axes) @ direction), turn

# SPDX-License-Identifier: Apache-2.0
"""The seamless map of frames and matchings on tets: the least-squares map, without integers and without untangling.

Notation: g a rotation of the cube, as a number (judge_mesh) or a signed permutation; t the translation of a sheet of the cut;
u the map, with coordinates along the axes of the gauged frames.

All frames are brought into one gauge along a spanning tree of the tets; faces at which regular edges then close are joined
too. What is left of the faces is the cut. Across it u' = g u + t, with one t for each sheet: faces of the cut that meet two and
two at regular edges (Nieser, Reitebuch and Polthier 2011, section 4). Linear equations make regular edges trivial, keep
singular edges on their axis, (I - R) u = T, and faces of the boundary on one coordinate. They are eliminated exactly, and the
rest minimises sum volume |grad u - F|^2.
"""

from collections import deque
from fractions import Fraction

import numpy as np
from scipy.sparse import coo_matrix, csr_matrix, diags, kron
from scipy.sparse.csgraph import breadth_first_order, connected_components
from scipy.sparse.linalg import cg

from frame_math import CUBE_ROTATIONS
from judge_mesh import IDENTITY, PRODUCTS, TET_FACES, TetField, number_of

INVERSES = np.argmax(PRODUCTS == IDENTITY, axis=1)
# Row i of rotation g: (g x)[i] = sign * x[place].
ROWS = [[(int(np.argmax(np.abs(row))), int(round(row.sum()))) for row in g] for g in CUBE_ROTATIONS]
AXES, CORNERS = np.arange(3), range(4)
RELATIVE_RESIDUAL = 1e-10  # flips of the 25 meshes are the same from 1e-8 to 1e-12
MOST_STEPS = 20000


class MatchedField(TetField):
    """A TetField whose matchings are given: rows a b p1 p2 p3 of a .perm file, or None for those of the nearest frames.

    `cosines` are those between the normals of the faces of the surface and the axes of their tets, (faces, 3).
    """

    def __init__(self, points, tets, axes, rows):
        self.rows = rows
        super().__init__(points, tets, np.swapaxes(axes, 1, 2))
        self.cosines = np.einsum("nij,ni->nj", self.frames[self.surface_tets], self.normals)

    def find_faces(self):
        super().find_faces()
        if self.rows is None:
            return
        self.matching[:] = IDENTITY
        if not len(self.rows):
            return
        one, other, images = self.rows[:, 0], self.rows[:, 1], self.rows[:, 2:]
        rotation = np.zeros((len(one), 3, 3))
        rotation[np.arange(len(one))[:, None], np.abs(images) - 1, AXES] = np.sign(images)
        number = number_of(rotation)
        if (CUBE_ROTATIONS[number] != rotation).any():
            raise ValueError("a matching is not a rotation of the cube")
        for a, b, g in ((one, other, number), (other, one, INVERSES[number])):
            at = self.beside[a] == b[:, None]
            if (at.sum(axis=1) != 1).any():
                raise ValueError("a matching is between tets without a common face")
            self.matching[a, np.argmax(at, axis=1)] = g


class Cut:
    """The faces that the gauge leaves, as sheets.

    A side is a face of a tet, 4 tet + the corner opposite; partner has the other side of each, -1 at the surface. frames and
    matching are gauged; joined[side] says that u is continuous there. sheet[side] is s or -s where the face belongs to sheet
    s = 1, 2... and leads out of the tet along or against its direction, and 0 elsewhere; rotation[s] is the number of g along
    the direction. singular and open_count have of each edge whether it is singular, and the number of faces of the cut.
    """

    def __init__(self, field):
        self.field = field
        self.pair_sides()
        self.choose_gauge()
        self.join_around_regular_edges()
        self.find_sheets()

    def pair_sides(self):
        beside = self.field.beside
        tet, corner = np.nonzero(beside >= 0)
        there = np.argmax(beside[beside[tet, corner]] == tet[:, None], axis=1)
        self.partner = np.full(beside.size, -1)
        self.partner[4 * tet + corner] = 4 * beside[tet, corner] + there

    def choose_gauge(self):
        field, count = self.field, len(self.field.tets)
        side = np.flatnonzero(self.partner >= 0)
        graph = csr_matrix((np.ones(len(side)), (side // 4, self.partner[side] // 4)), (count, count))
        parts, part = connected_components(graph, directed=False)
        gauge, tree = [IDENTITY] * count, []
        beside, matching, products = field.beside.tolist(), field.matching.tolist(), PRODUCTS.tolist()
        for root in np.unique(part, return_index=True)[1].tolist():
            order, parent = breadth_first_order(graph, root, directed=False)
            for tet, above in zip(order[1:].tolist(), parent[order[1:]].tolist()):
                corner = beside[tet].index(above)
                gauge[tet] = products[gauge[above]][matching[tet][corner]]
                tree.append(4 * tet + corner)
        gauge = np.array(gauge)
        self.joined = np.zeros(4 * count, bool)
        self.joined[tree] = self.joined[self.partner[tree]] = True
        self.frames = np.einsum("nij,nkj->nik", field.frames, CUBE_ROTATIONS[gauge])
        beyond = np.where(field.beside >= 0, gauge[field.beside], gauge[:, None])
        self.matching = PRODUCTS[PRODUCTS[beyond, field.matching], INVERSES[gauge][:, None]].ravel()

    def join_around_regular_edges(self):
        """A regular edge with one face that is not joined has the identity there: joins it, until there is no such edge."""
        field = self.field
        self.singular = np.zeros(len(field.edges), bool)
        self.singular[list(field.singular_edges())] = True
        side = np.flatnonzero(self.partner > np.arange(len(self.partner)))
        edges = self.edges_of(side)
        is_open = ~self.joined[side]
        count = np.bincount(edges[is_open].ravel(), minlength=len(field.edges)).tolist()
        order = np.argsort(edges, axis=None, kind="stable")
        start = np.searchsorted(edges.ravel()[order], np.arange(len(field.edges) + 1)).tolist()
        faces, edges, is_open = (order // 3).tolist(), edges.tolist(), is_open.tolist()
        closes = (field.inside & ~self.singular).tolist()
        queue = deque(e for e, close in enumerate(closes) if close and count[e] == 1)
        while queue:
            edge = queue.popleft()
            if count[edge] != 1:
                continue
            face = next(f for f in faces[start[edge]:start[edge + 1]] if is_open[f])
            is_open[face] = False
            for other in edges[face]:
                count[other] -= 1
                if closes[other] and count[other] == 1:
                    queue.append(other)
        joined = side[~np.array(is_open, bool)]
        self.joined[joined] = self.joined[self.partner[joined]] = True
        self.open_count = np.array(count)
        assert (self.matching[self.joined] == IDENTITY).all()

    def edges_of(self, sides):
        """The numbers of the edges of faces, (faces, 3)."""
        field = self.field
        corners = np.sort(field.tets[(sides // 4)[:, None], TET_FACES[sides % 4]], axis=1)
        keys = field.edges[:, 0] * len(field.points) + field.edges[:, 1]
        return np.searchsorted(keys, corners[:, [0, 0, 1]] * len(field.points) + corners[:, [1, 2, 2]])

    def find_sheets(self):
        """Faces continue each other at regular edges with two of them. The way around leaves the second backwards."""
        field, partner = self.field, self.partner.tolist()
        two = field.inside & ~self.singular & (self.open_count == 2)
        slots = np.flatnonzero(two[field.edge_of])
        sides = 4 * (slots // 6) + field.leaving[slots]
        slots, sides = slots[~self.joined[sides]], sides[~self.joined[sides]]
        pairs = sides[np.argsort(field.edge_of[slots], kind="stable")].reshape(-1, 2)
        pairs = np.concatenate([np.stack([pairs[:, 0], self.partner[pairs[:, 1]]], axis=1),
                                np.stack([self.partner[pairs[:, 0]], pairs[:, 1]], axis=1)]).tolist()
        beside = {}
        for a, b in pairs:
            beside.setdefault(a, []).append(b)
            beside.setdefault(b, []).append(a)
        sheet, self.rotation = [0] * len(partner), [IDENTITY]
        for first in np.flatnonzero(~self.joined & (self.partner >= 0)).tolist():
            if sheet[first]:
                continue
            name, stack = len(self.rotation), [first]
            self.rotation.append(int(self.matching[first]))
            sheet[first], sheet[partner[first]] = name, -name
            while stack:
                for side in beside.get(stack.pop(), []):
                    if not sheet[side]:
                        sheet[side], sheet[partner[side]] = name, -name
                        stack.append(side)
        self.sheet = np.array(sheet)

    def word_around(self, slot):
        """The sheets crossed on the way from a slot around its edge."""
        crossed = (int(self.sheet[4 * (s // 6) + self.field.leaving[s]]) for s in self.field.way(slot))
        return tuple(name for name in crossed if name)


def added(one, other, factor):
    """The linear form {unknown: coefficient} one + factor * other."""
    total = dict(one)
    for unknown, value in other.items():
        total[unknown] = total.get(unknown, 0) + factor * value
        if not total[unknown]:
            del total[unknown]
    return total


class Elimination:
    """Exact elimination of unknowns by linear equations with integer coefficients."""

    def __init__(self):
        self.forms = {}  # of the unknowns that are eliminated

    def reduced(self, form):
        """The same form in unknowns that are not eliminated."""
        while any(unknown in self.forms for unknown in form):
            total = {}
            for unknown, value in form.items():
                total = added(total, self.short(unknown), value)
            form = total
        return form

    def short(self, unknown):
        """A form of an unknown, kept in the least number of steps that are known by now."""
        form = self.forms.get(unknown)
        if form is None:
            return {unknown: 1}
        if any(other in self.forms for other in form):
            self.forms[unknown] = form = self.reduced(form)
        return form

    def impose(self, form, key=lambda unknown: 0):
        """form = 0. Eliminates an unknown whose coefficient is of least size, and of these one of least key."""
        form = self.reduced(form)
        if not form:
            return
        pivot = min(form, key=lambda unknown: (abs(form[unknown]), key(unknown), unknown))
        divisor = form.pop(pivot)
        inverse = divisor if divisor in (1, -1) else 1 / Fraction(divisor)
        self.forms[pivot] = {unknown: -value * inverse for unknown, value in form.items()}


class SeamlessMap:
    """u[tet, corner], (tets, 4, 3), in the gauge of `cut`, and the Jacobians' determinants; 1 where u follows the frames."""

    def __init__(self, field):
        self.field, self.cut = field, Cut(field)
        self.find_copies()
        self.elimination = Elimination()
        self.impose_edges()
        self.impose_surface()
        self.minimise()

    def find_copies(self):
        """A copy of a vertex is its corners that are joined; copies hang together by transitions from a first one, which has
        the unknowns 3 copy + axis. Translations are the unknowns first_translation + 3 sheet + axis."""
        field, cut = self.field, self.cut
        side = np.flatnonzero(cut.partner >= 0)
        here = np.array([[c for c in CORNERS if c != corner] for corner in CORNERS])[side % 4]
        tet, other = side // 4, cut.partner[side] // 4
        vertex = field.tets[tet[:, None], here]
        there = np.argmax(field.tets[other][:, None, :] == vertex[..., None], axis=2)
        one, two = 4 * tet[:, None] + here, 4 * other[:, None] + there
        count = field.tets.size
        joined = cut.joined[side]
        graph = csr_matrix((np.ones(3 * joined.sum()), (one[joined].ravel(), two[joined].ravel())), (count, count))
        self.copies, self.copy_of = connected_components(graph, directed=False)
        self.first_translation = 3 * self.copies
        ways = {}
        for a, b, name in zip(self.copy_of[one[~joined]].ravel().tolist(), self.copy_of[two[~joined]].ravel().tolist(),
                              np.repeat(cut.sheet[side[~joined]], 3).tolist()):
            ways.setdefault(a, {}).setdefault(b, name)
        self.transitions = {(): (IDENTITY, ({}, {}, {}))}
        self.base, self.word = [-1] * self.copies, [()] * self.copies
        for first in range(self.copies):
            if self.base[first] >= 0:
                continue
            self.base[first], queue = first, deque([first])
            while queue:
                copy = queue.popleft()
                for other, name in ways.get(copy, {}).items():
                    if self.base[other] < 0:
                        self.base[other], self.word[other] = first, extended(self.word[copy], name)
                        queue.append(other)

    def transition(self, word):
        """Number of R and forms of T of the way across the sheets of a word: u' = R u + T."""
        found = self.transitions.get(word)
        if found is None:
            rotation, translation = self.transition(word[:-1])
            name = word[-1]
            own = self.first_translation + 3 * abs(name)
            g = self.cut.rotation[abs(name)]
            step = g if name > 0 else int(INVERSES[g])
            rows = ROWS[step]
            if name > 0:
                forms = [added({own + i: 1}, translation[place], sign) for i, (place, sign) in enumerate(rows)]
            else:
                forms = [added({own + place: -sign}, translation[place], sign) for place, sign in rows]
            self.transitions[word] = found = (int(PRODUCTS[step, rotation]), tuple(forms))
        return found

    def forms(self, copy):
        """The three coordinates of a copy."""
        rotation, translation = self.transition(self.word[copy])
        return [added(translation[i], {3 * self.base[copy] + place: sign}, 1) for i, (place, sign) in enumerate(ROWS[rotation])]

    def impose_edges(self):
        """T = 0 around regular edges, then u = R u + T at both ends of singular ones."""
        field, cut, impose = self.field, self.cut, self.elimination.impose
        words = {cut.word_around(int(field.first[e]))
                 for e in np.flatnonzero(field.inside & ~cut.singular & (cut.open_count > 1))}
        for word in sorted(words, key=lambda word: (len(word), word)):
            for form in self.transition(reduced_word(word))[1]:
                impose(form)
        done = set()
        for edge in np.flatnonzero(cut.singular).tolist():
            slot = int(field.first[edge])
            word = cut.word_around(slot)
            for vertex in field.edges[edge]:
                corner = 4 * (slot // 6) + int(np.argmax(field.tets[slot // 6] == vertex))
                copy = int(self.copy_of[corner])
                if (copy, word) in done:
                    continue
                done.add((copy, word))
                rotation, translation = self.transition(word)
                u = self.forms(copy)
                for i, (place, sign) in enumerate(ROWS[rotation]):
                    impose(added(added(u[i], u[place], -sign), translation[i], -1), self.is_of_vertex)

    def is_of_vertex(self, unknown):
        return unknown < self.first_translation

    def impose_surface(self):
        """On a face, the coordinate along the axis nearest to its normal is constant."""
        field = self.field
        cosines = np.einsum("nij,ni->nj", self.cut.frames[field.surface_tets], field.normals)
        axis = np.argmax(np.abs(cosines), axis=1).tolist()
        tet, corner = np.nonzero(field.beside < 0)
        copies = self.copy_of.reshape(-1, 4)[tet[:, None], TET_FACES[corner]].tolist()
        for face, k in zip(copies, axis):
            first, *others = (self.forms(copy)[k] for copy in face)
            for other in others:
                self.elimination.impose(added(other, first, -1), lambda unknown: -unknown)

    def minimise(self):
        corners = self.field.points[self.field.tets]
        edges = corners[:, 1:] - corners[:, :1]
        volume = np.linalg.det(edges) / 6
        gradients = np.swapaxes(np.linalg.inv(edges), 1, 2)
        gradients = np.concatenate([-gradients.sum(axis=1, keepdims=True), gradients], axis=1)
        self.volume = volume
        copy = self.copy_of.reshape(-1, 4)
        stiffness = np.einsum("n,nai,nbi->nab", volume, gradients, gradients)
        rows, columns = np.repeat(copy, 4, axis=1).ravel(), np.tile(copy, (1, 4)).ravel()
        laplacian = coo_matrix((stiffness.ravel(), (rows, columns)), (self.copies,) * 2).tocsr()
        pull = np.einsum("n,nai,nij->naj", volume, gradients, self.cut.frames).reshape(-1, 3)
        target = np.stack([np.bincount(copy.ravel(), pull[:, i], self.copies) for i in AXES], axis=1).ravel()
        basis = self.basis()
        matrix = (basis.T @ kron(laplacian, np.eye(3), "csr") @ basis).tocsr()
        right = basis.T @ target
        solution, self.steps = conjugate_gradients(matrix, right)
        self.unknowns = basis.shape[1]
        self.u = (basis @ solution).reshape(-1, 3)[copy]
        self.jacobians = np.einsum("nai,naj->nij", self.u, gradients)
        self.determinants = np.linalg.det(self.jacobians)

    def basis(self):
        """The coordinates of all copies as combinations of the unknowns that are not eliminated."""
        number, rows, columns, values = {}, [], [], []
        for copy in range(self.copies):
            for i, form in enumerate(self.forms(copy)):
                for unknown, value in self.elimination.reduced(form).items():
                    rows.append(3 * copy + i)
                    columns.append(number.setdefault(unknown, len(number)))
                    values.append(float(value))
        return csr_matrix((values, (rows, columns)), (3 * self.copies, len(number)))


def extended(word, name):
    return word[:-1] if word and word[-1] == -name else (*word, name)


def reduced_word(word):
    result = ()
    for name in word:
        result = extended(result, name)
    return result


def conjugate_gradients(matrix, right):
    """A solution to RELATIVE_RESIDUAL, and the number of steps."""
    steps = [0]

    def count(_):
        steps[0] += 1

    diagonal = matrix.diagonal()
    inverse = diags(np.where(diagonal > 0, 1 / np.where(diagonal > 0, diagonal, 1), 0))
    solution, fault = cg(matrix, right, tol=RELATIVE_RESIDUAL, atol=0, maxiter=MOST_STEPS, M=inverse, callback=count)
    if fault:
        raise ValueError(f"the map did not converge in {MOST_STEPS} steps")
    return solution, steps[0]

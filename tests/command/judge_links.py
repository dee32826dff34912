# SPDX-License-Identifier: Apache-2.0
"""Whether hexahedra can meet at a vertex: searches for triangulations of the sphere and of the disc with given numbers of
triangles at their vertices, by brute force.

A polygon is filled triangle by triangle. `open` has for each vertex on its border how many triangles it still needs inside;
`inner` the numbers of triangles of the vertices that are not yet used. Two vertices have at most one edge.
"""

import itertools
from functools import lru_cache

MOST_TRIANGLES = 20


def fillings(border, need, edges, inner):
    """Yields (edges, unused inner vertices) of all ways to fill a polygon. border: its vertices; need: {vertex: triangles};
    edges: the set of edges so far; inner: sorted tuple of numbers for vertices inside."""
    if len(border) == 3 and all(need[v] == 1 for v in border):
        yield edges, inner
        return
    if len(border) < 3 or any(need[v] < 1 for v in border):
        return
    # At the vertex that needs fewest: the triangle on the side that leaves it.
    at = min(range(len(border)), key=lambda i: need[border[i]])
    order = border[at:] + border[:at]
    a, b = order[0], order[1]
    for number in sorted(set(inner)):
        if need[a] < 2 or need[b] < 2:
            break
        new = 1 + max(max(e) for e in edges)
        rest = list(inner)
        rest.remove(number)
        yield from fillings((a, new, *order[1:]), {**need, a: need[a] - 1, b: need[b] - 1, new: number - 1},
                            edges | {(a, new), (b, new)}, tuple(rest))
    for i in range(2, len(order)):
        yield from split(order, i, need, edges, inner)


def split(order, i, need, edges, inner):
    """The fillings with a triangle from the first side of a polygon to its vertex i, with what is left on either side of it: from
    the second vertex to i, and from i to the first. Where i is next to an end of the side, nothing is left there."""
    a, b, c = order[0], order[1], order[i]
    has_near, has_far = i > 2, i < len(order) - 1
    new = {tuple(sorted(pair)) for pair, is_new in (((b, c), has_near), ((a, c), has_far)) if is_new}
    if new & edges or (not has_near and need[b] != 1) or (not has_far and need[a] != 1):
        return
    rest = need[c] - 1
    for at_near in range(rest + 1):
        if (at_near > 0) != has_near or (rest - at_near > 0) != has_far:
            continue
        near_need, far_need = {**need, b: need[b] - 1, c: at_near}, {**need, a: need[a] - 1, c: rest - at_near}
        near = fillings(order[1:i + 1], near_need, edges | new, inner) if has_near else [(edges | new, inner)]
        for now, left in near:
            yield from fillings((a, *order[i:]), far_need, now, left) if has_far else [(now, left)]


def can_fill(numbers, inner):
    """Whether a polygon whose vertices have these numbers of triangles, in order, can be filled with these inside."""
    size = len(numbers)
    sides = frozenset(tuple(sorted((i, (i + 1) % size))) for i in range(size))
    return any(not left for _, left in fillings(tuple(range(size)), dict(enumerate(numbers)), sides, tuple(inner)))


def least_cyclic(word):
    """The first in order of all rotations of a word, forward and backward."""
    turned = [word[i:] + word[:i] for i in range(len(word))] or [word]
    return min(min(turned), min(w[::-1] for w in turned))


def with_twos(creases, twos):
    """All cyclic words of these numbers with so many twos between them."""
    gaps = max(1, len(creases))
    for bars in itertools.combinations(range(twos + gaps - 1), gaps - 1):
        ends = [-1, *bars, twos + gaps - 1]
        counts = [b - a - 1 for a, b in zip(ends[:-1], ends[1:])]
        yield tuple(x for i, n in enumerate(counts) for x in (*creases[i:i + 1], *[2] * n))


@lru_cache(maxsize=None)
def disc_of(valences, creases):
    size = 4 - sum(4 - n for n in valences) - sum(2 - k for k in creases)
    if size < 1 or any(k < 1 for k in creases):
        return False
    if size > MOST_TRIANGLES:
        return None
    # 2 inside + border = size + 2.
    for regular in range(size):
        border = size + 2 - 2 * (len(valences) + regular)
        if border < max(3, len(creases)):
            break
        inner = sorted(valences + (4,) * regular)
        if any(can_fill(word, inner) for word in set(map(least_cyclic, with_twos(creases, border - len(creases))))):
            return True
    return False


def has_disc(valences, creases):
    """Whether the disc has a triangulation with vertices inside of these numbers of triangles, and otherwise 4, and on its
    border of these in cyclic order, and otherwise 2. None if it has more than MOST_TRIANGLES."""
    return disc_of(tuple(sorted(valences)), least_cyclic(tuple(k for k in creases if k != 2)))


@lru_cache(maxsize=None)
def sphere_of(valences):
    twice_regular = 12 - sum(6 - n for n in valences)
    if twice_regular < 0 or twice_regular % 2:
        return False
    numbers = valences + (4,) * (twice_regular // 2)
    if 2 * len(numbers) - 4 > MOST_TRIANGLES:
        return None
    # The star of a vertex, and the disc on the other side of the ring around it.
    centre, others = min(numbers), sorted(numbers)[1:]
    for ring in set(map(least_cyclic, itertools.permutations(others, centre))):
        left = list(others)
        for n in ring:
            left.remove(n)
        if can_fill(tuple(n - 2 for n in ring), left):
            return True
    return False


def has_sphere(valences):
    """Whether the sphere has a triangulation with vertices of these valences, and otherwise 4. None if it has more than
    MOST_TRIANGLES."""
    return sphere_of(tuple(sorted(valences)))

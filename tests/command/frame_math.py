# SPDX-License-Identifier: Apache-2.0
"""Energies, coefficients and matchings of frames by formulas other than the program's.

Notation: r1, r2, r3 the axes of a frame, h its degree-4 coefficients; P the Legendre polynomial of degree 4; n a unit
normal that u, v complete to a frame. With Y(a).Y(b) = (9 / 4 pi) P(a.b) and h = c (Y(r1) + Y(r2) + Y(r3)) every product
of degree-4 coefficients is a sum of P over pairs of axes.
"""

import itertools
import math

import numpy as np


def legendre(t):
    return (35 * t**4 - 30 * t**2 + 3) / 8


def frame_product(a, b):
    """h(a).h(b) of frames (..., axis, component): (4 / 21) sum P(r_i . s_j)."""
    return 4 / 21 * legendre(a @ np.swapaxes(b, -1, -2)).sum(axis=(-1, -2))


def normal_energy(n, axes):
    """E_n(h) of degree 4: 1 - |P_n h|^2 - 2 b_n.h + 7/12, with |P_n h|^2 = (5 / 48) |sum ((u + i v).r_k)^4|^2 and
    b_n.h = (1 / 3) sum P(n.r_k)."""
    helper = np.eye(3)[np.argmin(np.abs(n))]
    u = np.cross(n, helper)
    u /= np.linalg.norm(u)
    v = np.cross(n, u)
    fourfold = np.sum((axes @ (u + 1j * v)) ** 4)
    return 1 - 5 / 48 * abs(fourfold) ** 2 - 2 / 3 * legendre(axes @ n).sum() + 7 / 12


def boundary_form(normals, weights):
    """A, b, c of sum weight E_n(h) = h.A h - 2 b.h + c, degree 4. The frames with an axis along n are
    b_n + sqrt(5/12) (cos(4 t) C + sin(4 t) S), t their turn about n; C and S span P_n."""
    matrix, linear = sum(weights) * np.eye(9), np.zeros(9)
    for n, weight in zip(normals, weights):
        u = np.cross(n, np.eye(3)[np.argmin(np.abs(n))])
        u /= np.linalg.norm(u)
        v = np.cross(n, u)
        turns = np.pi / 8 * np.arange(4)
        h = coefficients(4, np.array([(c * u + s * v, c * v - s * u, n) for c, s in zip(np.cos(turns), np.sin(turns))]))
        linear += weight * (h[0] + h[2]) / 2
        for harmonic in ((h[0] - h[2]) / 2, (h[1] - h[3]) / 2):
            matrix -= 12 / 5 * weight * np.outer(harmonic, harmonic)
    return matrix, linear, 19 / 12 * sum(weights) - sum(weights)


def least_near(form, axes):
    """The minimum of a boundary_form over frames that downhill Newton steps from these axes lead to."""
    matrix, linear, constant = form
    turns = generators(4)

    def energy(h):
        return h @ matrix @ h - 2 * linear @ h + constant

    h = coefficients(4, axes[None])[0]
    for _ in range(40):
        turned, residual = turns @ h, matrix @ h - linear
        slope = turned @ residual
        curvature = turned @ matrix @ turned.T - 0.5 * (turned @ (turns @ residual).T + (turns @ residual) @ turned.T)
        values, vectors = np.linalg.eigh(curvature)
        step = -vectors @ ((vectors.T @ slope) / np.maximum(np.abs(values), 1e-8 * np.abs(values).max()))
        step *= min(1, 0.3 / max(np.linalg.norm(step), 1e-300))
        while True:
            w, q = np.linalg.eigh(1j * np.einsum("a,aij->ij", step, turns))
            next_h = (q * np.exp(-1j * w) @ q.conj().T).real @ h
            if energy(next_h) <= energy(h) or np.linalg.norm(step) < 1e-9:
                break
            step = step / 2
        h = next_h
        if np.linalg.norm(step) < 1e-9:
            break
    return energy(h)


def cubic_projection(n):
    """The two harmonics with |m| = 2 about n as symmetric cubic tensors of unit norm, shape (2, 27): degree 3."""
    helper = np.eye(3)[np.argmin(np.abs(n))]
    u = np.cross(n, helper)
    u /= np.linalg.norm(u)
    v = np.cross(n, u)
    tensors = []
    for quadratic in (np.outer(u, u) - np.outer(v, v), np.outer(u, v) + np.outer(v, u)):
        product = np.einsum("i,jk->ijk", n, quadratic)
        symmetric = sum(np.transpose(product, order) for order in itertools.permutations(range(3)))
        tensors.append((symmetric / np.linalg.norm(symmetric)).ravel())
    return np.array(tensors)


def cubic_spectrum(normals, weights):
    """Eigenvalues over total weight of sum weight (I - P_n) on the seven harmonics of degree 3, ascending."""
    matrix = sum(w * p.T @ p for w, p in zip(weights, map(cubic_projection, normals)))
    # All P_n live in the seven dimensions; of the 27 of all tensors the others have eigenvalue zero.
    return 1 - np.linalg.eigvalsh(matrix)[:-8:-1] / sum(weights)


def harmonics(degree, x):
    """Real orthonormal harmonics at unit vectors x (..., 3), last axis m = -degree ... degree."""
    radius, phi = np.hypot(x[..., 0], x[..., 1]), np.arctan2(x[..., 1], x[..., 0])
    values = [None] * (2 * degree + 1)
    for m in range(degree + 1):
        polynomial = np.polynomial.legendre.Legendre.basis(degree).deriv(m)(x[..., 2]) * radius**m
        norm = math.sqrt((2 * degree + 1) / (4 * math.pi) * math.factorial(degree - m) / math.factorial(degree + m))
        norm *= math.sqrt(2) if m else 1
        values[degree - m] = norm * polynomial * np.sin(m * phi)
        values[degree + m] = norm * polynomial * np.cos(m * phi)
    return np.stack(values, axis=-1)


def coefficients(degree, axes):
    """Of frames (cells, axis, component). Degree 3: (r1.x)(r2.x)(r3.x) projected by quadrature, normalised."""
    if degree == 4:
        return math.sqrt(16 * math.pi / 189) * harmonics(4, axes).sum(axis=1)
    heights, weights = np.polynomial.legendre.leggauss(6)
    angles = 2 * np.pi * np.arange(12) / 12
    ring = np.sqrt(1 - heights**2)[:, None]
    points = np.stack([ring * np.cos(angles), ring * np.sin(angles),
                       np.broadcast_to(heights[:, None], (6, 12))], axis=-1).reshape(-1, 3)
    products = np.prod(np.einsum("cak,pk->cap", axes, points), axis=1)
    projected = (products * np.repeat(weights, 12)) @ harmonics(3, points)
    return projected / np.linalg.norm(projected, axis=1, keepdims=True)


def generators(degree):
    """L_x, L_y, L_z as the design tabulates them; antisymmetric."""
    tables = {
        3: ({(-1, 0): -6, (-2, 1): -2.5, (-1, 2): -2.5, (-3, 2): -1.5, (-2, 3): -1.5},
            {(-3, -2): 1.5, (-2, -1): 2.5, (0, 1): -6, (1, 2): -2.5, (2, 3): -1.5}),
        4: ({(-1, 0): -10, (-2, 1): -4.5, (-1, 2): -4.5, (-3, 2): -3.5, (-2, 3): -3.5, (-4, 3): -2, (-3, 4): -2},
            {(-4, -3): 2, (-3, -2): 3.5, (-2, -1): 4.5, (0, 1): -10, (1, 2): -4.5, (2, 3): -3.5, (3, 4): -2}),
    }[degree]
    turns = [{key: math.copysign(math.sqrt(abs(x)), x) for key, x in table.items()} for table in tables]
    turns.append({(-m, m): m for m in range(1, degree + 1)})
    result = np.zeros((3, 2 * degree + 1, 2 * degree + 1))
    for matrix, table in zip(result, turns):
        for (row, column), x in table.items():
            matrix[row + degree, column + degree], matrix[column + degree, row + degree] = x, -x
    return result


def deviation(degree, h):
    """E_sym of coefficients (cells, m)."""
    turned = np.einsum("aij,cj->cai", generators(degree), h)
    gram = turned @ np.swapaxes(turned, 1, 2)
    gram -= np.trace(gram, axis1=1, axis2=2)[:, None, None] / 3 * np.eye(3)
    return (gram**2).sum(axis=(1, 2))


def cube_rotations():
    """The 24 signed permutation matrices of determinant 1."""
    found = []
    for order in itertools.permutations(range(3)):
        for signs in itertools.product((-1, 1), repeat=3):
            matrix = np.zeros((3, 3))
            matrix[range(3), order] = signs
            if np.linalg.det(matrix) > 0:
                found.append(matrix)
    return np.array(found)


CUBE_ROTATIONS = cube_rotations()


def matching(axes_from, axes_to):
    """The cube rotation g that brings R_to g nearest to R_from. Axes are rows, so R is their transpose."""
    relative = axes_to @ axes_from.T
    return CUBE_ROTATIONS[np.argmax(np.einsum("gij,ij->g", CUBE_ROTATIONS, relative))]

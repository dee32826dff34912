# SPDX-License-Identifier: Apache-2.0
"""Surfaces with something wrong, made from sound ones: arrays (triangles, corners, coordinates)."""

import numpy as np


def anywhere(random):
    """A map of triangles to those of a random size, turned and moved at random, lengths times the second result."""
    rotation, _ = np.linalg.qr(random.normal(size=(3, 3)))
    rotation[0] *= np.sign(np.linalg.det(rotation))
    size = 10 ** random.uniform(-2, 3)
    offset = size * random.normal(size=3)
    return (lambda triangles: size * triangles @ rotation + offset), size


def subdivided(triangles, times=1):
    """Each triangle in four."""
    for _ in range(times):
        a, b, c = np.moveaxis(triangles, 1, 0)
        ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
        quarters = ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))
        triangles = np.concatenate([np.stack(corners, axis=1) for corners in quarters])
    return triangles


def flipped(triangles, share, random):
    """A share of the facets turned, and how many that were."""
    chosen = random.random(len(triangles)) < share
    triangles = triangles.copy()
    triangles[chosen] = triangles[chosen][:, ::-1]
    return triangles, int(chosen.sum())


def moebius_band(segments=40, radius=1.0, half_width=0.3):
    rims = []
    for i in range(segments):
        angle = 2 * np.pi * i / segments
        rims.append([np.array([(radius + s * np.cos(angle / 2)) * np.cos(angle),
                               (radius + s * np.cos(angle / 2)) * np.sin(angle), s * np.sin(angle / 2)])
                     for s in (-half_width, half_width)])
    rims.append(rims[0][::-1])
    return np.array([t for (a, b), (c, d) in zip(rims, rims[1:]) for t in ((a, b, d), (a, d, c))])


def sheet(side=0.6, times=3):
    corners = side * np.array([[-.5, -.5, 0], [.5, -.5, 0], [.5, .5, 0], [-.5, .5, 0]])
    return subdivided(np.array([corners[[0, 1, 2]], corners[[0, 2, 3]]]), times)

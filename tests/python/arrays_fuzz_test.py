# SPDX-License-Identifier: Apache-2.0
"""Arrays of any shape, type, order and stride give the right result or a TypeError (InputError for values that are wrong), never a crash.

CROSSGRAIN_ROUNDS is how many random arrays, 400 unless it says otherwise; CROSSGRAIN_SEED the first seed.
"""

import os
import sys
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
import crossgrain as cg
import numpy as np
from solids import ball, box, cube_of_tets

ROUNDS = int(os.environ.get("CROSSGRAIN_ROUNDS", "400"))
SEED = int(os.environ.get("CROSSGRAIN_SEED", "0"))

REAL = ["<f8", ">f8", "<f4", ">f4", "f2", "g", "i1", "<i2", ">i2", "<i4", ">i4", "<i8", ">i8", "u1", "<u2", "<u4", ">u4", "<u8"]
NOT_REAL = ["?", "c8", "c16", "O", "S4", "U4", "M8[s]", "m8[s]", "V8"]
INTEGERS = [name for name in REAL if np.dtype(name).kind in "iu"]


def rearranged(array, rng):
    """The same values with another order and other strides."""
    way = rng.integers(7)
    if way == 0:
        return np.asfortranarray(array)
    if way == 1:
        return np.repeat(array, 2, axis=0)[::2]
    if way == 2:
        return np.ascontiguousarray(array[::-1])[::-1]
    if way == 3:
        wide = np.zeros((array.shape[0], array.shape[1] + 3), array.dtype)
        wide[:, 1:1 + array.shape[1]] = array
        return wide[:, 1:1 + array.shape[1]]
    if way == 4:
        # Not aligned.
        raw = np.zeros(array.nbytes + 1, np.uint8)[1:].view(array.dtype).reshape(array.shape)
        raw[...] = array
        return raw
    if way == 5:
        copy = array.copy()
        copy.flags.writeable = False
        return copy
    return array.tolist() if array.dtype.kind in "fiu" else array


class AnyArray(unittest.TestCase):
    def test_of_points_gives_the_samples_of_its_values(self):
        field = cg.solve(*ball(6), resolution=8)
        for seed in range(SEED, SEED + ROUNDS):
            rng = np.random.default_rng(seed)
            with self.subTest(seed=seed):
                dtype = np.dtype(REAL[rng.integers(len(REAL))])
                values = rng.uniform(-1, 1, (int(rng.integers(0, 9)), 3))
                points = (values if dtype.kind == "f" else np.rint(values * 2).clip(0)).astype(dtype)
                expected = field.sample(np.array(points, dtype=np.float64))
                np.testing.assert_array_equal(field.sample(rearranged(points, rng)), expected)

    def test_of_another_type_is_a_type_error(self):
        field = cg.solve(*ball(6), resolution=8)
        for name in NOT_REAL:
            with self.subTest(dtype=name):
                points = np.zeros((4, 3), name)
                for call in (lambda p=points: field.sample(p), lambda p=points: cg.solve(p, [[0, 1, 2]]),
                             lambda p=points: cg.solve(box()[0], p), lambda p=points: field.streamlines(p),
                             lambda p=points: cg.solve_onto(p, [[0, 1, 2, 3]])):
                    self.assertRaises(TypeError, call)
        for junk in ([[1, 2], [3]], "points", None, object(), {1: 2}, [[1, 2, "a"]], np.ma.masked_equal([[1.0, 2, 3]], 2)):
            self.assertRaises(TypeError, field.sample, junk)

    def test_of_another_shape_is_a_type_error(self):
        field = cg.solve(*ball(6), resolution=8)
        for seed in range(SEED, SEED + ROUNDS):
            rng = np.random.default_rng(seed)
            shape = tuple(int(n) for n in rng.integers(0, 5, rng.integers(0, 5)))
            with self.subTest(shape=shape):
                points = np.zeros(shape, REAL[rng.integers(len(REAL))])
                is_right = (len(shape) == 2 and shape[1] == 3) or shape == (3,) or (len(shape) <= 2 and 0 in shape[-1:] or shape == (0,))
                if is_right:
                    field.sample(points)
                else:
                    self.assertRaises(TypeError, field.sample, points)

    def test_of_a_surface_gives_its_field(self):
        vertices, triangles = box((2, 1, 1))
        expected = cg.solve(vertices, triangles, resolution=6).quaternions
        for seed in range(SEED, SEED + ROUNDS // 8):
            rng = np.random.default_rng(seed)
            with self.subTest(seed=seed):
                its_vertices = rearranged(vertices.astype(REAL[rng.integers(len(REAL))]), rng)
                its_triangles = rearranged(triangles.astype(INTEGERS[rng.integers(len(INTEGERS))]), rng)
                np.testing.assert_array_equal(cg.solve(its_vertices, its_triangles, resolution=6).quaternions, expected)

    def test_of_indices_out_of_range_is_an_input_error(self):
        vertices, triangles = box()
        for wrong in (-1, 8, 2**31, 2**32, 2**40, -2**63):
            bad = triangles.copy()
            bad[3, 1] = wrong
            with self.subTest(index=wrong), self.assertRaisesRegex(cg.InputError, str(wrong)):
                cg.solve(vertices, bad)
            points, cells = cube_of_tets(1)
            cells[2, 1] = wrong
            with self.subTest(index=wrong), self.assertRaisesRegex(cg.InputError, str(wrong)):
                cg.solve_onto(points, cells)
        self.assertRaises(TypeError, cg.solve, vertices, triangles.astype(float))

    def test_of_values_that_are_not_finite_is_an_error_of_the_library(self):
        vertices, triangles = box()
        for wrong in (np.nan, np.inf, -np.inf, np.longdouble("1e4000")):
            bad = vertices.astype(np.longdouble)
            bad[2, 1] = wrong
            with self.subTest(value=wrong):
                self.assertRaises(cg.InputError, cg.solve, bad, triangles)
                self.assertRaises(cg.UsageError, cg.solve(vertices, triangles, resolution=8).sample, bad)


if __name__ == "__main__":
    unittest.main()

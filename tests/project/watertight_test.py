#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""watertight.py accepts a tetrahedron and refuses it with a face missing, turned, doubled or all inside out."""

import sys
import unittest
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).parent))
sys.dont_write_bytecode = True
import watertight  # noqa: E402

POINTS = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], dtype=numpy.float32)
TETRAHEDRON = POINTS[numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]])]


def is_refused(corners):
    return bool(list(watertight.faults_of(corners)))


class WatertightCheck(unittest.TestCase):
    def test_accepts_a_tetrahedron_and_knows_its_volume(self):
        self.assertFalse(is_refused(TETRAHEDRON))
        self.assertAlmostEqual(watertight.volume_of(TETRAHEDRON), 1 / 6)

    def test_refuses_a_missing_face(self):
        self.assertTrue(is_refused(TETRAHEDRON[1:]))

    def test_refuses_a_turned_face(self):
        turned = TETRAHEDRON.copy()
        turned[0] = turned[0, ::-1]
        self.assertTrue(is_refused(turned))

    def test_refuses_a_doubled_face(self):
        self.assertTrue(is_refused(numpy.concatenate([TETRAHEDRON, TETRAHEDRON[:1]])))

    def test_refuses_a_surface_inside_out(self):
        self.assertTrue(is_refused(TETRAHEDRON[:, ::-1]))

    def test_refuses_a_gap_of_one_bit(self):
        cracked = TETRAHEDRON.copy()
        cracked[1, 1, 0] = numpy.nextafter(numpy.float32(1), numpy.float32(2))
        self.assertTrue(is_refused(cracked))


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A sample of nightly.py: after a system call that fails, or a kill at it, every folder is old or new, and whole."""

import random
import tempfile
import unittest
from pathlib import Path

from faults import FAULTS, all_cases, broken_faults, folder_for_runs

COUNT = 40


class Faults(unittest.TestCase):
    def test_leave_every_result_old_or_new_and_whole(self):
        with tempfile.TemporaryDirectory(prefix="crossgrain-faults-", dir=folder_for_runs()) as folder:
            cases = all_cases(Path(folder))
            chosen = [(case, call, fault) for case in cases for call in range(1, len(case.calls) + 1) for fault in FAULTS]
            self.assertGreater(len(chosen), COUNT)
            self.assertEqual(broken_faults(random.Random(1).sample(chosen, COUNT)), [])


if __name__ == "__main__":
    unittest.main()

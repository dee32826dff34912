#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A sample of nightly.py: after a system call that fails, or a kill at it, every folder is old or new, and whole."""

import random
import tempfile
import time
import unittest
from pathlib import Path

from faults import FAULTS, all_cases, broken_faults, folder_for_runs

SECONDS = 40


class Faults(unittest.TestCase):
    def test_leave_every_result_old_or_new_and_whole(self):
        with tempfile.TemporaryDirectory(prefix="crossgrain-faults-", dir=folder_for_runs()) as folder:
            begin = time.monotonic()
            cases = all_cases(Path(folder))
            chosen = [(case, call, fault) for case in cases for call in range(1, len(case.calls) + 1) for fault in FAULTS]
            random.Random(1).shuffle(chosen)
            done = 0
            while chosen and time.monotonic() - begin < SECONDS:
                self.assertEqual(broken_faults([chosen.pop()]), [])
                done += 1
            self.assertGreater(done, 30, "each takes half a second")


if __name__ == "__main__":
    unittest.main()

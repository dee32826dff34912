# SPDX-License-Identifier: Apache-2.0
"""The examples in Python run, and say what they should."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(os.environ.get("CROSSGRAIN_EXAMPLES", Path(__file__).parents[2] / "examples" / "python"))

# What the last lines say.
SAYINGS = {
    "first_field": r"hexahedra: hexahedra fit locally.*\nwrote .*png",
    "orient_material": r"6000 elements; the stiff axis is within [01]\.\d\d degrees of z",
    "walk_singularities": r"4 arcs, 8 nodes: meshable(\n  valence 3.*){4}",
    "field_for_hexahedra": r"arcs: \[3, 3, 3, 3\]; hexahedra fit locally.*\nwrote ",
}


class Example(unittest.TestCase):
    def test_programs_run(self):
        self.assertEqual(set(SAYINGS) | {"solids"}, {path.stem for path in EXAMPLES.glob("*.py")})
        for name, saying in SAYINGS.items():
            with self.subTest(example=name), tempfile.TemporaryDirectory() as folder:
                result = subprocess.run([sys.executable, EXAMPLES / f"{name}.py", f"{folder}/out"], capture_output=True, text=True, timeout=100,
                                        check=False)
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                self.assertRegex(result.stdout, re.compile(saying))


if __name__ == "__main__":
    unittest.main()

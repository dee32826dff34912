#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""check_imports.py refuses circles however their imports are written, and nothing else."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "cmake"))
sys.dont_write_bytecode = True
import check_imports  # noqa: E402


def faults_of(files):
    """What the check says of a project that consists of these files: {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            target = Path(folder) / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        return list(check_imports.faults(Path(folder)))


def faults_of_python(**modules):
    return faults_of({f"python/crossgrain/{name}.py": text for name, text in modules.items()})


class ImportCheck(unittest.TestCase):
    def test_a_circle_of_python_modules_is_told_in_full(self):
        faults = faults_of_python(a="from .b import f\n", b="from . import c\n", c="import crossgrain.a\n", d="from .a import g\n")
        self.assertEqual(faults, ["python/crossgrain: a imports b imports c imports a"])

    def test_imports_in_functions_and_for_types_count(self):
        for hidden in ("def f():\n    from .b import g\n", "if TYPE_CHECKING:\n    from .b import B\n", "from crossgrain.b import g\n",
                       "from crossgrain import b\n"):
            with self.subTest(hidden=hidden):
                self.assertEqual(len(faults_of_python(a=hidden, b="from .a import f\n")), 1)

    def test_a_circle_through_the_package_itself_counts(self):
        self.assertEqual(len(faults_of_python(__init__="from .a import f\n", a="from . import f\n")), 1)

    def test_other_packages_and_generated_modules_are_no_circle(self):
        self.assertEqual(faults_of_python(a="import b\nfrom numpy import b\nfrom .options import B\n", b="from .a import f\n"), [])

    def test_a_circle_of_typescript_modules_is_refused(self):
        back = 'import { g } from "../a.ts";\n'
        for there in ('import type { B } from "./ui/b.ts";', 'import {\n  type B,\n  f,\n} from "./ui/b.ts";', 'export * from "./ui/b.ts";',
                      'import "./ui/b.ts";', 'const b = await import("./ui/b.ts");'):
            with self.subTest(there=there):
                self.assertEqual(faults_of({"viewer/src/a.ts": there, "viewer/src/ui/b.ts": back}),
                                 ["viewer/src: a.ts imports ui/b.ts imports a.ts"])

    def test_comments_and_other_packages_are_no_circle(self):
        for other in ('// import { f } from "./b.ts";', '/* from\n"./b.ts" */', 'import { b } from "b.ts";'):
            with self.subTest(other=other):
                self.assertEqual(faults_of({"viewer/src/a.ts": other, "viewer/src/b.ts": 'import { f } from "./a.ts";'}), [])


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: Apache-2.0
"""docs/options.md lists the options that there are, and docs/notes/options.md what became of those of before.

CROSSGRAIN_PROGRAM names the program.
"""

import os
import re
import subprocess
import unittest
from pathlib import Path

import crossgrain as cg
from crossgrain import _interface, _library, _options

DOCS = Path(__file__).parents[2] / "docs"
PARTS = {"hexahedra": "HexOptions", "tets": "TetMakingOptions", "tags": "TetTagOptions", "solve": "SolveOptions"}
LISTED = ["SolveOptions", "HexFitOptions", "ReadOptions", "TetTagOptions", "MapPreparationOptions", "OutputOptions", "TetMakingOptions", "RepairOptions", "HexOptions", "StreamlineOptions",
          "PictureOptions"]
KINDS = {name: getattr(cg, name)._kind for name in [*LISTED, "HexMeshingOptions"]}
MOST_NAMES = 45


def rows_of(text):
    """The cells of each row of the tables, without marks of code."""
    for line in text.splitlines():
        if line.startswith("| `"):
            yield [cell.strip().replace("`", "") for cell in line.strip()[1:-1].split("|")]


def default_of(handle, name, its_type):
    if its_type == _interface.TEXT:
        return _library.text_from("options_get_text", handle, name.encode()) or "none"
    rows = _library.made("numbers", "options_get_numbers", handle, name.encode())
    count = _library.library.crossgrain_numbers_rows(rows)
    numbers = _library.array_view(rows, _library.library.crossgrain_numbers_data(rows), float, (count,))
    if its_type == _interface.FLAG:
        return "yes" if numbers[0] else "no"
    return ", ".join(f"{number:g}" for number in numbers) or "none"


class ListedOptions(unittest.TestCase):
    def setUp(self):
        self.rows = list(rows_of((DOCS / "options.md").read_text(encoding="utf-8")))
        self.types = {of: _options.types_of(kind) for of, kind in KINDS.items()}

    def test_are_those_of_the_library(self):
        listed = {of: [name for name, structs, *_ in self.rows if of in structs.split(", ")] for of in LISTED}
        listed["HexMeshingOptions"] = [f"{part}.{name}" for part, of in PARTS.items() for name in listed[of]]
        listed["HexFitOptions"] += [f"tags.{name}" for name in listed["TetTagOptions"]]
        for of, types in self.types.items():
            self.assertEqual(sorted(listed[of]), sorted(types), of)

    def test_have_its_defaults(self):
        for name, structs, _, default, _ in self.rows:
            for of in structs.split(", "):
                handle = _library.made("options", "options_new", KINDS[of])
                self.assertEqual(default_of(handle, name, self.types[of][name]), default, f"{of}.{name}")

    def test_are_few(self):
        self.assertLessEqual(len(self.rows), MOST_NAMES)

    def test_have_the_flags_of_the_program(self):
        commands = ("solve", "tets", "hex", "fit", "render", "streamlines")
        texts = [subprocess.run([os.environ["CROSSGRAIN_PROGRAM"], "help", command], stdout=subprocess.PIPE, check=True).stdout.decode() for command in commands]
        flags = set(re.findall(r"--[a-z-]+", "".join(texts)))
        for name, _, named, *_ in self.rows:
            self.assertLessEqual(set(re.findall(r"--[a-z-]+", named)), flags, name)


class FormerOptions(unittest.TestCase):
    def test_are_refused_with_what_replaced_them(self):
        sections = re.split(r"^## ", (DOCS / "notes" / "options.md").read_text(encoding="utf-8"), flags=re.M)[1:]
        for section in sections:
            of = section.split()[0]
            if of not in KINDS:
                continue
            types = _options.types_of(KINDS[of])
            handle = _library.made("options", "options_new", KINDS[of])
            for names, became in rows_of(section):
                for name in names.split(", "):
                    self.assertEqual(name in types, became.startswith("kept"), f"{of}.{name}")
                    if name not in types:
                        with self.assertRaisesRegex(cg.UsageError, f"{re.escape(name)} is no option any more; "):
                            _library.call("options_set_number", handle, name.encode(), 0.0)

    def test_are_usage_errors_in_python(self):
        for make in (lambda: cg.TetMakingOptions(gmsh="gmsh"), lambda: setattr(cg.TetMakingOptions(), "gmsh", "gmsh"),
                     lambda: cg.TetMakingOptions().creases.least_deg, lambda: cg.make_tets("a.stl", options=cg.TetMakingOptions(triangles=None))):
            with self.assertRaisesRegex(cg.UsageError, "is no option any more"):
                make()


if __name__ == "__main__":
    unittest.main()

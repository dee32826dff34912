#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The answer about a field is the same in report.json, `check`, the page and the legend of pictures."""

import json
import unittest

import numpy as np

from counts_test import description_of
from page_reader import Page
from program import CommandTest, box_triangles, cylinder_triangles, stl_bytes, with_option
from render_test import read_png

WORDS = {"meshable": "hexahedra fit locally", "not_meshable": "hexahedra cannot follow this field", "undecided": "undecided"}


def pyramid_triangles(height):
    """On a square of side 2; four creases meet at its apex, around which no hexahedra fit."""
    base = np.array([(-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0)], float)
    sides = [(base[k], base[(k + 1) % 4], np.array((0, 0, height))) for k in range(4)]
    return np.array([(base[0], base[2], base[1]), (base[0], base[3], base[2]), *sides], float)


class AnswerTest(CommandTest):
    """A model of each answer, and a second without corners that meet; a plate is thinner than a cell."""

    MODELS = {"meshable": {"box": box_triangles(), "cylinder": cylinder_triangles()},
              "not_meshable": {"high": pyramid_triangles(2.0)},
              "undecided": {"plate": box_triangles((4.0, 3.0, 0.1))}}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.shared = CommandTest()
        cls.shared.setUp()
        cls.addClassCleanup(cls.shared.doCleanups)
        for models in cls.MODELS.values():
            for name, triangles in models.items():
                cls.shared.write(f"{name}.stl", stl_bytes(triangles))
                result = cls.shared.run_here("solve", f"{name}.stl", "--resolution", 24, "--quiet")
                assert result.returncode == 0, result.stderr

    def setUp(self):
        self.folder = self.shared.folder

    def for_each_model(self):
        for verdict, models in self.MODELS.items():
            for name in models:
                with self.subTest(model=name):
                    yield verdict, name, json.loads((self.folder / f"{name}.frames" / "report.json").read_text())

    def test_the_report_has_the_answer_in_words(self):
        for verdict, _, report in self.for_each_model():
            self.assertEqual(report["verdict"], verdict)
            self.assertTrue(report["answer"].startswith(WORDS[verdict]), report["answer"])
            self.assertEqual("'crossgrain hex' changes the field, and may mesh the part" in report["answer"], verdict == "not_meshable")
            self.assertEqual([reason["verdict"] for reason in report["reasons"][:1]], [verdict] * (verdict != "meshable"))

    def test_check_says_the_same_first(self):
        for _, name, report in self.for_each_model():
            self.assertEqual(self.run_here("check", f"{name}.frames").stdout.splitlines()[0], with_option(report["answer"]))
            told = json.loads(self.run_here("check", f"{name}.frames", "--json").stdout)
            self.assertEqual(told["verdict"], report["verdict"])

    def test_the_page_holds_the_same(self):
        for _, name, report in self.for_each_model():
            page = Page(self.folder / f"{name}.frames" / "report.html").report
            self.assertEqual([page[key] for key in ("verdict", "answer", "reasons")],
                             [report[key] for key in ("verdict", "answer", "reasons")])

    def test_the_legend_of_a_picture_has_the_answer_and_its_first_reason(self):
        for verdict, name, report in self.for_each_model():
            self.assert_succeeds(self.run_here("render", f"{name}.frames", "--size", "1200x400", "-o", f"{name}.png"))
            title, *lines = description_of(self.folder / f"{name}.png").splitlines()
            self.assertEqual(title, f"Answer: {WORDS[verdict]}")
            if verdict == "meshable":
                self.assertNotIn("because", report["answer"])
            else:
                self.assertIn(lines[0].strip(), report["answer"])
            self.assertEqual(any("other reason" in line for line in lines), len(report["reasons"]) > 1)

    def test_a_picture_marks_a_corner_without_hexahedra_as_impossible(self):
        crimson = {}
        for name in ("high", "box"):
            self.assert_succeeds(self.run_here("render", f"{name}.frames", "--without", "legend", "--size", "240x180", "-o", "a.png"))
            r, g, b = (read_png(self.folder / "a.png").astype(int)[:, :, k] for k in range(3))
            crimson[name] = ((r > 150) & (g < 60) & (b < 140)).sum()
        self.assertGreater(crimson["high"], 10)
        self.assertEqual(crimson["box"], 0)


if __name__ == "__main__":
    unittest.main()

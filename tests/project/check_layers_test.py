#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""check_layers.py refuses each kind of include that goes the wrong way, and no other."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "cmake"))
sys.dont_write_bytecode = True
import check_layers  # noqa: E402


def faults_of(files):
    """What the check says of a project that consists of these files: {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            target = Path(folder) / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        return list(check_layers.faults(Path(folder)))


class LayerCheck(unittest.TestCase):
    def assert_one_fault(self, path, include):
        faults = faults_of({path: f"// a comment\n#include {include}\n"})
        self.assertEqual(len(faults), 1, faults)
        self.assertIn(f"{path}:2:", faults[0])

    def assert_no_fault(self, path, include):
        self.assertEqual(faults_of({path: f"#include {include}\n"}), [])

    def test_a_layer_may_include_itself_those_below_and_public_headers(self):
        for include in ('"field/energy.hpp"', '"base/parallel.hpp"', '"crossgrain/types.hpp"', "<vector>", "<map>", "<zlib.h>"):
            self.assert_no_fault("src/field/energy.cpp", include)

    def test_the_list_in_contributing_must_be_that_of_the_layers(self):
        with tempfile.TemporaryDirectory() as folder:
            page = Path(folder) / "CONTRIBUTING.md"
            lines = [f"src/{layer}    words\n" for layer in check_layers.LAYERS]
            page.write_text("".join(lines), encoding="utf-8")
            self.assertEqual(list(check_layers.faults_of_the_list(Path(folder))), [])
            page.write_text("".join(lines[:-1]), encoding="utf-8")
            self.assertEqual(len(list(check_layers.faults_of_the_list(Path(folder)))), 1)

    def test_a_layer_may_not_include_one_above(self):
        self.assert_one_fault("src/surface/bvh.hpp", '"grid/octree.hpp"')

    def test_angle_brackets_hide_nothing(self):
        self.assert_one_fault("src/surface/bvh.hpp", "<grid/octree.hpp>")

    def test_a_path_without_its_layer_is_refused(self):
        self.assert_one_fault("src/grid/octree.cpp", '"octree.hpp"')
        self.assert_one_fault("src/grid/octree.cpp", '"../field/graph.hpp"')

    def test_pictures_see_neither_files_of_fields_nor_the_page(self):
        self.assert_no_fault("src/picture/renderer.cpp", '"files/output_file.hpp"')
        self.assert_one_fault("src/picture/renderer.cpp", '"results/surface_file.hpp"')
        self.assert_one_fault("src/picture/renderer.cpp", '"page/page_scene.hpp"')

    def test_a_public_header_includes_nothing_private_and_no_library(self):
        self.assert_no_fault("include/crossgrain/solve.hpp", '"crossgrain/types.hpp"')
        self.assert_no_fault("include/crossgrain/solve.hpp", "<functional>")
        for include in ('"base/vector3.hpp"', "<Eigen/Core>", "<zlib.h>", "<fmt/format.h>"):
            self.assert_one_fault("include/crossgrain/solve.hpp", include)

    def test_programs_include_public_headers_and_their_own_folder(self):
        self.assert_no_fault("apps/crossgrain/main.cpp", '"crossgrain/solve.hpp"')
        self.assert_no_fault("apps/crossgrain/main.cpp", "<CLI/CLI.hpp>")
        self.assert_one_fault("apps/crossgrain/main.cpp", '"field/graph.hpp"')
        self.assert_one_fault("apps/crossgrain/main.cpp", "<base/parallel.hpp>")
        self.assert_no_fault("apps/crossgrain/main.cpp", '"results/one_solve.hpp"')
        self.assert_one_fault("examples/sample_points.cpp", '"results/one_solve.hpp"')
        own = {"apps/crossgrain/main.cpp": '#include "options.hpp"\n', "apps/crossgrain/options.hpp": ""}
        self.assertEqual(faults_of(own), [])

    def test_an_unknown_folder_of_src_is_refused(self):
        self.assertEqual(len(faults_of({"src/misc/tools.hpp": ""})), 1)

    def test_tbb_stays_behind_the_parallel_loop(self):
        self.assert_no_fault("src/base/parallel.cpp", "<oneapi/tbb/parallel_for.h>")
        self.assert_one_fault("src/field/sweep.cpp", "<oneapi/tbb/parallel_for.h>")

    def test_opencascade_stays_in_its_program(self):
        self.assert_no_fault("src/cad_reading/program/bodies.cpp", "<TopoDS_Shape.hxx>")
        self.assert_no_fault("src/cad_reading/program/bodies.cpp", '"cad_reading/program/bodies.hpp"')
        self.assert_one_fault("src/mesh_files/surface/stl_reader.cpp", "<TopoDS_Shape.hxx>")
        self.assert_one_fault("src/cad_reading/cad_reader.cpp", '"cad_reading/program/bodies.hpp"')


if __name__ == "__main__":
    unittest.main()

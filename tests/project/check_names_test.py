#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""check_names.py refuses two types of one name, and takes nothing else for a type."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "cmake"))
sys.dont_write_bytecode = True
import check_names  # noqa: E402


def faults_of(files):
    """What the check says of a project that consists of these files: {path: text}."""
    with tempfile.TemporaryDirectory() as folder:
        for path, text in files.items():
            target = Path(folder) / path
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text, encoding="utf-8")
        return list(check_names.faults(Path(folder)))


class NameCheck(unittest.TestCase):
    def assert_same_name(self, first, second, folder="src"):
        """Both texts define the same type."""
        faults = faults_of({"src/a/first.hpp": first, f"{folder}/b/second.cpp": f"// a comment\n{second}"})
        self.assertEqual(len(faults), 1, faults)
        self.assertIn("src/a/first.hpp:", faults[0])
        self.assertIn(f"{folder}/b/second.cpp:", faults[0])

    def assert_no_fault(self, first, second):
        self.assertEqual(faults_of({"src/a/first.hpp": first, "src/b/second.cpp": second}), [])

    def test_two_types_of_one_name_are_refused_with_both_places(self):
        faults = faults_of({"src/a/first.hpp": "namespace crossgrain {\n\nstruct RayHit {};\n}\n",
                            "src/b/second.hpp": "namespace crossgrain {\nstruct RayHit { int shape; };\n}\n"})
        self.assertEqual(len(faults), 1, faults)
        self.assertTrue(faults[0].startswith("src/b/second.hpp:2: crossgrain::RayHit is another type in src/a/first.hpp:3;"), faults[0])

    def test_every_kind_of_definition_counts(self):
        plain = "namespace crossgrain { struct Hit {}; }"
        for text in ("class Hit {};", "class Hit final : public Base<int> {};", "union Hit { int i; };", "enum Hit { kNone };",
                     "enum class Hit : std::uint8_t { kNone };", "using Hit = std::array<int, 3>;", "struct alignas(16) Hit {};", "struct [[nodiscard]] Hit {};",
                     "template <class T, class U = std::vector<T>>\nclass Hit\n    : public Base<T> {\n};"):
            with self.subTest(text=text):
                self.assert_same_name(plain, f"namespace crossgrain {{\n{text}\n}}")

    def test_public_headers_count(self):
        self.assert_same_name("namespace crossgrain { struct Hit {}; }", "namespace crossgrain { struct Hit {}; }", folder="include")

    def test_a_cpp_file_has_its_own_types_in_an_anonymous_namespace_only(self):
        self.assert_same_name("namespace crossgrain { struct Hit {}; }", "namespace crossgrain { class Hit {}; }")
        self.assert_no_fault("namespace crossgrain { struct Hit {}; }", "namespace crossgrain { namespace { struct Hit {}; } }")
        self.assert_same_name("namespace crossgrain { struct Hit {}; }",
                              "namespace crossgrain { namespace { struct Other {}; }\nclass Hit {}; }")

    def test_namespaces_are_told_apart_however_they_are_written(self):
        self.assert_no_fault("namespace crossgrain { struct Hit {}; }", "namespace crossgrain::packed { struct Hit {}; }")
        self.assert_same_name("namespace crossgrain { namespace packed { struct Hit {}; } }",
                              "namespace crossgrain::packed { struct Hit {}; }")
        self.assert_same_name("namespace crossgrain { namespace fs = std::filesystem; struct Hit {}; }",
                              "using namespace std;\nnamespace crossgrain { struct Hit {}; }")

    def test_what_defines_no_type_does_not_count(self):
        for text in ("struct Hit;", "using other::Hit;", "enum class Hit : int;", "class Hit* find();", "Hit first(struct Hit& hit) { return hit; }",
                     "template <class Hit>\nstruct Other {};", "template <>\nstruct Hit<int> {};", "struct Other::Hit {};",
                     "struct Other { struct Hit {}; enum Kind { kNone }; };", "void f() { struct Hit {}; }",
                     "// struct Hit {};", "/* struct\nHit {}; */", 'const char* text = "struct Hit {};";',
                     'const char* text = R"x(struct Hit {};)" )x";', "#define HIT struct Hit \\\n  {}", "int n = 1'000; char c = '{';"):
            with self.subTest(text=text):
                self.assert_no_fault("namespace crossgrain { template <class T> struct Hit {}; }", f"namespace crossgrain {{\n{text}\n}}")

    def test_a_definition_and_its_alternative_in_one_file_are_one(self):
        self.assert_no_fault("namespace crossgrain {\n#if A\nstruct Hit {};\n#else\nstruct Hit { int i; };\n#endif\n}", "")

    def test_a_file_that_it_cannot_follow_is_told(self):
        for text in ("namespace crossgrain {", "namespace crossgrain { struct Hit {}; } }"):
            with self.subTest(text=text):
                faults = faults_of({"src/a/first.hpp": text})
                self.assertEqual(len(faults), 1, faults)
                self.assertIn("braces do not match", faults[0])


if __name__ == "__main__":
    unittest.main()

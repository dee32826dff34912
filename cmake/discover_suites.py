#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the file that adds each suite of a program of Google Test to ctest, as one test: its tests share a process and what the suite
makes once. Of a suite with slow tests these are a test of their own.

Usage: discover_suites.py PROGRAM PREFIX OUTPUT [SLOW], where SLOW has patterns of Google Test.
"""

import subprocess
import sys

# As the output ends where every test was skipped.
SKIPPED = r"""\[  PASSED  \] 0 tests\.
(\[  SKIPPED \][^
]*
)+$"""


def suites_of(program, passing):
    """{suite: names of its tests that pass the filter}."""
    command = [program, "--gtest_list_tests", f"--gtest_filter={passing}"]
    suites, suite = {}, ""
    for line in subprocess.run(command, capture_output=True, text=True, timeout=60, check=True).stdout.splitlines():
        name = line.split("  # ")[0]
        if line.startswith("  ") and not name.strip().startswith("DISABLED_"):
            suites.setdefault(suite, []).append(suite + name.strip())
        elif not line.startswith(" "):
            suite = name
    return suites


def added(program, name, tests, labels):
    properties = f"TIMEOUT 300 SKIP_REGULAR_EXPRESSION [==[{SKIPPED}]==]{labels}"
    return f"add_test([==[{name}]==] [==[{program}]==] [==[--gtest_filter={':'.join(tests)}]==])\nset_tests_properties([==[{name}]==] PROPERTIES {properties})\n"


def main(program, prefix, output, slow=""):
    kinds = [("-" + slow if slow else "*", "", ""), *([(slow, ".slow", " LABELS slow COST 10")] if slow else [])]
    suites = [(suites_of(program, passing), ending, labels) for passing, ending, labels in kinds]
    text = "".join(added(program, f"{prefix}.{suite.removesuffix('.')}{ending}", tests, labels)
                   for found, ending, labels in suites for suite, tests in found.items())
    with open(output, "w", encoding="utf-8") as file:
        file.write(text)


if __name__ == "__main__":
    main(*sys.argv[1:])

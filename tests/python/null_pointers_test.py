# SPDX-License-Identifier: Apache-2.0
"""Each function of the C interface is called with each of its pointers NULL while the others are valid, and with all of them NULL."""

import ctypes
import importlib.util
import os
import re
import signal
import sys
import tempfile
import unittest
from pathlib import Path

import crossgrain as cg
from crossgrain import _interface as c
from crossgrain._library import library, made

sys.path.insert(0, str(Path(__file__).parent))
from solids import box, cube_of_tets

ROOT = Path(__file__).parents[2]
LIMIT_S = 60
BUFFER_BYTES = 1 << 16
CALLBACKS = ("crossgrain_on_progress", "crossgrain_on_expectation", "crossgrain_companion_writer")


def declared_functions():
    """Name and arguments of the functions of c.h, of each of these its type, with [] for an array."""
    spec = importlib.util.spec_from_file_location("generate", ROOT / "python/generate.py")
    generate = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(generate)
    headers = sorted((ROOT / "include/crossgrain").glob("c*.h"))
    for _, name, listed in generate.Header("\n".join(path.read_text(encoding="utf-8") for path in headers)).functions:
        arguments = [argument.strip() for argument in listed.split(",") if argument.strip() != "void"]
        yield name, [re.sub(r"\b\w+\s*(\[\d*\])?$", lambda found: "[]" if found[1] else "", argument).strip() for argument in arguments]


def is_pointer(kind):
    return kind.endswith(("*", "[]")) or kind in CALLBACKS


class Arguments:
    """Valid ones of each type; a function may get any of them."""

    def __init__(self):
        tets, surface = cg.TetMesh(*cube_of_tets(2)).prepared_for_map(), cg.Surface(*box())
        field, grid = cg.solve_onto(tets, resolution=4, repair=True, threads=1), cg.solve(surface, resolution=4, threads=1)
        options, monitor = made("options", "options_new", c.SOLVE_OPTIONS), made("monitor", "monitor_new", c.crossgrain_on_progress(0), c.crossgrain_on_expectation(0), None)
        tracing = made("options", "options_new", c.STREAMLINE_OPTIONS)
        tracer = made("tracer", "tracer_new", grid._handle, tracing, surface._handle, monitor)
        self.handles = {
            "field": grid._handle, "tet_field": field._handle, "domain": tets._handle, "mesh": surface._handle, "tracer": tracer,
            "hexahedra": field.hexahedra(cells=2, threads=1)._handle, "options": options, "monitor": monitor,
            "graph": made("graph", "field_singularities", grid._handle, monitor), "answer": made("answer", "field_answer", grid._handle),
            "lines": made("lines", "tracer_trace", tracer, None, 0, 3, 1, monitor), "numbers": made("numbers", "tracer_spread_seeds", tracer, 2, monitor),
            "matchings": made("matchings", "tet_field_matchings", field._handle, monitor), "constraints": made("constraints", "constraints_new"),
            "tets": made("tets", "tets_new", None, 0, None, 0, None), "spectrum": made("spectrum", "spectrum_of_preset", b"cube", 4),
            "reservation": made("reservation", "reserve_folder", b"reserved", None, 0),
        }

    def of(self, kind):
        handle = re.fullmatch(r"(?:const )?crossgrain_(\w+)\*", kind)
        if handle and handle[1] in self.handles:
            return ctypes.c_void_p(self.handles[handle[1]].address)
        if kind == "const char*":
            return ctypes.c_char_p(b"out")
        if is_pointer(kind):
            return None if kind in CALLBACKS else ctypes.cast(ctypes.create_string_buffer(BUFFER_BYTES), ctypes.c_void_p)
        return {"double": ctypes.c_double(1), "size_t": ctypes.c_size_t(1)}.get(kind, ctypes.c_int(1))


def end_of(function, calls):
    """How a process ends that calls a function with each of several lists of arguments, and the calls that it has begun."""
    reader, writer = os.pipe()
    child = os.fork()
    if child == 0:
        signal.alarm(LIMIT_S)
        os.dup2(os.open(os.devnull, os.O_WRONLY), 1)
        for arguments in calls:
            os.write(writer, b".")
            function(*arguments)
        os._exit(0)
    os.close(writer)
    with os.fdopen(reader, "rb") as begun:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), len(begun.read())


class NullPointers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory(prefix="crossgrain-null-")
        cls.addClassCleanup(folder.cleanup)
        cls.addClassCleanup(os.chdir, os.getcwd())
        os.chdir(folder.name)
        cls.arguments = Arguments()
        cls.functions = list(declared_functions())
        # Without the types of arguments, which refuse None for some.
        cls.library = ctypes.CDLL(library._name)

    def test_crash_no_function(self):
        self.assertGreater(len(self.functions), 150)
        for name, kinds in self.functions:
            function = getattr(self.library, name)
            pointers = [at for at, kind in enumerate(kinds) if is_pointer(kind)]
            missing = [[at] for at in pointers] + ([pointers] if len(pointers) > 1 else [])
            calls = [[None if at in some else self.arguments.of(kind) for at, kind in enumerate(kinds)] for some in missing]
            end, begun = end_of(function, calls)
            with self.subTest(function=name, missing=missing[begun - 1] if end else None):
                self.assertEqual(end, 0)


if __name__ == "__main__":
    unittest.main()

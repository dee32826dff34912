#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the singular edges that mouette finds in a field, a line `own A B` of vertices for each, for matchings.py.

    mouette_singular_edges.py SOURCES MESH FRAME

SOURCES is a checkout of mouette. It imports packages that Debian has not and that do nothing here; others stand in for them.
"""

import enum
import sys
import types


class AnyPackage(types.ModuleType):
    """A package whose names are decorators that do nothing."""

    def __getattr__(self, name):
        if name.startswith("__"):
            raise AttributeError(name)
        return lambda *arguments, **options: arguments[0] if arguments and callable(arguments[0]) else lambda function: function


class MultiValueEnum(enum.Enum):
    """That of aenum: every value of a member's tuple is the member's."""

    def __new__(cls, *values):
        member = object.__new__(cls)
        member._value_ = values[0]
        for value in values[1:]:
            cls._value2member_map_[value] = member
        return member


def main(sources, mesh, frame):
    for name in ("osqp", "stl_reader", "pyminiply", "numba", "aenum"):
        sys.modules[name] = AnyPackage(name)
    sys.modules["aenum"].MultiValueEnum = MultiValueEnum
    sys.path.insert(0, sources)
    import mouette

    tets = mouette.mesh.load(mesh)
    field = mouette.framefield.VolumeFrameField(tets, "cells", verbose=False)
    field.read_from_file(frame)
    for edge in field.singular_edges:
        if not tets.is_edge_on_border(*tets.edges[edge]):
            print("own", *tets.edges[edge])


if __name__ == "__main__":
    main(*sys.argv[1:])

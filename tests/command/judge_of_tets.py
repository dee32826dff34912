#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Judges fields on tets from the written files alone, by the rules of docs/singularities.md, and lists what the report says
otherwise.

    judge_of_tets.py FOLDER...

FOLDER is what `crossgrain solve X -o FOLDER --write quaternions` wrote. Of a repaired field, whose matchings are not the nearest,
edges and vertices are judged as judge_matchings.py says; it needs `--write mesh,fra,perm`.
"""

import json
import sys
from collections import Counter
from pathlib import Path

import numpy as np

from judge_arcs import NEAR, ArcsOnEdges
from judge_links import has_sphere, least_cyclic
from judge_lines import MERGE_CELLS, Lines
from judge_matchings import differences as differences_of_repaired
from judge_mesh import read_field
from judge_surface import Surface

UNFOLLOWED_SHARE, UNFOLLOWED_DEG = 0.1, 25
FEW_SHORT, SHORT_PER_ARC = 2, 1
EXACT = 1e-6  # degrees, and shares: rounding of sums
VERDICTS = ["meshable", "undecided", "not_meshable"]


def worst(verdicts):
    return max(verdicts, key=VERDICTS.index, default="meshable")


class JudgeOfTets:
    """The judgement of a folder; differences(report) compares it with a report."""

    def __init__(self, folder):
        report = json.loads((Path(folder) / "report.json").read_text())
        if "repair" in report["onto"]:
            raise ValueError(f"{folder}: the field is repaired; judge_matchings.py judges it")
        self.field = read_field(folder)
        self.lines = Lines(self.field)
        self.on = ArcsOnEdges(folder, self.lines)
        self.graph = self.on.graph
        self.surface = Surface(self.field, [c["place"] for c in report["onto"]["singularity"]["corner_list"]])
        self.unfollowed = self.field.unfollowed_share(UNFOLLOWED_DEG)
        self.node_on_boundary = [self.on.is_on_boundary(k) for k in range(len(self.graph.nodes))]
        self.node_verdicts = [self.node_verdict(k) for k in range(len(self.graph.nodes))]
        ends = [(self.graph.points[k], self.valence(a)) for k, on in enumerate(self.node_on_boundary) if on
                for a in self.graph.arcs_at(k) if self.on.arcs[a].index]
        for corner in self.surface.corners:
            corner.judge(self.field, ends)
        self.creases = [c for c in self.surface.creases if c.is_listed()]
        self.corners = [c for c in self.surface.corners if c.is_listed()]

    def valence(self, arc):
        return 4 - round(4 * self.on.arcs[arc].index)

    def node_verdict(self, node):
        arcs = self.graph.arcs_at(node)
        verdict = worst(self.on.arcs[a].verdict for a in arcs)
        valences = [self.valence(a) for a in arcs]
        if self.node_on_boundary[node]:
            return "meshable" if verdict == "not_meshable" or 4 - sum(4 - n for n in valences) >= 1 else "undecided"
        if verdict != "meshable":
            return verdict
        return {True: "meshable", False: "not_meshable", None: "undecided"}[has_sphere(valences)]

    def reasons(self):
        """{(kind, verdict): count} of the whole field, and its verdict."""
        found = Counter()
        if self.unfollowed > UNFOLLOWED_SHARE:
            found["surface", "undecided"] = 0
        length = sum(c.length for c in self.creases)
        if sum((1 - c.followed) * c.length for c in self.creases) > UNFOLLOWED_SHARE * length:
            found["creases", "undecided"] = 1
        short = self.on.loops + self.on.stubs
        if short > FEW_SHORT and short > SHORT_PER_ARC * len(self.on.arcs):
            found["short_lines", "undecided"] = 0
        fault = "undecided" if found else "not_meshable"
        for kind, verdicts in (("arc", [a.verdict for a in self.on.arcs]),
                               ("node", [v for v, on in zip(self.node_verdicts, self.node_on_boundary) if not on])):
            found[kind, fault] += verdicts.count("not_meshable")
            found[kind, "undecided"] += verdicts.count("undecided")
        found["ends", "undecided"] = sum(v == "undecided" and on for v, on in zip(self.node_verdicts, self.node_on_boundary))
        for kind, parts in (("knife_edge", self.creases), ("corner", self.corners)):
            for verdict in ("not_meshable", "undecided"):
                found[kind, verdict] = sum(p.verdict == verdict for p in parts)
        counted = {key: n for key, n in found.items() if n or key[0] in ("surface", "short_lines")}
        verdicts = [verdict for _, verdict in counted]
        return counted, worst(verdicts)

    def differences(self, report):
        """A line for each item of the report that is otherwise here."""
        onto = report["onto"]
        comparison = Comparison(self)
        comparison.lines(onto["singularity"])
        comparison.creases(onto["singularity"]["crease_list"])
        comparison.corners(onto["singularity"]["corner_list"])
        comparison.number("unfollowed_share", onto["unfollowed_share"], self.unfollowed, EXACT)
        reasons, verdict = self.reasons()
        comparison.same("verdict", report["verdict"], verdict)
        comparison.same("reasons", sorted((r["kind"], r["verdict"], r["count"]) for r in report["reasons"]),
                        sorted((*key, n) for key, n in reasons.items()))
        return comparison.found


class Comparison:
    def __init__(self, judge):
        self.judge, self.found = judge, list(judge.on.faults)

    def same(self, name, reported, judged):
        if reported != judged:
            self.found.append(f"{name}: {reported} in the report, {judged} judged")

    def number(self, name, reported, judged, tolerance):
        if not abs(reported - judged) <= tolerance:
            self.found.append(f"{name}: {reported} in the report, {judged} judged")

    def between(self, name, reported, low, high):
        if not low <= reported <= high:
            self.found.append(f"{name}: {reported} in the report, {low} to {high} judged")

    def lines(self, section):
        judge, on = self.judge, self.judge.on
        self.same("edges", section["edges"], len(judge.lines.turns))
        length = judge.field.length[list(judge.lines.turns)].sum()
        self.number("length", section["length"], length, EXACT * length)
        self.same("unresolved_loops", section["unresolved_loops"], on.loops)
        self.same("unresolved_stubs", section["unresolved_stubs"], on.stubs)
        self.same("crease_hooks", section["crease_hooks"], 0)
        self.same("contacts", section["contacts"], on.contacts())
        short = [sum(arc.cells <= MERGE_CELLS * margin for arc in on.arcs) for margin in (1 / NEAR, NEAR)]
        self.between("short_arcs", section["short_arcs"], *short)
        self.same("arcs", (section["arcs"], len(section["arc_list"])), (len(on.arcs),) * 2)
        for i, (said, arc) in enumerate(zip(section["arc_list"], on.arcs)):
            for key in ("type", "index", "verdict"):
                self.same(f"arc_list[{i}].{key}", said[key], getattr(arc, key))
            low, high = arc.oblique
            self.between(f"arc_list[{i}].oblique_length", said["oblique_length"], low - EXACT, high + EXACT)
        for k, (said, verdict) in enumerate(zip(section["node_list"], judge.node_verdicts)):
            self.same(f"node_list[{k}].verdict", said["verdict"], verdict)
            self.same(f"node_list[{k}].on_boundary", said["on_boundary"], judge.node_on_boundary[k])
        verdicts = [arc.verdict for arc in on.arcs]
        self.same("boundary_ends", section["boundary_ends"], sum(judge.node_on_boundary))
        self.same("not_meshable_arcs", section["not_meshable_arcs"], verdicts.count("not_meshable"))
        self.same("not_meshable_nodes", section["not_meshable_nodes"], judge.node_verdicts.count("not_meshable"))
        self.same("undecided_nodes", section["undecided_nodes"], judge.node_verdicts.count("undecided"))
        self.same("singularity.verdict", section["verdict"], worst(verdicts + judge.node_verdicts))

    def creases(self, said):
        """Creases are known by the edge of their least angle; of equal angles rounding chooses."""
        own = {tuple(np.round(place, 6)): c for c in self.judge.creases for place in c.sharpest_places()}
        least, most = (sum(not c.is_tie or tie for c in self.judge.creases) for tie in (False, True))
        self.between("crease_list", len(said), least, most)
        for i, entry in enumerate(said):
            crease = own.get(tuple(np.round(entry["place"], 6)))
            if crease is None:
                self.found.append(f"crease_list[{i}] at {entry['place']}: judged to be none, or flat")
                continue
            name = f"crease_list[{i}]"
            for key in ("hexahedra", "verdict"):
                self.same(f"{name}.{key}", entry[key], getattr(crease, key))
            for key, value in (("angle_deg", crease.angle), ("least_angle_deg", crease.least), ("followed", crease.followed)):
                self.number(f"{name}.{key}", entry[key], value, EXACT)
            self.number(f"{name}.length", entry["length"], crease.length, EXACT * crease.length)

    def corners(self, said):
        own = {tuple(np.round(self.judge.field.points[c.vertex], 6)): c for c in self.judge.corners}
        self.same("corner_list", len(said), len(self.judge.corners))
        for i, entry in enumerate(said):
            corner = own.get(tuple(np.round(entry["place"], 6)))
            if corner is None:
                self.found.append(f"corner_list[{i}] at {entry['place']}: judged to be none")
                continue
            name = f"corner_list[{i}]"
            self.same(f"{name}.hexahedra", entry["hexahedra"], corner.hexahedra)
            self.same(f"{name}.creases", least_cyclic(tuple(entry["creases"])),
                      least_cyclic(tuple(k for k in corner.numbers if k != 2)))
            self.same(f"{name}.arcs", sorted(entry["arcs"]), sorted(corner.arcs))
            self.same(f"{name}.verdict", entry["verdict"], corner.verdict)


def main(folders):
    for folder in folders:
        report = json.loads((Path(folder) / "report.json").read_text())
        found = differences_of_repaired(folder, report) if "repair" in report["onto"] else JudgeOfTets(folder).differences(report)
        print(f"{Path(folder).name}: {report['verdict']}, {len(found)} differences")
        print("".join(f"  {line}\n" for line in found), end="")


if __name__ == "__main__":
    main(sys.argv[1:])

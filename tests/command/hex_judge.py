#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Judges hexahedra by the files alone: whether they are valid, closed, of the part's topology, and keep its corners, creases and faces.

    hex_judge.py MESH.msh MODEL --size EDGE [--json FILE] [--cache FOLDER]

MESH is what `crossgrain hex` writes as hexahedra.msh; MODEL the CAD file (gmsh reads it), tet mesh or surface; EDGE the size of hexahedra
that was asked for, the unit of all lengths below. Exit status: 0 all_hex, 3 approximate, 6 partial.

A corner is kept by a vertex of the boundary within 0.12; a crease by an unbroken path of its edges within 0.12 and what straight edges
cut off; a face by quads of its number, or without numbers by quads on it. Only resolved ones decide: creases of at least 2 that have no
other one, which does not meet them there, within 1 for half of their length or a stretch of 1; corners alone within 1; faces of a mean
width, twice the area over the perimeter, of at least 1, with creases of which half is resolved.
"""

import argparse
import json
import sys

import numpy as np

from hex_judge_curves import Features
from hex_judge_distances import NearestTriangle, SurfaceDistances
from hex_judge_mesh import ClosedSurface, HexFile, are_valid
from hex_judge_model import Model
from hex_judge_paths import KEPT, KeptFeatures

FARTHEST, FARTHEST_EXCESS, COMMON_EXCESS = 0.35, 0.2, 0.1  # in hexahedra: in all, beyond what edges cut off, its 99th percentile
VOLUME = 0.05
AREA, ON_FACE = 0.15, 0.9  # of a face: what the area of its quads may be off beside its border, and how much of it must be on the face
SOFT = 0.5  # hexahedra that quads may reach over a border where the face is tangent to another one, since such borders need not be kept
OUTCOMES = {"all_hex": 0, "approximate": 3, "partial": 6}  # with exit statuses


class Verdict:
    """`figures`, a dict for JSON; `outcome`; `reasons`."""

    def __init__(self, mesh, model, size):
        self.mesh, self.model, self.size = mesh, model, size
        self.figures = {"hexahedra": len(mesh.hexahedra), "size": size}
        self.broken, self.lacking = [], []
        self.features = Features(model, size)
        if len(mesh.hexahedra):
            self.judge_hexahedra()
            self.quads, crowded = mesh.boundary()
            self.judge_topology(crowded)
            self.kept = KeptFeatures(self.features, mesh.points, self.quads)
            self.distances = SurfaceDistances(self.features, mesh.points, self.quads, self.kept.sagittas)
            self.judge_features()
            self.judge_faces()
            self.judge_distances()
        else:
            self.broken.append("no hexahedra")
            self.lose_all()
        self.outcome = "partial" if self.broken else "approximate" if self.lacking else "all_hex"
        self.reasons = self.broken + self.lacking
        self.figures.update(outcome=self.outcome, reasons=self.reasons)

    def lose_all(self):
        lengths = [curve.length for curve in self.features.curves if curve.is_resolved]
        numbers = {"corners": self.features.resolved_corners, "creases": lengths, "faces": [face for face in self.features.faces if face.is_resolved]}
        for name, found in numbers.items():
            self.figures[name] = {"number": int(sum(found)) if name == "corners" else len(found), "kept": 0}
        self.figures["creases"].update(length=float(sum(lengths)), kept_length=0.0)

    def judge_hexahedra(self):
        jacobians, valid = self.mesh.scaled_jacobians(), are_valid(self.mesh.corners())
        self.figures["scaled_jacobian"] = {"min": float(jacobians.min()), "mean": float(jacobians.mean()),
                                           "place": self.mesh.corners()[jacobians.argmin()].mean(axis=0).tolist()}
        self.figures["invalid"] = int((~valid).sum())
        if not valid.all():
            self.broken.append(f"{(~valid).sum()} invalid hexahedra, one at {words_of(self.mesh.corners()[~valid][0].mean(axis=0))}")

    def judge_topology(self, crowded):
        found, model = ClosedSurface(self.quads), self.model.topology
        is_same = len(self.mesh.quads) == len(self.quads) and (self.mesh.tags_of(self.quads) >= 0).all()
        self.figures["topology"] = {"shells": found.shells, "euler": found.euler, "model_shells": model.shells, "model_euler": model.euler,
                                    "crowded_quads": crowded, "open_edges": found.open_edges, "pinched_vertices": found.pinched}
        if crowded or found.open_edges or found.pinched:
            self.broken.append(f"not closed: {crowded} crowded quads, {found.open_edges} open edges, {found.pinched} pinched vertices")
        if (found.shells, found.euler) != (model.shells, model.euler):
            self.broken.append(f"{found.shells} shells of Euler number {found.euler} for {model.shells} of {model.euler}")
        if not is_same:
            self.broken.append("the quads of the file are not the boundary")
        ratio = self.mesh.volume() / self.model.volume() - 1
        self.figures["volume"] = ratio
        if abs(ratio) > VOLUME:
            self.lacking.append(f"volume {100 * ratio:+.1f} %")

    def judge_features(self):
        features, kept = self.features, self.kept
        resolved = np.array([curve.is_resolved for curve in features.curves], bool)
        lengths = np.array([curve.length for curve in features.curves])
        is_kept, shares = np.array(kept.curves, bool), np.array(kept.shares)
        lost = np.flatnonzero(resolved & ~is_kept).tolist()
        self.figures["creases"] = {
            "number": int(resolved.sum()), "kept": int((resolved & is_kept).sum()), "length": float(lengths[resolved].sum()),
            "kept_length": float((lengths * shares)[resolved].sum()), "unresolved": int((~resolved).sum()),
            "unresolved_kept": int((~resolved & is_kept).sum()), "unresolved_length": float(lengths[~resolved].sum()),
            "unresolved_kept_length": float((lengths * shares)[~resolved].sum()),
            "missing": [{"curve": k, "place": features.curves[k].place(features.curves[k].length / 2).tolist(),
                         "length": float(lengths[k]), "share": float(shares[k])} for k in lost]}
        self.figures["scaled_jacobian"]["bound"] = min((float(curve.bounds.min()) for curve, k in zip(features.curves, is_kept) if k), default=1.0)
        self.lacking += [f"{100 * (1 - shares[k]):.0f} % of a crease of {lengths[k] / self.size:.1f} hexahedra lost around "
                         f"{words_of(features.curves[k].place(features.curves[k].length / 2))}" for k in lost]
        corners = features.resolved_corners
        away = np.flatnonzero(corners & ~kept.corners)
        self.figures["corners"] = {"number": int(corners.sum()), "kept": int((corners & kept.corners).sum()), "unresolved": int((~corners).sum()),
                                   "missing": features.corners[away].tolist()}
        self.lacking += [f"no vertex at the corner {words_of(features.corners[k])}" for k in away]

    def judge_faces(self):
        """By the numbers of quads where the file of the model has numbers; otherwise by where they lie."""
        tags, faces = self.mesh.tags_of(self.quads), self.features.faces
        if not self.model.has_numbers:
            tags = None if len(np.unique(tags)) < 2 else tags
        missing = []
        for k, face in enumerate(faces):
            if self.model.has_numbers:
                fault = self.fault_of(face, np.flatnonzero(tags == face.number))
            else:
                own = np.flatnonzero(self.distances.face_of_quad == k)
                fault = self.fault_of(face, own) or (self.mixed(own, tags) if tags is not None else None)
            if fault and face.is_resolved:
                missing.append({"face": face.number if self.model.has_numbers else k,
                                "place": self.model.corners()[face.triangles].mean(axis=(0, 1)).tolist(), "fault": fault})
        number = sum(1 for face in faces if face.is_resolved)
        self.figures["faces"] = {"number": number, "kept": number - len(missing), "unresolved": len(faces) - number, "missing": missing}
        self.lacking += [f"face {fault['face']} at {words_of(fault['place'])} {fault['fault']}" for fault in missing]

    def fault_of(self, face, own):
        if not len(own):
            return "has no quads"
        areas = self.distances.quad_areas[own]
        border = KEPT * (face.perimeter - face.soft) + SOFT * face.soft
        if abs(areas.sum() - face.area) > AREA * face.area + border * self.size:
            return f"has quads of {100 * areas.sum() / face.area:.0f} % of its area"
        middles = self.distances.corners[own].mean(axis=1)
        search = NearestTriangle(self.model.corners()[face.triangles], self.size / 2)
        is_on = search.query(middles)[0] <= FARTHEST * self.size + self.distances.allowances[own]
        share = areas[is_on].sum() / areas.sum()
        return f"has quads that are {100 * (1 - share):.0f} % elsewhere" if share < ON_FACE else None

    def mixed(self, own, tags):
        """Whether quads on one face have several numbers, in a file that numbers faces by itself; 0 is none."""
        own = own[tags[own] != 0]
        shares = np.bincount(tags[own] - tags.min(), self.distances.quad_areas[own])
        return None if not len(own) or shares.max() >= ON_FACE * shares.sum() else "has quads of several numbers"

    def judge_distances(self):
        self.figures["distances"] = {"mesh_to_model": self.distances.mesh_to_model, "model_to_mesh": self.distances.model_to_mesh}
        for name, found in self.figures["distances"].items():
            if found["most"] > FARTHEST:
                self.lacking.append(f"{name.replace('_', ' ')} {found['most']:.2f} at {words_of(found['place'])}")
            elif found["excess_most"] > FARTHEST_EXCESS or found["excess_p99"] > COMMON_EXCESS:
                self.lacking.append(f"{name.replace('_', ' ')} {found['excess_most']:.2f} ({found['excess_p99']:.2f} at 99 %) beyond what edges "
                                    f"cut off, at {words_of(found['excess_place'])}")

    def line(self):
        found = self.figures
        if not found["hexahedra"]:
            return f"{self.outcome}: no hexahedra"
        creases, corners, faces, jacobian = (found[name] for name in ("creases", "corners", "faces", "scaled_jacobian"))
        length = 100 * creases["kept_length"] / creases["length"] if creases["length"] else 100
        far = [f"{value['most']:.2f} ({value['excess_most']:.2f})" for value in found["distances"].values()]
        return (f"{self.outcome}: {found['hexahedra']} hexahedra, scaled Jacobian {jacobian['min']:.3f}; corners {corners['kept']} of "
                f"{corners['number']}, creases {creases['kept']} of {creases['number']} ({length:.1f} % of length), faces {faces['kept']} of "
                f"{faces['number']}; mesh to model {far[0]}, model to mesh {far[1]} hexahedra; volume {100 * found['volume']:+.2f} %")


def words_of(place):
    return " ".join(f"{x:.4g}" for x in place)


def judged(mesh, model, size, cache=None):
    """The Verdict on files."""
    return Verdict(HexFile.read(mesh), Model.read(model, cache), size)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh")
    parser.add_argument("model")
    parser.add_argument("--size", type=float, required=True)
    parser.add_argument("--json")
    parser.add_argument("--cache", help="keeps what gmsh makes of CAD files")
    options = parser.parse_args()
    verdict = judged(options.mesh, options.model, options.size, options.cache)
    print("\n  ".join([verdict.line(), *verdict.reasons]))
    if options.json:
        with open(options.json, "w", encoding="utf-8") as file:
            json.dump(verdict.figures, file, indent=1)
    return OUTCOMES[verdict.outcome]


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The judge of hexahedra (hex_judge.py), on meshes whose verdict is known."""

import shutil
import subprocess
import unittest
from types import SimpleNamespace

import numpy as np

from hex_judge import Verdict, judged
from hex_judge_curves import Curve, Features
from hex_judge_distances import NearestTriangle
from hex_judge_mesh import PLACES, HexFile, are_valid, determinants
from hex_judge_model import Model
from hex_judge_paths import KeptFeatures
from program import CommandTest, cylinder_triangles, tet_box

CELLS = (4, 3, 3)
NORMALS = [(-1, 0, 0), (1, 0, 0), (0, -1, 0), (0, 1, 0), (0, 0, -1), (0, 0, 1)]  # of the faces 1 to 6 of a box


def lattice(cells=CELLS, without=()):
    """Points and hexahedra of unit cubes, `without` those at some places."""
    number = np.arange(np.prod(np.add(cells, 1))).reshape(np.add(cells, 1))
    points = np.stack(np.meshgrid(*[np.arange(n + 1.0) for n in cells], indexing="ij"), axis=-1).reshape(-1, 3)
    places = [place for place in np.ndindex(*cells) if place not in without]
    return points, np.array([[number[tuple(np.add(place, corner).astype(int))] for corner in PLACES] for place in places])


def box_file(points, hexahedra, numbers=(1, 2, 3, 4, 5, 6)):
    """With the quads of the boundary; `numbers` are those of the faces of the box, by where quads look."""
    mesh = HexFile(points, hexahedra)
    quads, _ = mesh.boundary()
    a, b, c, d = np.moveaxis(mesh.points[quads], 1, 0)
    faces = (np.cross(c - a, d - b) @ np.transpose(NORMALS)).argmax(axis=1)
    return HexFile(points, hexahedra, quads, np.array(numbers)[faces])


def box_model(cells=CELLS, **options):
    """Of triangles on the faces 1 to 6, some of which look inward, as files have them."""
    points, hexahedra = lattice(cells)
    quads = box_file(points, hexahedra)
    triangles = np.concatenate([quads.quads[:, [0, 1, 2]], quads.quads[:, [0, 3, 2]]])
    return Model(points, triangles, np.tile(quads.tags, 2), **options)


def disc_points(around, rings):
    """A square inside a disc of radius 1: rings from it outward, of `around` quads each, a multiple of 8."""
    angles = 2 * np.pi * np.arange(around) / around
    circle = np.stack([np.cos(angles), np.sin(angles)], axis=1)
    square = 0.5 * circle / np.abs(circle).max(axis=1, keepdims=True)
    return [(1 - t) * square + t * circle for t in np.linspace(0, 1, rings + 1)]


def tube(around, layers, rings=2):
    """Hexahedra of a tube between radii of about 0.5, where it is square, and 1."""
    discs = np.array(disc_points(around, rings))
    points = np.concatenate([np.column_stack([discs.reshape(-1, 2), np.full((rings + 1) * around, float(z))]) for z in range(layers + 1)])

    def number(ring, k, z):
        return (z * (rings + 1) + ring) * around + k % around

    return points, np.array([[number(r + dr, k + dk, z + dz) for dz in (0, 1) for dr, dk in ((0, 0), (1, 0), (1, 1), (0, 1))]
                             for r in range(rings) for k in range(around) for z in range(layers)])


def round_tube(around, layers):
    """Triangles of the tube whose outer circle is fine."""
    points, hexahedra = tube(around, layers)
    quads = HexFile(points, hexahedra).boundary()[0]
    triangles = points[np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])]
    return Model.of_surface(triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3))


class JudgeTest(unittest.TestCase):
    def assert_lacks(self, verdict, outcome, *words):
        self.assertEqual(verdict.outcome, outcome, verdict.reasons)
        self.assertEqual(len(verdict.reasons), len(words), verdict.reasons)
        for reason, word in zip(verdict.reasons, words):
            self.assertIn(word, reason)

    def test_bricks_of_a_box_are_all_hex(self):
        verdict = Verdict(box_file(*lattice()), box_model(), 1.0)
        self.assert_lacks(verdict, "all_hex")
        found = verdict.figures
        self.assertEqual([found[name]["number"] for name in ("corners", "creases", "faces")], [8, 12, 6])
        self.assertEqual([found[name]["kept"] for name in ("corners", "creases", "faces")], [8, 12, 6])
        self.assertEqual(found["creases"]["kept_length"], 40)
        self.assertAlmostEqual(found["volume"], 0)
        self.assertAlmostEqual(found["scaled_jacobian"]["bound"], 1)
        self.assertAlmostEqual(max(way["most"] for way in found["distances"].values()), 0)

    def test_a_vertex_off_a_crease_breaks_its_path(self):
        for off, outcome in ((0.1, "all_hex"), (0.15, "approximate")):
            points, hexahedra = lattice()
            points[(points == (2, 0, 0)).all(axis=1)] = (2, off, 0)
            verdict = Verdict(box_file(points, hexahedra), box_model(), 1.0)
            self.assertEqual(verdict.outcome, outcome, verdict.reasons)
            self.assertEqual(verdict.figures["creases"]["kept"], 12 - (off > 0.12))
        self.assert_lacks(verdict, "approximate", "a crease of 4.0 hexahedra lost around 2 0 0")
        self.assertAlmostEqual(verdict.figures["creases"]["missing"][0]["share"], 0.25)  # an edge on each side, less one for the break

    def test_a_vertex_off_a_corner_loses_it_with_its_creases(self):
        points, hexahedra = lattice()
        points[(points == 0).all(axis=1)] = (0.1, 0.1, 0.1)
        verdict = Verdict(box_file(points, hexahedra), box_model(), 1.0)
        self.assert_lacks(verdict, "approximate", *["crease"] * 3, "no vertex at the corner 0 0 0")

    def test_a_face_without_quads_of_its_number_is_lost(self):
        verdict = Verdict(box_file(*lattice(), numbers=(1, 2, 1, 4, 5, 6)), box_model(), 1.0)
        self.assert_lacks(verdict, "approximate", "face 3 at 2 0 1.5 has no quads", "face 1 at 0 1.5 1.5 has quads of 233 % of its area")

    def test_quads_of_a_number_on_another_face_are_told(self):
        verdict = Verdict(box_file(*lattice(), numbers=(2, 1, 3, 4, 5, 6)), box_model(), 1.0)
        self.assert_lacks(verdict, "approximate", "face 1 at 0 1.5 1.5 has quads that are 100 % elsewhere", "face 2 at ")

    def test_quads_that_are_not_the_boundary_are_told(self):
        mesh = box_file(*lattice())
        mesh.quads, mesh.tags = mesh.quads[1:], mesh.tags[1:]
        self.assert_lacks(Verdict(mesh, box_model(), 1.0), "partial", "the quads of the file are not the boundary")

    def test_hexahedra_that_share_only_an_edge_are_not_closed(self):
        mesh = box_file(*lattice((2, 2, 1), without={(0, 0, 0), (1, 1, 0)}))
        verdict = Verdict(mesh, box_model((2, 2, 1)), 1.0)
        self.assertEqual(verdict.outcome, "partial")
        self.assertEqual(verdict.figures["topology"]["open_edges"], 1)
        self.assertIn("not closed: 0 crowded quads, 1 open edges, 2 pinched vertices", verdict.reasons)

    def test_hexahedra_that_share_only_a_vertex_are_pinched(self):
        mesh = box_file(*lattice((2, 2, 2), without=set(np.ndindex(2, 2, 2)) - {(0, 0, 0), (1, 1, 1)}))
        self.assertIn("not closed: 0 crowded quads, 0 open edges, 1 pinched vertices", Verdict(mesh, box_model((2, 2, 2)), 1.0).reasons)

    def test_two_hexahedra_on_one_side_of_a_quad_crowd_it(self):
        points, hexahedra = lattice((2, 1, 1))
        points = np.concatenate([points, points[hexahedra[1]][[1, 2, 5, 6]] + (0, 0.2, 0)])
        other = hexahedra[1].copy()
        other[[1, 2, 5, 6]] = np.arange(len(points) - 4, len(points))
        verdict = Verdict(box_file(points, np.concatenate([hexahedra, [other]])), box_model((2, 1, 1)), 1.0)
        self.assertGreater(verdict.figures["topology"]["crowded_quads"], 0)
        self.assertEqual(verdict.outcome, "partial")

    def test_a_void_and_a_hole_are_another_topology(self):
        void = Verdict(box_file(*lattice(without={(1, 1, 1)})), box_model(), 1.0)
        self.assertIn("2 shells of Euler number 4 for 1 of 2", void.reasons)
        hole = Verdict(box_file(*lattice(without={(1, 1, z) for z in range(3)})), box_model(), 1.0)
        self.assertIn("1 shells of Euler number 0 for 1 of 2", hole.reasons)

    def test_a_hexahedron_inverted_inside_is_invalid_though_its_corners_are_not(self):
        draws = np.random.default_rng(5)
        corners = PLACES + 0.6 * draws.uniform(-1, 1, (1000, 8, 3))
        grid = np.stack(np.meshgrid(*[np.linspace(0, 1, 7)] * 3, indexing="ij"), axis=-1).reshape(-1, 3)
        least, at_corners = determinants(corners, grid).min(axis=1), determinants(corners, PLACES).min(axis=1)
        hidden = np.flatnonzero((at_corners > 0) & (least < 0))
        self.assertGreater(len(hidden), 0)
        valid = are_valid(corners)
        self.assertFalse(valid[least <= 0].any())
        self.assertTrue(valid[least > 0.05].all())
        points = corners[hidden[0]]
        verdict = Verdict(box_file(points, np.arange(8)[None]), box_model((1, 1, 1)), 1.0)
        self.assertIn("1 invalid hexahedra", verdict.reasons[0])

    def test_determinants_are_those_of_finite_differences(self):
        corners = (PLACES + 0.3 * np.random.default_rng(2).uniform(-1, 1, (8, 3)))[None]

        def place(at):
            return np.prod(np.where(PLACES == 1, at, 1 - at), axis=1) @ corners[0]

        at = np.array([0.2, 0.7, 0.4])
        slopes = [(place(at + step) - place(at - step)) / 2e-5 for step in 1e-5 * np.eye(3)]
        self.assertAlmostEqual(determinants(corners, at[None])[0, 0], np.linalg.det(slopes), places=8)

    def test_what_straight_edges_cut_off_a_cylinder_is_allowed_but_not_its_volume(self):
        model = round_tube(64, 1)
        for around, outcome in ((16, "all_hex"), (8, "approximate")):
            verdict = Verdict(box_file(*tube(around, 1)), model, 0.5)
            self.assertEqual(verdict.outcome, outcome, verdict.reasons)
            way = verdict.figures["distances"]["model_to_mesh"]
            self.assertAlmostEqual(way["most"], (1 - np.cos(np.pi / around)) / 0.5, delta=0.005)
            self.assertLess(way["excess_most"], 0.02)
        self.assertIn("volume -", verdict.reasons[0])

    def test_a_mesh_off_the_model_is_told_both_ways(self):
        points, hexahedra = lattice()
        points[points[:, 0] == 4, 0] = 4.3
        reasons = Verdict(box_file(points, hexahedra), box_model(), 1.0).reasons
        self.assertTrue(any(reason.startswith("mesh to model 0.30 (0.30 at 99 %) beyond what edges cut off") for reason in reasons), reasons)
        self.assertTrue(any(reason.startswith("model to mesh 0.30") for reason in reasons), reasons)

    def test_nearest_triangles_are_those_of_brute_force(self):
        draws = np.random.default_rng(1)
        triangles, points = draws.normal(size=(100, 3, 3)), 1.5 * draws.normal(size=(50, 3))
        found, nearest, weights = NearestTriangle(triangles, 0.5).query(points)
        places = np.einsum("kc,tcd->tkd", draws.dirichlet([0.6] * 3, 4000), triangles).reshape(-1, 3)
        brute = np.array([np.linalg.norm(places - point, axis=1).min() for point in points])
        self.assertTrue((found <= brute + 1e-12).all())
        self.assertLess((brute - found).max(), 0.15)
        np.testing.assert_allclose(np.linalg.norm((triangles[nearest] * weights[..., None]).sum(axis=1) - points, axis=1), found)


class FeaturesTest(unittest.TestCase):
    def test_creases_of_a_cylinder_are_its_two_rims(self):
        triangles = cylinder_triangles()
        features = Features(Model.of_surface(triangles.reshape(-1, 3), np.arange(3 * len(triangles)).reshape(-1, 3)), 0.3)
        self.assertEqual((len(features.curves), len(features.corners), len(features.faces)), (2, 0, 3))
        self.assertTrue(all(curve.is_closed and curve.is_resolved for curve in features.curves))

    def test_features_of_a_plate_thinner_than_a_hexahedron_are_not_resolved(self):
        for size, resolved in ((0.9, 12), (1.1, 0)):
            features = Features(box_model((8, 8, 1)), size)
            self.assertEqual(sum(curve.is_resolved for curve in features.curves), resolved if size > 1 else 8)
            self.assertEqual(sum(features.resolved_corners), 8 if size < 1 else 0)
        self.assertEqual([face.is_resolved for face in features.faces].count(True), 0)

    def test_curves_that_meet_at_an_acute_angle_are_resolved(self):
        angle = np.radians(25)
        rim = [(0, 0), (12, 0), (12 * np.cos(angle), 12 * np.sin(angle))]
        low, high = ([(x, y, z) for x, y in rim] for z in (0.0, 5.0))
        triangles = [(low[0], low[2], low[1]), (high[0], high[1], high[2])]
        for k in range(3):
            n = (k + 1) % 3
            triangles += [(low[k], low[n], high[n]), (low[k], high[n], high[k])]
        features = Features(Model.of_surface(np.reshape(triangles, (-1, 3)), np.arange(24).reshape(-1, 3)), 1.0)
        self.assertEqual([curve.is_resolved for curve in features.curves], [True] * 9)
        self.assertAlmostEqual(min(curve.bounds.min() for curve in features.curves), np.sin(angle))

    def test_a_tagged_edge_counts_in_a_flat_face_no_more_than_a_sharp_one(self):
        vertices, tets = tet_box()
        self.assertEqual(len(Features(Model.of_tets(vertices, tets), 0.3).curves), 12)
        self.assertEqual(len(Features(Model.of_tets(vertices, tets, lines=[(0, 1)]), 0.3).curves), 12)

    def test_a_crease_around_from_a_corner_is_kept_by_edges_all_around(self):
        angles = np.radians(np.arange(0, 361, 45))
        ring = np.stack([np.cos(angles), np.sin(angles), 0 * angles], axis=1)
        features = SimpleNamespace(size=0.75, corners=ring[:1], curves=[Curve(ring, (0, 0), np.ones(8), np.ones(8))])
        points = np.concatenate([ring[:8], [(0, 0, 0)]])
        points[0, 1] = -0.02  # nearest to the end of the crease, which is also its start
        quads = np.array([(8, k, k + 1, (k + 2) % 8) for k in range(0, 8, 2)])
        self.assertEqual(KeptFeatures(features, points, quads).shares, [1.0])
        self.assertLess(KeptFeatures(features, points, quads[:3]).shares[0], 0.8)


    def test_a_tagged_edge_where_a_rounding_begins_is_no_crease(self):
        angles = np.radians([0, 30, 60, 90])
        rounding, bend = np.column_stack([np.sin(angles), np.cos(angles)]), np.array([(0, 1), (2, 0.2)])
        for top, creases in ((rounding, 0), (bend, 1)):
            outline = np.array([(-2, 1), *top, (top[-1][0], -3), (-2, -3)])
            count = len(outline)
            points = np.array([(*place, z) for z in (0, 2) for place in outline])
            sides = [(k, n, count + n, count + k) for k, n in zip(range(count), [*range(1, count), 0])]
            triangles = [triangle for a, b, c, d in sides for triangle in ((a, b, c), (a, c, d))]
            triangles += [(top + 0, top + k, top + k + 1) for top in (0, count) for k in range(1, count - 1)]
            tagged = Model(points, triangles, lines=[(1, count + 1)], line_curves=[0])
            features = Features(tagged, 0.3)
            plain = Features(Model(points, triangles), 0.3)
            self.assertEqual(len(features.curves) - len(plain.curves), 3 * creases)


class FilesTest(CommandTest):
    def test_a_file_of_gmsh_is_judged_with_a_cad_file(self):
        if not shutil.which("gmsh"):
            self.skipTest("gmsh is not installed")
        self.write("box.geo", b'SetFactory("OpenCASCADE"); Box(1)={0,0,0,4,3,3};\nSave "box.step";\n')
        subprocess.run(["gmsh", "-0", "box.geo", "-o", "box.brep"], cwd=self.folder, capture_output=True, check=True)
        points, hexahedra = lattice()
        mesh = box_file(points, hexahedra)
        lines = ["$MeshFormat", "4.1 0 8", "$EndMeshFormat", "$PhysicalNames", "7", *[f'2 {k} "face {k}"' for k in range(1, 7)], '3 1 "volume"',
                 "$EndPhysicalNames", "$Entities", "0 0 6 1", *[f"{k} 0 0 0 1 1 1 1 {k} 0" for k in range(1, 7)], "1 0 0 0 4 3 3 1 1 0",
                 "$EndEntities", "$Nodes", f"1 {len(points)} 1 {len(points)}", f"3 1 0 {len(points)}", *map(str, range(1, len(points) + 1)),
                 *[" ".join(map(str, point)) for point in points], "$EndNodes", "$Elements", f"7 {len(mesh.quads) + len(hexahedra)} 1 999"]
        for tag in range(1, 7):
            own = mesh.quads[mesh.tags == tag] + 1
            lines += [f"2 {tag} 3 {len(own)}", *[" ".join(map(str, [0, *quad])) for quad in own]]
        lines += [f"3 1 5 {len(hexahedra)}", *[" ".join(map(str, [0, *row])) for row in hexahedra + 1], "$EndElements", ""]
        self.write("box.msh", "\n".join(lines).encode())
        verdict = judged(self.folder / "box.msh", self.folder / "box.step", 1.0, self.folder)
        self.assertEqual(verdict.outcome, "all_hex", verdict.reasons)
        self.assertEqual(verdict.figures["faces"]["kept"], 6)
        self.assertTrue((self.folder / "box.model.msh").exists())


if __name__ == "__main__":
    unittest.main()

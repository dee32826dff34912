// SPDX-License-Identifier: Apache-2.0
// Solids that tests make for themselves: closed, outward-oriented, about one unit across and centred near the
// origin.
#pragma once

#include "base/quaternion.hpp"
#include "crossgrain/types.hpp"

namespace crossgrain {

TriangleMesh make_box(const Vector3& size);

/// An icosahedron divided `subdivisions` times: 20 * 4^subdivisions triangles, corners on the sphere.
TriangleMesh make_sphere(double radius, int subdivisions);

/// About the z axis, `segments` around and `rings` along the side, caps as fans.
TriangleMesh make_cylinder(double radius, double half_height, int segments, int rings = 1);

/// A cylinder so thin that it passes through a coarse cell: radius 0.01, length 1.2, 48 segments.
TriangleMesh make_thin_cylinder();

/// About the z axis.
TriangleMesh make_torus(double major_radius, double minor_radius, int major_segments, int minor_segments);

/// A box 1.4 x 1.2 x 0.6 with a round hole of the given radius along z, off centre at (0.2, 0.1).
TriangleMesh make_box_with_hole(int segments, double hole_radius = 0.25);

/// Two plates 1 x 1 x thickness, one above the other, with an outside gap between z = -gap / 2 and gap / 2.
TriangleMesh make_plates(double gap, double thickness = 0.4);

/// 1 x 1 x thickness.
TriangleMesh make_wall(double thickness);

/// A part without any symmetry: an L whose inner corner is a fillet, with an outer edge chamfered, a round
/// hole in the long arm, and a top face that slants in both directions. `segments` go around the hole, a
/// quarter of them around the fillet.
TriangleMesh make_bracket(int segments);

TriangleMesh rotate_mesh(TriangleMesh mesh, const Quaternion& rotation);
TriangleMesh translate_mesh(TriangleMesh mesh, const Vector3& offset);
TriangleMesh scale_mesh(TriangleMesh mesh, double factor);

/// Turned inside out.
TriangleMesh flip_mesh(TriangleMesh mesh);

/// Both meshes in one, `first` first; nothing is merged.
TriangleMesh join_meshes(TriangleMesh first, const TriangleMesh& second);

/// Every triangle with three vertices of its own, as an STL file gives them.
TriangleMesh to_soup(const TriangleMesh& mesh);

}  // namespace crossgrain

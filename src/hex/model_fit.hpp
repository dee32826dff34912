// SPDX-License-Identifier: Apache-2.0
// How well hexahedra fit the model as given.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/types.hpp"
#include "crossgrain/warning.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {

/// A largest distance, and the point that is so far away.
struct Farthest {
  double distance = 0, mean = 0;
  Vector3 place{0, 0, 0};
};

/// Returns the faces of a mesh's boundary, each as four triangles around its centroid.
TriangleMesh surface_triangles(const HexMesh& mesh);

/// The largest distance from points to the boundary of a mesh, which has one.
Farthest farthest_from(const HexMesh& mesh, const std::vector<Vector3>& points);

/// Vertices and centroids of triangles.
std::vector<Vector3> points_on(const std::vector<Vector3>& vertices,
                               const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// What hexahedra bound: the common surface of all solids, or the surfaces of all, those between solids that
/// touch or overlap too.
enum class FitTo { kCommonSurface, kEachSolid };

/// Sizes that follow each other, of lattices and in advice: each as a share of the one before. Half of a size
/// makes eight times as many hexahedra.
inline constexpr double kSmallerSize = 0.7;

/// Returns the size to be tried where hexahedra of a size are too coarse: two digits, not above kSmallerSize
/// of it.
double next_smaller_size(double size);

/// Fills in volumes, areas and distances: to the model that the tets were made of (TetMesh::given), if there
/// is one that knows these surfaces, otherwise to the tets.
void measure_fit(const HexMesh& mesh, const TetSolid& tets, FitTo fit_to, HexReport& report);

/// Fills in ModelFace::quads and quads_area of the faces that bound the model, unless the boundary has no
/// tags.
void count_quads(const HexMesh& mesh, std::vector<ModelFace>& faces);

/// Returns a size of hexahedra, of two digits, that fits across all faces without quads; none if all have
/// some, if one is as wide as the hexahedra, and if the size makes too many (kMostHexahedra). `tets` are
/// tagged. The report has the size and the volume.
std::optional<double> size_for_faces(const std::vector<ModelFace>& faces, const TetSolid& tets,
                                     const HexReport& report);

/// A warning with the list of faces that have no quads, and the size that fits across them if there is one,
/// unless the report names a size already; none if all have some. `tets` and report as above.
std::optional<Warning> faces_without_quads(const std::vector<ModelFace>& faces, const TetSolid& tets,
                                           const HexReport& report);

/// A warning with the list of faces whose quads cover another area than these, since they end off the smooth
/// border to a neighbour; none if all cover theirs. The faces have their quads (count_quads).
std::optional<Warning> faces_off(const std::vector<ModelFace>& faces, const HexReport& report);

/// Returns how far the volume of hexahedra is off the model's: "its volume is 22 % below the model's".
std::string words_of_volume(const HexReport& report);

/// Returns a size of hexahedra, of two digits, with which their volume would be near the model's; none if it
/// is so already. What straight edges cut off curved surfaces falls with the square of their length; `quads`
/// is the number of faces on the boundary, whose edges may be shorter than the size.
std::optional<double> size_for_volume(const HexReport& report, std::size_t quads);

/// A warning with the figures if hexahedra are far from the surface, or miss much of the volume and the
/// report does not say so (explain_poor).
std::optional<Warning> poor_fit(const HexReport& report);

}  // namespace crossgrain

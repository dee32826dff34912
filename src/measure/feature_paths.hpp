// SPDX-License-Identifier: Apache-2.0
// Where the corners, curves and faces of a model lie on hexahedra, and how much of curves paths of edges
// keep.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "measure/measured_curve.hpp"
#include "measure/surface_quads.hpp"
#include "surface/feature_complex.hpp"

namespace crossgrain {

/// How far a vertex may be from its corner and an edge from its curve, in sizes of hexahedra, beyond what
/// straight edges cut off.
inline constexpr double kKeptWithin = 0.12;

/// By index in a complex and in the quads of a mesh; kNone, or empty, without.
struct FeaturePlaces {
  std::vector<std::uint32_t> vertex_of_corner;
  std::vector<std::vector<std::uint32_t>> path_of_curve;  ///< a closed one ends with its first vertex
  std::vector<std::uint32_t> face_of_quad;
};

/// Edges of quads, ascending, each with its vertices ascending.
std::vector<std::array<std::uint32_t, 2>> edges_of_quads(std::span<const SurfaceQuad> quads);

/// How much of a curve is kept.
struct CurveShare {
  double kept = 0;         ///< length
  bool is_whole = false;   ///< one unbroken path keeps all of it
  double farthest = 0;     ///< largest distance between the path and the curve beyond what it cuts off
  Vector3 place{0, 0, 0};  ///< of the farthest, or where the first stretch that is not kept begins
};

/// Returns how much of a curve a path keeps: an edge of length e keeps the stretch between the nearest points
/// of its ends if all of it lies within `tolerance` + k e^2 / 8 of the edge, and the edge of it, where the
/// curve turns by k e. The path runs from corner to corner; around a closed curve in either direction.
CurveShare share_kept(const MeasuredCurve& line, std::span<const std::uint32_t> path,
                      std::span<const std::array<std::uint32_t, 2>> edges,
                      const std::vector<Vector3>& vertices, double tolerance);

/// Finds places for a mesh that comes without: the nearest vertices of corners, for curves the paths of edges
/// of quads that follow them within the tolerance, none for faces. Where a curve
/// has no unbroken path, `shares` has what its edges keep one by one.
FeaturePlaces found_places(const HexMesh& mesh, std::span<const SurfaceQuad> quads,
                           const FeatureComplex& complex, const std::vector<MeasuredCurve>& lines,
                           double tolerance, std::vector<CurveShare>& shares);

}  // namespace crossgrain

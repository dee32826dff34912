// SPDX-License-Identifier: Apache-2.0
// Triangulations of the link of a vertex of a hexahedral mesh, which say whether hexahedra can meet there.
#pragma once

#include <optional>
#include <span>

namespace crossgrain {

/// Largest number of triangles for which the following searches are made; with more they return none.
inline constexpr int kMostLinkTriangles = 20;

/// Returns whether hexahedra can meet at an inner vertex with exactly these singular edges; `valences` are
/// their numbers of hexahedra, 3 or more each and not 4.
///
/// Hexahedra cut a small sphere around the vertex into triangles, one for each of them, with a vertex of
/// valence n for an edge of n hexahedra. By Euler's formula there are 12 - sum (6 - n) = 2 m regular edges (n
/// = 4) besides. Tries all simplicial triangulations with these valences.
std::optional<bool> has_inner_link(std::span<const int> valences);

/// Returns whether hexahedra can meet at a vertex of the surface with exactly these singular edges inside and
/// these creases: `valences` as for an inner vertex, `creases` the numbers of hexahedra at the edges on the
/// surface around it, in cyclic order, without those of 2.
///
/// The part of the small sphere inside the solid is a disc. By Euler's formula it has F = 4 - sum (4 - n) -
/// sum (2 - k) triangles. Tries all simplicial triangulations, with regular edges (n = 4, k = 2) added in
/// every way; there are none for F < 1 or k < 1.
std::optional<bool> has_surface_link(std::span<const int> valences, std::span<const int> creases);

/// The same with the whole border of the disc, at least three edges: `border` are the numbers of hexahedra at
/// all edges on the surface around the vertex in cyclic order, those of 2 among them. Only regular edges
/// inside are added, as many as Euler's formula asks for.
std::optional<bool> has_link_within(std::span<const int> border, std::span<const int> valences);

/// Returns F, the number of hexahedra at a vertex of the surface.
int hexahedra_at_surface_vertex(std::span<const int> valences, std::span<const int> creases);

}  // namespace crossgrain

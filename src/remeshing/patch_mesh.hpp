// SPDX-License-Identifier: Apache-2.0
// Triangles of patches that change: edges are split, collapsed and flipped, vertices move.
#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "surface/patched_surface.hpp"

namespace crossgrain {

inline constexpr std::uint32_t kNoCurve = UINT32_MAX;

/// Where a vertex may be.
enum class Hold : std::uint8_t {
  kPatch,  ///< anywhere on its patch
  kCurve,  ///< on its curve
  kFixed   ///< where it is: an end of curves, or a vertex where the surface touches itself
};

/// An edge with its triangles, if there are two: (a, b, left) and (b, a, right).
struct PatchEdge {
  std::uint32_t a, b;
  std::uint32_t left, right;               ///< opposite vertices
  std::array<std::uint32_t, 2> triangles;  ///< left and right
};

/// Invariant: every edge that had two triangles has two, which run along it in opposite directions. Edges of
/// one or of more than two triangles never change.
class PatchMesh {
 public:
  /// `sizes`: of the edges wanted at each vertex.
  PatchMesh(const PatchedSurface& given, std::vector<double> sizes);

  struct Vertex {
    Vector3 position;
    double size;
    Hold hold;
    std::uint32_t home;  ///< the patch or curve that it lies on; without meaning if it is fixed
  };

  std::vector<Vertex> vertices;

  const std::array<std::uint32_t, 3>& triangle(std::uint32_t t) const { return triangles_[t]; }
  std::uint32_t patch_of(std::uint32_t t) const { return patch_of_[t]; }
  const std::vector<std::uint32_t>& triangles_at(std::uint32_t vertex) const { return around_[vertex]; }
  std::array<Vector3, 3> corners(const std::array<std::uint32_t, 3>& triangle) const;

  /// The edges of two triangles that there are now, in the order of their triangles; others may be among
  /// them.
  std::vector<std::array<std::uint32_t, 2>> edges() const;

  /// Returns whether the edge exists and has two triangles in opposite directions; fills it in.
  bool find(std::uint32_t a, std::uint32_t b, PatchEdge& edge) const;

  /// Curve of an edge, or kNoCurve.
  std::uint32_t curve_of(std::uint32_t a, std::uint32_t b) const;

  /// The neighbours of a vertex, ascending.
  std::vector<std::uint32_t> neighbours(std::uint32_t vertex) const;

  /// Whether removing `edge.a` at `edge.b` leaves a surface of the same topology, with all curves.
  bool may_collapse(const PatchEdge& edge) const;

  /// Whether the edge between the opposite vertices is new, so that a flip leaves a surface.
  bool may_flip(const PatchEdge& edge) const;

  /// Splits the edge at a new vertex, which is returned.
  std::uint32_t split(const PatchEdge& edge, const Vertex& vertex);
  void collapse(const PatchEdge& edge);
  void flip(const PatchEdge& edge);

  /// Returns what is left, with the tags and curves of the given surface.
  PatchedSurface result(const PatchedSurface& given) const;

 private:
  bool has_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const;
  void hold_vertices(const PatchedSurface& given);
  void replace(std::uint32_t t, std::uint32_t from, std::uint32_t to);
  std::uint32_t add_triangle(const std::array<std::uint32_t, 3>& triangle, std::uint32_t patch);
  void remove_triangle(std::uint32_t t);
  static std::uint64_t key(std::uint32_t a, std::uint32_t b);

  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<std::uint32_t> patch_of_;
  std::vector<bool> is_there_;                      ///< of triangles
  std::vector<std::vector<std::uint32_t>> around_;  ///< triangles at each vertex, in no order
  std::unordered_map<std::uint64_t, std::uint32_t> curve_of_edge_;
};

}  // namespace crossgrain

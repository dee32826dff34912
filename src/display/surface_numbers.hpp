// SPDX-License-Identifier: Apache-2.0
// Numbers on the surface of a field, interpolated: how well the field follows the surface, and its energy.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "display/shown_field.hpp"

namespace crossgrain {

class GridNumbers;
class TetNumbers;

enum class SurfaceNumber {
  kAlignment,  ///< angle between the surface normal and the nearest axis, degrees
  kEnergy,     ///< smoothness energy per volume, length^-2
};

class CornersOfLeaves;

/// A point of ShownField::surface().
struct SurfacePoint {
  Vector3 place;
  std::uint32_t triangle;
  float u, v;  ///< barycentric coordinates of the triangle's second and third corner
};

/// Interpolated numbers. Those of a grid come from the cells around a point that lie in the part and are
/// connected there, so they are continuous within a face except where cells change their size. Those of tets
/// are linear over triangles, energies in their logarithm. Refers to the
/// field. Safe to use from any number of threads; the same for any number of threads.
class SurfaceNumbers {
 public:
  /// On a grid the surface is cut into pieces with sides of `longest` cells at most, from which cells are
  /// weighed and angles measured; by default a few in each cell, or one or two where cells are so many that
  /// each is smaller than a pixel of most pictures.
  SurfaceNumbers(const ShownField& field, SurfaceNumber number, std::optional<double> longest = {});

  /// Another number of the same field on a grid, from the same pieces.
  SurfaceNumbers(const SurfaceNumbers& other, SurfaceNumber number);
  ~SurfaceNumbers();
  SurfaceNumbers(SurfaceNumbers&&) noexcept;

  /// The number at a point of the surface; NaN where the field has no cell or tet.
  double at(const SurfacePoint& point) const;

  /// Energy per volume inside: at a place in a grid, NaN outside of its cells; or of a tet. Only kEnergy.
  double energy_at(const Vector3& place) const;
  double energy_of_tet(std::uint32_t tet) const;

  /// Numbers at places spread over the surface, each with the area around it.
  struct Sample {
    double number;
    double area;
  };
  std::vector<Sample> samples() const;

  /// For tets: one number per vertex of the surface, the mean over the triangles at it; 0 off the surface.
  std::vector<float> at_vertices() const;

  /// For a grid: numbers at the corners of the leaves with surface, fitted to those on it; `corners` are of
  /// the same field. Trilinear interpolation between them is continuous from leaf to leaf of the same size.
  struct LeafCorners {
    CellIndex leaf;
    std::array<float, 8> numbers;  ///< bit a of the index is set on the high side along axis a
  };
  std::vector<LeafCorners> at_leaf_corners(const CornersOfLeaves& corners) const;

 private:
  // One of the two.
  std::unique_ptr<const GridNumbers> grid_;
  std::unique_ptr<const TetNumbers> tets_;
};

}  // namespace crossgrain

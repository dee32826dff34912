// SPDX-License-Identifier: Apache-2.0
// The size of a part: whether numbers hold it, and whether a size that is asked for suits it. Most that do
// not are in another unit.
#pragma once

#include <cstddef>
#include <string>

#include "crossgrain/message.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {

/// The size of a part, model units.
struct PartSize {
  double longest = 0;  ///< longest side of its bounding box
  double volume = 0;
  double area = 0;
  std::string unit;  ///< TriangleMesh::unit
};

/// Returns the size of the part in a closed surface.
PartSize part_size(const Surface& surface);

/// Returns about how many tets of a size fill a part, unless its details ask for smaller ones. Walls thinner
/// than the size have at least a layer of tets beneath their triangles.
double expected_tets(const PartSize& part, double size);

/// A size of elements that is asked for.
struct AskedSize {
  double size = 0;       ///< model units
  const char* elements;  ///< "tets"
  double least = 1;      ///< number of them that the longest side must hold
  double usual = 20;     ///< number of them along it by default
  double expected = 0;   ///< number of them that fill the part
  Remedy remedy = Remedy::kNone;
};

/// Throws Error(kInput) for a model so small, large or far away that derived numbers exceed single precision.
void check_scale(const Box& box);

/// Throws Error(kUsage) if elements of a size are larger than the part, or so many that no memory holds them.
/// The message tells the size of the part, the unit that it may be in, and a size that suits it.
void check_asked_size(const AskedSize& asked, const PartSize& part);

/// Returns a length with its unit: "0.2 mm".
std::string length_text(double length, const std::string& unit);

/// Lines of which `usual_thickness` takes the median. Of wedge, pillow block and bracket in models/, 30 lines
/// give up to 67 % more than 1000, 100 lines 5 % less, 300 lines 3 % more. The simpler 2 V / A is .46 to .76
/// of it, for it counts rims and corners, and a third of the edge of a cube.
inline constexpr std::size_t kThicknessLines = 1000;

/// Returns the thickness of most of a part: the median, over the area of its surface, of the length of the
/// line that runs inward along the normal until it leaves the solid. The edge of a cube, the diameter of a
/// sphere or a rod, the thickness of a plate. Infinite if most lines do not leave.
double usual_thickness(const TriangleBvh& surface, std::size_t lines = kThicknessLines);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// The objects of a 3MF document and how they are put together.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "crossgrain/types.hpp"
#include "files/input_file.hpp"

namespace crossgrain {

/// An affine map: a point p, as a row, becomes p times the first three rows plus the fourth.
struct ThreeMfTransform {
  std::array<Vector3, 4> rows{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}}};

  Vector3 operator()(const Vector3& point) const;

  /// Returns the map that does `first`, then this one.
  ThreeMfTransform after(const ThreeMfTransform& first) const;

  double determinant() const;
};

/// Objects are known by the part (a member of the archive) that holds them and their number in it.
using ThreeMfName = std::pair<std::string, std::string>;

struct ThreeMfPlaced {
  ThreeMfName object;
  ThreeMfTransform transform;
};

/// A mesh, or components.
struct ThreeMfObject {
  bool is_built = true;  ///< false for supports and for what the format calls "other"
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<ThreeMfPlaced> components;
};

struct ThreeMfDocument {
  double millimetres = 1;  ///< of the unit
  std::string unit = "mm";
  std::map<ThreeMfName, ThreeMfObject> objects;
  std::vector<ThreeMfPlaced> items;  ///< what is built
};

/// Reads a document and all parts that it refers to. Indices are in range, numbers finite. Throws
/// Error(kInput) naming the part and the line, Error(kLimit).
ThreeMfDocument read_3mf_document(const InputFile& file);

}  // namespace crossgrain

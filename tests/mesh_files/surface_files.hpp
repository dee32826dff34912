// SPDX-License-Identifier: Apache-2.0
// Small surface files made on the spot, and what reading them gives.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/reading.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {

/// Reads `content` as a file called `name`.
inline TriangleMesh read_as(const std::string& name, std::string_view content) {
  const TemporaryFolder folder;
  return read_surface(folder.write(name, content));
}

/// The message of the Error(kInput) that reading gives; empty, with a failure of the test, where there is
/// none.
inline std::string input_error_of(const std::filesystem::path& path) {
  try {
    const TriangleMesh mesh = read_surface(path);
    ADD_FAILURE() << path << " gave " << mesh.triangles.size() << " triangles and no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInput);
    const std::string message = error.what();
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
    EXPECT_NE(message.find(path.string()), std::string::npos) << message;
    return message;
  }
  return "";
}

inline std::string input_error_as(const std::string& name, std::string_view content) {
  const TemporaryFolder folder;
  return input_error_of(folder.write(name, content));
}

inline double area_of(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    area += norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a])) / 2;
  return area;
}

inline double volume_of(const TriangleMesh& mesh) {
  double volume = 0;
  for (const auto& [a, b, c] : mesh.triangles)
    volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6;
  return volume;
}

/// The corner tetrahedron of the unit cube, outward oriented: volume 1/6.
inline const std::vector<std::array<Vector3, 3>>& tetrahedron() {
  static const std::vector<std::array<Vector3, 3>> triangles = {
      {Vector3{0, 0, 0}, Vector3{0, 1, 0}, Vector3{1, 0, 0}},
      {Vector3{0, 0, 0}, Vector3{1, 0, 0}, Vector3{0, 0, 1}},
      {Vector3{0, 0, 0}, Vector3{0, 0, 1}, Vector3{0, 1, 0}},
      {Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}};
  return triangles;
}

inline void expect_tetrahedron(const TriangleMesh& mesh) {
  EXPECT_EQ(mesh.vertices.size(), 4u);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_DOUBLE_EQ(volume_of(mesh), 1.0 / 6);
}

template <class T>
void append_bytes(std::string& out, T value, bool swapped = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (swapped) std::reverse(raw, raw + sizeof(T));
  out.append(raw, sizeof(T));
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "surface/constraint_guides.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "harmonics/symmetric_matrix3.hpp"
#include "surface/constraint_faults.hpp"

namespace crossgrain {
namespace {

/// Maximum number of face numbers that a message lists; a run counts once.
constexpr std::size_t kRunsShown = 8;

/// With a reach of one cell, the interpolated frame is up to 10 degrees off where a single point rotates the
/// field by 40 degrees. Stresses are dense, their neighbours rotate alike, and there may be many.
constexpr int kReachOfPoint = 2, kReachOfStress = 1;

using TrianglesOfFace = std::map<std::int32_t, std::vector<std::uint32_t>>;

TrianglesOfFace triangles_of_faces(const TriangleMesh& mesh) {
  TrianglesOfFace result;
  for (std::size_t t = 0; t < mesh.faces.size(); ++t)
    result[mesh.faces[t]].push_back(static_cast<std::uint32_t>(t));
  return result;
}

/// Lists face numbers as "1 to 6, 9 and 12".
std::string in_words(const TrianglesOfFace& faces) {
  std::vector<std::string> runs;
  for (auto face = faces.begin(); face != faces.end();) {
    const std::int64_t first = face->first;
    std::int64_t last = first;
    while (++face != faces.end() && face->first == last + 1) ++last;
    runs.push_back(std::to_string(first));
    if (last > first) runs.back() += (last == first + 1 ? " and " : " to ") + std::to_string(last);
  }
  if (runs.size() > kRunsShown) {
    runs.resize(kRunsShown);
    runs.push_back("others up to " + std::to_string(faces.rbegin()->first));
  }
  std::string text = runs[0];
  for (std::size_t k = 1; k < runs.size(); ++k) text += (k + 1 < runs.size() ? ", " : " and ") + runs[k];
  return text;
}

[[noreturn]] void fail_face(const Constraints& constraints, const Constraints::Face& face,
                            const TrianglesOfFace& faces) {
  const std::string text =
      faces.empty() ? "the model has no numbered faces, as files in STEP and other CAD formats have"
                    : "the model has no face " + std::to_string(face.face) + ", only " + in_words(faces);
  throw Error(ErrorKind::kInput, message_on(constraints, face.line, "constraints", text));
}

void add_polyline(const Constraints::Polyline& polyline, Guides& guides) {
  const std::vector<Vector3> given =
      polyline.axes.empty() ? std::vector<Vector3>{} : directions_of(polyline.axes);
  for (std::size_t k = 0; k + 1 < polyline.points.size(); ++k) {
    const Vector3 &a = polyline.points[k], &b = polyline.points[k + 1];
    if (a == b) continue;  // a segment of length zero would be a point
    if (given.empty()) {
      const Vector3 along = unit_vector(b - a);
      guides.segments.push_back({{a, b}, {along, along}, polyline.weight});
    }
    for (const Vector3& axis : given) guides.segments.push_back({{a, b}, {axis, axis}, polyline.weight});
  }
}

void add_face(const Constraints::Face& face, const Surface& surface,
              const std::vector<std::uint32_t>& triangles, Guides& guides) {
  const std::vector<Vector3> given = face.axes.empty() ? std::vector<Vector3>{} : directions_of(face.axes);
  for (const std::uint32_t t : triangles) {
    const std::array<Vector3, 3> corners = surface.corners(t);
    if (given.empty()) {
      std::array<Vector3, 3> normals;
      for (int k = 0; k < 3; ++k) normals[k] = surface.normal_at(t, corners[k]);
      guides.faces.push_back({corners, normals, face.weight});
    }
    for (const Vector3& axis : given) guides.faces.push_back({corners, {axis, axis, axis}, face.weight});
  }
}

GuidePoint guide_of(const Constraints::Point& point) {
  GuidePoint guide{point.at, {}, {}, kReachOfPoint};
  const std::vector<Vector3> directions = directions_of(point.axes);
  for (std::size_t k = 0; k < directions.size(); ++k) {
    guide.directions[k] = directions[k];
    guide.weights[k] = point.weight;
  }
  return guide;
}

}  // namespace

Vector3 unit_vector(const Vector3& vector) {
  // Squares of unit-sized numbers neither overflow nor underflow.
  const double largest = std::max({std::abs(vector[0]), std::abs(vector[1]), std::abs(vector[2])});
  return normalised({vector[0] / largest, vector[1] / largest, vector[2] / largest});
}

std::vector<Vector3> directions_of(std::span<const Vector3> axes) {
  std::vector<Vector3> units;
  for (const Vector3& axis : axes) units.push_back(unit_vector(axis));
  if (units.size() != 3) return units;
  const auto& [a, b, c] = std::array<Vector3, 3>{units[0], units[1], units[2]};
  const Eigensystem3 gram = eigensystem({dot(a, a), dot(a, b), dot(a, c), dot(b, b), dot(b, c), dot(c, c)});
  std::vector<Vector3> result(3, Vector3{0, 0, 0});
  for (int k = 0; k < 3; ++k) {
    const Vector3& v = gram.vectors[k];
    const Vector3 image = (1 / std::sqrt(gram.values[k])) * (v[0] * a + v[1] * b + v[2] * c);
    for (int j = 0; j < 3; ++j) result[static_cast<std::size_t>(j)] += v[j] * image;
  }
  return result;
}

StressAxes stress_axes(const std::array<double, 6>& tensor) {
  double largest = 0;
  for (const double entry : tensor) largest = std::max(largest, std::abs(entry));
  if (largest == 0) return {{Vector3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {}};
  std::array<double, 6> unit;
  for (std::size_t k = 0; k < 6; ++k) unit[k] = tensor[k] / largest;
  const auto& [xx, yy, zz, yz, xz, xy] = unit;
  const Eigensystem3 eigen = eigensystem({xx, xy, xz, yy, yz, zz});
  const auto& [low, middle, high] = eigen.values;
  const double length = std::max(high, 0.0) - std::min(low, 0.0);
  StressAxes axes{
      eigen.vectors,
      {(middle - low) / length, std::min(middle - low, high - middle) / length, (high - middle) / length}};
  for (double& gap : axes.gaps) {
    if (gap < kSmallestGap) gap = 0;
  }
  return axes;
}

void add_constraints(const Constraints& constraints, const Surface& surface, Guides& guides) {
  for (const Constraints::Point& point : constraints.points) guides.points.push_back(guide_of(point));
  for (const Constraints::Polyline& polyline : constraints.polylines) add_polyline(polyline, guides);
  if (!constraints.faces.empty()) {
    const TrianglesOfFace triangles = triangles_of_faces(surface.mesh);
    for (const Constraints::Face& face : constraints.faces) {
      const auto found = triangles.find(face.face);
      if (found == triangles.end()) fail_face(constraints, face, triangles);
      add_face(face, surface, found->second, guides);
    }
  }
  for (const Constraints::Stress& stress : constraints.stresses) {
    const StressAxes axes = stress_axes(stress.tensor);
    if (axes.say_nothing()) continue;
    GuidePoint guide{stress.at, axes.directions, {}, kReachOfStress};
    for (int k = 0; k < 3; ++k) guide.weights[k] = stress.weight * axes.gaps[k];
    guides.points.push_back(guide);
  }
}

}  // namespace crossgrain

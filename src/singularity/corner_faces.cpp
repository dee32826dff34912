// SPDX-License-Identifier: Apache-2.0
#include "singularity/corner_faces.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/degree.hpp"
#include "base/elementary.hpp"

namespace crossgrain {
namespace {

/// The corners of a triangle after and before one of them.
std::array<std::uint32_t, 2> others(const std::array<std::uint32_t, 3>& triangle, std::uint32_t vertex) {
  const auto& [a, b, c] = triangle;
  return a == vertex ? std::array{b, c} : b == vertex ? std::array{c, a} : std::array{a, b};
}

/// Without repeats of the one before, all around.
std::vector<std::int32_t> runs_of(const std::vector<std::int32_t>& faces) {
  std::vector<std::int32_t> runs;
  for (const std::int32_t face : faces)
    if (runs.empty() || runs.back() != face) runs.push_back(face);
  if (runs.size() > 1 && runs.front() == runs.back()) runs.pop_back();
  return runs;
}

}  // namespace

SurfaceFans::SurfaceFans(const SolidSurface& surface)
    : surface_(surface), begins_(surface.vertices.size() + 1, 0) {
  for (const auto& triangle : surface.triangles)
    for (const std::uint32_t v : triangle) ++begins_[v + 1];
  for (std::size_t v = 1; v < begins_.size(); ++v) begins_[v] += begins_[v - 1];
  triangles_.resize(begins_.back());
  std::vector<std::size_t> at = begins_;
  for (std::uint32_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t v : surface.triangles[t]) triangles_[at[v]++] = t;
}

/// Its triangles in cyclic order; empty if they are not one closed fan.
std::vector<std::uint32_t> SurfaceFans::fan_of(std::uint32_t vertex) const {
  std::map<std::uint32_t, std::uint32_t> from;  // the triangle that begins at a neighbour
  for (std::size_t k = begins_[vertex]; k < begins_[vertex + 1]; ++k)
    from.emplace(others(surface_.triangles[triangles_[k]], vertex)[0], triangles_[k]);
  std::vector<std::uint32_t> fan;
  if (from.size() < begins_[vertex + 1] - begins_[vertex]) return fan;
  for (auto next = from.begin(); next != from.end() && fan.size() < from.size();) {
    fan.push_back(next->second);
    const std::uint32_t neighbour = others(surface_.triangles[next->second], vertex)[1];
    next = from.find(neighbour);
    if (next != from.end() && next->second == fan.front())
      return fan.size() == from.size() ? fan : std::vector<std::uint32_t>{};
  }
  return {};
}

double SurfaceFans::angle_at(std::uint32_t triangle, std::uint32_t vertex) const {
  const auto [b, c] = others(surface_.triangles[triangle], vertex);
  const Vector3 to_b = normalised(surface_.vertices[b] - surface_.vertices[vertex]),
                to_c = normalised(surface_.vertices[c] - surface_.vertices[vertex]);
  return arc_cosine(std::clamp(dot(to_b, to_c), -1.0, 1.0)) / kDegree;
}

bool SurfaceFans::is_sharp(std::uint32_t triangle, std::uint32_t next) const {
  return dot(normal_of(surface_, triangle), normal_of(surface_, next)) < std::cos(kSharpDeg * kDegree);
}

CornerFaces SurfaceFans::at(std::uint32_t vertex) const {
  CornerFaces result;
  std::vector<std::uint32_t> fan = fan_of(vertex);
  if (fan.empty()) return result;
  // Begins at a sharp edge, if there is one.
  for (std::size_t k = 0; k < fan.size(); ++k) {
    if (!is_sharp(fan.back(), fan.front())) std::rotate(fan.begin(), fan.begin() + 1, fan.end());
  }
  std::size_t narrowest = 0;
  if (is_sharp(fan.back(), fan.front())) {
    double angle = 0;
    for (std::size_t k = 0, begin = 0; k < fan.size(); ++k) {
      angle += angle_at(fan[k], vertex);
      if (!is_sharp(fan[k], fan[(k + 1) % fan.size()])) continue;
      if (angle < result.narrowest_deg) {
        result.narrowest_deg = angle;
        narrowest = begin;
      }
      angle = 0;
      begin = k + 1;
    }
  }
  if (surface_.faces.empty()) return result;
  std::rotate(fan.begin(), fan.begin() + static_cast<std::ptrdiff_t>(narrowest), fan.end());
  for (const std::uint32_t t : fan) result.faces.push_back(surface_.faces[t]);
  result.faces = runs_of(result.faces);
  return result;
}

std::vector<std::int32_t> SurfaceFans::beside(const SolidCrease::Edge& edge) const {
  if (surface_.faces.empty()) return {};
  return runs_of({surface_.faces[edge.triangles[0]], surface_.faces[edge.triangles[1]]});
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "display/tet_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "display/smooth_corners.hpp"
#include "harmonics/frame.hpp"
#include "measure/alignment.hpp"

namespace crossgrain {
namespace {

/// Energies below this share of the largest count as that much between vertices: they have logarithms.
constexpr float kLeastShare = 1e-8f;

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

double area_of(const SolvedSurface& surface, std::size_t triangle) {
  const auto& [a, b, c] = surface.triangles[triangle];
  return 0.5 *
         norm(cross(surface.vertices[b] - surface.vertices[a], surface.vertices[c] - surface.vertices[a]));
}

/// Six times the volume of a tet and the gradients of its barycentric coordinates times that, of corners 1
/// to 3.
struct TetGradients {
  double six_volumes;
  std::array<Vector3, 3> scaled;
};

TetGradients gradients_in(const TetMesh& mesh, std::size_t tet) {
  const auto& [a, b, c, d] = mesh.tets[tet];
  const Vector3 &origin = mesh.vertices[a], u = mesh.vertices[b] - origin, v = mesh.vertices[c] - origin,
                w = mesh.vertices[d] - origin;
  const Vector3 of_b = cross(v, w);
  return {dot(u, of_b), {of_b, cross(w, u), cross(u, v)}};
}

/// 1/2 |grad h|^2 of each tet, with h linear in it: the energy that `evaluate_vertex_field` sums.
std::vector<float> energy_densities(const TetMesh& mesh, const std::vector<Quaternion>& vertex_frames) {
  std::vector<Coefficients<4>> h(vertex_frames.size());
  parallel_for(h.size(), [&](std::size_t v) { h[v] = frame_coefficients<4>(vertex_frames[v]); });
  std::vector<float> densities(mesh.tets.size());
  parallel_for(densities.size(), [&](std::size_t t) {
    const TetGradients gradients = gradients_in(mesh, t);
    const auto& corners = mesh.tets[t];
    double sum = 0;
    for (std::size_t m = 0; m < h[0].size(); ++m) {
      Vector3 gradient{0, 0, 0};
      for (std::size_t k = 0; k < 3; ++k)
        gradient += (h[corners[k + 1]][m] - h[corners[0]][m]) * gradients.scaled[k];
      sum += dot(gradient, gradient);
    }
    densities[t] = static_cast<float>(0.5 * sum / (gradients.six_volumes * gradients.six_volumes));
  });
  return densities;
}

}  // namespace

TetNumbers::TetNumbers(const ShownField& field, SurfaceNumber number)
    : field_(field), numbers_(field.surface().triangles.size()) {
  if (number == SurfaceNumber::kAlignment)
    average_alignment();
  else
    average_energy();
}

/// The angle of each tet's frame to the normal of its face, averaged by area over the triangles that continue
/// each other.
void TetNumbers::average_alignment() {
  const SolvedSurface& surface = field_.surface();
  const std::vector<std::uint32_t>& tets = field_.tets().solid.boundary_tets;
  const SmoothCorners corners(surface.vertices, surface.triangles);
  std::vector<float> angles(surface.triangles.size(), kNoNumber);
  parallel_for(angles.size(), [&](std::size_t t) {
    if (tets[t] != kNoTet)
      angles[t] = static_cast<float>(
          angle_to_nearest_axis_deg(field_.tet_field().tet_frames[tets[t]], corners.normal(t)));
  });
  parallel_for(numbers_.size(), [&](std::size_t t) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      double sum = 0, area = 0;
      corners.for_each_at(t, corner, [&](std::uint32_t other) {
        if (tets[other] == kNoTet) return;
        const double own = norm(corners.area_vector(other));
        sum += own * static_cast<double>(angles[other]);
        area += own;
      });
      numbers_[t][corner] = area > 0 ? static_cast<float>(sum / area) : kNoNumber;
    }
  });
}

/// The energy of all tets at each vertex per volume of them.
void TetNumbers::average_energy() {
  const TetMesh& mesh = field_.tets().solid.mesh;
  densities_ = energy_densities(mesh, field_.tet_field().vertex_frames);
  std::vector<double> energies(mesh.vertices.size(), 0), volumes(mesh.vertices.size(), 0);
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const double volume = gradients_in(mesh, t).six_volumes;
    for (const std::uint32_t vertex : mesh.tets[t]) {
      energies[vertex] += volume * static_cast<double>(densities_[t]);
      volumes[vertex] += volume;
    }
  }
  const float most = densities_.empty() ? 0 : *std::max_element(densities_.begin(), densities_.end());
  least_ = std::max(kLeastShare * most, std::numeric_limits<float>::min());
  const auto& triangles = field_.surface().triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const std::uint32_t vertex = triangles[t][corner];
      numbers_[t][corner] =
          volumes[vertex] > 0 ? static_cast<float>(energies[vertex] / volumes[vertex]) : kNoNumber;
    }
}

double TetNumbers::at(const SurfacePoint& point) const {
  const auto& [a, b, c] = numbers_[point.triangle];
  const auto mean = [&](float at_a, float at_b, float at_c) {
    return static_cast<double>((1 - point.u - point.v) * at_a + point.u * at_b + point.v * at_c);
  };
  if (densities_.empty()) return mean(a, b, c);
  const auto log_of = [&](float energy) { return std::log(std::max(energy, least_)); };
  return std::isfinite(a + b + c) ? std::exp(mean(log_of(a), log_of(b), log_of(c))) : std::nan("");
}

std::vector<SurfaceNumbers::Sample> TetNumbers::samples() const {
  std::vector<SurfaceNumbers::Sample> samples(3 * numbers_.size());
  parallel_for(numbers_.size(), [&](std::size_t t) {
    const double area = area_of(field_.surface(), t);
    for (std::size_t corner = 0; corner < 3; ++corner)
      samples[3 * t + corner] = {static_cast<double>(numbers_[t][corner]), area / 3};
  });
  return samples;
}

std::vector<float> TetNumbers::at_vertices() const {
  const SolvedSurface& surface = field_.surface();
  std::vector<double> sums(surface.vertices.size(), 0), areas(surface.vertices.size(), 0);
  for (std::size_t t = 0; t < numbers_.size(); ++t) {
    const double area = area_of(surface, t);
    for (std::size_t corner = 0; corner < 3; ++corner) {
      if (!std::isfinite(numbers_[t][corner])) continue;
      sums[surface.triangles[t][corner]] += area * static_cast<double>(numbers_[t][corner]);
      areas[surface.triangles[t][corner]] += area;
    }
  }
  std::vector<float> means(surface.vertices.size(), 0);
  for (std::size_t v = 0; v < means.size(); ++v)
    if (areas[v] > 0) means[v] = static_cast<float>(sums[v] / areas[v]);
  return means;
}

}  // namespace crossgrain

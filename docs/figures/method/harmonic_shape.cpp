// SPDX-License-Identifier: Apache-2.0
#include "harmonic_shape.hpp"

#include <cmath>
#include <numbers>

#include "figure.hpp"
#include "harmonics/evaluation.hpp"
#include "picture/corner_normals.hpp"

namespace crossgrain::figures {
namespace {

/// Rings of the surface from pole to pole, and half as many points as a ring has.
constexpr std::uint32_t kRings = 160;

/// Lobes are round all over; across the pinch between two of them normals differ by more.
constexpr double kSmoothDeg = 75;

}  // namespace

template <int D>
DrawnMesh harmonic_shape(const Coefficients<D>& h) {
  DrawnMesh mesh;
  constexpr std::uint32_t kAround = 2 * kRings;
  for (std::uint32_t ring = 0; ring <= kRings; ++ring) {
    const double polar = std::numbers::pi * ring / kRings;
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const double around = 2 * std::numbers::pi * i / kAround;
      const Vector3 direction{std::sin(polar) * std::cos(around), std::sin(polar) * std::sin(around),
                              std::cos(polar)};
      mesh.vertices.push_back(std::abs(dot(h, evaluate_harmonics<D>(direction))) * direction);
    }
  }
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    for (std::uint32_t i = 0; i < kAround; ++i) {
      const std::uint32_t a = ring * kAround + i, b = ring * kAround + (i + 1) % kAround;
      mesh.triangles.push_back({a, a + kAround, b + kAround});
      mesh.triangles.push_back({a, b + kAround, b});
    }
  }
  mesh.corner_normals = corner_normals(mesh.vertices, mesh.triangles, kSmoothDeg);
  mesh.colour_at = [h](const MeshPoint& point) {
    return dot(h, evaluate_harmonics<D>(point.place)) > 0 ? kPositive : kNegative;
  };
  return mesh;
}

template DrawnMesh harmonic_shape<3>(const Coefficients<3>&);
template DrawnMesh harmonic_shape<4>(const Coefficients<4>&);

}  // namespace crossgrain::figures

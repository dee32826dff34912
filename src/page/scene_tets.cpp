// SPDX-License-Identifier: Apache-2.0
#include "page/scene_tets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/vector3.hpp"
#include "display/surface_numbers.hpp"
#include "measure/alignment.hpp"
#include "page/scene_parts.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

/// Factor on the side of sampled cells while there are too many of them: a few rounds suffice.
constexpr double kCoarser = 1.12;

/// Cells at the surface whose centre lies outside every tet by no more than this in barycentric coordinates
/// take the nearest tet: about half a cell for cells as large as tets.
constexpr double kOutside = -0.5;

/// A face with its area as a vector.
Vector3 area_of(const std::vector<Vector3>& vertices, const std::array<std::uint32_t, 3>& face) {
  return 0.5 * cross(vertices[face[1]] - vertices[face[0]], vertices[face[2]] - vertices[face[0]]);
}

/// Mean by area of the angle between boundary faces and the nearest axis of their tet; negative inside.
std::vector<float> alignments(const ShownField& field) {
  const TetSolid& solid = field.tets().solid;
  std::vector<double> sums(solid.mesh.tets.size(), 0), areas(sums.size(), 0);
  for (std::size_t k = 0; k < solid.boundary.size(); ++k) {
    const std::uint32_t tet = solid.boundary_tets[k];
    const Vector3 area = area_of(solid.mesh.vertices, solid.boundary[k]);
    if (tet == kNoTet || norm(area) == 0) continue;
    sums[tet] += norm(area) * angle_to_nearest_axis_deg(field.tet_field().tet_frames[tet], normalised(area));
    areas[tet] += norm(area);
  }
  std::vector<float> result;
  for (std::size_t i = 0; i < sums.size(); ++i)
    result.push_back(areas[i] > 0 ? static_cast<float>(sums[i] / areas[i]) : -1.0f);
  return result;
}

/// Cubic cells of one size over the tets, each with the tet that holds its centre.
class SampledTets {
 public:
  SampledTets(const TetMesh& mesh, const Box& box, double unit) : low_(box.low), unit_(unit) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      counts_[axis] = static_cast<std::int64_t>((box.high[axis] - box.low[axis]) / unit) + 1;
    const auto size = static_cast<std::size_t>(counts_[0] * counts_[1] * counts_[2]);
    best_.assign(size, static_cast<float>(kOutside));
    tets_.assign(size, kNoTet);
    for (std::uint32_t tet = 0; tet < mesh.tets.size(); ++tet) mark(mesh, tet);
    is_enough_ = std::max({counts_[0], counts_[1], counts_[2]}) <= 65535;
  }

  std::size_t size() const {
    return tets_.size() - static_cast<std::size_t>(std::count(tets_.begin(), tets_.end(), kNoTet));
  }
  bool is_within(std::size_t most) const { return is_enough_ && size() <= most; }

  template <class Act>
  void for_each(const Act& act) const {
    for (std::int64_t z = 0; z < counts_[2]; ++z)
      for (std::int64_t y = 0; y < counts_[1]; ++y)
        for (std::int64_t x = 0; x < counts_[0]; ++x)
          if (const std::uint32_t tet = tets_[index(x, y, z)]; tet != kNoTet)
            act(std::array<std::uint16_t, 3>{static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y),
                                             static_cast<std::uint16_t>(z)},
                tet);
  }

 private:
  std::size_t index(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::size_t>((z * counts_[1] + y) * counts_[0] + x);
  }

  /// Gives the tet to the cells whose centres are in it, or nearer to it than to those before.
  void mark(const TetMesh& mesh, std::uint32_t tet) {
    std::array<Vector3, 4> corner{};
    std::array<std::int64_t, 3> first{}, last{};
    for (std::size_t k = 0; k < 4; ++k) corner[k] = mesh.vertices[mesh.tets[tet][k]];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] =
          std::minmax({corner[0][axis], corner[1][axis], corner[2][axis], corner[3][axis]});
      first[axis] = std::max<std::int64_t>(0, static_cast<std::int64_t>((low - low_[axis]) / unit_));
      last[axis] = std::min(counts_[axis] - 1, static_cast<std::int64_t>((high - low_[axis]) / unit_));
    }
    const Vector3 a = corner[1] - corner[0], b = corner[2] - corner[0], c = corner[3] - corner[0];
    const double volume = dot(a, cross(b, c));
    for (std::int64_t z = first[2]; z <= last[2]; ++z)
      for (std::int64_t y = first[1]; y <= last[1]; ++y)
        for (std::int64_t x = first[0]; x <= last[0]; ++x) {
          const std::array<double, 3> at{static_cast<double>(x), static_cast<double>(y),
                                         static_cast<double>(z)};
          Vector3 centre{};
          for (std::size_t axis = 0; axis < 3; ++axis)
            centre[axis] = low_[axis] + (at[axis] + 0.5) * unit_ - corner[0][axis];
          const double u = dot(centre, cross(b, c)) / volume, v = dot(centre, cross(c, a)) / volume,
                       w = dot(centre, cross(a, b)) / volume;
          const auto inside = static_cast<float>(std::min({u, v, w, 1 - u - v - w}));
          const std::size_t cell = index(x, y, z);
          if (inside <= best_[cell]) continue;
          best_[cell] = inside;
          tets_[cell] = tet;
        }
  }

  Vector3 low_;
  double unit_;
  std::array<std::int64_t, 3> counts_{};
  std::vector<float> best_;  ///< smallest barycentric coordinate of the centre in the cell's tet
  std::vector<std::uint32_t> tets_;
  bool is_enough_ = true;
};

void add_sampled(const ShownField& field, const std::vector<float>& energies, const std::vector<float>& tilts,
                 const Vector3& origin, std::size_t most, const Monitor& monitor, SceneWriter& scene) {
  const TetMesh& mesh = field.tets().solid.mesh;
  double unit = std::cbrt(volume_of(mesh) / static_cast<double>(most));
  SampledTets sampled(mesh, field.tets().box, unit);
  while (!sampled.is_within(most)) {
    monitor.check();
    unit *= kCoarser;
    sampled = SampledTets(mesh, field.tets().box, unit);
  }
  SceneCells cells;
  cells.low = field.tets().box.low;
  cells.unit = unit;
  sampled.for_each([&](const std::array<std::uint16_t, 3>& corner, std::uint32_t tet) {
    cells.corners.insert(cells.corners.end(), corner.begin(), corner.end());
    cells.sizes.push_back(1);
    add_quaternion(field.tet_field().tet_frames[tet], cells.frames);
    cells.energy_density.push_back(to_bfloat16(energies[tet]));
    cells.alignment_deg.push_back(to_bfloat16(std::max(0.0f, tilts[tet])));
    cells.classes.push_back(tilts[tet] >= 0 ? 1 : 0);
    if (!mesh.regions.empty()) cells.regions.push_back(mesh.regions[tet]);
  });
  cells.write(cells.size(), origin, scene);
}

}  // namespace

bool add_tets(const ShownField& field, const Vector3& origin, std::size_t most_tets, std::size_t most_cells,
              const Monitor& monitor, SceneWriter& scene) {
  const TetMesh& mesh = field.tets().solid.mesh;
  const SurfaceNumbers numbers(field, SurfaceNumber::kEnergy);
  std::vector<float> energies;
  for (std::uint32_t tet = 0; tet < mesh.tets.size(); ++tet)
    energies.push_back(static_cast<float>(numbers.energy_of_tet(tet)));
  const std::vector<float> tilts = alignments(field);
  const bool are_tets = mesh.tets.size() <= most_tets;
  scene.header["tets"] = {{"total", mesh.tets.size()}, {"shown", are_tets ? mesh.tets.size() : 0}};
  if (!are_tets) {
    add_sampled(field, energies, tilts, origin, most_cells, monitor, scene);
    return false;
  }
  constexpr std::uint32_t kUnused = UINT32_MAX;
  std::vector<std::uint32_t> place(mesh.vertices.size(), kUnused), corners;
  std::vector<float> points;
  std::vector<std::int16_t> frames;
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    for (const std::uint32_t vertex : mesh.tets[i]) {
      if (place[vertex] == kUnused) {
        place[vertex] = used++;
        for (std::size_t axis = 0; axis < 3; ++axis)
          points.push_back(static_cast<float>(mesh.vertices[vertex][axis] - origin[axis]));
      }
      corners.push_back(place[vertex]);
    }
    add_quaternion(field.tet_field().tet_frames[i], frames);
  }
  scene.add("tet_points", 3, points);
  scene.add("tet_corners", 4, corners);
  scene.add("tet_frame", 4, frames);
  scene.add("tet_energy_density", 1, column<std::uint16_t>(energies, to_bfloat16));
  scene.add("tet_alignment_deg", 1, column<std::uint16_t>(tilts, to_bfloat16));
  add_regions(mesh.regions, mesh.regions, "tet_region", "tet_regions", scene);
  return true;
}

void add_boundary_numbers(const ShownField& field, const DrawnSurface& drawn, SceneWriter& scene) {
  const auto add = [&](const char* name, SurfaceNumber number) {
    const std::vector<float> numbers = SurfaceNumbers(field, number).at_vertices();
    scene.add(name, 1, column<std::uint16_t>(drawn.originals, [&](std::uint32_t vertex) {
                return to_bfloat16(numbers[vertex]);
              }));
  };
  add("surface_alignment_deg", SurfaceNumber::kAlignment);
  add("surface_energy_density", SurfaceNumber::kEnergy);
  const SolvedSurface& surface = field.surface();
  // Triangles of a simplified surface are none of the boundary: the tets at their first vertices tell.
  std::vector<std::int32_t> of_vertex(surface.vertices.size(), 0), regions;
  if (surface.regions.empty()) return;
  for (std::size_t k = 0; k < surface.triangles.size(); ++k)
    for (const std::uint32_t vertex : surface.triangles[k]) of_vertex[vertex] = surface.regions[k];
  const bool is_whole = 3 * surface.triangles.size() == drawn.vertices.size();
  for (std::size_t k = 0; k < drawn.vertices.size(); k += 3)
    regions.push_back(is_whole ? surface.regions[k / 3] : of_vertex[drawn.originals[drawn.vertices[k]]]);
  add_regions(regions, field.tets().solid.mesh.regions, "surface_region", "tet_regions", scene);
}

}  // namespace crossgrain

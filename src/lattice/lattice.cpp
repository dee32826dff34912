// SPDX-License-Identifier: Apache-2.0
#include "lattice/lattice.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <utility>

#include "base/required_memory.hpp"
#include "base/vector3.hpp"
#include "lattice/lattice_axes.hpp"
#include "lattice/lattice_cells.hpp"
#include "lattice/lattice_planes.hpp"
#include "lattice/volume_shares.hpp"
#include "measure/hex_faces.hpp"
#include "surface/shells.hpp"

namespace crossgrain {
namespace {

/// Bytes of a cell while it is decided which are kept, and of its hexahedron.
constexpr double kBytesOfCell = 120;

/// The surface in coordinates along the axes of a frame.
Surface turned(const Surface& surface, const Quaternion& axes) {
  TriangleMesh mesh;
  mesh.triangles = surface.mesh.triangles;
  for (const Vector3& p : surface.mesh.vertices) mesh.vertices.push_back(rotate(conjugate(axes), p));
  return prepare_surface(CheckedMesh::derived(std::move(mesh)));
}

/// A box around a hole's.
Box ring_around(Box box) {
  // Of a width: a wall of a quarter of it has half of the cells beside the hole.
  constexpr double kRing = 0.5;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double width = kRing * (box.high[axis] - box.low[axis]);
    box.low[axis] -= width;
    box.high[axis] += width;
  }
  return box;
}

void require_memory_of(const LatticePlanes& planes) {
  const auto cells = static_cast<double>(planes.cells(0)) * static_cast<double>(planes.cells(1)) *
                     static_cast<double>(planes.cells(2));
  require_memory(kBytesOfCell * cells, fmt::format("a lattice of {:.2g} cells", cells),
                 Remedy::kTakeFewerHexahedra);
}

HexMesh mesh_of(const KeptCells& kept, const LatticePlanes& planes) {
  constexpr std::uint32_t kNone = UINT32_MAX;
  const std::array<std::size_t, 3> cells = {planes.cells(0), planes.cells(1), planes.cells(2)};
  std::vector<std::uint32_t> vertex_of((cells[0] + 1) * (cells[1] + 1) * (cells[2] + 1), kNone);
  HexMesh mesh;
  const auto vertex = [&](std::size_t i, std::size_t j, std::size_t k) {
    std::uint32_t& index = vertex_of[(i * (cells[1] + 1) + j) * (cells[2] + 1) + k];
    if (index == kNone) {
      index = static_cast<std::uint32_t>(mesh.vertices.size());
      mesh.vertices.push_back({planes.at[0][i], planes.at[1][j], planes.at[2][k]});
    }
    return index;
  };
  for (std::size_t i = 0; i < cells[0]; ++i)
    for (std::size_t j = 0; j < cells[1]; ++j)
      for (std::size_t k = 0; k < cells[2]; ++k) {
        if (!kept.is_kept[(i * cells[1] + j) * cells[2] + k]) continue;
        mesh.hexahedra.push_back({vertex(i, j, k), vertex(i + 1, j, k), vertex(i + 1, j + 1, k),
                                  vertex(i, j + 1, k), vertex(i, j, k + 1), vertex(i + 1, j, k + 1),
                                  vertex(i + 1, j + 1, k + 1), vertex(i, j + 1, k + 1)});
      }
  return mesh;
}

/// Boxes of bodies that may have too few cells for the largest one's.
std::vector<Box> small_bodies_of(const TriangleMesh& mesh) {
  constexpr double kSmall = 2 * kLeastBody;
  const std::vector<ShellBody> bodies = bodies_in(mesh.triangles, mesh.vertices);
  double largest = 0;
  for (const ShellBody& body : bodies) largest = std::max(largest, body.volume);
  std::vector<Box> boxes;
  for (const ShellBody& body : bodies)
    if (body.volume < kSmall * largest) boxes.push_back(body.box);
  return boxes;
}

NarrowPlanes narrow_along(const NarrowFeatures& narrow, const Quaternion& axes) {
  NarrowPlanes along{.walls = narrow.level >= NarrowLevel::kWalls, .fine = narrow.fine};
  const auto box_along = [&](const std::vector<Vector3>& line) {
    Box box = empty_box();
    for (const Vector3& p : line) include(box, rotate(conjugate(axes), p));
    return box;
  };
  for (const std::vector<Vector3>& line : narrow.lines) along.lines.push_back(box_along(line));
  for (FinePlace& place : along.fine) {
    place.at = rotate(conjugate(axes), place.at);
    place.normal = rotate(conjugate(axes), place.normal);
  }
  for (const Hole& hole : narrow.holes) along.holes.push_back({box_along(hole.points), hole.is_boss});
  for (const auto& [box, is_boss] : along.holes)
    if (narrow.level >= NarrowLevel::kHoles) along.boxes.push_back(box);
  for (const auto& [box, is_boss] : along.holes)
    if (narrow.level >= NarrowLevel::kRings) along.boxes.push_back(ring_around(box));
  return along;
}

}  // namespace

std::vector<int> shells_of(const HexMesh& mesh) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const HexMesh::Face& face : mesh.boundary) {
    const auto& [a, b, c, d] = face.vertices;
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
  }
  return euler_numbers_of_shells(triangles);
}

Lattice lattice_of(const Surface& surface, double size, const NarrowFeatures& narrow) {
  const Quaternion axes = lattice_axes(surface);
  Lattice lattice = lattice_between(surface, axes, [&](const Surface& along) {
    return lattice_planes(along, size, narrow_along(narrow, axes));
  });
  lattice.level = narrow.level;
  return lattice;
}

Lattice lattice_between(const Surface& surface, const Quaternion& axes,
                        const std::function<LatticePlanes(const Surface& along)>& planes_of) {
  Lattice lattice;
  lattice.axes = axes;
  const Surface along = turned(surface, axes);
  lattice.slanted_share = slanted_share(along);
  const LatticePlanes planes = planes_of(along);
  require_memory_of(planes);
  const KeptCells kept =
      kept_cells(volume_shares(along, planes), planes, [&] { return small_bodies_of(along.mesh); });
  lattice.toggled = kept.toggled;
  lattice.mesh = mesh_of(kept, planes);
  for (Vector3& p : lattice.mesh.vertices) p = rotate(lattice.axes, p);
  for (const HexSide& side : boundary_of(lattice.mesh)) lattice.mesh.boundary.push_back({side.vertices, 0});
  if (kept.faults == 0) lattice.shells = shells_of(lattice.mesh);
  return lattice;
}

bool has_other_planes(const Surface& surface, double size, NarrowFeatures narrow, NarrowLevel level) {
  const Quaternion axes = lattice_axes(surface);
  const Surface along = turned(surface, axes);
  const LatticePlanes now = lattice_planes(along, size, narrow_along(narrow, axes));
  narrow.level = level;
  return lattice_planes(along, size, narrow_along(narrow, axes)).at != now.at;
}

}  // namespace crossgrain

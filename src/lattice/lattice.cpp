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

/// Adds a box around each.
void add_rings(std::vector<Box>& boxes) {
  constexpr double kRing =
      0.5;  // of a width: a wall of a quarter of it has half of the cells beside the hole
  const std::size_t count = boxes.size();
  for (std::size_t k = 0; k < count; ++k) {
    Box ring = boxes[k];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double width = kRing * (ring.high[axis] - ring.low[axis]);
      ring.low[axis] -= width;
      ring.high[axis] += width;
    }
    boxes.push_back(ring);
  }
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
  Lattice lattice;
  lattice.axes = lattice_axes(surface);
  const Surface along = turned(surface, lattice.axes);
  NarrowPlanes of_narrow{narrow.walls, {}, narrow.fine};
  const auto box_along = [&](const std::vector<Vector3>& line) {
    std::vector<Vector3> points;
    for (const Vector3& p : line) points.push_back(rotate(conjugate(lattice.axes), p));
    return box_of(points);
  };
  for (const std::vector<Vector3>& line : narrow.lines) of_narrow.lines.push_back(box_along(line));
  for (FinePlace& place : of_narrow.fine) {
    place.at = rotate(conjugate(lattice.axes), place.at);
    place.normal = rotate(conjugate(lattice.axes), place.normal);
  }
  for (const std::vector<Vector3>& hole : narrow.holes) of_narrow.holes.push_back(box_along(hole));
  if (narrow.have_rings) add_rings(of_narrow.holes);
  lattice.slanted_share = slanted_share(along);
  const LatticePlanes planes = lattice_planes(along, size, of_narrow);
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

}  // namespace crossgrain

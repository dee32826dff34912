// SPDX-License-Identifier: Apache-2.0
#include "display/shown_field.hpp"

#include <algorithm>

#include "crossgrain/error.hpp"
#include "tets/inner_walls.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

std::shared_ptr<const SolvedSurface> surface_of(const FieldData& field) {
  auto surface = field.surface.get();
  if (!surface || surface->triangles.empty())
    throw Error(ErrorKind::kInput, "the field has no surface (earlier versions did not write it)",
                Remedy::kSolveAgain);
  return surface;
}

/// The face of a tet with these vertices, outward.
std::array<std::uint32_t, 3> outward(const std::array<std::uint32_t, 4>& tet,
                                     const std::array<std::uint32_t, 3>& face) {
  for (const auto& corners : kFaceCorners) {
    const std::array<std::uint32_t, 3> own{tet[corners[0]], tet[corners[1]], tet[corners[2]]};
    if (std::is_permutation(own.begin(), own.end(), face.begin())) return own;
  }
  return face;
}

void add_regions(const TetSolid& solid, SolvedSurface& surface) {
  if (!has_several_regions(solid.mesh)) return;
  const std::vector<std::int32_t>& regions = solid.mesh.regions;
  surface.regions = regions_of_boundary(solid);
  for (const auto& [vertices, tets] : solid.inner_faces) {
    if (tets[1] == kNoTet || regions[tets[0]] == regions[tets[1]]) continue;
    surface.interfaces.push_back(outward(solid.mesh.tets[tets[0]], vertices));
    surface.interface_regions.push_back({regions[tets[0]], regions[tets[1]]});
  }
}

/// The boundary of the tets, with the creases of the solve and the faces between regions.
std::shared_ptr<const SolvedSurface> boundary_of(const TetSolid& solid, const FieldData& grid) {
  auto surface = std::make_shared<SolvedSurface>();
  surface->vertices = solid.mesh.vertices;
  surface->triangles = solid.boundary;
  surface->faces = tags_of_faces(solid.mesh, solid.boundary);
  if (const auto solved = grid.surface.get()) surface->creases = solved->creases;
  add_regions(solid, *surface);
  return surface;
}

}  // namespace

ShownField::ShownField(const FrameField& field, const SingularityGraph* lines)
    : grid_(field), surface_(surface_of(field.data())), lines_(lines ? lines : &grid_.singularities()) {}

ShownField::ShownField(const TetFrameField& field, const SingularityGraph* lines)
    : grid_(field.grid()),
      tets_(field),
      surface_(boundary_of(field.domain().data().solid, field.grid().data())),
      lines_(lines ? lines : &tets_->singularities()) {}

}  // namespace crossgrain

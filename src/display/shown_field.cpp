// SPDX-License-Identifier: Apache-2.0
#include "display/shown_field.hpp"

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

std::shared_ptr<const SolvedSurface> surface_of(const FieldData& field) {
  auto surface = field.surface.get();
  if (!surface || surface->triangles.empty())
    throw Error(ErrorKind::kInput, "the field has no surface (earlier versions did not write it)",
                Remedy::kSolveAgain);
  return surface;
}

/// The boundary of the tets, with the creases of the solve and the faces between regions.
std::shared_ptr<const SolvedSurface> boundary_of(const TetSolid& solid, const FieldData& grid) {
  auto surface = std::make_shared<SolvedSurface>();
  surface->vertices = solid.mesh.vertices;
  surface->triangles = solid.boundary;
  if (const auto solved = grid.surface.get()) surface->creases = solved->creases;
  for (const TetSolid::InnerFace& face : solid.inner_faces) {
    if (solid.mesh.regions.empty() || face.tets[1] == kNoTet) continue;
    if (solid.mesh.regions[face.tets[0]] != solid.mesh.regions[face.tets[1]])
      surface->interfaces.push_back(face.vertices);
  }
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

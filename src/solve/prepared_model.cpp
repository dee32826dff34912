// SPDX-License-Identifier: Apache-2.0
#include "solve/prepared_model.hpp"

#include <utility>

#include "measure/constraint_report.hpp"
#include "measure/input_report.hpp"
#include "measure/part_size.hpp"
#include "solve/solve_checks.hpp"
#include "surface/constraint_guides.hpp"
#include "surface/model_faces.hpp"
#include "surface/self_intersections.hpp"

namespace crossgrain {
namespace {

/// Weight of tagged edges of a tet mesh where the surface is not sharp, as SolverTuning::crease_weight. It is
/// larger because no surface constrains the frames there: 0.25, and at some resolutions 1, leave frames 45
/// degrees off along a diagonal through a block; from 1.75 on some fields end with three times the energy.
constexpr double kTaggedWeight = 1.5;

MendedSurface mended_and_checked(CheckedMesh outer, const SolveTuning& options) {
  MendedSurface mended = mend_surface(std::move(outer));
  check_size(mended.surface, options);
  check_places(options.constraints, mended.surface.box);
  return mended;
}

SolidSplit checked_and_split(CheckedMesh mesh, const SolveTuning& options) {
  if (const Box box = box_of_solid_triangles(*mesh); box.low[0] <= box.high[0]) check_scale(box);
  return split_solids(std::move(mesh), options.unite_solids);
}

Guides guides_of(const CreaseNetwork& creases, const TriangleMesh& inner_faces, const Surface& surface,
                 const SolveTuning& options) {
  Guides guides = guides_along(creases.curves, creases.corners, options.solver.crease_weight, kTaggedWeight);
  guides.faces = guides_across(inner_faces);
  add_constraints(options.constraints, surface, guides);
  return guides;
}

/// Adds the faces between solids, with vertices of their own.
void add_interfaces(const std::vector<SolidSplit::Between>& between, const std::vector<Vector3>& vertices,
                    SolvedSurface& surface) {
  std::vector<std::uint32_t> new_index(vertices.size(), UINT32_MAX);
  for (const auto& [triangle, solids, sources] : between) {
    auto& corners = surface.interfaces.emplace_back(triangle);
    for (std::uint32_t& vertex : corners) {
      std::uint32_t& index = new_index[vertex];
      if (index == UINT32_MAX) {
        index = static_cast<std::uint32_t>(surface.vertices.size());
        surface.vertices.push_back(vertices[vertex]);
      }
      vertex = index;
    }
    surface.interface_regions.push_back(solids);
  }
}

}  // namespace

PreparedModel::PreparedModel(const TriangleMesh& mesh, const SolveTuning& options)
    : PreparedModel(mesh, checked_and_split(mesh, options), options) {}

PreparedModel::PreparedModel(const TriangleMesh& mesh, SolidSplit split, const SolveTuning& options)
    : mesh_(mesh),
      inner_faces_(std::move(split.inner)),
      interfaces_(std::move(split.between)),
      searchable_(
          std::make_shared<const SearchableSurface>(mended_and_checked(std::move(split.outer), options))),
      face_numbers_(face_numbers(surface(), {.least_deg = options.crease_angle_deg})),
      creases_(surface(), inner_faces_, {.least_deg = options.crease_angle_deg},
               searchable_->winding().flipped()),
      guides_(guides_of(creases_, inner_faces_, surface(), options)),
      solid_{surface(), searchable_->bvh(), searchable_->winding(), mended().closed, &guides_} {}

std::vector<std::vector<Vector3>> PreparedModel::crease_lines() const {
  std::vector<std::vector<Vector3>> lines;
  for (const CreaseCurve& curve : creases_.curves)
    if (curve.points.size() > 1) lines.push_back(curve.points);
  return lines;
}

SolveReport::Model PreparedModel::description() const {
  // Edges along which solids touch have more than two triangles.
  const SurfaceTopology& topology = mended().topology;
  SolveReport::Model model;
  model.triangles = mesh_.triangles.size();
  const bool has_exact_box = longest_side(mesh_.exact_box) > 0;
  model.bounding_box = has_exact_box ? mesh_.exact_box : surface().box;
  model.watertight = topology.watertight || (has_several_solids(mesh_) && topology.unbalanced_edges == 0);
  model.components = topology.components;
  model.unit = mesh_.unit;
  model.file_unit = mesh_.file_unit;
  return model;
}

std::vector<ModelFace> PreparedModel::faces() const {
  if (!mesh_.face_list.empty()) return mesh_.face_list;
  return listed_faces(surface().mesh.vertices, surface().mesh.triangles, face_numbers_,
                      mesh_.faces.empty() ? FaceKind::kPatch : FaceKind::kTagged);
}

SolveReport::Input PreparedModel::findings() const {
  SurfaceFindings findings = mended().findings;
  find_self_intersections(mended(), searchable_->bvh(), searchable_->winding(), findings);
  return input_report(mended(), findings);
}

SurfaceSource PreparedModel::solved_surface() && {
  const TriangleMesh& mesh = surface().mesh;
  SolvedSurface released{mesh.vertices, mesh.triangles, crease_lines()};
  released.faces = std::move(face_numbers_);
  if (has_several_solids(mesh_)) released.regions = mesh.solids;
  add_interfaces(interfaces_, inner_faces_.vertices, released);
  const bool is_flipped = searchable_->winding().flipped();
  if (is_flipped) {
    for (auto& [a, b, c] : released.triangles) std::swap(b, c);
    for (auto& [a, b, c] : released.interfaces) std::swap(b, c);
  }
  // With the triangles reversed, normals and trees are others.
  return is_flipped ? SurfaceSource(std::move(released)) : SurfaceSource(std::move(released), searchable_);
}

}  // namespace crossgrain

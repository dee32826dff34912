// SPDX-License-Identifier: Apache-2.0
#include "tet_making/given_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <utility>

#include "base/vector3.hpp"
#include "crossgrain/features.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/place.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "surface/closing.hpp"
#include "surface/defeaturing.hpp"
#include "surface/edge_uses.hpp"
#include "surface/faded_creases.hpp"
#include "surface/feature_complex.hpp"
#include "surface/model_faces.hpp"
#include "surface/solid_split.hpp"
#include "surface/topology.hpp"
#include "tet_making/surface_faults.hpp"
#include "tet_making/surface_tets.hpp"

namespace crossgrain {
namespace {

/// Of the triangles of a CAD file that hexahedra are measured against: they are within 0.02 % of the longest
/// side of the true faces, 0.4 % of the size of twenty hexahedra along it.
constexpr int kGivenResolution = 4 * kDefaultResolution;

/// Numbers of solids that are not closed.
std::set<std::int32_t> open_solids(const CadModel& model) {
  std::set<std::int32_t> solids(model.mesh.solids.begin(), model.mesh.solids.end());
  for (const std::int32_t closed : model.solids.solid_numbers) solids.erase(closed);
  return solids;
}

/// Throws Error(kInput) if solids are not closed, naming the places.
void check_solids(const CadModel& model) {
  const std::set<std::int32_t> solids = open_solids(model);
  if (solids.empty()) return;
  TriangleMesh open;
  open.vertices = model.mesh.vertices;
  for (std::size_t t = 0; t < model.mesh.triangles.size(); ++t)
    if (solids.contains(model.mesh.solids[t])) open.triangles.push_back(model.mesh.triangles[t]);
  check_bounds_solid(SearchableSurface(mend_surface(CheckedMesh(weld(std::move(open))))));
}

}  // namespace

CadModel read_open_solids(const InputFile& file, CadFormat format, const TetMakingTuning& options,
                          const Monitor& monitor) {
  CadReading reading;
  reading.resolution = kGivenResolution;
  reading.crease_angle_deg = options.crease_angle_deg;
  reading.read_seconds = options.read_seconds;
  reading.glue = options.glue;
  reading.max_memory_bytes = options.max_memory_bytes;
  reading.cad_program = options.cad_program;
  CadModel model = read_cad(file, format, reading, monitor, CadContent::kWithSolids);
  model.mesh = with_unit(std::move(model.mesh), options.unit, file.name());
  monitor.tell(summary_of(model.mesh));
  return model;
}

CadModel read_solids(const InputFile& file, CadFormat format, const TetMakingTuning& options,
                     const Monitor& monitor) {
  CadModel model = read_open_solids(file, format, options, monitor);
  check_solids(model);
  return model;
}

bool has_open_solids(const CadModel& model) {
  return !open_solids(model).empty();
}

GivenModel given_cad(const TriangleMesh& mesh, double crease_angle_deg) {
  const SolidSplit split = split_solids(CheckedMesh(mesh), /*unite=*/true);
  const TriangleMesh& outer = *split.outer;
  const bool is_exact = mesh.exact_size.volume > 0;
  GivenModel given{is_exact ? ModelSource::kCad : ModelSource::kSurface, mesh.face_list,
                   is_exact ? mesh.exact_size : size_of(outer.vertices, outer.triangles), outer,
                   crease_angle_deg};
  for (const SolidSplit::Between& pair : split.between) given.between.push_back(pair.triangle);
  return given;
}

ClosedModel::ClosedModel(TriangleMesh given, double crease_angle_deg, double defeature)
    : crease_angle_deg_(crease_angle_deg) {
  surface_.emplace(closed_surface(CheckedMesh(std::move(given)), warnings_));
  const SurfaceFindings findings = all_findings(*surface_);
  std::vector<Warning> mended = warnings_of_faults(surface_->mended(), findings);
  if (may_be_united(findings)) {
    MendedSurface united = united_surface(*surface_);
    // Parts that meet in an edge stay as they are.
    if (has_crossings(findings) || united.surface.size() != surface_->surface().size()) {
      surface_.emplace(std::move(united));
      may_cross_ = true;
    }
  }
  check_closed(surface_->mended());
  warnings_.insert(warnings_.end(), mended.begin(), mended.end());
  if (defeature > 0) leave_out_below(defeature);
  const Surface& surface = surface_->surface();
  if (!surface.mesh.faces.empty()) return;
  auto faded = faded_crease_warning(surface, sorted_edge_uses(surface.mesh.triangles),
                                    {.least_deg = crease_angle_deg});
  if (faded) warnings_.push_back(*std::move(faded));
}

void ClosedModel::leave_out_below(double size) {
  constexpr std::size_t kMostPlaces = 5;
  const Surface& surface = surface_->surface();
  DefeaturedSurface left = without_small_features(
      surface.mesh,
      feature_complex(surface, {.angles = {.least_deg = crease_angle_deg_}, .unite_solids = true}), size);
  if (left.features.empty()) {
    warnings_.emplace_back(WarningKind::kLeftOutFeatures,
                           fmt::format("no hole, slot, pocket or boss is narrower than {:.4g}", size));
    return;
  }
  const double longest = longest_side(surface.box);
  std::string places;
  for (std::size_t k = 0; k < std::min(left.features.size(), kMostPlaces); ++k)
    places += fmt::format("{} {:.3g} wide at {}", k == 0 ? "" : ",", left.features[k].width,
                          words_of_place(left.features[k].middle, longest));
  if (left.features.size() > kMostPlaces)
    places += fmt::format(", and {} narrower", left.features.size() - kMostPlaces);
  warnings_.emplace_back(WarningKind::kLeftOutFeatures,
                         fmt::format("{} narrower than {:.4g} left out:{}",
                                     counted(left.features.size(), "hole, slot, pocket or boss",
                                             "holes, slots, pockets or bosses"),
                                     size, places));
  surface_.emplace(mend_surface(CheckedMesh::derived(std::move(left.mesh))));
  check_closed(surface_->mended());
  may_cross_ = true;
}

void ClosedModel::check_crossings() const {
  if (may_cross_) check_bounds_solid(*surface_);
}

PatchedSurface ClosedModel::patches() const {
  return surface_to_fill(surface_->surface(), {.least_deg = crease_angle_deg_});
}

GivenModel ClosedModel::given(const PatchedSurface& patches) const {
  TriangleMesh mesh{patches.vertices, patches.triangles};
  mesh.unit = surface_->surface().mesh.unit;
  for (const std::uint32_t patch : patches.patch_of) mesh.faces.push_back(patches.tags[patch]);
  const FaceKind kind = surface_->surface().mesh.faces.empty() ? FaceKind::kPatch : FaceKind::kTagged;
  std::vector<ModelFace> faces = listed_faces(mesh.vertices, mesh.triangles, mesh.faces, kind);
  const ModelSize size = size_of(mesh.vertices, mesh.triangles);
  return {ModelSource::kSurface, std::move(faces), size, std::move(mesh), crease_angle_deg_};
}

}  // namespace crossgrain

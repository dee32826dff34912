// SPDX-License-Identifier: Apache-2.0
#include "picture/cell_colours.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "crossgrain/error.hpp"
#include "display/shown_faces.hpp"
#include "picture/face_labels.hpp"
#include "picture/region_colours.hpp"

namespace crossgrain {
namespace {

/// Share of the surface that is within the scale; numbers above it have the colour of its end.
constexpr double kWithinScale = 0.99;

/// Smallest range of a scale of angles, in degrees: below it, a field follows its surface.
constexpr double kLeastAngles = 5;

/// Largest number of powers of ten on a logarithmic scale.
constexpr double kMostDecades = 4;

struct ClassLook {
  const char* text;
  Colour colour;
};

/// Names and colours in the order of CellConstraint.
constexpr std::array<ClassLook, kCellConstraintCount> kClasses{
    {{"no surface", kPlainPart},
     {"plane: one axis along the normal", colour_of(0xbfd0e0)},
     {"axis: one, by compromise", colour_of(0x3d9bd9)},
     {"frame: all three axes", colour_of(0x12916f)},
     {"free: any frame", colour_of(0xf0d442)},
     {"conflicted: no frame fits", colour_of(0xd5481f)}}};

std::string unit_of_density(const std::string& unit) {
  return unit.empty() ? "length⁻²" : unit + "⁻²";
}

/// Ascending samples, without those that have no number or, on a logarithmic scale, no logarithm.
std::vector<SurfaceNumbers::Sample> sorted_samples(const SurfaceNumbers& numbers, bool is_logarithmic) {
  std::vector<SurfaceNumbers::Sample> samples = numbers.samples();
  std::erase_if(samples, [&](const auto& sample) {
    return !std::isfinite(sample.number) || (is_logarithmic && sample.number <= 0);
  });
  if (samples.empty()) samples.push_back({1, 1});
  std::sort(samples.begin(), samples.end(), [](const auto& a, const auto& b) { return a.number < b.number; });
  return samples;
}

/// The smallest number that this share of the surface does not exceed.
double percentile(const std::vector<SurfaceNumbers::Sample>& sorted, double share) {
  double all = 0, area = 0;
  for (const auto& sample : sorted) all += sample.area;
  for (const auto& sample : sorted)
    if ((area += sample.area) >= share * all) return sample.number;
  return sorted.back().number;
}

}  // namespace

CellColours::CellColours(const ShownField& field, const PictureOptions& options)
    : field_(field),
      finder_(field.grid().tree),
      what_(options.colour),
      map_(options.colour != PictureColour::kEnergy         ? ColourMap::heat()
           : options.background == PictureBackground::kDark ? ColourMap::dawn()
                                                            : ColourMap::dusk()) {
  if (what_ == PictureColour::kConstraint) {
    if (field.is_on_tets())
      throw Error(ErrorKind::kUsage,
                  "a field on tets has no classes of constraints; draw the grid from which it started");
    if (field.grid().constraints.empty())
      throw Error(ErrorKind::kInput,
                  "the field has no array 'constraint_class' (earlier versions did not write it)",
                  Remedy::kSolveAgain);
    boundary_.emplace(field.grid());
  }
  if (what_ == PictureColour::kAlignment) numbers_.emplace(field, SurfaceNumber::kAlignment);
  if (what_ == PictureColour::kEnergy) numbers_.emplace(field, SurfaceNumber::kEnergy);
  if (numbers_) choose_scale(options);
  if (what_ == PictureColour::kRegion) choose_regions(options);
  if (what_ == PictureColour::kFace) choose_faces();
}

void CellColours::choose_faces() {
  faces_ = faces_of(field_);
  if (!faces_.empty()) return;
  throw Error(ErrorKind::kInput, "the model has no faces, or the folder is of an earlier version");
}

void CellColours::choose_scale(const PictureOptions& options) {
  scale_.is_logarithmic = what_ == PictureColour::kEnergy;
  const auto samples = sorted_samples(*numbers_, scale_.is_logarithmic);
  const double high = percentile(samples, kWithinScale);
  if (scale_.is_logarithmic) {
    scale_.high = std::pow(10.0, std::ceil(std::log10(high) - 1e-9));
    scale_.low = std::pow(10.0, std::max(std::floor(std::log10(samples.front().number)),
                                         std::log10(scale_.high) - kMostDecades));
    scale_.low = std::min(scale_.low, scale_.high / 10);
  } else {
    scale_.high = round_up(std::max(high, kLeastAngles));
  }
  if (options.range) scale_.low = (*options.range)[0], scale_.high = (*options.range)[1];
  if (samples.back().number > scale_.high) largest_ = samples.back().number;
}

void CellColours::choose_regions(const PictureOptions& options) {
  const SolvedSurface& surface = field_.surface();
  const FieldData& grid = field_.grid();
  if (!field_.is_on_tets() && surface.regions.empty() && !grid.regions.empty())
    throw Error(ErrorKind::kInput,
                "the field has no regions of its surface (earlier versions did not write them)",
                Remedy::kSolveAgain);
  std::vector<SolveReport::Region> listed = field_.report().regions;
  if (surface.regions.empty() || listed.empty())
    throw Error(ErrorKind::kUsage, "the field has only one region");
  for (const SolveReport::Region& region : listed)
    regions_.push_back(static_cast<std::int32_t>(region.region));
  if (!options.cut || field_.is_on_tets()) return;
  // Of solids that overlap, the smallest counts.
  std::stable_sort(listed.begin(), listed.end(),
                   [](const auto& a, const auto& b) { return a.volume < b.volume; });
  std::vector<std::int32_t> by_volume;
  for (const SolveReport::Region& region : listed)
    by_volume.push_back(static_cast<std::int32_t>(region.region));
  const auto axis = static_cast<std::size_t>(options.cut->axis);
  const Box box = grid.report.model.bounding_box;
  sections_.emplace(surface, by_volume, axis,
                    options.cut->position.value_or(0.5 * (box.low[axis] + box.high[axis])));
}

CellIndex CellColours::leaf_at(const Vector3& point) const {
  const auto cell = field_.grid().tree.root().locate(point);
  return cell ? finder_.containing(*cell) : kNoCell;
}

Colour CellColours::of_number(double number) const {
  return std::isfinite(number) ? map_.at(scale_.share_of(number)) : kPlainPart;
}

Colour CellColours::class_at(const MeshPoint& point) const {
  const CellIndex leaf = boundary_->beside(point.place, point.normal).leaf;
  if (leaf == kNoCell) return kPlainPart;
  return kClasses[static_cast<std::size_t>(field_.grid().constraints[leaf])].colour;
}

Colour CellColours::on_surface(const MeshPoint& point) const {
  switch (what_) {
    case PictureColour::kAlignment:
    case PictureColour::kEnergy:
      return of_number(numbers_->at({point.place, point.triangle, point.u, point.v}));
    case PictureColour::kConstraint:
      return class_at(point);
    case PictureColour::kRegion:
      return colour_of_region(regions_, field_.surface().regions[point.triangle]);
    case PictureColour::kFace:
      return colour_of_face(faces_[point.triangle]);
    case PictureColour::kNone:
      break;
  }
  return kPlainPart;
}

std::optional<Colour> CellColours::on_cut(const Vector3& point,
                                          const std::function<bool()>& is_enclosed) const {
  const CellIndex leaf = leaf_at(point);
  if (leaf == kNoCell || (field_.grid().on_boundary[leaf] != 0 && !is_enclosed())) return std::nullopt;
  if (what_ == PictureColour::kEnergy) return of_number(numbers_->energy_at(point));
  if (what_ == PictureColour::kRegion)
    return colour_of_region(regions_, sections_->at(point).value_or(field_.grid().regions[leaf]));
  return kPlainCut;
}

Colour CellColours::of_tet(std::uint32_t tet) const {
  if (what_ == PictureColour::kEnergy) return of_number(numbers_->energy_of_tet(tet));
  if (what_ == PictureColour::kRegion)
    return colour_of_region(regions_, field_.tets().solid.mesh.regions[tet]);
  return kPlainCut;
}

LegendBlock CellColours::class_legend() const {
  LegendBlock block{"Surface constraints"};
  std::array<bool, kCellConstraintCount> is_there{};
  for (const CellConstraint constraint : field_.grid().constraints)
    is_there[static_cast<std::size_t>(constraint)] = true;
  for (std::size_t i = 1; i < kClasses.size(); ++i)
    if (is_there[i]) block.signs.push_back({Sign::Shape::kBox, kClasses[i].colour, kClasses[i].text});
  return block;
}

std::optional<LegendBlock> CellColours::legend() const {
  switch (what_) {
    case PictureColour::kAlignment:
      return LegendBlock{"Surface to axis", "°", ColourBar{map_, scale_, largest_}};
    case PictureColour::kEnergy:
      return LegendBlock{"Energy density", unit_of_density(field_.report().model.unit),
                         ColourBar{map_, scale_, largest_}};
    case PictureColour::kConstraint:
      return class_legend();
    case PictureColour::kRegion:
      return region_legend(regions_);
    case PictureColour::kFace:
      return face_legend(faces_);
    case PictureColour::kNone:
      break;
  }
  return std::nullopt;
}

}  // namespace crossgrain

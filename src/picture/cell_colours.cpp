// SPDX-License-Identifier: Apache-2.0
#include "picture/cell_colours.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// Distance of sampled points from the surface, as a share of the smallest cell size: enough for single
/// precision, too little to leave the cell.
constexpr double kInwards = 0.02;

/// Share of the cells at the surface that is within the scale; numbers above it have the colour of its end.
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

}  // namespace

CellColours::CellColours(const FieldData& field, const PictureOptions& options)
    : field_(field),
      finder_(field.tree),
      what_(options.colour),
      map_(options.colour != PictureColour::kEnergy         ? ColourMap::heat()
           : options.background == PictureBackground::kDark ? ColourMap::dawn()
                                                            : ColourMap::dusk()) {
  if (what_ == PictureColour::kConstraint && field.constraints.empty())
    throw Error(ErrorKind::kInput,
                "the field has no array 'constraint_class' (earlier versions did not write it)",
                Remedy::kSolveAgain);
  int deepest = 0;
  for (const CellAddress leaf : field.tree.leaves()) deepest = std::max(deepest, leaf.depth());
  inwards_ = kInwards * field.tree.root().cell_size(deepest);
  choose_scale(options);
}

void CellColours::choose_scale(const PictureOptions& options) {
  if (what_ != PictureColour::kAlignment && what_ != PictureColour::kEnergy) return;
  scale_.is_logarithmic = what_ == PictureColour::kEnergy;
  const auto& numbers = scale_.is_logarithmic ? field_.energy_density : field_.alignment_deg;
  std::vector<float> shown;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (field_.on_boundary[i] != 0 && numbers[i] > 0 && std::isfinite(numbers[i]))
      shown.push_back(numbers[i]);
  if (shown.empty()) shown.push_back(1);
  const auto at =
      shown.begin() + static_cast<std::ptrdiff_t>(kWithinScale * static_cast<double>(shown.size() - 1));
  std::nth_element(shown.begin(), at, shown.end());
  const double most = *std::max_element(at, shown.end()), high = *at;
  if (scale_.is_logarithmic) {
    scale_.high = std::pow(10.0, std::ceil(std::log10(high) - 1e-9));
    const double least = *std::min_element(shown.begin(), shown.end());
    scale_.low =
        std::pow(10.0, std::max(std::floor(std::log10(least)), std::log10(scale_.high) - kMostDecades));
    scale_.low = std::min(scale_.low, scale_.high / 10);
  } else {
    scale_.high = round_up(std::max(high, kLeastAngles));
  }
  if (options.range) scale_.low = (*options.range)[0], scale_.high = (*options.range)[1];
  goes_on_ = most > scale_.high;
}

CellIndex CellColours::leaf_at(const Vector3& point) const {
  const auto cell = field_.tree.root().locate(point);
  return cell ? finder_.containing(*cell) : kNoCell;
}

Colour CellColours::of_leaf(CellIndex leaf) const {
  switch (what_) {
    case PictureColour::kAlignment:
      return map_.at(scale_.share_of(field_.alignment_deg[leaf]));
    case PictureColour::kEnergy:
      return map_.at(scale_.share_of(field_.energy_density[leaf]));
    case PictureColour::kConstraint:
      return kClasses[static_cast<std::size_t>(field_.constraints[leaf])].colour;
    case PictureColour::kNone:
      break;
  }
  return kPlainPart;
}

Colour CellColours::on_surface(const MeshPoint& point) const {
  // A surface between two layers of cells is in only one of them.
  CellIndex found = kNoCell;
  for (const double way : {-inwards_, inwards_}) {
    const CellIndex leaf = leaf_at(point.place + way * point.normal);
    if (leaf == kNoCell) continue;
    if (field_.on_boundary[leaf] != 0) return of_leaf(leaf);
    if (found == kNoCell) found = leaf;
  }
  return found == kNoCell ? kPlainPart : of_leaf(found);
}

std::optional<Colour> CellColours::on_cut(const Vector3& point, bool is_enclosed) const {
  const CellIndex leaf = leaf_at(point);
  if (leaf == kNoCell || (field_.on_boundary[leaf] != 0 && !is_enclosed)) return std::nullopt;
  return what_ == PictureColour::kEnergy ? of_leaf(leaf) : colour_of(0xe4e9ee);
}

std::optional<LegendBlock> CellColours::legend() const {
  switch (what_) {
    case PictureColour::kAlignment:
      return LegendBlock{"Surface to axis", "°", ColourBar{map_, scale_, goes_on_}};
    case PictureColour::kEnergy:
      return LegendBlock{"Energy density", unit_of_density(field_.report.model.unit),
                         ColourBar{map_, scale_, goes_on_}};
    case PictureColour::kConstraint: {
      LegendBlock block{"Surface constraints"};
      std::array<bool, kCellConstraintCount> is_there{};
      for (const CellConstraint constraint : field_.constraints)
        is_there[static_cast<std::size_t>(constraint)] = true;
      for (std::size_t i = 1; i < kClasses.size(); ++i)
        if (is_there[i]) block.signs.push_back({Sign::Shape::kBox, kClasses[i].colour, kClasses[i].text});
      return block;
    }
    case PictureColour::kNone:
      break;
  }
  return std::nullopt;
}

}  // namespace crossgrain

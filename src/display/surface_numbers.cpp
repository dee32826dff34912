// SPDX-License-Identifier: Apache-2.0
#include "display/surface_numbers.hpp"

#include <algorithm>
#include <iterator>

#include "display/grid_numbers.hpp"
#include "display/tet_numbers.hpp"

namespace crossgrain {

namespace {

/// Longest sides of pieces, and the number of cells with surface from which they are the longer.
constexpr double kUsualPieces = 1, kLongPieces = 2;
constexpr std::ptrdiff_t kManyCells = 150000;

double longest_pieces(const FieldData& field) {
  const auto inner = std::count(field.on_boundary.begin(), field.on_boundary.end(), std::uint8_t{0});
  return std::ssize(field.on_boundary) - inner < kManyCells ? kUsualPieces : kLongPieces;
}

}  // namespace

SurfaceNumbers::SurfaceNumbers(const ShownField& field, SurfaceNumber number, std::optional<double> longest) {
  if (field.is_on_tets())
    tets_ = std::make_unique<const TetNumbers>(field, number);
  else
    grid_ =
        std::make_unique<const GridNumbers>(field, number, longest ? *longest : longest_pieces(field.grid()));
}

SurfaceNumbers::SurfaceNumbers(const SurfaceNumbers& other, SurfaceNumber number)
    : grid_(std::make_unique<const GridNumbers>(*other.grid_, number)) {}

SurfaceNumbers::~SurfaceNumbers() = default;
SurfaceNumbers::SurfaceNumbers(SurfaceNumbers&&) noexcept = default;

double SurfaceNumbers::at(const SurfacePoint& point) const {
  return grid_ ? grid_->at(point) : tets_->at(point);
}

double SurfaceNumbers::energy_at(const Vector3& place) const {
  return grid_->energy_at(place);
}

double SurfaceNumbers::energy_of_tet(std::uint32_t tet) const {
  return tets_->energy_of_tet(tet);
}

std::vector<SurfaceNumbers::Sample> SurfaceNumbers::samples() const {
  return grid_ ? grid_->samples() : tets_->samples();
}

std::vector<float> SurfaceNumbers::at_vertices() const {
  return tets_->at_vertices();
}

std::vector<SurfaceNumbers::LeafCorners> SurfaceNumbers::at_leaf_corners(
    const CornersOfLeaves& corners) const {
  return grid_->at_leaf_corners(corners);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "grid/cell_constraints.hpp"

#include <algorithm>
#include <span>

#include "base/instruction_set.hpp"
#include "base/lanes.hpp"
#include "base/vector3.hpp"
#include "constraint/normal_form.hpp"

namespace crossgrain {
namespace {

/// Leaves with at least so many pieces, as near the root, have them added in lanes, at a fifth of the time.
constexpr std::size_t kManyPieces = 32;

/// Number of sums that pieces are added to in turn, whatever the number of lanes: so all processors get the
/// same bits.
constexpr std::size_t kSums = 8;

/// Sums of weighted C C^T + S S^T, b and weights (constraint/normal_form.hpp).
template <int D, class Real>
struct NormalSums {
  FormMatrix<D, Real> projections{};
  Coefficients<D, Real> zonals{};
  Real weight = 0.0;

  void add(const BasicVector3<Real>& normal, const Real& area) {
    const NormalBasis<D, Real> basis = normal_basis<D, Real>(normal);
    add_outer_product<D, Real>(projections, area, basis.cosine);
    add_outer_product<D, Real>(projections, area, basis.sine);
    if constexpr (D == 4)
      for (std::size_t k = 0; k < zonals.size(); ++k) zonals[k] += area * basis.zonal[k];
    weight += area;
  }
};

template <int D>
void add_sums(const NormalSums<D, double>& sums, QuadraticForm<D>& form) {
  add_scaled(form.matrix, -1.0, sums.projections);
  add_identity(form, sums.weight);
  if constexpr (D == 4) {
    add_scaled(form.linear, 1.0, sums.zonals);
    form.constant += sums.weight * kZonalShare;
  }
  form.weight += sums.weight;
}

template <int D>
void add_many_pieces(const GridLevel& level, const Solid& solid, CellIndex i, QuadraticForm<D>& form) {
  const std::span<const SurfacePiece> pieces = level.pieces_of(i);
  run_in_lanes([&]<int W>() {
    for (std::size_t first = 0; first < kSums; first += W) {
      NormalSums<D, Lanes<W>> sums;
      for (std::size_t k = first; k < pieces.size(); k += kSums) {
        BasicVector3<Lanes<W>> normals{0.0, 0.0, 1.0};
        Lanes<W> areas = 0.0;
        for (int lane = 0; lane < W && k + static_cast<std::size_t>(lane) < pieces.size(); ++lane) {
          const SurfacePiece& piece = pieces[k + static_cast<std::size_t>(lane)];
          set_lane(normals, lane, normal_of(level, solid, i, piece));
          areas.set(lane, piece.area);
        }
        sums.add(normals, areas);
      }
      for (int lane = 0; lane < W; ++lane)
        add_sums<D>({in_lane(sums.projections, lane), in_lane(sums.zonals, lane), sums.weight[lane]}, form);
    }
  });
}

/// Returns whether all normals are so close to one of them, n, that the class is kPlane by classify's default
/// tolerances; no eigenvalues are needed. On the two harmonics with |m| = 2 about n, the form of a normal at
/// an angle t to n is at most 4 sin^2 t. So two eigenvalues are at most the mean q of 4 sin^2 t. No
/// eigenvalue is above 1 and all seven add up to 5, so the third is at least 1 - 2 q, which is far from the
/// first two if q is at most 0.1.
bool is_surely_plane(const GridLevel& level, const Solid& solid, CellIndex i) {
  constexpr ClassificationTolerances kTolerances{};
  constexpr double kLargest = std::min(kTolerances.same_eigenvalue, kTolerances.fits);
  static_assert(1 - 2 * kLargest > kLargest + kTolerances.same_eigenvalue);
  if (level.guides.has(i)) return false;
  const auto pieces = level.pieces_of(i);
  const Vector3 first = normal_of(level, solid, i, pieces[0]);
  double sum = 0, area = 0;
  for (const SurfacePiece& piece : pieces) {
    const Vector3 off = cross(normal_of(level, solid, i, piece), first);
    sum += piece.area * 4 * dot(off, off);
    area += piece.area;
  }
  return sum < kLargest * area;
}

}  // namespace

template <int D>
QuadraticForm<D> cell_form(const GridLevel& level, const Solid& solid, CellIndex i) {
  QuadraticForm<D> form{};
  if (level.pieces_of(i).size() >= kManyPieces) {
    add_many_pieces(level, solid, i, form);
  } else {
    for (const SurfacePiece& piece : level.pieces_of(i))
      add_normal(form, normal_of(level, solid, i, piece), piece.area);
  }
  for (const LeafGuide& guide : level.guides.of(i)) add_normal(form, guide.unit_direction(), guide.area);
  return form;
}

template QuadraticForm<3> cell_form<3>(const GridLevel&, const Solid&, CellIndex);
template QuadraticForm<4> cell_form<4>(const GridLevel&, const Solid&, CellIndex);

bool is_same_normal(const Vector3& a, const Vector3& b) {
  const Vector3 off = cross(a, b);
  return dot(off, off) <= kSameNormal;
}

bool has_single_normal(const GridLevel& level, const Solid& solid, CellIndex i) {
  if (!level.is_constrained(i)) return false;
  const Vector3 first = first_normal(level, solid, i);
  const auto pieces = level.pieces_of(i);
  const auto guides = level.guides.of(i);
  return std::all_of(guides.begin(), guides.end(),
                     [&](const LeafGuide& guide) { return is_same_normal(guide.unit_direction(), first); }) &&
         std::all_of(pieces.begin(), pieces.end(), [&](const SurfacePiece& piece) {
           return is_same_normal(normal_of(level, solid, i, piece), first);
         });
}

Vector3 first_normal(const GridLevel& level, const Solid& solid, CellIndex i) {
  const auto pieces = level.pieces_of(i);
  return pieces.empty() ? level.guides.of(i)[0].unit_direction() : normal_of(level, solid, i, pieces[0]);
}

double constrained_area(const GridLevel& level, CellIndex i) {
  double area = 0;
  for (const SurfacePiece& piece : level.pieces_of(i)) area += piece.area;
  for (const LeafGuide& guide : level.guides.of(i)) area += guide.area;
  return area;
}

ConstraintClass constraint_class(const GridLevel& level, const Solid& solid, CellIndex i) {
  if (has_single_normal(level, solid, i) || is_surely_plane(level, solid, i)) return ConstraintClass::kPlane;
  return classify(cell_form<3>(level, solid, i));
}

}  // namespace crossgrain

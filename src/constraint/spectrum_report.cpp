// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <string>

#include "constraint/dense.hpp"
#include "constraint/normal_form.hpp"
#include "constraint/spectral_shift.hpp"
#include "constraint/spectrum.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/spectrum.hpp"
#include "harmonics/sphere_quadrature.hpp"

namespace crossgrain {

namespace {

// Largest difference between eigenvalues over weight that count as equal: the shift of degree 4 is accurate
// to 1e-7 in its hardest cells, and rounding is far below.
constexpr double kSameEigenvalue = 1e-6;

// An orthonormal basis of the span of orthonormal vectors that depends on the span only, and is close to the
// coordinate axes by a greedy choice: the projector's column with the largest diagonal, the first among
// equals, then again for the rest.
template <int D>
std::vector<std::vector<double>> aligned_basis(const std::vector<Coefficients<D>>& vectors) {
  DenseMatrix<D> projector = DenseMatrix<D>::Zero();
  for (const auto& v : vectors) projector += to_dense<D>(v) * to_dense<D>(v).transpose();
  std::vector<std::vector<double>> basis;
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    int pivot = 0;
    for (int k = 1; k < kCoefficientCount<D>; ++k) {
      if (projector(k, k) > projector(pivot, pivot) + 1e-9) pivot = k;
    }
    const DenseVector<D> v = projector.col(pivot) / std::sqrt(projector(pivot, pivot));
    projector -= v * v.transpose();
    basis.emplace_back(v.data(), v.data() + v.size());
  }
  return basis;
}

// The minimum of the shifted form: in degree 4 the least-norm point A^+ b first, then directions along A's
// null space.
template <int D>
std::vector<std::vector<double>> null_space_of(const QuadraticForm<D>& shifted_form) {
  const Spectrum<D> shifted_spectrum = spectrum(shifted_form);
  std::vector<Coefficients<D>> directions;
  Coefficients<D> point{};
  for (int i = 0; i < kCoefficientCount<D>; ++i) {
    const double eigenvalue = shifted_spectrum.eigenvalues[i];
    const auto& eigenvector = shifted_spectrum.eigenvectors[i];
    if (eigenvalue <= kSameEigenvalue * shifted_form.weight) {
      directions.push_back(eigenvector);
    } else {
      add_scaled(point, dot(linear_part(shifted_form), eigenvector) / eigenvalue, eigenvector);
    }
  }
  auto basis = aligned_basis<D>(directions);
  if constexpr (D == 4) basis.insert(basis.begin(), std::vector<double>(point.begin(), point.end()));
  return basis;
}

template <int D>
SpectrumReport report_of(const QuadraticForm<D>& form) {
  SpectrumReport report;
  report.degree = D;
  const DenseMatrix<D> matrix = dense_matrix(form);
  for (int row = 0; row < kCoefficientCount<D>; ++row) {
    const DenseVector<D> entries = matrix.row(row);
    report.matrix.emplace_back(entries.data(), entries.data() + entries.size());
  }
  const Coefficients<D> eigenvalues = spectrum(form).eigenvalues;
  report.eigenvalues.assign(eigenvalues.begin(), eigenvalues.end());
  report.null_space = null_space_of(shifted(form));
  const Coefficients<D> linear = linear_part(form);
  report.linear.assign(linear.begin(), linear.end());
  report.constant = constant_part(form);
  return report;
}

double largest_entry(const Vector3& v) {
  return std::max({std::fabs(v[0]), std::fabs(v[1]), std::fabs(v[2])});
}

// Divided by the largest entry first, since squares of entries near the ends of the range of doubles overflow
// or vanish.
Vector3 direction_of(const Vector3& v) {
  const double scale = largest_entry(v);
  return normalised(Vector3{v[0] / scale, v[1] / scale, v[2] / scale});
}

template <int D>
SpectrumReport report_of_normals(std::span<const WeightedNormal> normals) {
  QuadraticForm<D> form;
  for (const auto& [normal, weight] : normals) add_normal(form, direction_of(normal), weight);
  return report_of(form);
}

/// Limits of weights whose sums and squares stay far from the ends of double precision.
constexpr double kSmallestWeight = 1e-100, kLargestWeight = 1e100;

void check(std::span<const WeightedNormal> normals) {
  if (normals.empty()) throw Error(ErrorKind::kUsage, "no normals are given, but at least one is needed");
  for (std::size_t i = 0; i < normals.size(); ++i) {
    const double length = largest_entry(normals[i].normal), weight = normals[i].weight;
    const bool finite = std::all_of(normals[i].normal.begin(), normals[i].normal.end(),
                                    [](double x) { return std::isfinite(x); });
    const std::string place = "normal " + std::to_string(i + 1);
    if (!finite || !(length > 0)) {
      throw Error(ErrorKind::kUsage, {"", place, "the length is zero or not finite"});
    }
    if (!(weight >= kSmallestWeight && weight <= kLargestWeight)) {
      throw Error(ErrorKind::kUsage, {"", place, "the weight must be from 1e-100 to 1e100"});
    }
  }
}

std::vector<WeightedNormal> preset_normals(std::string_view name) {
  const Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  if (name == "plane") return {{z, 1}};
  if (name == "cube") return {{x, 1}, {y, 1}, {z, 1}};
  // The forms are polynomials in the normal, of degree 8 at most, so these sums are the integrals.
  std::vector<WeightedNormal> normals;
  if (name == "cylinder") {
    for (const auto& [direction, weight] : circle_quadrature<8>()) normals.push_back({direction, weight});
  } else if (name == "sphere") {
    for (const auto& [direction, weight] : sphere_quadrature<8>()) normals.push_back({direction, weight});
  } else {
    throw Error(ErrorKind::kUsage, {"", "preset '" + std::string(name) + "'",
                                    "is unknown; the presets are plane, cube, cylinder and sphere"});
  }
  return normals;
}

}  // namespace

SpectrumReport spectrum_of_normals(std::span<const WeightedNormal> normals, Degree degree) {
  check(normals);
  return degree == Degree::kThree ? report_of_normals<3>(normals) : report_of_normals<4>(normals);
}

SpectrumReport spectrum_of_preset(std::string_view name, Degree degree) {
  return spectrum_of_normals(preset_normals(name), degree);
}

}  // namespace crossgrain

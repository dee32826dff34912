// SPDX-License-Identifier: Apache-2.0
#include <utility>
#include <vector>

#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"

namespace crossgrain {
namespace {

std::vector<double> joined(const std::vector<std::vector<double>>& rows) {
  std::vector<double> numbers;
  for (const std::vector<double>& row : rows) numbers.insert(numbers.end(), row.begin(), row.end());
  return numbers;
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_spectrum::crossgrain_spectrum(SpectrumReport its_report)
    : report(std::move(its_report)), matrix(joined(report.matrix)), null_space(joined(report.null_space)) {
  form.degree = report.degree;
  form.size = report.eigenvalues.size();
  form.matrix = data_or_null(matrix);
  form.eigenvalues = data_or_null(report.eigenvalues);
  form.linear = data_or_null(report.linear);
  form.constant = report.constant;
  form.null_space_count = report.null_space.size();
  form.null_space = data_or_null(null_space);
}

crossgrain_status crossgrain_spectrum_of_normals(const double* normals, const double* weights, size_t count,
                                                 int degree, crossgrain_spectrum** out,
                                                 crossgrain_error** error) {
  return made(out, error, [&] {
    const std::vector<Vector3> its_normals = rows_of<Vector3>(normals, count, "normals");
    const auto its_weights = elements(weights, count, 1, "weights");
    std::vector<WeightedNormal> all(count);
    for (std::size_t i = 0; i < count; ++i) all[i] = {its_normals[i], its_weights[i]};
    return new crossgrain_spectrum(spectrum_of_normals(all, degree_of(degree)));
  });
}

crossgrain_status crossgrain_spectrum_of_preset(const char* name, int degree, crossgrain_spectrum** out,
                                                crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_spectrum(spectrum_of_preset(&given(name, "name"), degree_of(degree)));
  });
}

const crossgrain_form* crossgrain_spectrum_form(const crossgrain_spectrum* spectrum) {
  return &spectrum->form;
}

void crossgrain_spectrum_free(crossgrain_spectrum* spectrum) {
  delete spectrum;
}

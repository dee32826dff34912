// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "commands.hpp"
#include "crossgrain/samples.hpp"
#include "crossgrain/spectrum.hpp"
#include "crossgrain/writing.hpp"
#include "output.hpp"

namespace crossgrain::app {
namespace {

/// Numbers below this fraction of the largest of a block are rounding errors of the sums.
constexpr double kRounding = 1e-14;

double largest_of(const std::vector<double>& numbers) {
  double largest = 0;
  for (const double number : numbers) largest = std::max(largest, std::abs(number));
  return largest;
}

std::string row_of(const std::vector<double>& numbers, double largest) {
  std::string row;
  for (const double number : numbers) {
    const bool is_rounding = std::abs(number) < kRounding * largest;
    fmt::format_to(std::back_inserter(row), " {:>18.12g}", is_rounding ? 0.0 : number);
  }
  return row + "\n";
}

std::string rows_of(const std::vector<std::vector<double>>& rows) {
  double largest = 0;
  for (const auto& row : rows) largest = std::max(largest, largest_of(row));
  std::string text;
  for (const auto& row : rows) text += row_of(row, largest);
  return text;
}

std::string text_of(const SpectrumReport& report) {
  std::string text =
      fmt::format("matrix (degree {}, order m = {} ... {})\n", report.degree, -report.degree, report.degree);
  text += rows_of(report.matrix);
  if (report.degree == 4) {
    text += "linear\n" + row_of(report.linear, largest_of(report.linear));
    text += "constant\n" + row_of({report.constant}, 0);
  }
  text += "eigenvalues\n" + row_of(report.eigenvalues, largest_of(report.eigenvalues));
  text += report.degree == 4 ? "null space after the shift: a point, then directions\n"
                             : "null space after the shift\n";
  return text + rows_of(report.null_space);
}

}  // namespace

void run_spectrum(const SpectrumArguments& arguments) {
  const SpectrumReport report = arguments.preset.empty()
                                    ? spectrum_of_normals(read_normals(arguments.normals), arguments.degree)
                                    : spectrum_of_preset(arguments.preset, arguments.degree);
  print_result(arguments.json ? spectrum_json(report) : text_of(report));
}

}  // namespace crossgrain::app

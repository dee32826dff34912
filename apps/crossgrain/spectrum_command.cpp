// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <iterator>

#include "commands.hpp"
#include "crossgrain/io.hpp"
#include "crossgrain/spectrum.hpp"
#include "output.hpp"

namespace crossgrain::app {
namespace {

/// Rounding of the sums is far below twelve digits.
std::string row_of(const std::vector<double>& numbers) {
  std::string row;
  for (const double number : numbers) fmt::format_to(std::back_inserter(row), " {:>18.12f}", number);
  return row + "\n";
}

std::string rows_of(const std::vector<std::vector<double>>& rows) {
  std::string text;
  for (const auto& row : rows) text += row_of(row);
  return text;
}

std::string text_of(const SpectrumReport& report) {
  std::string text =
      fmt::format("matrix (degree {}, order m = {} ... {})\n", report.degree, -report.degree, report.degree);
  text += rows_of(report.matrix);
  if (report.degree == 4) {
    text += "linear\n" + row_of(report.linear);
    text += "constant\n" + row_of({report.constant});
  }
  text += "eigenvalues\n" + row_of(report.eigenvalues);
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

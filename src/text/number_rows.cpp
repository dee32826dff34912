// SPDX-License-Identifier: Apache-2.0
// Reads text files of points and of normals.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/samples.hpp"
#include "files/input_file.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

InputFile open(const std::filesystem::path& path) {
  return path == "-" ? InputFile::standard_input() : InputFile(path);
}

/// Range that a spectrum accepts (constraint/spectrum_report.cpp); beyond it, or below its inverse, sums
/// overflow or underflow.
constexpr double kLargestWeight = 1e100;

/// Names of the numbers in a row, for error messages; those from `needed` on are optional.
struct Columns {
  std::array<const char*, 4> names;
  std::size_t count;
  std::size_t needed;
};

/// Calls take(scanner, numbers, count) for every line that is not empty.
template <class Take>
void for_each_row(const InputFile& file, const Columns& columns, const Take& take) {
  TextScanner scanner(file, {.comments = true});
  do {
    std::array<double, 4> numbers{};
    std::size_t count = 0;
    for (std::string_view word = scanner.word(); !word.empty(); word = scanner.word()) {
      if (count == columns.count)
        scanner.fail(fmt::format("{} after the {} numbers of a line", in_quotes(word), columns.count),
                     Remedy::kCorrectLine);
      numbers[count] = scanner.number(word, columns.names[count]);
      ++count;
    }
    if (count == 0) continue;
    if (count < columns.needed)
      scanner.fail(
          fmt::format("{} is missing: a line needs {} numbers", columns.names[count], columns.needed),
          Remedy::kCorrectLine);
    take(scanner, numbers, count);
  } while (scanner.next_line());
}

}  // namespace

std::vector<Vector3> read_points(const std::filesystem::path& path) {
  const InputFile file = open(path);
  std::vector<Vector3> points;
  for_each_row(file, {{"x", "y", "z", ""}, 3, 3}, [&](const TextScanner&, const auto& row, std::size_t) {
    points.push_back({row[0], row[1], row[2]});
  });
  if (points.empty()) fail_input(file, {}, "has no points ('x y z' on each line)", Remedy::kNone);
  return points;
}

std::vector<WeightedNormal> read_normals(const std::filesystem::path& path) {
  const InputFile file = open(path);
  std::vector<WeightedNormal> normals;
  for_each_row(file, {{"nx", "ny", "nz", "the weight"}, 4, 3},
               [&](const TextScanner& scanner, const auto& row, std::size_t count) {
                 const WeightedNormal normal{{row[0], row[1], row[2]}, count == 4 ? row[3] : 1};
                 const double length = norm(normal.normal);
                 if (!(length > 0) || std::isinf(length))
                   scanner.fail("the normal's length is zero or too large", Remedy::kCorrectLine);
                 if (!(normal.weight > 0)) scanner.fail("the weight is not positive", Remedy::kCorrectLine);
                 if (normal.weight < 1 / kLargestWeight || normal.weight > kLargestWeight)
                   scanner.fail(
                       fmt::format("the weight is not between {} and {}", 1 / kLargestWeight, kLargestWeight),
                       Remedy::kCorrectLine);
                 normals.push_back(normal);
               });
  if (normals.empty())
    fail_input(file, {}, "has no normals ('nx ny nz' or 'nx ny nz weight' on each line)", Remedy::kNone);
  return normals;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Prints the table of docs/notes/hexahedra.md of factors of a map's equations: by the width of supernodes, by
// merging, by precision and by the shift of the diagonal.
//
//   factor_sweep CELLS FOLDER...      folders of `crossgrain solve MESH --prepare --repair`
#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/tet_frame_field.hpp"
#include "map/map_energy.hpp"
#include "map/nested_dissection.hpp"
#include "map/supernodal_factor.hpp"
#include "reduction/demanded_splits.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {
namespace {

using Clock = std::chrono::steady_clock;
using Sparse = Eigen::SparseMatrix<double>;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// The equations of the map with ones on the diagonal.
Sparse equations_of(const std::filesystem::path& folder, double cells) {
  const TetFrameField field = read_tet_field(folder).value();
  const TetDomainData& data = field.domain().data();
  const TetComplex complex(data.solid, data.features);
  const OwnedField split =
      split_for_map(MatchedField(complex, field.data().tet_frames, matchings_of(data.solid, field.data())));
  const CutSolid cut(*split.field);
  const MapUnknowns unknowns(cut);
  const Sparse matrix = MapEnergy(unknowns, longest_side(data.box) / cells).matrix();
  const Eigen::VectorXd scale = matrix.diagonal().cwiseSqrt().cwiseInverse();
  return scale.asDiagonal() * matrix * scale.asDiagonal();
}

/// In the range of a matrix that hardly is one of full rank, with smooth and rough parts.
Eigen::VectorXd right_of(const Sparse& matrix) {
  Eigen::VectorXd values(matrix.cols());
  for (Eigen::Index k = 0; k < values.size(); ++k)
    values[k] = 0.5 + 1.5 * std::sin(static_cast<double>(k * k));
  return matrix * values;
}

void print_row(const std::string& name, const std::string& what, double entries, double analysis,
               double factor, double solve, double residual) {
  fmt::print("| {} | {} | {:.1f} | {:.2f} | {:.2f} | {:.3f} | {:.1e} |\n", name, what, entries / 1e6,
             analysis, factor, solve, residual);
  std::fflush(stdout);
}

template <class Real>
void add_row(const std::string& name, const std::string& what, const Sparse& matrix,
             const std::vector<int>& places, double shift, const SupernodeOptions& options) {
  auto start = Clock::now();
  const Supernodes nodes(matrix, places, options);
  const double analysis = seconds_since(start);
  double entries = 0;
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    const double columns = nodes.columns(node);
    entries += columns * (columns + static_cast<double>(nodes.below(node).size()));
  }
  Sparse shifted = matrix;
  shifted.diagonal().array() += shift;
  start = Clock::now();
  const SupernodalFactor<Real> factor(shifted, nodes);
  const double factored = seconds_since(start);
  if (!factor.is_positive())
    return print_row(name, what + ", not positive", entries, analysis, factored, 0, 1);
  const Eigen::VectorXd right = right_of(matrix);
  start = Clock::now();
  const Eigen::VectorXd solution = factor.solve(right);
  const double solved = seconds_since(start);
  print_row(name, what, entries, analysis, factored, solved,
            (matrix * solution - right).norm() / right.norm());
}

void add_simplicial_row(const std::string& name, const Sparse& matrix, const std::vector<int>& places) {
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> order(matrix.cols());
  std::copy(places.begin(), places.end(), order.indices().data());
  Sparse ordered;
  ordered = matrix.twistedBy(order);
  Eigen::SimplicialLDLT<Sparse, Eigen::Lower, Eigen::NaturalOrdering<int>> ldlt;
  auto start = Clock::now();
  ldlt.analyzePattern(ordered);
  const double analysis = seconds_since(start);
  start = Clock::now();
  ldlt.factorize(ordered);
  const double factored = seconds_since(start);
  const Eigen::VectorXd right = right_of(ordered);
  start = Clock::now();
  const Eigen::VectorXd solution = ldlt.solve(right);
  print_row(name, "Eigen's SimplicialLDLT", static_cast<double>(ldlt.matrixL().nestedExpression().nonZeros()),
            analysis, factored, seconds_since(start), (ordered * solution - right).norm() / right.norm());
}

void add_rows(const std::filesystem::path& folder, double cells) {
  const std::string name = folder.filename().string();
  const Sparse matrix = equations_of(folder, cells);
  auto start = Clock::now();
  const std::vector<int> places = nested_dissection(matrix);
  fmt::print("{}: {} rows, {} entries, order in {:.2f} s\n", name, matrix.cols(), matrix.nonZeros(),
             seconds_since(start));
  constexpr double kShift = 1e-6;
  for (const int columns : {32, 64, 128, 256, 512, 1024, 4096}) {
    SupernodeOptions options;
    options.most_columns = columns;
    add_row<float>(name, fmt::format("at most {} columns", columns), matrix, places, kShift, options);
  }
  for (const double share : {0.0, 0.5, 1.0, 2.0, 4.0}) {
    SupernodeOptions options;
    for (auto& limit : options.merging) limit.zeros = std::min(1.0, share * limit.zeros);
    add_row<float>(name, fmt::format("{} of the zeros", share), matrix, places, kShift, options);
  }
  for (const double shift : {0.0, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4})
    add_row<float>(name, fmt::format("shift {:g}", shift), matrix, places, shift, {});
  add_row<double>(name, "double precision", matrix, places, 1e-12, {});
  add_simplicial_row(name, matrix, places);
}

}  // namespace
}  // namespace crossgrain

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: factor_sweep CELLS FOLDER...\n", stderr);
    return 2;
  }
  const double cells = std::atof(argv[1]);
  if (!(cells > 0)) {
    std::fputs("factor_sweep: CELLS is a positive number\n", stderr);
    return 2;
  }
  fmt::print(
      "| mesh | factor | million entries | s, entries | s, factor | s, solution | residual |\n"
      "|---|---|---|---|---|---|---|\n");
  for (int k = 2; k < argc; ++k) crossgrain::add_rows(argv[k], cells);
}

// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <utility>

#include "crossgrain/hex_fit.hpp"
#include "results/field_file.hpp"
#include "results/result_files.hpp"
#include "results/solve_id.hpp"

namespace crossgrain {

SolveReport write_fitted(const FittedHexahedra& fitted, const std::filesystem::path& folder,
                         const Monitor& monitor, const OutputOptions& options) {
  OutputOptions of_mesh;
  of_mesh.hexahedra = std::shared_ptr<const HexMesh>(std::shared_ptr<void>(), &fitted.mesh);
  of_mesh.inverted_hexahedra = options.inverted_hexahedra;
  of_mesh.companion = options.companion;
  of_mesh.foreign_files = options.foreign_files;
  of_mesh.reservation = options.reservation;
  const auto remove_field = [](OutputFolder& output, SolveReport& report) {
    for (const char* name : {kCellsFile, kPiecesFile, kSingularityFile, kSurfaceFile})
      output.remove_at_commit(name);
    remove_tet_files(output, report);
  };
  return write_result(fitted.report, folder, monitor, of_mesh, solve_id(of_mesh), remove_field);
}

}  // namespace crossgrain

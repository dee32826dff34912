// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "mesh_files/hex/hex_reader.hpp"
#include "results/one_solve.hpp"
#include "results/report_file.hpp"
#include "results/result_files.hpp"

namespace crossgrain {
namespace {

HexMesh read_from_folder(const std::filesystem::path& folder) {
  std::filesystem::path path = folder / kHexahedraFile;
  if (!may_exist(path)) path = folder / kPartialHexahedraFile;
  if (!may_exist(path))
    throw Error(ErrorKind::kInput, {folder.string(), "", "has no hexahedra", Remedy::kMakeHexahedra});
  HexMesh mesh = read_hexahedra_file(path);
  mesh.unit = read_report(folder / kReportFile).model.unit;
  return mesh;
}

}  // namespace

HexMesh read_hexahedra(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return read_hexahedra_file(path);
  return read_one_solve(path, [&] { return read_from_folder(path); });
}

}  // namespace crossgrain

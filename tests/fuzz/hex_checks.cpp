// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/result_folder.hpp"
#include "crossgrain/writing.hpp"
#include "fuzz/input_folder.hpp"
#include "fuzz/mesh_promises.hpp"
#include "fuzz/reader_checks.hpp"

namespace crossgrain {
namespace {

bool check_hexahedra(const char* name, std::string_view bytes) {
  const auto path = as_file(name, bytes);
  HexMesh mesh;
  if (!succeeds([&] { mesh = read_hexahedra(path); })) return false;
  require(!mesh.hexahedra.empty(), "a mesh without hexahedra");
  require_finite(mesh.vertices);
  for (const auto& hexahedron : mesh.hexahedra) require_in_range(hexahedron, mesh.vertices.size());
  for (const HexMesh::Face& face : mesh.boundary) require_in_range(face.vertices, mesh.vertices.size());
  for (const Warning& warning : mesh.warnings) require_one_line(sentence_of(warning));
  // Whatever is no mesh is refused here.
  write_hexahedra(mesh, as_file("again.vtu", ""));
  return true;
}

}  // namespace

bool check_hex_medit(std::string_view bytes) {
  return check_hexahedra("input.mesh", bytes);
}
bool check_hex_gmsh(std::string_view bytes) {
  return check_hexahedra("input.msh", bytes);
}
bool check_hex_vtk(std::string_view bytes) {
  return check_hexahedra("input.vtk", bytes);
}
bool check_abaqus(std::string_view bytes) {
  return check_hexahedra("input.inp", bytes);
}

}  // namespace crossgrain

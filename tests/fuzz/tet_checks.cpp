// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/reading.hpp"
#include "crossgrain/tet_domain.hpp"
#include "fuzz/input_folder.hpp"
#include "fuzz/mesh_promises.hpp"
#include "fuzz/reader_checks.hpp"

namespace crossgrain {
namespace {

bool check_tets(const char* name, std::string_view bytes) {
  const auto path = as_file(name, bytes);
  TetMesh mesh;
  if (!succeeds([&] { mesh = read_tets(path); })) return false;
  require_tets(mesh);
  succeeds([&] {
    const TetDomain domain(std::move(mesh));
    require_tets(domain.mesh());
    require_triangles(domain.boundary());
    require(domain.typical_edge_length() > 0, "tets of no size");
  });
  return true;
}

}  // namespace

bool check_medit(std::string_view bytes) {
  return check_tets("input.mesh", bytes);
}
bool check_medit_binary(std::string_view bytes) {
  return check_tets("input.meshb", bytes);
}
bool check_gmsh(std::string_view bytes) {
  return check_tets("input.msh", bytes);
}
bool check_vtk(std::string_view bytes) {
  return check_tets("input.vtk", bytes);
}
bool check_vtu(std::string_view bytes) {
  return check_tets("input.vtu", bytes);
}

}  // namespace crossgrain

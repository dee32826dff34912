// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <vector>

#include "crossgrain/reading.hpp"
#include "fuzz/input_folder.hpp"
#include "fuzz/mesh_promises.hpp"
#include "fuzz/reader_checks.hpp"
#include "surface/surface.hpp"
#include "surface/topology.hpp"

namespace crossgrain {
namespace {

/// What read_surface says of its answer.
void require_surface(const TriangleMesh& mesh) {
  require(!mesh.triangles.empty(), "a surface without triangles");
  require_triangles(mesh);
  std::vector<bool> used(mesh.vertices.size());
  for (const auto& triangle : mesh.triangles)
    for (const std::uint32_t corner : triangle) used[corner] = true;
  require(std::ranges::count(used, false) == 0, "a vertex that no triangle uses");
  std::vector<Vector3> sorted = mesh.vertices;
  std::ranges::sort(sorted);
  require(std::ranges::adjacent_find(sorted) == sorted.end(), "two vertices at one place");
  for (const Warning& warning : mesh.warnings) require_one_line(sentence_of(warning));
}

bool check_surface(const char* name, std::string_view bytes) {
  const auto path = as_file(name, bytes);
  TriangleMesh mesh;
  if (!succeeds([&] { mesh = read_surface(path); })) return false;
  require_surface(mesh);
  analyse_topology(mesh);
  succeeds([&] {
    const Surface surface = prepare_surface(mesh);
    require(surface.size() > 0 && surface.size() + surface.degenerate_triangles == mesh.triangles.size(),
            "triangles lost");
    for (std::size_t i = 0; i < surface.size(); ++i)
      require(surface.areas[i] > 0 && std::isfinite(surface.areas[i]), "a triangle of no or infinite area");
  });
  return true;
}

}  // namespace

bool check_stl(std::string_view bytes) {
  return check_surface("input.stl", bytes);
}
bool check_obj(std::string_view bytes) {
  return check_surface("input.obj", bytes);
}
bool check_ply(std::string_view bytes) {
  return check_surface("input.ply", bytes);
}
bool check_off(std::string_view bytes) {
  return check_surface("input.off", bytes);
}

}  // namespace crossgrain

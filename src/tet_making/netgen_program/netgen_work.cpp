// SPDX-License-Identifier: Apache-2.0
#include "tet_making/netgen_program/netgen_work.hpp"

#include <fstream>
#include <numbers>
#include <sstream>

#include "tet_making/netgen_program/netgen_library.hpp"
#include "tet_making/netgen_program/vol_file.hpp"

namespace crossgrain {
namespace {

std::string content_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

nglib::Ng_Meshing_Parameters parameters_for(const NetgenRequest& request) {
  nglib::Ng_Meshing_Parameters parameters;
  parameters.maxh = request.sizes.size;
  parameters.minh = request.sizes.smallest_share * request.sizes.size;
  parameters.grading = kGradation;
  // Netgen counts elements per radius of curvature, and may leave short edges whole.
  parameters.elementspercurve = request.sizes.edges_per_circle / (2 * std::numbers::pi);
  parameters.elementsperedge = 1;
  return parameters;
}

void require(nglib::Ng_Result result, const char* fault) {
  if (result != nglib::NG_OK) throw NetgenFault{fault};
}

void add_vertices(nglib::Ng_Mesh* from, TetMesh& mesh) {
  for (int number = 1; number <= nglib::Ng_GetNP(from); ++number) {
    Vector3& vertex = mesh.vertices.emplace_back();
    nglib::Ng_GetPoint(from, number, vertex.data());
  }
}

TetMesh filled(const NetgenRequest& request) {
  const std::optional<NetgenSurface> surface =
      netgen_surface_in(content_of(request.folder + "/" + kNetgenSurface));
  if (!surface) throw NetgenFault{"the triangles for Netgen are damaged"};
  const NetgenMesh mesh(nglib::Ng_NewMesh());
  for (Vector3 vertex : surface->vertices) nglib::Ng_AddPoint(mesh.get(), vertex.data());
  for (const auto& [a, b, c] : surface->triangles) {
    int numbers[] = {static_cast<int>(a) + 1, static_cast<int>(b) + 1, static_cast<int>(c) + 1};
    nglib::Ng_AddSurfaceElement(mesh.get(), nglib::NG_TRIG, numbers);
  }
  nglib::Ng_Meshing_Parameters parameters = parameters_for(request);
  parameters.minh = 0;
  require(nglib::Ng_GenerateVolumeMesh(mesh.get(), &parameters), "Netgen cannot fill the surface with tets");
  TetMesh result;
  add_vertices(mesh.get(), result);
  for (int number = 1; number <= nglib::Ng_GetNE(mesh.get()); ++number) {
    int corners[NG_VOLUME_ELEMENT_MAXPOINTS];
    if (nglib::Ng_GetVolumeElement(mesh.get(), number, corners) != nglib::NG_TET)
      throw NetgenFault{"Netgen makes elements that are no tets"};
    auto& tet = result.tets.emplace_back();
    for (std::size_t k = 0; k < 4; ++k) tet[k] = static_cast<std::uint32_t>(corners[k] - 1);
  }
  return result;
}

TetMesh cut(const NetgenRequest& request) {
  using namespace nglib;
  Ng_OCC_Geometry* const geometry = Ng_OCC_Load_BREP((request.folder + "/" + kNetgenSolids).c_str());
  if (geometry == nullptr) throw NetgenFault{"Netgen cannot read the solids"};
  const NetgenMesh mesh(Ng_NewMesh());
  Ng_Meshing_Parameters parameters = parameters_for(request);
  parameters.Transfer_Parameters();
  require(Ng_OCC_SetLocalMeshSize(geometry, mesh.get(), &parameters),
          "Netgen cannot find sizes for the faces");
  require(Ng_OCC_GenerateEdgeMesh(geometry, mesh.get(), &parameters), "Netgen cannot mesh the edges");
  require(Ng_OCC_GenerateSurfaceMesh(geometry, mesh.get(), &parameters), "Netgen cannot mesh the faces");
  require(Ng_GenerateVolumeMesh(mesh.get(), &parameters), "Netgen cannot fill the faces with tets");
  // Of triangles and edges only its files have the numbers.
  const std::string path = request.folder + "/" + kNetgenMesh;
  Ng_SaveMesh(mesh.get(), path.c_str());
  std::ifstream file(path);
  std::optional<TetMesh> result = tets_of_vol_file(file);
  if (!result) throw NetgenFault{"Netgen wrote no complete mesh"};
  return *std::move(result);
}

}  // namespace

TetMesh netgen_tets_for(const NetgenRequest& request) {
  nglib::Ng_Init();
  return request.work == NetgenWork::kFill ? filled(request) : cut(request);
}

}  // namespace crossgrain

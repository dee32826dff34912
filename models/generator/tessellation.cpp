// SPDX-License-Identifier: Apache-2.0
#include "tessellation.hpp"

#include <BRepCheck_Analyzer.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRep_Tool.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

namespace crossgrain::models {
namespace {

Corner to_corner(const gp_Pnt& point) {
  // Adding zero turns -0 into 0, which differs from it in its bits.
  return {static_cast<float>(point.X()) + 0.0F, static_cast<float>(point.Y()) + 0.0F,
          static_cast<float>(point.Z()) + 0.0F};
}

void append_face(const TopoDS_Face& face, std::vector<Triangle>& triangles) {
  TopLoc_Location location;
  const Handle(Poly_Triangulation) mesh = BRep_Tool::Triangulation(face, location);
  if (mesh.IsNull()) throw std::runtime_error("a face has no triangles");
  const auto corner = [&](int node) { return to_corner(mesh->Node(node).Transformed(location)); };
  for (int i = 1; i <= mesh->NbTriangles(); ++i) {
    int a, b, c;
    mesh->Triangle(i).Get(a, b, c);
    if (face.Orientation() == TopAbs_REVERSED) std::swap(b, c);
    const Triangle triangle{corner(a), corner(b), corner(c)};
    // At the tip of a cone or the pole of a sphere an edge of the face is one point.
    if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
      triangles.push_back(triangle);
  }
}

/// Neighbouring faces share the points of their common edge, to the bit: each edge must have its opposite.
bool is_closed(const std::vector<Triangle>& triangles) {
  std::map<std::pair<Corner, Corner>, int> uses;
  for (const Triangle& triangle : triangles) {
    for (int i = 0; i < 3; ++i) {
      ++uses[{triangle[i], triangle[(i + 1) % 3]}];
      --uses[{triangle[(i + 1) % 3], triangle[i]}];
    }
  }
  for (const auto& [edge, count] : uses) {
    if (count != 0) return false;
  }
  return true;
}

Corner unit_normal(const Triangle& t) {
  std::array<double, 3> u, v;
  for (int i = 0; i < 3; ++i) {
    u[i] = static_cast<double>(t[1][i]) - t[0][i];
    v[i] = static_cast<double>(t[2][i]) - t[0][i];
  }
  const std::array<double, 3> n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                                u[0] * v[1] - u[1] * v[0]};
  const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
  if (length == 0) return {0, 0, 0};
  return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
          static_cast<float>(n[2] / length)};
}

}  // namespace

std::vector<Triangle> tessellate(const TopoDS_Shape& solid, const Deflection& deflection) {
  if (!BRepCheck_Analyzer(solid).IsValid()) throw std::runtime_error("the solid is not valid");
  const bool relative = false, in_parallel = false;
  BRepMesh_IncrementalMesh(solid, deflection.length_mm, relative, deflection.angle_rad, in_parallel);
  std::vector<Triangle> triangles;
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
    append_face(TopoDS::Face(faces.Current()), triangles);
  if (!is_closed(triangles)) throw std::runtime_error("the triangles do not close");
  return triangles;
}

void write_stl(const std::filesystem::path& path, const std::vector<Triangle>& triangles) {
  std::ofstream file(path, std::ios::binary);
  char header[80] = "Crossgrain model, millimetres";
  file.write(header, sizeof header);
  const auto count = static_cast<std::uint32_t>(triangles.size());
  file.write(reinterpret_cast<const char*>(&count), sizeof count);
  for (const Triangle& triangle : triangles) {
    const Corner normal = unit_normal(triangle);
    const std::uint16_t attribute = 0;
    file.write(reinterpret_cast<const char*>(normal.data()), sizeof normal);
    file.write(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
    file.write(reinterpret_cast<const char*>(&attribute), sizeof attribute);
  }
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

}  // namespace crossgrain::models

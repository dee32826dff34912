// SPDX-License-Identifier: Apache-2.0
// Meshes as Medit files, written by code of its own.
#pragma once

#include <fmt/format.h>

#include "mesh_files/made_tet_mesh.hpp"

namespace crossgrain {

inline MadeFile medit_text(const TetMesh& mesh) {
  std::string text = fmt::format("MeshVersionFormatted 2\nDimension 3\nVertices\n{}\n", mesh.vertices.size());
  for (const auto& [x, y, z] : mesh.vertices) text += fmt::format("{} {} {} 0\n", x, y, z);
  text += fmt::format("Edges\n{}\n", mesh.feature_edges.size());
  for (const auto& edge : mesh.feature_edges)
    text += fmt::format("{} {} {}\n", edge.vertices[0] + 1, edge.vertices[1] + 1, edge.tag);
  text += fmt::format("Triangles\n{}\n", mesh.feature_faces.size());
  for (const auto& face : mesh.feature_faces)
    text += fmt::format("{} {} {} {}\n", face.vertices[0] + 1, face.vertices[1] + 1, face.vertices[2] + 1,
                        face.tag);
  text += fmt::format("Tetrahedra\n{}\n", mesh.tets.size());
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    const auto& [a, b, c, d] = mesh.tets[t];
    text += fmt::format("{} {} {} {} {}\n", a + 1, b + 1, c + 1, d + 1, mesh.regions[t]);
  }
  return {"Medit text", ".mesh", text + "End\n"};
}

class MeditBinaryWriter {
 public:
  MeditBinaryWriter(int version, bool swapped) : version_(version), out_(swapped) {
    out_.put<std::int32_t>(1);
    out_.put<std::int32_t>(version);
    out_.put<std::int32_t>(3);  // Dimension
    put_place(out_.size() + place_bytes() + 4);
    out_.put<std::int32_t>(3);
  }

  /// `rows` of `columns` whole numbers, the last a reference number.
  void section(int keyword, std::size_t columns, const std::vector<std::int64_t>& numbers) {
    begin(keyword, numbers.size() / columns, numbers.size() * integer_bytes());
    for (const std::int64_t number : numbers) put_integer(number);
  }

  void vertices(const std::vector<Vector3>& vertices) {
    const std::size_t row_bytes = 3 * (version_ == 1 ? 4 : 8) + integer_bytes();
    begin(4, vertices.size(), vertices.size() * row_bytes);
    for (const Vector3& vertex : vertices) {
      for (const double x : vertex) {
        if (version_ == 1)
          out_.put(static_cast<float>(x));
        else
          out_.put(x);
      }
      put_integer(0);
    }
  }

  std::string finish() {
    out_.put<std::int32_t>(54);
    put_place(0);
    return out_.bytes();
  }

 private:
  std::size_t place_bytes() const { return version_ >= 3 ? 8 : 4; }
  std::size_t integer_bytes() const { return version_ == 4 ? 8 : 4; }

  void put_place(std::size_t place) {
    if (version_ >= 3)
      out_.put(static_cast<std::int64_t>(place));
    else
      out_.put(static_cast<std::int32_t>(place));
  }

  void put_integer(std::int64_t number) {
    if (version_ == 4)
      out_.put(number);
    else
      out_.put(static_cast<std::int32_t>(number));
  }

  void begin(int keyword, std::size_t rows, std::size_t bytes) {
    out_.put<std::int32_t>(keyword);
    put_place(out_.size() + place_bytes() + integer_bytes() + bytes);
    put_integer(static_cast<std::int64_t>(rows));
  }

  int version_;
  ByteWriter out_;
};

inline MadeFile medit_binary(const TetMesh& mesh, int version, bool swapped) {
  MeditBinaryWriter out(version, swapped);
  // Cells before vertices, which the format allows.
  std::vector<std::int64_t> edges, faces, tets;
  for (const auto& [vertices, tag, is_stated] : mesh.feature_edges) {
    for (const std::uint32_t v : vertices) edges.push_back(v + 1);
    edges.push_back(tag);
  }
  for (const auto& [vertices, tag] : mesh.feature_faces) {
    for (const std::uint32_t v : vertices) faces.push_back(v + 1);
    faces.push_back(tag);
  }
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) {
    for (const std::uint32_t v : mesh.tets[t]) tets.push_back(v + 1);
    tets.push_back(mesh.regions[t]);
  }
  out.section(8, 5, tets);
  out.vertices(mesh.vertices);
  out.section(1000, 1, {1, 2, 3});  // which nobody knows
  out.section(5, 3, edges);
  out.section(6, 4, faces);
  return {fmt::format("Medit binary {}{}", version, swapped ? " swapped" : ""), ".meshb", out.finish()};
}

inline std::vector<MadeFile> medit_files(const TetMesh& mesh) {
  std::vector<MadeFile> files{medit_text(mesh)};
  for (const int version : {1, 2, 3, 4})
    for (const bool swapped : {false, true}) files.push_back(medit_binary(mesh, version, swapped));
  return files;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Writes tets with their tags, for other programs and for `read_tets`.
#include <fmt/format.h>

#include <array>
#include <string_view>
#include <vector>

#include "crossgrain/writing.hpp"
#include "files/file_mark.hpp"
#include "mesh_files/medit_sections.hpp"
#include "mesh_files/mesh_formats.hpp"
#include "text/text_lines.hpp"

namespace crossgrain {
namespace {

constexpr std::string_view kContent = "tets with numbers of regions, faces and edges";

std::int32_t region_of(const TetMesh& mesh, std::size_t tet) {
  return mesh.regions.empty() ? 0 : mesh.regions[tet];
}

void write_ridges(OutputFile& file, const TetMesh& mesh, const Monitor& monitor) {
  std::vector<std::size_t> ridges;
  for (std::size_t k = 0; k < mesh.feature_edges.size(); ++k)
    if (mesh.feature_edges[k].is_stated) ridges.push_back(k + 1);
  if (ridges.empty()) return;
  file.write(fmt::format("\nRidges\n{}\n", ridges.size()));
  const auto put = [&](std::size_t k, char* out) {
    return put_integer(out, static_cast<std::int64_t>(ridges[k]), '\n');
  };
  write_text_lines(file, ridges.size(), kIntegerBytes, put, monitor);
}

template <class Feature>
void write_features(OutputFile& file, std::string_view keyword, const std::vector<Feature>& features,
                    const Monitor& monitor) {
  if (features.empty()) return;
  write_medit_elements(
      file, keyword, features.size(), [&](std::size_t k) { return features[k].vertices; },
      [&](std::size_t k) { return features[k].tag; }, monitor);
}

void write_medit(OutputFile& file, const TetMesh& mesh, const Monitor& monitor) {
  begin_medit(file, kContent, mesh.vertices, monitor);
  write_features(file, "Edges", mesh.feature_edges, monitor);
  write_ridges(file, mesh, monitor);
  write_features(file, "Triangles", mesh.feature_faces, monitor);
  write_medit_elements(
      file, "Tetrahedra", mesh.tets.size(), [&](std::size_t k) { return mesh.tets[k]; },
      [&](std::size_t k) { return region_of(mesh, k); }, monitor);
  file.write(kMeditEnd);
}

/// An element of MSH 2.2: number, type, two tags (physical group and entity), vertices.
template <std::size_t N>
char* put_msh(char* out, std::size_t number, int type, const std::array<std::uint32_t, N>& vertices,
              std::int32_t tag, bool is_group) {
  out = fmt::format_to(out, "{} {} 2 {} {}", number, type, is_group ? tag : 0, tag);
  for (const std::uint32_t vertex : vertices) out = fmt::format_to(out, " {}", std::uint64_t{vertex} + 1);
  *out++ = '\n';
  return out;
}

/// Stated edges, and all triangles and tets, are in physical groups, since readers take entities for any
/// curve of a model.
void write_msh(OutputFile& file, const TetMesh& mesh, const Monitor& monitor) {
  constexpr int kLine = 1, kTriangle = 2, kTet = 4;
  constexpr std::size_t kElementBytes = 9 * kIntegerBytes;
  file.write(fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n{}{}\n$EndComments\n$Nodes\n{}\n",
                         kTextMark, kContent, mesh.vertices.size()));
  const auto put_vertex = [&](std::size_t v, char* out) {
    const auto& [x, y, z] = mesh.vertices[v];
    out = put_integer(out, static_cast<std::int64_t>(v + 1), ' ');
    return put_shortest(put_shortest(put_shortest(out, x, ' '), y, ' '), z, '\n');
  };
  write_text_lines(file, mesh.vertices.size(), 3 * kNumberBytes + kIntegerBytes, put_vertex, monitor);
  const std::size_t edges = mesh.feature_edges.size(), faces = mesh.feature_faces.size();
  file.write(fmt::format("$EndNodes\n$Elements\n{}\n", edges + faces + mesh.tets.size()));
  const auto put_edge = [&](std::size_t k, char* out) {
    const TetMesh::Edge& edge = mesh.feature_edges[k];
    return put_msh(out, k + 1, kLine, edge.vertices, edge.tag, edge.is_stated);
  };
  const auto put_face = [&](std::size_t k, char* out) {
    const TetMesh::Face& face = mesh.feature_faces[k];
    return put_msh(out, edges + k + 1, kTriangle, face.vertices, face.tag, true);
  };
  const auto put_tet = [&](std::size_t k, char* out) {
    return put_msh(out, edges + faces + k + 1, kTet, mesh.tets[k], region_of(mesh, k), true);
  };
  write_text_lines(file, edges, kElementBytes, put_edge, monitor);
  write_text_lines(file, faces, kElementBytes, put_face, monitor);
  write_text_lines(file, mesh.tets.size(), kElementBytes, put_tet, monitor);
  file.write("$EndElements\n");
}

constexpr std::array kWrittenTetFormats{MeshFormat<TetMesh>{".mesh", write_medit, SealForm::kText},
                                        MeshFormat<TetMesh>{".msh", write_msh}};

const MeshFormat<TetMesh>& tet_format_of(const std::filesystem::path& path) {
  return format_of<TetMesh>(path, kWrittenTetFormats, "a tet mesh");
}

}  // namespace

void write_tets(const TetMesh& mesh, const std::filesystem::path& path, const Monitor& monitor) {
  write_mesh(tet_format_of(path), mesh, path, monitor);
}

void check_tets_output(const std::filesystem::path& path) {
  tet_format_of(path);
  OutputFile{path};
}

}  // namespace crossgrain

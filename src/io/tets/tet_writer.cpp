// SPDX-License-Identifier: Apache-2.0
// Writes tets with their tags, for other programs and for `read_tets`.
#include <fmt/format.h>

#include <array>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/io.hpp"
#include "files/file_mark.hpp"
#include "files/output_file.hpp"
#include "io/text/text_scanner.hpp"

namespace crossgrain {
namespace {

constexpr std::string_view kContent = "tets with numbers of regions, faces and edges";

/// Rows between two looks at the monitor.
constexpr std::size_t kRowsAtOnce = 1 << 16;

/// Writes put(text, k) for each k below `count`.
void write_rows(OutputFile& file, std::size_t count, const Monitor& monitor,
                const std::function<void(fmt::memory_buffer& text, std::size_t k)>& put) {
  fmt::memory_buffer text;
  for (std::size_t k = 0; k < count; ++k) {
    put(text, k);
    if (k + 1 < count && text.size() < kRowsAtOnce) continue;
    monitor.check();
    file.write({text.data(), text.size()});
    text.clear();
  }
}

std::int32_t region_of(const TetMesh& mesh, std::size_t tet) {
  return mesh.regions.empty() ? 0 : mesh.regions[tet];
}

/// Vertices of elements, from 1, and a number after them.
template <std::size_t N>
void put_medit(fmt::memory_buffer& text, const std::array<std::uint32_t, N>& vertices, std::int32_t tag) {
  const auto out = std::back_inserter(text);
  for (const std::uint32_t vertex : vertices) fmt::format_to(out, "{} ", std::uint64_t{vertex} + 1);
  fmt::format_to(out, "{}\n", tag);
}

void write_ridges(OutputFile& file, const TetMesh& mesh, const Monitor& monitor) {
  std::vector<std::size_t> ridges;
  for (std::size_t k = 0; k < mesh.feature_edges.size(); ++k)
    if (mesh.feature_edges[k].is_stated) ridges.push_back(k + 1);
  if (ridges.empty()) return;
  file.write(fmt::format("\nRidges\n{}\n", ridges.size()));
  write_rows(file, ridges.size(), monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    fmt::format_to(std::back_inserter(text), "{}\n", ridges[k]);
  });
}

void write_medit(OutputFile& file, const TetMesh& mesh, const Monitor& monitor) {
  file.write(fmt::format("MeshVersionFormatted 2\n{}{}\n\nDimension 3\n\nVertices\n{}\n", kTextMark, kContent,
                         mesh.vertices.size()));
  write_rows(file, mesh.vertices.size(), monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    const auto& [x, y, z] = mesh.vertices[k];
    fmt::format_to(std::back_inserter(text), "{} {} {} 0\n", x, y, z);
  });
  if (!mesh.feature_edges.empty()) file.write(fmt::format("\nEdges\n{}\n", mesh.feature_edges.size()));
  write_rows(file, mesh.feature_edges.size(), monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    put_medit(text, mesh.feature_edges[k].vertices, mesh.feature_edges[k].tag);
  });
  write_ridges(file, mesh, monitor);
  if (!mesh.feature_faces.empty()) file.write(fmt::format("\nTriangles\n{}\n", mesh.feature_faces.size()));
  write_rows(file, mesh.feature_faces.size(), monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    put_medit(text, mesh.feature_faces[k].vertices, mesh.feature_faces[k].tag);
  });
  file.write(fmt::format("\nTetrahedra\n{}\n", mesh.tets.size()));
  write_rows(file, mesh.tets.size(), monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    put_medit(text, mesh.tets[k], region_of(mesh, k));
  });
  file.write("\nEnd\n");
}

/// An element of MSH 2.2: number, type, two tags (physical group and entity), vertices.
template <std::size_t N>
void put_msh(fmt::memory_buffer& text, std::size_t number, int type,
             const std::array<std::uint32_t, N>& vertices, std::int32_t tag, bool is_group) {
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "{} {} 2 {} {}", number, type, is_group ? tag : 0, tag);
  for (const std::uint32_t vertex : vertices) fmt::format_to(out, " {}", std::uint64_t{vertex} + 1);
  text.push_back('\n');
}

/// Stated edges, and all triangles and tets, are in physical groups, since readers take entities for any
/// curve of a model.
void write_msh(OutputFile& file, const TetMesh& mesh, const Monitor& monitor) {
  constexpr int kLine = 1, kTriangle = 2, kTet = 4;
  file.write(fmt::format("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Comments\n{}{}\n$EndComments\n$Nodes\n{}\n",
                         kTextMark, kContent, mesh.vertices.size()));
  write_rows(file, mesh.vertices.size(), monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    const auto& [x, y, z] = mesh.vertices[k];
    fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", k + 1, x, y, z);
  });
  const std::size_t edges = mesh.feature_edges.size(), faces = mesh.feature_faces.size();
  file.write(fmt::format("$EndNodes\n$Elements\n{}\n", edges + faces + mesh.tets.size()));
  write_rows(file, edges, monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    const TetMesh::Edge& edge = mesh.feature_edges[k];
    put_msh(text, k + 1, kLine, edge.vertices, edge.tag, edge.is_stated);
  });
  write_rows(file, faces, monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    put_msh(text, edges + k + 1, kTriangle, mesh.feature_faces[k].vertices, mesh.feature_faces[k].tag, true);
  });
  write_rows(file, mesh.tets.size(), monitor, [&](fmt::memory_buffer& text, std::size_t k) {
    put_msh(text, edges + faces + k + 1, kTet, mesh.tets[k], region_of(mesh, k), true);
  });
  file.write("$EndElements\n");
}

struct Format {
  std::string_view extension;
  void (*write)(OutputFile& file, const TetMesh& mesh, const Monitor& monitor);
};
constexpr std::array kFormats{Format{".mesh", write_medit}, Format{".msh", write_msh}};

const Format& format_of(const std::filesystem::path& path) {
  for (const Format& format : kFormats)
    if (equals_ignoring_case(format.extension, path.extension().string())) return format;
  throw Error(
      ErrorKind::kUsage,
      {path.string(), "", "is no name of a tet mesh that can be written; let it end in .mesh or .msh"});
}

}  // namespace

void write_tets(const TetMesh& mesh, const std::filesystem::path& path, const Monitor& monitor) {
  const Format& format = format_of(path);
  OutputFile file(path);
  format.write(file, mesh, monitor);
  file.commit();
}

void check_tets_output(const std::filesystem::path& path) {
  format_of(path);
  OutputFile{path};
}

}  // namespace crossgrain

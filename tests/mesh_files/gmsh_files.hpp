// SPDX-License-Identifier: Apache-2.0
// Meshes as Gmsh files, written by code of its own.
#pragma once

#include <fmt/format.h>

#include <span>

#include "mesh_files/made_tet_mesh.hpp"

namespace crossgrain {

/// How a Gmsh file is written.
struct GmshEncoding {
  bool binary = false;
  bool swapped = false;
  bool wide = true;  ///< counts of 64 bits, in binary of version 4.1

  /// Numbers of nodes are 1, 1 + gap, 1 + 2 gap and so on.
  std::int64_t gap = 1;

  /// Entities have tags of their own and belong to physical groups with the mesh's tags; without, the
  /// entities have those.
  bool physical = true;
};

/// A number each by its type, as text or bytes.
class GmshWriter {
 public:
  explicit GmshWriter(const GmshEncoding& encoding) : encoding_(encoding), out_(encoding.swapped) {}

  void line(std::string_view text) { out_.text(std::string(text) + "\n"); }

  void integer(std::int64_t value) {
    if (encoding_.binary)
      out_.put(static_cast<std::int32_t>(value));
    else
      out_.text(fmt::format("{} ", value));
  }

  void size(std::int64_t value) {
    if (encoding_.binary && encoding_.wide)
      out_.put(value);
    else
      integer(value);
  }

  void real(double value) {
    if (encoding_.binary)
      out_.put(value);
    else
      out_.text(fmt::format("{} ", value));
  }

  /// The end of a row of text.
  void end_row() {
    if (!encoding_.binary) out_.text("\n");
  }

  /// The end of a section.
  void end(std::string_view name) {
    if (encoding_.binary) out_.text("\n");
    line(fmt::format("$End{}", name));
  }

  void format(std::string_view version) {
    line("$MeshFormat");
    line(fmt::format("{} {} {}", version, encoding_.binary ? 1 : 0, encoding_.wide ? 8 : 4));
    if (encoding_.binary) {
      integer(1);
      out_.text("\n");
    }
    line("$EndMeshFormat");
  }

  const std::string& bytes() const { return out_.bytes(); }

 private:
  GmshEncoding encoding_;
  ByteWriter out_;
};

/// A row of elements, whatever their kind.
struct GmshRow {
  int dimension, type;
  std::int32_t tag;
  std::vector<std::uint32_t> nodes;
};

/// A point, then the edges, faces and tets, each in their order.
inline std::vector<GmshRow> gmsh_rows(const TetMesh& mesh) {
  std::vector<GmshRow> rows{{0, 15, 6, {0}}};
  for (const auto& [nodes, tag, is_stated] : mesh.feature_edges)
    rows.push_back({1, 1, tag, {nodes.begin(), nodes.end()}});
  for (const auto& [nodes, tag] : mesh.feature_faces)
    rows.push_back({2, 2, tag, {nodes.begin(), nodes.end()}});
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    rows.push_back({3, 4, mesh.regions[t], {mesh.tets[t].begin(), mesh.tets[t].end()}});
  return rows;
}

inline std::string what_of(const char* version, const GmshEncoding& encoding) {
  return fmt::format("Gmsh {}{}{}{} gap {}{}", version, encoding.binary ? " binary" : " text",
                     encoding.swapped ? " swapped" : "", encoding.wide ? "" : " narrow", encoding.gap,
                     encoding.physical ? "" : " entities");
}

inline std::int64_t gmsh_entity(const GmshEncoding& encoding, std::int32_t tag) {
  return encoding.physical ? tag + 100 : tag;
}

inline MadeFile gmsh_2(const TetMesh& mesh, const GmshEncoding& encoding) {
  GmshWriter out(encoding);
  const auto number = [&](std::size_t node) { return 1 + encoding.gap * static_cast<std::int64_t>(node); };
  out.format("2.2");
  out.line("$PhysicalNames\n1\n3 1 \"inside $End\"\n$EndPhysicalNames");
  out.line(fmt::format("$Nodes\n{}", mesh.vertices.size()));
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    out.integer(number(v));
    for (const double x : mesh.vertices[v]) out.real(x);
    out.end_row();
  }
  out.end("Nodes");
  const auto rows = gmsh_rows(mesh);
  out.line(fmt::format("$Elements\n{}", rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const GmshRow& row = rows[i];
    if (encoding.binary) {
      for (const int head : {row.type, 1, 3}) out.integer(head);
      out.integer(static_cast<std::int64_t>(i + 1));
    } else {
      out.integer(static_cast<std::int64_t>(i + 1));
      for (const int head : {row.type, 3}) out.integer(head);
    }
    out.integer(encoding.physical ? row.tag : 0);
    out.integer(gmsh_entity(encoding, row.tag));
    out.integer(1);  // a tag that nobody asks for
    for (const std::uint32_t node : row.nodes) out.integer(number(node));
    out.end_row();
  }
  out.end("Elements");
  return {what_of("2.2", encoding), ".msh", out.bytes()};
}

/// Rows that belong to one entity.
inline std::vector<std::span<const GmshRow>> gmsh_blocks(const std::vector<GmshRow>& rows) {
  std::vector<std::span<const GmshRow>> blocks;
  for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
    while (end < rows.size() && rows[end].type == rows[begin].type && rows[end].tag == rows[begin].tag) ++end;
    blocks.push_back(std::span(rows).subspan(begin, end - begin));
  }
  return blocks;
}

inline void write_gmsh_entities(const std::vector<std::span<const GmshRow>>& blocks,
                                const GmshEncoding& encoding, GmshWriter& out) {
  out.line("$Entities");
  for (int dimension = 0; dimension < 4; ++dimension)
    out.size(
        std::ranges::count_if(blocks, [&](const auto& block) { return block[0].dimension == dimension; }));
  out.end_row();
  for (const auto& block : blocks) {
    const int dimension = block[0].dimension;
    out.integer(gmsh_entity(encoding, block[0].tag));
    for (int i = 0; i < (dimension == 0 ? 3 : 6); ++i) out.real(0.5);
    // Negative where the entity is turned round; a second group counts for nothing.
    out.size(encoding.physical ? 2 : 0);
    if (encoding.physical) {
      out.integer(-block[0].tag);
      out.integer(1234);
    }
    if (dimension > 0) {
      out.size(2);
      out.integer(1);
      out.integer(-2);
    }
    out.end_row();
  }
  out.end("Entities");
}

/// In two blocks, the second with parameters.
inline void write_gmsh_nodes(const TetMesh& mesh, const GmshEncoding& encoding, GmshWriter& out) {
  const auto count = static_cast<std::int64_t>(mesh.vertices.size()), half = count / 2;
  const auto number = [&](std::int64_t node) { return 1 + encoding.gap * node; };
  out.line("$Nodes");
  for (const std::int64_t head : {std::int64_t{2}, count, number(0), number(count - 1)}) out.size(head);
  out.end_row();
  for (const bool second : {false, true}) {
    const std::int64_t begin = second ? half : 0, end = second ? count : half;
    out.integer(2);
    out.integer(1);
    out.integer(second ? 1 : 0);
    out.size(end - begin);
    out.end_row();
    for (std::int64_t v = begin; v < end; ++v) out.size(number(v));
    out.end_row();
    for (std::int64_t v = begin; v < end; ++v) {
      for (const double x : mesh.vertices[static_cast<std::size_t>(v)]) out.real(x);
      for (int i = 0; second && i < 2; ++i) out.real(0.25);
      out.end_row();
    }
  }
  out.end("Nodes");
}

inline MadeFile gmsh_4(const TetMesh& mesh, const GmshEncoding& encoding) {
  GmshWriter out(encoding);
  const auto rows = gmsh_rows(mesh);
  const auto blocks = gmsh_blocks(rows);
  out.format("4.1");
  write_gmsh_entities(blocks, encoding, out);
  write_gmsh_nodes(mesh, encoding, out);
  out.line("$Elements");
  const auto all = static_cast<std::int64_t>(rows.size());
  for (const std::int64_t head : {static_cast<std::int64_t>(blocks.size()), all, std::int64_t{1}, all})
    out.size(head);
  out.end_row();
  std::int64_t element = 0;
  for (const auto& block : blocks) {
    out.integer(block[0].dimension);
    out.integer(gmsh_entity(encoding, block[0].tag));
    out.integer(block[0].type);
    out.size(static_cast<std::int64_t>(block.size()));
    out.end_row();
    for (const GmshRow& row : block) {
      out.size(++element);
      for (const std::uint32_t node : row.nodes) out.size(1 + encoding.gap * node);
      out.end_row();
    }
  }
  out.end("Elements");
  out.line("$NodeData\n1\n\"anything\"\n$EndNodeData");
  return {what_of("4.1", encoding), ".msh", out.bytes()};
}

inline std::vector<MadeFile> gmsh_files(const TetMesh& mesh) {
  std::vector<MadeFile> files;
  for (const std::int64_t gap : {1, 7}) {
    for (const bool physical : {true, false}) {
      for (const GmshEncoding& encoding :
           {GmshEncoding{false, false, true, gap, physical}, GmshEncoding{true, false, true, gap, physical},
            GmshEncoding{true, true, true, gap, physical}}) {
        files.push_back(gmsh_2(mesh, encoding));
        files.push_back(gmsh_4(mesh, encoding));
      }
      files.push_back(gmsh_4(mesh, {true, false, false, gap, physical}));
    }
  }
  return files;
}

}  // namespace crossgrain

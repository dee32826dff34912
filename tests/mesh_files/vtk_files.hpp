// SPDX-License-Identifier: Apache-2.0
// Meshes as VTK files, legacy and XML, written by code of its own.
#pragma once

#include <fmt/format.h>
#include <zlib.h>

#include "mesh_files/made_tet_mesh.hpp"

namespace crossgrain {

/// The cells of a mesh as VTK has them: a point, then edges, faces and tets.
struct VtkGrid {
  explicit VtkGrid(const TetMesh& mesh) {
    for (const Vector3& vertex : mesh.vertices) points.insert(points.end(), vertex.begin(), vertex.end());
    add(1, 3, std::array<std::uint32_t, 1>{0});
    for (const auto& [nodes, tag, is_stated] : mesh.feature_edges) add(3, tag, nodes);
    for (const auto& [nodes, tag] : mesh.feature_faces) add(5, tag, nodes);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t) add(10, mesh.regions[t], mesh.tets[t]);
  }

  template <std::size_t N>
  void add(int type, std::int32_t tag, const std::array<std::uint32_t, N>& nodes) {
    types.push_back(type);
    tags.push_back(tag);
    for (const std::uint32_t node : nodes) connectivity.push_back(node);
    ends.push_back(static_cast<std::int64_t>(connectivity.size()));
  }

  std::vector<double> points;
  std::vector<std::int64_t> connectivity, ends, types, tags;
};

/// Numbers of type T, as text or bytes of a legacy file.
template <class T, class U>
void put_vtk(ByteWriter& out, bool binary, const std::vector<U>& values) {
  for (const U value : values) {
    if (binary)
      out.put(static_cast<T>(value));
    else
      out.text(fmt::format("{} ", value));
  }
  out.text("\n");
}

template <class Real>
MadeFile vtk_legacy(const TetMesh& mesh, std::string_view version, bool binary) {
  const VtkGrid grid(mesh);
  ByteWriter out(true);  // big endian
  out.text(fmt::format("# vtk DataFile Version {}\nmade\n{}\nDATASET UNSTRUCTURED_GRID\n", version,
                       binary ? "BINARY" : "ASCII"));
  constexpr bool kIsDouble = sizeof(Real) == 8;
  out.text(fmt::format("POINTS {} {}\n", mesh.vertices.size(), kIsDouble ? "double" : "float"));
  put_vtk<Real>(out, binary, grid.points);
  const std::size_t cells = grid.types.size();
  if (version.starts_with("5")) {
    out.text("METADATA\nINFORMATION 0\n\n");
    out.text(fmt::format("CELLS {} {}\nOFFSETS vtktypeint64\n", cells + 1, grid.connectivity.size()));
    std::vector<std::int64_t> ends = grid.ends;
    ends.insert(ends.begin(), 0);
    put_vtk<std::int64_t>(out, binary, ends);
    out.text("CONNECTIVITY vtktypeint64\n");
    put_vtk<std::int64_t>(out, binary, grid.connectivity);
  } else {
    std::vector<std::int64_t> mixed;
    for (std::size_t i = 0, at = 0; i < cells; ++i) {
      mixed.push_back(grid.ends[i] - static_cast<std::int64_t>(at));
      for (; at < static_cast<std::size_t>(grid.ends[i]); ++at) mixed.push_back(grid.connectivity[at]);
    }
    out.text(fmt::format("CELLS {} {}\n", cells, mixed.size()));
    put_vtk<std::int32_t>(out, binary, mixed);
  }
  out.text(fmt::format("CELL_TYPES {}\n", cells));
  put_vtk<std::int32_t>(out, binary, grid.types);
  out.text(fmt::format("\nCELL_DATA {}\nSCALARS quality double 2\nLOOKUP_TABLE default\n", cells));
  put_vtk<double>(out, binary, std::vector<double>(2 * cells, 0.5));
  out.text(fmt::format("FIELD FieldData 2\nother 1 {} int\n", cells));
  put_vtk<std::int32_t>(out, binary, grid.types);
  out.text(fmt::format("CellEntityIds 1 {} {}\n", cells, kIsDouble ? "long" : "int"));
  if (kIsDouble)
    put_vtk<std::int64_t>(out, binary, grid.tags);
  else
    put_vtk<std::int32_t>(out, binary, grid.tags);
  out.text(fmt::format("POINT_DATA {}\nVECTORS v float\n", mesh.vertices.size()));
  put_vtk<float>(out, binary, grid.points);
  return {fmt::format("VTK {} {} {}", version, binary ? "binary" : "text", kIsDouble ? "double" : "float"),
          ".vtk", out.bytes()};
}

inline std::vector<MadeFile> vtk_files(const TetMesh& mesh) {
  std::vector<MadeFile> files;
  for (const char* version : {"2.0", "4.2", "5.1"}) {
    for (const bool binary : {false, true}) {
      files.push_back(vtk_legacy<float>(mesh, version, binary));
      files.push_back(vtk_legacy<double>(mesh, version, binary));
    }
  }
  return files;
}

/// How a VTK XML file is written.
struct VtuEncoding {
  std::string format;  ///< ascii, binary, raw or base64; the last two appended
  bool compressed = false;
  bool wide = false;  ///< headers of 64 bits
  bool swapped = false;

  /// Base64 of the header apart from that of the data, as VTK writes what is compressed.
  bool apart = true;
};

inline std::string base64(std::string_view bytes) {
  constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t bits = 0;
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    for (std::size_t k = 0; k < 3; ++k)
      bits = bits << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k) out += k <= count ? kAlphabet[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

/// An array as the file has it: the numbers before the data, and the data.
inline std::string packed_vtu_data(const std::string& raw, const VtuEncoding& encoding) {
  const auto put_word = [&](ByteWriter& out, std::size_t word) {
    if (encoding.wide)
      out.put(static_cast<std::uint64_t>(word));
    else
      out.put(static_cast<std::uint32_t>(word));
  };
  ByteWriter header(encoding.swapped);
  std::string data = raw;
  if (encoding.compressed) {
    constexpr std::size_t kBlock = 64;
    data.clear();
    std::vector<std::size_t> sizes;
    for (std::size_t begin = 0; begin < raw.size(); begin += kBlock) {
      const std::size_t bytes = std::min(kBlock, raw.size() - begin);
      std::string block(compressBound(bytes), '\0');
      uLongf size = block.size();
      compress(reinterpret_cast<Bytef*>(block.data()), &size,
               reinterpret_cast<const Bytef*>(raw.data() + begin), bytes);
      data += block.substr(0, size);
      sizes.push_back(size);
    }
    put_word(header, sizes.size());
    put_word(header, kBlock);
    put_word(header, raw.size() % kBlock);
    for (const std::size_t size : sizes) put_word(header, size);
  } else {
    put_word(header, raw.size());
  }
  if (encoding.format == "raw") return header.bytes() + data;
  return encoding.apart ? base64(header.bytes()) + base64(data) : base64(header.bytes() + data);
}

class VtuFileWriter {
 public:
  explicit VtuFileWriter(VtuEncoding encoding) : encoding_(std::move(encoding)) {}

  void text(std::string_view words) { text_ += words; }

  template <class T, class U>
  void array(std::string_view type, std::string_view name, std::size_t components,
             const std::vector<U>& values) {
    text_ +=
        fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" ", type, name, components);
    if (encoding_.format == "ascii") {
      text_ += "format=\"ascii\">\n";
      for (const U value : values) text_ += fmt::format(" {}", value);
      text_ += "\n<InformationKey name=\"a\"><Value>0.5</Value></InformationKey></DataArray>\n";
      return;
    }
    ByteWriter raw(encoding_.swapped);
    for (const U value : values) raw.put(static_cast<T>(value));
    const std::string packed = packed_vtu_data(raw.bytes(), encoding_);
    if (encoding_.format == "binary") {
      text_ += fmt::format("format=\"binary\">\n  {}\n</DataArray>\n", packed);
    } else {
      text_ += fmt::format("format=\"appended\" offset=\"{}\"/>\n", appended_.size());
      appended_ += packed;
    }
  }

  std::string finish() const {
    std::string begin = fmt::format(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
        "byte_order=\"{}\"{}{}>\n",
        encoding_.swapped ? "BigEndian" : "LittleEndian", encoding_.wide ? " header_type=\"UInt64\"" : "",
        encoding_.compressed ? " compressor=\"vtkZLibDataCompressor\"" : "");
    std::string end = "</VTKFile>\n";
    if (encoding_.format == "raw" || encoding_.format == "base64")
      end = fmt::format("<AppendedData encoding=\"{}\">\n_{}\n</AppendedData>\n{}", encoding_.format,
                        appended_, end);
    return begin + text_ + end;
  }

 private:
  VtuEncoding encoding_;
  std::string text_, appended_;
};

inline MadeFile vtu(const TetMesh& mesh, const VtuEncoding& encoding) {
  const VtkGrid grid(mesh);
  VtuFileWriter out(encoding);
  out.text(
      fmt::format("<UnstructuredGrid>\n<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"></Piece>\n"
                  "<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n<PointData></PointData>\n<CellData>\n",
                  mesh.vertices.size(), grid.types.size()));
  out.array<double>("Float64", "quality", 1, std::vector<double>(grid.types.size(), 0.5));
  out.array<std::uint8_t>("UInt8", "vtkGhostType", 1, std::vector<int>(grid.types.size(), 0));
  out.array<std::int64_t>("Int64", "CellEntityIds", 1, grid.tags);
  out.text("</CellData>\n<Points>\n");
  if (encoding.wide)
    out.array<float>("Float32", "Points", 3, grid.points);
  else
    out.array<double>("Float64", "Points", 3, grid.points);
  out.text("</Points>\n<Cells>\n");
  if (encoding.wide)
    out.array<std::int64_t>("Int64", "connectivity", 1, grid.connectivity);
  else
    out.array<std::int32_t>("Int32", "connectivity", 1, grid.connectivity);
  out.array<std::int64_t>("Int64", "offsets", 1, grid.ends);
  out.array<std::uint8_t>("UInt8", "types", 1, grid.types);
  out.text("</Cells>\n</Piece>\n</UnstructuredGrid>\n");
  return {fmt::format("VTU {}{}{}{}{}", encoding.format, encoding.compressed ? " zlib" : "",
                      encoding.wide ? " 64" : " 32", encoding.swapped ? " swapped" : "",
                      encoding.apart ? "" : " as one"),
          ".vtu", out.finish()};
}

inline std::vector<MadeFile> vtu_files(const TetMesh& mesh) {
  std::vector<MadeFile> files{vtu(mesh, {"ascii"}), vtu(mesh, {"ascii", true, true, true})};
  for (const char* format : {"binary", "raw", "base64"})
    for (const bool compressed : {false, true})
      for (const bool wide : {false, true})
        for (const bool swapped : {false, true})
          for (const bool apart : {false, true})
            if (apart || (std::string_view(format) != "raw" && !compressed))
              files.push_back(vtu(mesh, {format, compressed, wide, swapped, apart}));
  return files;
}

}  // namespace crossgrain

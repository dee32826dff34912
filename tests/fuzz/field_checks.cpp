// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>

#include "crossgrain/result_folder.hpp"
#include "crossgrain/writing.hpp"
#include "fuzz/input_folder.hpp"
#include "fuzz/mesh_promises.hpp"
#include "fuzz/reader_checks.hpp"
#include "mesh_files/hex/hex_arrays.hpp"
#include "mesh_files/vtk_files.hpp"
#include "results/report_file.hpp"
#include "results/sample_field.hpp"
#include "results/singularity_file.hpp"
#include "results/surface_file.hpp"
#include "vtu/array_names.hpp"

namespace crossgrain {
namespace {

struct FieldArray {
  const char* name;
  const char* section;
  const char* type;
  std::size_t components;
};

constexpr std::array kFieldArrays = {
    FieldArray{field_arrays::kSchema, "FieldData", "UInt32", 1},
    FieldArray{field_arrays::kDegree, "FieldData", "UInt32", 1},
    FieldArray{field_arrays::kRootCube, "FieldData", "Float64", 4},
    FieldArray{field_arrays::kCellAddress, "FieldData", "UInt64", 1},
    FieldArray{field_arrays::kFrame, "FieldData", "Float32", 4},
    FieldArray{field_arrays::kOpenFaces, "FieldData", "UInt8", 1},
    FieldArray{field_arrays::kEnergyDensity, "CellData", "Float32", 1},
    FieldArray{field_arrays::kAlignment, "CellData", "Float32", 1},
    FieldArray{field_arrays::kOnBoundary, "CellData", "UInt8", 1},
};

/// The next array: its number of bytes, and these, as far as there are any.
std::vector<std::uint8_t> take_array(std::string_view& bytes) {
  if (bytes.size() < 2) return {};
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
  };
  const std::size_t count = std::min(byte(0) + 256 * byte(1), bytes.size() - 2);
  const std::string_view here = bytes.substr(2, count);
  bytes.remove_prefix(2 + count);
  return {here.begin(), here.end()};
}

constexpr std::array kOntoArrays = {
    FieldArray{"Points", "Points", "Float64", 3},   FieldArray{"connectivity", "Cells", "Int32", 1},
    FieldArray{"axis_u", "CellData", "Float32", 3}, FieldArray{"axis_v", "CellData", "Float32", 3},
    FieldArray{"axis_w", "CellData", "Float32", 3},
};

constexpr std::array kRepairedArrays = {
    FieldArray{"Points", "Points", "Float64", 3},
    FieldArray{"connectivity", "Cells", "Int32", 1},
    FieldArray{"axis_u", "CellData", "Float32", 3},
    FieldArray{"axis_v", "CellData", "Float32", 3},
    FieldArray{"axis_w", "CellData", "Float32", 3},
    FieldArray{field_arrays::kTetFrame, "CellData", "Float64", 4},
    FieldArray{field_arrays::kMatching, "CellData", "Int8", 12},
};

constexpr std::array kSurfaceArrays = {
    FieldArray{field_arrays::kSchema, "FieldData", "UInt32", 1},
    FieldArray{"Points", "Points", "Float64", 3},
    FieldArray{"connectivity", "Cells", "Int32", 1},
    FieldArray{"offsets", "Cells", "Int32", 1},
    FieldArray{"types", "Cells", "UInt8", 1},
};

constexpr std::array kSingularityArrays = {
    FieldArray{"Points", "Points", "Float64", 3},
    FieldArray{"node", "PointData", "Int32", 1},
    FieldArray{"node_on_boundary", "PointData", "UInt8", 1},
    FieldArray{"node_verdict", "PointData", "UInt8", 1},
    FieldArray{"axis", "PointData", "Float64", 3},
    FieldArray{"turning_point", "PointData", "UInt8", 1},
    FieldArray{"vertex", "PointData", "Int64", 1},
    FieldArray{"connectivity", "Cells", "Int64", 1},
    FieldArray{"offsets", "Cells", "Int64", 1},
    FieldArray{"index", "CellData", "Float64", 1},
    FieldArray{"length", "CellData", "Float64", 1},
    FieldArray{"type", "CellData", "UInt8", 1},
    FieldArray{"verdict", "CellData", "UInt8", 1},
    FieldArray{"closed", "CellData", "UInt8", 1},
};

constexpr std::array kStreamlineArrays = {
    FieldArray{"Points", "Points", "Float64", 3},
    FieldArray{"offsets", "Cells", "Int32", 1},
    FieldArray{"axis", "CellData", "UInt8", 1},
};

constexpr std::array kHexahedronArrays = {
    FieldArray{"Points", "Points", "Float64", 3},
    FieldArray{"connectivity", "Cells", "Int32", 1},
    FieldArray{"offsets", "Cells", "Int32", 1},
    FieldArray{"types", "Cells", "UInt8", 1},
    FieldArray{field_arrays::kRegion, "CellData", "Int32", 1},
    FieldArray{hex_arrays::kBoundary, "FieldData", "Int32", 4},
    FieldArray{hex_arrays::kBoundaryTag, "FieldData", "Int32", 1},
};

using ArrayBytes = std::vector<std::vector<std::uint8_t>>;

ArrayBytes taken_arrays(std::span<const FieldArray> kinds, std::string_view bytes) {
  ArrayBytes arrays(kinds.size());
  std::ranges::generate(arrays, [&] { return take_array(bytes); });
  return arrays;
}

/// A file of these arrays as `write_field` packs them.
std::string packed(std::span<const FieldArray> kinds, const ArrayBytes& arrays, std::size_t points,
                   std::size_t cells) {
  VtuFileWriter out({"raw", true, true});
  out.text(
      fmt::format("<UnstructuredGrid><Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n", points, cells));
  for (std::size_t i = 0; i < arrays.size(); ++i) {
    const FieldArray& array = kinds[i];
    out.text(fmt::format("<{}>\n", array.section));
    out.array<std::uint8_t>(array.type, array.name, array.components, arrays[i]);
    out.text(fmt::format("</{}>\n", array.section));
  }
  out.text("</Piece></UnstructuredGrid>\n");
  return out.finish();
}

/// At the corners of the root cube, in it and far off.
void sample_everywhere(const FrameField& field) {
  const RootCube& root = field.data().tree.root();
  for (const double part : {0.0, 0.3, 0.5, 1.0, 7.0}) {
    Vector3 point;
    for (std::size_t i = 0; i < 3; ++i) point[i] = root.origin[i] + part * root.size;
    if (!std::isfinite(point[0] + point[1] + point[2])) continue;
    for (const Vector3& axis : field.sample(point).frame.axes)
      require(std::abs(norm(axis) - 1) < 1e-6, "an axis that is no unit vector");
  }
}

/// `field_vtu` beside a report without fault.
bool check_field_of(std::string_view field_vtu) {
  static const std::string report = json_of(sample_report()).dump();
  as_file("report.json", report);
  as_file("field.vtu", field_vtu);
  std::optional<FrameField> field;
  if (!succeeds([&] { field.emplace(read_field(input_folder().path())); })) return false;
  require(field->size() > 0, "a field without cells");
  for (std::size_t i = 0; i < field->size(); ++i) {
    const FrameField::Cell cell = field->cell(i);
    require_finite({cell.frame.axes.begin(), cell.frame.axes.end()});
  }
  sample_everywhere(*field);
  return true;
}

}  // namespace

bool check_field(std::string_view bytes) {
  const bool is_field = check_field_of(bytes);
  succeeds([&] { is_clipped_field(input_folder().path()); });
  return is_field;
}

bool check_field_arrays(std::string_view bytes) {
  const ArrayBytes arrays = taken_arrays(kFieldArrays, bytes);
  return check_field_of(packed(kFieldArrays, arrays, 0, arrays.back().size()));
}

namespace {

/// onto.vtu with points first and tets next.
bool check_onto(std::span<const FieldArray> kinds, std::string_view bytes) {
  const ArrayBytes arrays = taken_arrays(kinds, bytes);
  as_file("onto.vtu", packed(kinds, arrays, arrays[0].size() / (3 * sizeof(double)),
                             arrays[1].size() / (4 * sizeof(std::int32_t))));
  std::optional<SingularityGraph> graph;
  if (!succeeds([&] { graph = read_onto_singularities(input_folder().path()); })) return false;
  require(graph.has_value(), "a field on tets that is not there");
  for (const SingularityGraph::Arc& arc : graph->arcs) require_finite(arc.points);
  return true;
}

}  // namespace

bool check_onto_arrays(std::string_view bytes) {
  return check_onto(kOntoArrays, bytes);
}

bool check_repaired_arrays(std::string_view bytes) {
  return check_onto(kRepairedArrays, bytes);
}

bool check_surface_arrays(std::string_view bytes) {
  const ArrayBytes arrays = taken_arrays(kSurfaceArrays, bytes);
  const auto path =
      as_file("surface.vtu",
              packed(kSurfaceArrays, arrays, arrays[1].size() / (3 * sizeof(double)), arrays.back().size()));
  std::shared_ptr<const SolvedSurface> surface;
  const bool is_surface = succeeds([&] { surface = surface_in(path).get(); });
  std::filesystem::remove(path);
  if (!is_surface) return false;
  require(surface != nullptr, "a surface that is not there");
  require_finite(surface->vertices);
  for (const auto& triangle : surface->triangles)
    for (const std::uint32_t vertex : triangle)
      require(vertex < surface->vertices.size(), "a vertex that is not there");
  for (const std::vector<Vector3>& crease : surface->creases) {
    require(crease.size() > 1, "a crease without length");
    require_finite(crease);
  }
  return true;
}

bool check_singularity_arrays(std::string_view bytes) {
  const ArrayBytes arrays = taken_arrays(kSingularityArrays, bytes);
  const auto path = as_file(
      "singularities.vtu",
      packed(kSingularityArrays, arrays, arrays[0].size() / (3 * sizeof(double)), arrays.back().size()));
  SingularityGraph graph;
  if (!succeeds([&] { graph = read_singularities(path); })) return false;
  for (const SingularityGraph::Arc& arc : graph.arcs) {
    require(arc.points.size() > 1, "an arc without length");
    require(std::isfinite(arc.index) && std::isfinite(arc.length), "an arc of no length or index");
    require_finite(arc.points);
    if (!arc.nodes) continue;
    for (const std::uint32_t node : *arc.nodes)
      require(node < graph.nodes.size(), "a node that is not there");
  }
  for (const SingularityGraph::Node& node : graph.nodes)
    for (const std::uint32_t arc : node.arcs) require(arc < graph.arcs.size(), "an arc that is not there");
  return true;
}

bool check_streamline_arrays(std::string_view bytes) {
  const ArrayBytes arrays = taken_arrays(kStreamlineArrays, bytes);
  const auto path =
      as_file("streamlines.vtu", packed(kStreamlineArrays, arrays, arrays[0].size() / (3 * sizeof(double)),
                                        arrays[1].size() / sizeof(std::int32_t)));
  std::vector<AxisCurve> lines;
  if (!succeeds([&] { lines = read_streamlines(path); })) return false;
  for (const AxisCurve& line : lines) {
    require(line.points.size() > 1, "a line without length");
    require(line.axis >= 0 && line.axis < 3, "an axis that is not there");
    require_finite(line.points);
  }
  return true;
}

bool check_hexahedron_arrays(std::string_view bytes) {
  constexpr std::span kAll = kHexahedronArrays;
  const ArrayBytes arrays = taken_arrays(kAll, bytes);
  const bool has_boundary = !arrays[5].empty();
  const auto path =
      as_file("hexahedra.vtu", packed(has_boundary ? kAll : kAll.first(5),
                                      has_boundary ? arrays : ArrayBytes{arrays.begin(), arrays.begin() + 5},
                                      arrays[0].size() / (3 * sizeof(double)), arrays[3].size()));
  HexMesh mesh;
  if (!succeeds([&] { mesh = read_hexahedra(path); })) return false;
  require_finite(mesh.vertices);
  // Whatever is no mesh is refused here.
  write_hexahedra(mesh, path);
  const HexMesh again = read_hexahedra(path);
  require(again.vertices == mesh.vertices && again.hexahedra == mesh.hexahedra &&
              again.regions == mesh.regions && again.boundary.size() == mesh.boundary.size(),
          "hexahedra that change when written");
  return true;
}

bool check_report(std::string_view bytes) {
  const auto path = as_file("input.json", bytes);
  SolveReport report;
  if (!succeeds([&] { report = read_report(path); })) return false;
  // Written and read again it is the same.
  const std::string text = report_json(report);
  const auto again = as_file("again.json", text);
  require(report_json(read_report(again)) == text, "a report that changes when written");
  return true;
}

}  // namespace crossgrain

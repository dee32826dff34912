// SPDX-License-Identifier: Apache-2.0
#include "page/page_scene.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/streamlines.hpp"
#include "field/field_data.hpp"
#include "io/result/output_cells.hpp"
#include "page/drawn_surface.hpp"
#include "page/scene_writer.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kMostTriangles = 150000;

/// Three lines each, one an axis: a few across any part, not so many that they hide each other.
constexpr std::size_t kStreamlineSeeds = 40;

/// Lines go no further each way, in longest sides: they may wind round a part many times, and hide it.
constexpr double kStreamlineSides = 1;

/// Points of a streamline, at most: tracing takes a point a cell.
constexpr std::size_t kMostLinePoints = 200;

/// Polylines as two arrays: points, and where each line begins.
class Polylines {
 public:
  explicit Polylines(const Vector3& origin) : origin_(origin) {}

  void add_point(const Vector3& point) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      points_.push_back(static_cast<float>(point[axis] - origin_[axis]));
  }
  void end_line() { starts_.push_back(static_cast<std::uint32_t>(points_.size() / 3)); }

  void add(const std::vector<Vector3>& line) {
    for (const Vector3& point : line) add_point(point);
    end_line();
  }

  void write(SceneWriter& scene, const char* points, const char* starts) const {
    scene.add(points, 3, points_);
    scene.add(starts, 1, starts_);
  }

 private:
  Vector3 origin_;
  std::vector<float> points_;
  std::vector<std::uint32_t> starts_{0};
};

Vector3 middle_of(const Box& box) {
  return 0.5 * (box.low + box.high);
}

DrawnSurface add_surface(const SolvedSurface& surface, const Vector3& origin, SceneWriter& scene) {
  DrawnSurface drawn = drawn_surface(surface, origin, kMostTriangles);
  scene.add("surface_vertices", 3, drawn.positions);
  scene.add("surface_triangles", 3, drawn.vertices);
  scene.header["surface"] = {{"triangles_total", surface.triangles.size()},
                             {"triangles_shown", drawn.vertices.size() / 3}};
  Polylines creases(origin);
  for (const std::vector<Vector3>& crease : surface.creases) creases.add(crease);
  creases.write(scene, "crease_points", "crease_starts");
  return drawn;
}

template <class T, class Items, class ValueOf>
std::vector<T> column(const Items& items, const ValueOf& value_of) {
  std::vector<T> values;
  values.reserve(items.size());
  for (const auto& item : items) values.push_back(static_cast<T>(value_of(item)));
  return values;
}

void add_singularities(const SingularityGraph& graph, const Vector3& origin, SceneWriter& scene) {
  using Arc = SingularityGraph::Arc;
  using Node = SingularityGraph::Node;
  Polylines arcs(origin);
  for (const Arc& arc : graph.arcs) arcs.add(arc.points);
  arcs.write(scene, "arc_points", "arc_starts");
  scene.add("arc_index", 1, column<float>(graph.arcs, [](const Arc& arc) { return arc.index; }));
  scene.add("arc_type", 1, column<std::uint8_t>(graph.arcs, [](const Arc& arc) { return arc.type; }));
  scene.add("arc_verdict", 1, column<std::uint8_t>(graph.arcs, [](const Arc& arc) { return arc.verdict; }));
  std::vector<float> places;
  for (const Node& node : graph.nodes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      places.push_back(static_cast<float>(node.place[axis] - origin[axis]));
  scene.add("node_points", 3, places);
  scene.add("node_verdict", 1,
            column<std::uint8_t>(graph.nodes, [](const Node& node) { return node.verdict; }));
  scene.add("node_on_boundary", 1,
            column<std::uint8_t>(graph.nodes, [](const Node& node) { return node.on_boundary; }));
  scene.add("node_degree", 1, column<std::uint8_t>(graph.nodes, [](const Node& node) {
              return std::min<std::size_t>(255, node.degree());
            }));
}

/// Cells of `shown`, with corners counted in the smallest of them.
void add_cells(const FieldData& shown, std::size_t total, std::optional<int> merged_to, const Vector3& origin,
               SceneWriter& scene) {
  const auto& leaves = shown.tree.leaves();
  int deepest = 0;
  for (const CellAddress leaf : leaves) deepest = std::max(deepest, leaf.depth());
  const int shift = kMaxDepth - deepest;
  std::vector<std::uint16_t> corners, sizes;
  std::vector<std::int16_t> frames;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    for (const std::int32_t place : leaves[i].corner())
      corners.push_back(static_cast<std::uint16_t>(place >> shift));
    sizes.push_back(static_cast<std::uint16_t>(leaves[i].width() >> shift));
    const StoredQuaternion& q = shown.frames[i];
    for (const float part : {q.w, q.x, q.y, q.z})
      frames.push_back(static_cast<std::int16_t>(std::lround(32767 * std::clamp(part, -1.0f, 1.0f))));
  }
  scene.add("cell_corner", 3, corners);
  scene.add("cell_size", 1, sizes);
  scene.add("cell_frame", 4, frames);
  scene.add("cell_energy_density", 1, column<std::uint16_t>(shown.energy_density, to_bfloat16));
  scene.add("cell_alignment_deg", 1, column<std::uint16_t>(shown.alignment_deg, to_bfloat16));
  std::vector<CellConstraint> classes = shown.constraints;
  classes.resize(leaves.size(), CellConstraint::kNoSurface);
  scene.add("cell_class", 1, column<std::uint8_t>(classes, [](CellConstraint c) { return c; }));

  const RootCube& root = shown.tree.root();
  const Vector3 low = root.origin - origin;
  scene.header["cells"] = {{"low", low},
                           {"unit", root.cell_size(deepest)},
                           {"total", total},
                           {"shown", leaves.size()},
                           {"merged_to", nullptr}};
  if (merged_to) scene.header["cells"]["merged_to"] = root.cell_size(*merged_to);
}

void add_forms(const ShownForms& forms, const FieldData& shown, SceneWriter& scene) {
  const auto& leaves = shown.tree.leaves();
  std::vector<std::uint32_t> cells;
  for (const CellAddress cell : forms.cells)
    cells.push_back(
        static_cast<std::uint32_t>(std::lower_bound(leaves.begin(), leaves.end(), cell) - leaves.begin()));
  const std::size_t size = shown.degree == Degree::kThree ? 7 : 9;
  scene.add("form_cell", 1, cells);
  scene.add("form_matrix", size * (size + 1) / 2, forms.matrices);
  scene.add("form_linear", size, forms.linear_parts);
  scene.add("form_constant", 1, forms.constants);
  scene.add("form_weight", 1, forms.weights);
}

TriangleMesh mesh_of(const DrawnSurface& surface, const Vector3& origin) {
  TriangleMesh mesh;
  for (std::size_t k = 0; k < surface.positions.size(); k += 3)
    mesh.vertices.push_back(
        origin + Vector3{surface.positions[k], surface.positions[k + 1], surface.positions[k + 2]});
  for (std::size_t k = 0; k < surface.vertices.size(); k += 3)
    mesh.triangles.push_back({surface.vertices[k], surface.vertices[k + 1], surface.vertices[k + 2]});
  return mesh;
}

/// Lines end on the surface as it is drawn, which is quicker to look into than a large one, or with the cells
/// where no surface is known or it is not where the field is.
StreamlineTracer tracer_of(const FrameField& field, const DrawnSurface& surface, const Vector3& origin) {
  StreamlineOptions options;
  options.longest_sides = kStreamlineSides;
  if (!surface.vertices.empty()) {
    const TriangleMesh mesh = mesh_of(surface, origin);
    try {
      return StreamlineTracer(field, options, &mesh);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kInput) throw;
    }
  }
  return StreamlineTracer(field, options);
}

/// Of the cells that are shown, which lines through the cells themselves would hardly differ from.
void add_streamlines(const FrameField& shown, const DrawnSurface& surface, const Vector3& origin,
                     const Monitor& monitor, SceneWriter& scene) {
  Polylines lines(origin);
  const StreamlineTracer tracer = tracer_of(shown, surface, origin);
  const auto seeds = tracer.spread_seeds(kStreamlineSeeds, monitor);
  for (const Streamline& line : tracer.trace(seeds, monitor).lines) {
    const std::size_t pieces = line.points.size() - 1;
    const std::size_t drawn = std::min(pieces, kMostLinePoints);
    for (std::size_t k = 0; k <= drawn; ++k) lines.add_point(line.points[k * pieces / drawn]);
    lines.end_line();
  }
  lines.write(scene, "streamline_points", "streamline_starts");
}

}  // namespace

std::string page_scene(const FrameField& field, const Monitor& monitor) {
  const FieldData& data = field.data();
  const Box& box = data.report.model.bounding_box;
  const Vector3 origin = middle_of(box);
  SceneWriter scene;
  scene.header["origin"] = origin;
  scene.header["unit"] = data.report.model.unit;
  scene.header["low"] = box.low - origin;
  scene.header["high"] = box.high - origin;

  const std::shared_ptr<const SolvedSurface> surface = data.surface.get();
  const DrawnSurface drawn = add_surface(surface ? *surface : SolvedSurface{}, origin, scene);
  monitor.check();
  add_singularities(field.singularities(), origin, scene);

  OutputOptions merged;
  merged.level = shown_depth(data.tree);
  const bool shows_all = ask_for_all(merged, data.tree);
  const FrameField shown =
      shows_all ? field : FrameField(std::make_shared<const FieldData>(output_cells(data, merged, monitor)));
  add_cells(shown.data(), data.tree.size(), shows_all ? std::nullopt : merged.level, origin, scene);
  add_forms(data.shown_forms, shown.data(), scene);
  add_streamlines(shown, drawn, origin, monitor, scene);
  return scene.bytes();
}

}  // namespace crossgrain

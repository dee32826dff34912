// SPDX-License-Identifier: Apache-2.0
#include "page/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "display/drawn_lines.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kMostInterfaceTriangles = 50000;

}  // namespace

void Polylines::add_point(const Vector3& point) {
  for (std::size_t axis = 0; axis < 3; ++axis)
    points_.push_back(static_cast<float>(point[axis] - origin_[axis]));
}

void Polylines::add(const std::vector<Vector3>& line) {
  for (const Vector3& point : line) add_point(point);
  end_line();
}

void Polylines::write(SceneWriter& scene, const std::string& points, const std::string& starts) const {
  scene.add(points, 3, points_);
  scene.add(starts, 1, starts_);
}

void add_quaternion(const Quaternion& q, std::vector<std::int16_t>& frames) {
  for (const double part : {q.w, q.x, q.y, q.z})
    frames.push_back(static_cast<std::int16_t>(std::lround(32767 * std::clamp(part, -1.0, 1.0))));
}

DrawnSurface add_surface(const SolvedSurface& surface, const SolvedSurface& outside, const Vector3& origin,
                         const std::string& prefix, std::size_t most_triangles, SceneWriter& scene) {
  DrawnSurface drawn = drawn_surface(outside.vertices, outside.triangles, origin, most_triangles);
  scene.add(prefix + "surface_vertices", 3, drawn.positions);
  scene.add(prefix + "surface_triangles", 3, drawn.vertices);
  scene.header[prefix + "surface"] = {{"triangles_total", surface.triangles.size()},
                                      {"triangles_shown", drawn.vertices.size() / 3}};
  const DrawnSurface between =
      drawn_surface(surface.vertices, surface.interfaces, origin, kMostInterfaceTriangles);
  if (!between.vertices.empty()) {
    scene.add(prefix + "interface_vertices", 3, between.positions);
    scene.add(prefix + "interface_triangles", 3, between.vertices);
  }
  return drawn;
}

namespace {

void add_marks(const std::vector<LineMark>& marks, const Vector3& origin, const std::string& prefix,
               SceneWriter& scene) {
  std::vector<float> places, directions;
  for (const LineMark& mark : marks) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      places.push_back(static_cast<float>(mark.place[axis] - origin[axis]));
      directions.push_back(static_cast<float>(mark.direction[axis]));
    }
  }
  scene.add(prefix + "mark_points", 3, places);
  scene.add(prefix + "mark_directions", 3, directions);
  scene.add(prefix + "mark_shape", 1,
            column<std::uint8_t>(marks, [](const LineMark& mark) { return mark.shape; }));
  scene.add(prefix + "mark_verdict", 1,
            column<std::uint8_t>(marks, [](const LineMark& mark) { return mark.verdict; }));
  scene.add(prefix + "mark_wall", 1, column<float>(marks, [](const LineMark& mark) { return mark.wall; }));
}

}  // namespace

void add_singularities(const ShownField& field, const Vector3& origin, const std::string& prefix,
                       SceneWriter& scene) {
  using Arc = SingularityGraph::Arc;
  using Node = SingularityGraph::Node;
  const auto& [arc_list, node_list] = std::tie(field.lines().arcs, field.lines().nodes);
  const auto flags = [&](const char* name, const auto& items, const auto& value_of) {
    scene.add(prefix + name, 1, column<std::uint8_t>(items, value_of));
  };
  const DrawnLines drawn = drawn_lines(field);
  Polylines arcs(origin);
  std::vector<float> walls;
  for (const DrawnLine& line : drawn.lines) {
    arcs.add(line.points);
    for (const double wall : line.walls) walls.push_back(static_cast<float>(wall));
  }
  arcs.write(scene, prefix + "arc_points", prefix + "arc_starts");
  scene.add(prefix + "arc_wall", 1, walls);
  scene.add(prefix + "arc_index", 1, column<float>(arc_list, [](const Arc& arc) { return arc.index; }));
  flags("arc_type", arc_list, [](const Arc& arc) { return arc.type; });
  flags("arc_verdict", arc_list, [](const Arc& arc) { return arc.verdict; });
  flags("node_verdict", node_list, [](const Node& node) { return node.verdict; });
  flags("node_on_boundary", node_list, [](const Node& node) { return node.on_boundary; });
  flags("node_degree", node_list, [](const Node& node) { return std::min<std::size_t>(255, node.degree()); });
  add_marks(drawn.marks, origin, prefix, scene);
}

void SceneCells::write(std::size_t total, const Vector3& origin, SceneWriter& scene) const {
  scene.add("cell_corner", 3, corners);
  scene.add("cell_size", 1, sizes);
  scene.add("cell_frame", 4, frames);
  scene.add("cell_energy_density", 1, energy_density);
  scene.add("cell_alignment_deg", 1, alignment_deg);
  scene.add("cell_class", 1, classes);
  add_regions(regions, regions, "cell_region", "regions", scene);
  scene.header["cells"] = {
      {"low", low - origin}, {"unit", unit}, {"total", total}, {"shown", size()}, {"merged_to", nullptr}};
}

void add_regions(const std::vector<std::int32_t>& regions, const std::vector<std::int32_t>& all,
                 const char* array, const char* numbers, SceneWriter& scene) {
  std::vector<std::int32_t> distinct = all;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 2 || distinct.size() > std::numeric_limits<std::uint16_t>::max()) return;
  scene.add(array, 1, column<std::uint16_t>(regions, [&](std::int32_t region) {
              return std::lower_bound(distinct.begin(), distinct.end(), region) - distinct.begin();
            }));
  scene.header[numbers] = distinct;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "page/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossgrain {

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

DrawnSurface add_surface(const SolvedSurface& surface, const Vector3& origin, const std::string& prefix,
                         std::size_t most_triangles, SceneWriter& scene) {
  DrawnSurface drawn = drawn_surface(surface, origin, most_triangles);
  scene.add(prefix + "surface_vertices", 3, drawn.positions);
  scene.add(prefix + "surface_triangles", 3, drawn.vertices);
  scene.header[prefix + "surface"] = {{"triangles_total", surface.triangles.size()},
                                      {"triangles_shown", drawn.vertices.size() / 3}};
  return drawn;
}

void add_singularities(const SingularityGraph& graph, const Vector3& origin, const std::string& prefix,
                       SceneWriter& scene) {
  using Arc = SingularityGraph::Arc;
  using Node = SingularityGraph::Node;
  const auto flags = [&](const char* name, const auto& items, const auto& value_of) {
    scene.add(prefix + name, 1, column<std::uint8_t>(items, value_of));
  };
  Polylines arcs(origin);
  for (const Arc& arc : graph.arcs) arcs.add(arc.points);
  arcs.write(scene, prefix + "arc_points", prefix + "arc_starts");
  scene.add(prefix + "arc_index", 1, column<float>(graph.arcs, [](const Arc& arc) { return arc.index; }));
  flags("arc_type", graph.arcs, [](const Arc& arc) { return arc.type; });
  flags("arc_verdict", graph.arcs, [](const Arc& arc) { return arc.verdict; });
  std::vector<float> places;
  for (const Node& node : graph.nodes)
    for (std::size_t axis = 0; axis < 3; ++axis)
      places.push_back(static_cast<float>(node.place[axis] - origin[axis]));
  scene.add(prefix + "node_points", 3, places);
  flags("node_verdict", graph.nodes, [](const Node& node) { return node.verdict; });
  flags("node_on_boundary", graph.nodes, [](const Node& node) { return node.on_boundary; });
  flags("node_degree", graph.nodes,
        [](const Node& node) { return std::min<std::size_t>(255, node.degree()); });
}

void SceneCells::write(std::size_t total, const Vector3& origin, SceneWriter& scene) const {
  scene.add("cell_corner", 3, corners);
  scene.add("cell_size", 1, sizes);
  scene.add("cell_frame", 4, frames);
  scene.add("cell_energy_density", 1, energy_density);
  scene.add("cell_alignment_deg", 1, alignment_deg);
  scene.add("cell_class", 1, classes);
  add_regions(regions, "cell_region", "regions", scene);
  scene.header["cells"] = {
      {"low", low - origin}, {"unit", unit}, {"total", total}, {"shown", size()}, {"merged_to", nullptr}};
}

void add_regions(const std::vector<std::int32_t>& regions, const char* array, const char* numbers,
                 SceneWriter& scene) {
  std::vector<std::int32_t> distinct = regions;
  std::sort(distinct.begin(), distinct.end());
  distinct.erase(std::unique(distinct.begin(), distinct.end()), distinct.end());
  if (distinct.size() < 2 || distinct.size() > std::numeric_limits<std::uint16_t>::max()) return;
  scene.add(array, 1, column<std::uint16_t>(regions, [&](std::int32_t region) {
              return std::lower_bound(distinct.begin(), distinct.end(), region) - distinct.begin();
            }));
  scene.header[numbers] = distinct;
}

}  // namespace crossgrain

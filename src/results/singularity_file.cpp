// SPDX-License-Identifier: Apache-2.0
#include "results/singularity_file.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "results/tet_writers.hpp"
#include "vtu/vtu_arrays.hpp"
#include "vtu/vtu_writer.hpp"

namespace crossgrain {
namespace {

/// Columns of the file.
struct Polylines {
  struct Points {
    std::vector<Vector3> places;
    std::vector<std::int32_t> degrees;  ///< of nodes; 2 at points within an arc
    std::vector<std::int32_t> nodes;    ///< -1 at points within an arc
    std::vector<std::int64_t> vertices;
    std::vector<std::uint8_t> on_boundary, verdicts;
    std::vector<Vector3> axes;
    std::vector<std::uint8_t> turning;
  } points;
  struct Arcs {
    std::vector<double> indices, lengths, oblique_lengths;
    std::vector<std::uint8_t> types, verdicts, on_boundary, closed;
  } arcs;
  std::vector<std::int64_t> connectivity, offsets;
};

void add_point(Polylines& lines, const Vector3& place, std::int64_t vertex) {
  Polylines::Points& points = lines.points;
  points.places.push_back(place);
  points.degrees.push_back(2);
  points.nodes.push_back(-1);
  points.vertices.push_back(vertex);
  points.on_boundary.push_back(0);
  points.verdicts.push_back(static_cast<std::uint8_t>(Verdict::kMeshable));
  points.axes.push_back({0, 0, 0});
  points.turning.push_back(0);
}

/// Sets the axes and turning points of an arc at its points, but not the axes at nodes of several arcs, which
/// have an axis for each.
void set_axes(const SingularityGraph::Arc& arc, std::span<const std::int64_t> points, Polylines& lines) {
  for (std::size_t k = 0; k < arc.axes.size(); ++k) {
    const auto point = static_cast<std::size_t>(points[k]);
    const bool is_shared = lines.points.nodes[point] >= 0 && lines.points.degrees[point] > 1;
    if (!is_shared) lines.points.axes[point] = arc.axes[k];
  }
  for (const std::uint32_t k : arc.turning_points)
    lines.points.turning[static_cast<std::size_t>(points[k])] = 1;
}

void add_nodes(const SingularityGraph& graph, Polylines& lines) {
  for (const SingularityGraph::Node& node : graph.nodes) {
    add_point(lines, node.place, -1);
    lines.points.degrees.back() = static_cast<std::int32_t>(node.degree());
    lines.points.nodes.back() = static_cast<std::int32_t>(lines.points.nodes.size() - 1);
    lines.points.on_boundary.back() = node.on_boundary;
    lines.points.verdicts.back() = static_cast<std::uint8_t>(node.verdict);
  }
}

void add_arc(const SingularityGraph& graph, const SingularityGraph::Arc& arc, Polylines& lines) {
  bool on_boundary = false;
  const auto first = static_cast<std::int64_t>(lines.points.places.size());
  if (arc.nodes) {
    for (std::size_t end = 0; end < 2; ++end) {
      const std::uint32_t node = (*arc.nodes)[end];
      on_boundary |= graph.nodes[node].on_boundary;
      lines.points.vertices[node] = end == 0 ? arc.vertices.front() : arc.vertices.back();
    }
    lines.connectivity.push_back((*arc.nodes)[0]);
  } else {
    lines.connectivity.push_back(first);
    add_point(lines, arc.points.front(), arc.vertices.front());
  }
  for (std::size_t k = 1; k + 1 < arc.points.size(); ++k) {
    lines.connectivity.push_back(static_cast<std::int64_t>(lines.points.places.size()));
    add_point(lines, arc.points[k], arc.vertices[k]);
  }
  lines.connectivity.push_back(arc.nodes ? (*arc.nodes)[1] : first);
  set_axes(arc, std::span(lines.connectivity).last(arc.points.size()), lines);
  lines.offsets.push_back(static_cast<std::int64_t>(lines.connectivity.size()));
  lines.arcs.indices.push_back(arc.index);
  lines.arcs.lengths.push_back(arc.length);
  lines.arcs.oblique_lengths.push_back(arc.oblique_length);
  lines.arcs.types.push_back(static_cast<std::uint8_t>(arc.type));
  lines.arcs.verdicts.push_back(static_cast<std::uint8_t>(arc.verdict));
  lines.arcs.on_boundary.push_back(on_boundary);
  lines.arcs.closed.push_back(arc.is_closed());
}

std::vector<VtuArray> arrays_of(const Polylines& lines) {
  std::vector<VtuArray> arrays;
  const auto add = [&arrays](VtuSection section, const char* name, const auto& values) {
    arrays.push_back(stored_array(section, name, values));
  };
  add(VtuSection::kPointData, "node_degree", lines.points.degrees);
  add(VtuSection::kPointData, "node", lines.points.nodes);
  add(VtuSection::kPointData, "vertex", lines.points.vertices);
  add(VtuSection::kPointData, "node_on_boundary", lines.points.on_boundary);
  add(VtuSection::kPointData, "node_verdict", lines.points.verdicts);
  arrays.push_back(row_array<double>(VtuSection::kPointData, "axis", 3, lines.points.axes.size(),
                                     [&lines](std::size_t i) { return lines.points.axes[i]; }));
  add(VtuSection::kPointData, "turning_point", lines.points.turning);
  add(VtuSection::kCellData, "index", lines.arcs.indices);
  add(VtuSection::kCellData, "type", lines.arcs.types);
  add(VtuSection::kCellData, "verdict", lines.arcs.verdicts);
  add(VtuSection::kCellData, "length", lines.arcs.lengths);
  add(VtuSection::kCellData, "oblique_length", lines.arcs.oblique_lengths);
  add(VtuSection::kCellData, "on_boundary", lines.arcs.on_boundary);
  add(VtuSection::kCellData, "closed", lines.arcs.closed);
  arrays.push_back(
      points_array(lines.points.places.size(), [&lines](std::size_t i) { return lines.points.places[i]; }));
  add(VtuSection::kCells, "connectivity", lines.connectivity);
  add(VtuSection::kCells, "offsets", lines.offsets);
  arrays.push_back(uniform_types(lines.offsets.size(), kVtkPolyLine));
  return arrays;
}

}  // namespace

void write_singularities(OutputFile& file, const SingularityGraph& graph, const Monitor& monitor) {
  monitor.check();
  Polylines lines;
  add_nodes(graph, lines);
  for (const SingularityGraph::Arc& arc : graph.arcs) add_arc(graph, arc, lines);
  std::vector<VtuArray> arrays = arrays_of(lines);
  watch(arrays, monitor);
  write_vtu(file, lines.points.places.size(), lines.offsets.size(), arrays);
  file.finish();
}

void write_tet_singularities(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_singularities(file, output.lines, monitor);
}

}  // namespace crossgrain

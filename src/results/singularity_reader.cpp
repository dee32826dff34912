// SPDX-License-Identifier: Apache-2.0
// Reads files of singularity_file.cpp.
#include <cmath>
#include <cstdint>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

/// Rounding of the length of a unit vector.
constexpr double kUnitRounding = 1e-9;

class SingularityReader {
 public:
  explicit SingularityReader(const std::filesystem::path& path) : file_(path) {}

  SingularityGraph read() const {
    SingularityGraph graph;
    const std::vector<Vector3> places = file_.read_points(kLargestLength);
    add_nodes(places, graph);
    add_arcs(places, graph);
    return graph;
  }

 private:
  using ArcType = SingularityGraph::ArcType;

  /// The first points are the nodes.
  void add_nodes(const std::vector<Vector3>& places, SingularityGraph& graph) const {
    const auto nodes = file_.read<std::int32_t>(VtuSection::kPointData, "node", 1);
    const auto on_boundary = file_.read<std::uint8_t>(VtuSection::kPointData, "node_on_boundary", 1);
    const auto verdicts = file_.read<std::uint8_t>(VtuSection::kPointData, "node_verdict", 1);
    for (std::size_t i = 0; i < nodes.size() && nodes[i] >= 0; ++i) {
      require(static_cast<std::size_t>(nodes[i]) == i);
      require(verdicts[i] <= static_cast<int>(Verdict::kUndecided));
      graph.nodes.push_back({places[i], on_boundary[i] != 0, {}, static_cast<Verdict>(verdicts[i])});
    }
  }

  /// What belongs to points, beside their places.
  struct Columns {
    std::vector<double> axes;
    std::vector<std::uint8_t> turning;
    std::vector<std::int64_t> vertices;
  };

  Columns read_columns() const {
    Columns columns{file_.read<double>(VtuSection::kPointData, "axis", 3),
                    file_.read<std::uint8_t>(VtuSection::kPointData, "turning_point", 1),
                    file_.read<std::int64_t>(VtuSection::kPointData, "vertex", 1)};
    for (const double component : columns.axes) require(std::abs(component) <= 1 + kUnitRounding);
    return columns;
  }

  static void add_point(std::size_t point, bool is_repeated, const std::vector<Vector3>& places,
                        const Columns& columns, SingularityGraph::Arc& arc) {
    if (columns.turning[point] != 0 && !is_repeated)
      arc.turning_points.push_back(static_cast<std::uint32_t>(arc.points.size()));
    arc.points.push_back(places[point]);
    arc.axes.push_back({columns.axes[3 * point], columns.axes[3 * point + 1], columns.axes[3 * point + 2]});
    arc.vertices.push_back(columns.vertices[point]);
  }

  void add_arcs(const std::vector<Vector3>& places, SingularityGraph& graph) const {
    const auto entries = file_.read<std::int64_t>(VtuSection::kCells, "connectivity", 1);
    const auto ends = file_.read<std::int64_t>(VtuSection::kCells, "offsets", 1);
    const auto indices = file_.read<double>(VtuSection::kCellData, "index", 1);
    const auto lengths = file_.read<double>(VtuSection::kCellData, "length", 1);
    const auto types = file_.read<std::uint8_t>(VtuSection::kCellData, "type", 1);
    const auto verdicts = file_.read<std::uint8_t>(VtuSection::kCellData, "verdict", 1);
    const auto closed = file_.read<std::uint8_t>(VtuSection::kCellData, "closed", 1);
    const Columns columns = read_columns();
    require(ends.size() == file_.cells());
    std::size_t begin = 0;
    for (std::size_t cell = 0; cell < ends.size(); ++cell) {
      const auto end = static_cast<std::size_t>(ends[cell]);
      require(end >= begin + 2 && end <= entries.size());
      require(types[cell] <= static_cast<int>(ArcType::kNoAxis) && std::abs(indices[cell]) <= 1 &&
              std::abs(lengths[cell]) < kLargestLength &&
              verdicts[cell] <= static_cast<int>(Verdict::kUndecided));
      SingularityGraph::Arc& arc = graph.arcs.emplace_back();
      arc.type = static_cast<ArcType>(types[cell]);
      arc.index = indices[cell];
      arc.verdict = static_cast<Verdict>(verdicts[cell]);
      arc.length = lengths[cell];
      for (std::size_t i = begin; i < end; ++i) {
        require(static_cast<std::uint64_t>(entries[i]) < places.size());
        add_point(static_cast<std::size_t>(entries[i]), i + 1 == end && closed[cell] != 0, places, columns,
                  arc);
      }
      if (closed[cell] == 0) join(entries[begin], entries[end - 1], graph);
      begin = end;
    }
    require(begin == entries.size());
  }

  /// Adds the last arc to the nodes at its ends.
  void join(std::int64_t first, std::int64_t last, SingularityGraph& graph) const {
    require(static_cast<std::size_t>(first) < graph.nodes.size() &&
            static_cast<std::size_t>(last) < graph.nodes.size());
    graph.arcs.back().nodes = {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(last)};
    const auto arc = static_cast<std::uint32_t>(graph.arcs.size() - 1);
    for (const std::int64_t node : {first, last})
      graph.nodes[static_cast<std::size_t>(node)].arcs.push_back(arc);
  }

  void require(bool sound) const {
    if (!sound)
      throw Error(ErrorKind::kInput,
                  {file_.name(), "", "its arrays make no singular lines", Remedy::kCopyOrSolveAgain});
  }

  VtuFile file_;
};

}  // namespace

SingularityGraph read_singularities(const std::filesystem::path& path) {
  return SingularityReader(path).read();
}

}  // namespace crossgrain

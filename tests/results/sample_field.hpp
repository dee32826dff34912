// SPDX-License-Identifier: Apache-2.0
// A small field made up for the tests of its files.
#pragma once

#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "crossgrain/frame_field.hpp"
#include "field/field_data.hpp"
#include "field/field_state.hpp"

namespace crossgrain {

/// An octree of 8^depth cells, one of which is split into eight, all joined as far as they can be.
inline Octree sample_tree(int depth) {
  std::vector<CellAddress> leaves{CellAddress::root()};
  for (int d = 0; d <= depth; ++d) {
    std::vector<CellAddress> finer;
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if (d == depth && i != leaves.size() / 2) {
        finer.push_back(leaves[i]);
        continue;
      }
      for (int octant = 0; octant < 8; ++octant) finer.push_back(leaves[i].child(octant));
    }
    leaves = finer;
  }
  // Far off and of an odd size, where single precision would not do.
  return {{{1e5 + 0.1, -3e4 + 0.7, 11.3}, 0.731}, leaves};
}

inline SolveReport sample_report() {
  SolveReport report;
  report.model = {"a \"quoted\" name.stl", 12, {{-1, -2, -3}, {0.1, 1.0 / 3, 1e300}}, true, 2, "mm", "INCH"};
  report.faces = {{-2, FaceKind::kTagged, 0.25, {1, 2, 3}, 0, {}},
                  {7, FaceKind::kCone, 1.5, {4, 5, 6}, 1, 12}};
  report.degree = 3;
  report.resolution = 7.3;
  report.levels = {{2, 100, 50, 12, 0.1, 0.2}, {3, 1000, 500, 5, 1.0 / 7, 0.4}};
  report.energy = {1.25, 2.5, 3.75, 1e-13};
  report.alignment_deg = {0.5, 1.5, 2.5, 0.125};
  report.spectrum = {1, 2, 3, 4, 5};
  report.singularity = {
      .edges = 6,
      .length = 7.5,
      .arcs = 1,
      .nodes = 9,
      .boundary_ends = 10,
      .unresolved_loops = 11,
      .verdict = Verdict::kNotMeshable,
      .not_meshable_arcs = 12,
      .not_meshable_nodes = 13,
      .undecided_nodes = 14,
      .arc_list = {{SingularityGraph::ArcType::kChanging,
                    0,
                    Verdict::kNotMeshable,
                    1.25,
                    0.75,
                    true,
                    {1, 2, 1.0 / 3},
                    {0, 1}}},
      .node_list = {{{1, 2, 3}, true, Verdict::kMeshable, {0}}, {{4, 5, 6}, false, Verdict::kUndecided, {0}}},
      .crease_list = {{3, 265.5, 250, 1.5, 0.875, Verdict::kMeshable, {1, 2, 3}}},
      .corner_list = {{-2, {1, 3}, {5}, Verdict::kNotMeshable, {4, 5, 6}}}};
  report.coarser =
      SolveReport::Coarser{3.65, 1, 2, 3, Verdict::kUndecided, {{true, -0.25, {1, 2, 3}}, {false, 0.25, {}}}};
  report.answer = {
      Verdict::kNotMeshable,
      {{ReasonKind::kCorner, Verdict::kNotMeshable, 1, {4, 5, 6}, "a corner", Remedy::kUseResolution, 256},
       {ReasonKind::kUnfinished, Verdict::kUndecided, 0, {}, "unfinished", Remedy::kLetFinish, 0}}};
  report.walls = {4, 0.25, 0.125, 2.25, 1.5, 340, 11, 12};
  report.seconds = {0.1, 0.2, 0.3, 0.4, 1.5};
  report.peak_memory_bytes = 1;
  report.expected = Expectation{5, 0.125, 6.5, 100, 200, 1.75};
  report.limited = SolveReport::Limited{14.6, 300, 400};
  report.unfinished = SolveReport::Unfinished{14.6, 2, true};
  report.warnings = {{WarningKind::kThinWalls, "one", Remedy::kRaiseResolution},
                     {WarningKind::kSkippedData, {"a.vtk", "line 12", "two"}}};
  return report;
}

inline FieldData sample_data(Degree degree, int depth = 2) {
  FieldData data;
  data.degree = degree;
  data.tree = sample_tree(depth);
  const std::size_t count = data.tree.size();
  data.frames = random_frames(count, 5);
  std::mt19937 random(6);
  for (CellIndex i = 0; i < count; ++i) {
    unsigned open = 0;
    for (int face = 0; face < kFaceCount; ++face)
      open |= (data.tree.neighbour(i, face) != kNoCell ? 1u : 0u) << face;
    data.open_faces.push_back(static_cast<std::uint8_t>(open));
    data.on_boundary.push_back(random() & 1);
    data.energy_density.push_back(static_cast<float>(random()) * 1e-9f);
    data.alignment_deg.push_back(static_cast<float>(random()) * 1e-8f);
  }
  data.report = sample_report();
  return data;
}

inline FrameField field_of(FieldData data) {
  return FrameField(std::make_shared<const FieldData>(std::move(data)));
}

}  // namespace crossgrain

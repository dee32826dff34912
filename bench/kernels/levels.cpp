// SPDX-License-Identifier: Apache-2.0
#include "kernels/levels.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <random>
#include <utility>

#include "field/face_edges.hpp"
#include "field/solve_tuning.hpp"
#include "grid/open_faces.hpp"
#include "support/shapes.hpp"

namespace crossgrain::bench {
namespace {

/// Finest cells along the longest side of a part; gives some hundred thousand cells, more than any cache
/// holds.
constexpr int kResolution = 256;
constexpr int kCoarsestDepth = 4;
constexpr int kBoxAcross = 96;

constexpr double kBoxCellSize = 1;
constexpr double kStartTurn_rad = 0.1;

template <int D>
SweptField<D> swept(std::shared_ptr<const Connectivity> connectivity, CellForms<D> forms) {
  SweptField<D> field{{std::move(connectivity), std::move(forms)}, {}};
  std::mt19937_64 random(1);
  const auto deviate = [&] { return kStartTurn_rad * (0x1p-63 * static_cast<double>(random()) - 1); };
  std::vector<StoredQuaternion> frames(field.graph.size());
  for (StoredQuaternion& frame : frames)
    frame = to_stored(from_rotation_vector({deviate(), deviate(), deviate()}));
  field.start = state_of<D>(std::move(frames));
  return field;
}

std::shared_ptr<const Connectivity> connected(const GridLevel& level,
                                              std::span<const FaceNeighbours> neighbours,
                                              const LeafConnections& connections) {
  const double share = SolverTuning{}.diagonal_share;
  return std::make_shared<const Connectivity>(connectivity_of(level, neighbours, connections, share));
}

std::shared_ptr<const Connectivity> box_connectivity() {
  int depth = 0;
  while ((1 << depth) < kBoxAcross) ++depth;
  const std::int32_t width = std::int32_t{1} << (kMaxDepth - depth);
  std::vector<CellAddress> leaves;
  for (std::int32_t z = 0; z < kBoxAcross; ++z) {
    for (std::int32_t y = 0; y < kBoxAcross; ++y) {
      for (std::int32_t x = 0; x < kBoxAcross; ++x)
        leaves.emplace_back(GridPoint{x * width, y * width, z * width}, depth);
    }
  }
  std::sort(leaves.begin(), leaves.end());
  const GridLevel level =
      testing::interior_level({{{0, 0, 0}, kBoxCellSize * (1 << depth)}, std::move(leaves)});
  // No leaf holds surface, so the solid is not used.
  const testing::TestSolid any(make_box({1, 1, 1}));
  const std::vector<FaceNeighbours> neighbours = face_neighbours(level.tree);
  return connected(level, neighbours, connect_leaves(level, neighbours, any.solid()));
}

std::shared_ptr<const Connectivity> part_connectivity(Part part) {
  static std::array<std::shared_ptr<const Connectivity>, 2> made;
  auto& connectivity = made[static_cast<std::size_t>(part)];
  const PartLevel& level = part_level(part);
  if (!connectivity) connectivity = connected(level.level, level.neighbours, level.connections);
  return connectivity;
}

template <int D>
SweptField<D> make_part_field(Part part) {
  const PartLevel& level = part_level(part);
  return swept<D>(part_connectivity(part),
                  boundary_forms<D>(level.level, level.solid.solid(), SolverTuning{}.boundary_weight));
}

}  // namespace

PartLevel::PartLevel(TriangleMesh mesh) : solid(std::move(mesh)) {
  const Box& box = solid.surface().box;
  const GridFrame frame = frame_around(box, longest_side(box) / kResolution);
  RefinedLevel made = uniform_level(solid.solid(), frame.root, kCoarsestDepth);
  for (int depth = kCoarsestDepth; depth < frame.finest_depth; ++depth) {
    before = std::move(made.level);
    neighbours_before = std::move(made.neighbours);
    marks = refinement_marks(before, neighbours_before, solid.solid(), {}, 0, frame.finest_depth);
    made = refined(before, neighbours_before, solid.solid(), marks);
  }
  level = std::move(made.level);
  neighbours = std::move(made.neighbours);
  parent = std::move(made.parent);
  connections = connect_leaves(level, neighbours, solid.solid());
}

const PartLevel& part_level(Part part) {
  if (part == Part::kTorus) {
    static const PartLevel torus(make_torus(0.6, 0.25, 192, 96));
    return torus;
  }
  static const PartLevel bracket(make_bracket(64));
  return bracket;
}

template <int D>
const SweptField<D>& box_field() {
  static const std::shared_ptr<const Connectivity> connectivity = box_connectivity();
  static const SweptField<D> field = swept<D>(connectivity, CellForms<D>(connectivity->adjacency.size()));
  return field;
}

template <int D>
const SweptField<D>& part_field(Part part) {
  if (part == Part::kTorus) {
    static const SweptField<D> torus = make_part_field<D>(part);
    return torus;
  }
  static const SweptField<D> bracket = make_part_field<D>(part);
  return bracket;
}

template <int D>
ItemCost sweep_cost(const FieldGraph<D>& graph, double (*flops_of)(const CellKind&), SweptData changed) {
  struct Kind {
    double cells = 0, neighbours = 0;
  };
  std::array<std::array<Kind, 3>, 2> kinds;  // equal weights or not; no form, plane, general form
  ItemCost cost;
  for (std::size_t i = 0; i < graph.size(); ++i) {
    const auto row = graph.adjacency()[i];
    const bool plane = graph.forms.plane(i) != nullptr, general = graph.forms.general(i) != nullptr;
    Kind& kind = kinds[row.has_equal_weights() ? 1 : 0][general ? 2 : plane ? 1 : 0];
    kind.cells += 1;
    kind.neighbours += static_cast<double>(row.size());
    cost.bytes += plane ? sizeof(PlaneForm) : general ? sizeof(PackedForm<D>) : 0;
  }
  for (int equal = 0; equal < 2; ++equal) {
    for (int form = 0; form < 3; ++form) {
      const auto [cells, neighbours] = kinds[equal][form];
      if (cells > 0) cost.flops += cells * flops_of({neighbours / cells, equal == 1, form == 1, form == 2});
    }
  }
  const auto cells = static_cast<double>(graph.size());
  cost.flops /= cells;
  // Data of each cell: its position in the order, its form, and the state.
  cost.bytes = (cost.bytes + bytes_of(graph.adjacency())) / cells + 2 * sizeof(std::uint32_t) +
               2 * sizeof(StoredCoefficients<D>);
  if (changed == SweptData::kFramesAndCoefficients) cost.bytes += 2 * sizeof(StoredQuaternion);
  return cost;
}

double bytes_of(const GridLevel& level) {
  const auto leaves = static_cast<double>(level.size());
  return leaves * (sizeof(CellAddress) + sizeof(std::uint32_t) + sizeof(std::int8_t) + sizeof(CellIndex) +
                   sizeof(FaceNeighbours)) +
         static_cast<double>(level.pieces.size()) * sizeof(SurfacePiece);
}

double bytes_of(const LeafConnections& connections) {
  return static_cast<double>(connections.weights.size()) * sizeof(connections.weights[0]) +
         static_cast<double>(connections.open_faces.size());
}

double bytes_of(const Adjacency& adjacency) {
  return static_cast<double>(adjacency.bytes());
}

double sampled_pieces(const PartLevel& part) {
  const GridLevel& level = part.level;
  double pieces = 0;
  for (const WeightedEdge& edge : testing::face_edges(level, part.connections)) {
    if (level.holds_surface(edge.first) && level.holds_surface(edge.second))
      pieces += static_cast<double>(level.pieces_of(edge.first).size());
  }
  return pieces * kOpenFaceSamples;
}

ClippedPieces clipped_pieces(const PartLevel& part) {
  ClippedPieces result;
  for (CellIndex i = 0; i < part.before.size(); ++i) {
    if (part.marks[i]) result.tried += 8 * static_cast<double>(part.before.pieces_of(i).size());
  }
  for (CellIndex i = 0; i < part.level.size(); ++i) {
    if (part.marks[part.parent[i]]) result.kept += static_cast<double>(part.level.pieces_of(i).size());
  }
  return result;
}

template const SweptField<3>& box_field<3>();
template const SweptField<4>& box_field<4>();
template const SweptField<3>& part_field<3>(Part);
template const SweptField<4>& part_field<4>(Part);
template ItemCost sweep_cost<3>(const FieldGraph<3>&, double (*)(const CellKind&), SweptData);
template ItemCost sweep_cost<4>(const FieldGraph<4>&, double (*)(const CellKind&), SweptData);

}  // namespace crossgrain::bench

// SPDX-License-Identifier: Apache-2.0
#include "tet_making/netgen_program/vol_file.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace crossgrain {
namespace {

/// Columns of a row, from 0.
constexpr std::size_t kFaceNumber = 1, kFaceCorners = 4, kFaceFirst = 5;
constexpr std::size_t kTetDomain = 0, kTetCorners = 1, kTetFirst = 2;
constexpr std::size_t kEdgeFirst = 2, kEdgeNumber = 10;

/// Reads rows of numbers, as many as the line before them says.
class Rows {
 public:
  explicit Rows(std::istream& file) : file_(file) {}

  /// Calls take(numbers) for each row. Returns false if a row is missing or `take` returns false.
  template <class Take>
  bool read(const Take& take) const {
    std::string line;
    std::size_t count = 0;
    if (!std::getline(file_, line) || !(std::istringstream(line) >> count)) return false;
    std::vector<double> numbers;
    for (std::size_t k = 0; k < count; ++k) {
      if (!std::getline(file_, line)) return false;
      numbers.clear();
      std::istringstream row(line);
      for (double number; row >> number;) numbers.push_back(number);
      if (!take(numbers)) return false;
    }
    return true;
  }

 private:
  std::istream& file_;
};

/// Reads vertices, which count from 1, into `out`.
template <std::size_t N>
bool take_vertices(const std::vector<double>& row, std::size_t first, std::array<std::uint32_t, N>& out) {
  if (row.size() < first + N) return false;
  for (std::size_t k = 0; k < N; ++k) {
    if (!(row[first + k] >= 1 && row[first + k] < UINT32_MAX)) return false;
    out[k] = static_cast<std::uint32_t>(row[first + k]) - 1;
  }
  return true;
}

bool take_face(const std::vector<double>& row, TetMesh& mesh) {
  TetMesh::Face face{};
  if (!take_vertices(row, kFaceFirst, face.vertices) || row[kFaceCorners] != 3) return false;
  face.tag = static_cast<std::int32_t>(row[kFaceNumber]);
  mesh.feature_faces.push_back(face);
  return true;
}

bool take_tet(const std::vector<double>& row, TetMesh& mesh) {
  std::array<std::uint32_t, 4> tet;
  if (!take_vertices(row, kTetFirst, tet) || row[kTetCorners] != 4) return false;
  mesh.tets.push_back(tet);
  mesh.regions.push_back(static_cast<std::int32_t>(row[kTetDomain]));
  return true;
}

bool take_edge(const std::vector<double>& row, std::set<std::array<std::uint32_t, 2>>& seen, TetMesh& mesh) {
  TetMesh::Edge edge{};
  if (row.size() <= kEdgeNumber || !take_vertices(row, kEdgeFirst, edge.vertices)) return false;
  edge.tag = static_cast<std::int32_t>(row[kEdgeNumber]);
  edge.is_stated = false;
  const auto [low, high] = std::minmax(edge.vertices[0], edge.vertices[1]);
  if (seen.insert({low, high}).second) mesh.feature_edges.push_back(edge);
  return true;
}

}  // namespace

std::optional<TetMesh> tets_of_vol_file(std::istream& file) {
  TetMesh mesh;
  std::set<std::array<std::uint32_t, 2>> edges;
  const Rows rows(file);
  bool is_sound = true, is_complete = false;
  std::string line;
  while (is_sound && std::getline(file, line)) {
    if (line.starts_with("surfaceelements")) {
      is_sound = rows.read([&](const auto& row) { return take_face(row, mesh); });
    } else if (line.starts_with("volumeelements")) {
      is_sound = rows.read([&](const auto& row) { return take_tet(row, mesh); });
    } else if (line.starts_with("edgesegmentsgi2")) {
      is_sound = rows.read([&](const auto& row) { return take_edge(row, edges, mesh); });
    } else if (line.starts_with("points")) {
      is_complete = true;
      is_sound = rows.read([&](const auto& row) {
        if (row.size() == 3) mesh.vertices.push_back({row[0], row[1], row[2]});
        return row.size() == 3;
      });
    }
  }
  if (!is_sound || !is_complete) return std::nullopt;
  return mesh;
}

}  // namespace crossgrain

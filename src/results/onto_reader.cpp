// SPDX-License-Identifier: Apache-2.0
#include "results/onto_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "results/one_solve.hpp"
#include "results/result_files.hpp"
#include "results/solve_id.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tet_field.hpp"
#include "tets/tet_solid.hpp"
#include "text/text_scanner.hpp"
#include "vtu/array_names.hpp"
#include "vtu/vtu_reader.hpp"

namespace crossgrain {
namespace {

/// Tolerance of orthonormal axes in single precision.
constexpr double kAxesTolerance = 1e-5;

[[noreturn]] void fail_damaged(const std::filesystem::path& path) {
  throw Error(ErrorKind::kInput,
              {path.string(), "", "is damaged or was not written by crossgrain", Remedy::kSolveAgain});
}

bool are_orthonormal(const std::array<Vector3, 3>& axes) {
  for (std::size_t a = 0; a < 3; ++a) {
    for (std::size_t b = a; b < 3; ++b) {
      // Negated, so that NaN fails too.
      if (!(std::abs(dot(axes[a], axes[b]) - (a == b ? 1 : 0)) < kAxesTolerance)) return false;
    }
  }
  return dot(cross(axes[0], axes[1]), axes[2]) > 0;
}

template <class Index>
void read_corners(const VtuFile& file, std::vector<std::array<std::uint32_t, 4>>& tets) {
  const std::vector<Index> corners = file.read<Index>(VtuSection::kCells, "connectivity", 1);
  tets.resize(corners.size() / 4);
  for (std::size_t k = 0; k < 4 * tets.size(); ++k) {
    if (corners[k] < 0 || static_cast<std::size_t>(corners[k]) >= file.points()) fail_damaged(file.name());
    tets[k / 4][k % 4] = static_cast<std::uint32_t>(corners[k]);
  }
}

TetMesh read_mesh(const VtuFile& file) {
  TetMesh mesh;
  // Too large coordinates are refused when the tets are prepared.
  mesh.vertices = file.read_points(INFINITY);
  if (file.has_wide_indices())
    read_corners<std::int64_t>(file, mesh.tets);
  else
    read_corners<std::int32_t>(file, mesh.tets);
  if (mesh.tets.size() != file.cells()) fail_damaged(file.name());
  if (file.find(VtuSection::kCellData, field_arrays::kRegion))
    mesh.regions = file.read<std::int32_t>(VtuSection::kCellData, field_arrays::kRegion, 1);
  return mesh;
}

/// Written tets form a valid solid, so an error means that the file is damaged.
TetDomain domain_in(const std::filesystem::path& path) {
  TetMesh mesh = read_mesh(VtuFile(path));
  const std::size_t tets = mesh.tets.size();
  try {
    TetDomain domain(std::move(mesh), {.keep_all = true});
    if (domain.mesh().tets.size() == tets) return domain;
  } catch (const Error&) {
  }
  fail_damaged(path);
}

std::vector<Quaternion> read_vertex_frames(const std::filesystem::path& path, std::size_t vertices,
                                           const SolveReport& report) {
  const InputFile file(path);
  check_listed_bytes(path, file.bytes(), report);
  TextScanner scanner(file, {});
  std::vector<Quaternion> frames;
  frames.reserve(vertices);
  while (frames.size() < vertices) {
    std::array<Vector3, 3> axes;
    for (Vector3& axis : axes)
      for (double& number : axis) number = scanner.number(scanner.word_anywhere(), "an axis");
    if (!are_orthonormal(axes)) fail_damaged(path);
    frames.push_back(quaternion_of(axes));
  }
  if (!scanner.word_anywhere().empty()) fail_damaged(path);
  return frames;
}

void read_repair(const VtuFile& file, const std::filesystem::path& path, OntoTets& tets) {
  const std::vector<double> frames = file.read<double>(VtuSection::kCellData, field_arrays::kTetFrame, 4);
  const std::vector<std::int8_t> axes =
      file.read<std::int8_t>(VtuSection::kCellData, field_arrays::kMatching, 12);
  tets.axes_behind_faces.resize(tets.frames.size());
  for (std::size_t t = 0; t < tets.frames.size(); ++t) {
    tets.frames[t] = {frames[4 * t], frames[4 * t + 1], frames[4 * t + 2], frames[4 * t + 3]};
    if (!are_orthonormal(axes_of(tets.frames[t]))) fail_damaged(path);
    std::copy_n(axes.begin() + static_cast<std::ptrdiff_t>(12 * t), 12, tets.axes_behind_faces[t].begin());
  }
}

/// The matchings across the inner faces; empty if the field is not repaired.
std::vector<CubeRotation> matchings_of(const OntoTets& tets, const TetSolid& solid,
                                       const std::filesystem::path& path) {
  if (tets.axes_behind_faces.empty()) return {};
  auto matchings = matchings_in(solid, tets.axes_behind_faces);
  if (!matchings) fail_damaged(path);
  return *std::move(matchings);
}

}  // namespace

OntoTets read_onto_tets(const std::filesystem::path& path) {
  const VtuFile file(path);
  OntoTets tets{read_mesh(file), {}, {}};
  std::array<std::vector<float>, 3> axes;
  for (std::size_t k = 0; k < 3; ++k)
    axes[k] = file.read<float>(VtuSection::kCellData, std::array{"axis_u", "axis_v", "axis_w"}[k], 3);
  tets.frames.resize(tets.mesh.tets.size());
  for (std::size_t t = 0; t < tets.frames.size(); ++t) {
    std::array<Vector3, 3> frame;
    for (std::size_t k = 0; k < 3; ++k) frame[k] = {axes[k][3 * t], axes[k][3 * t + 1], axes[k][3 * t + 2]};
    if (!are_orthonormal(frame)) fail_damaged(path);
    tets.frames[t] = quaternion_of(frame);
  }
  if (file.find(VtuSection::kCellData, field_arrays::kMatching)) read_repair(file, path, tets);
  return tets;
}

namespace {

std::optional<TetFrameField> read_any_tet_field(const std::filesystem::path& folder) {
  const std::filesystem::path grid_path = folder / kTetGridFile;
  if (!may_exist(grid_path)) return std::nullopt;
  FrameField grid = read_field(folder);
  TetDomain domain = domain_in(grid_path);
  auto field = std::make_shared<TetField>();
  SolveReport report = grid.report();
  field->vertex_frames = read_vertex_frames(folder / kTetFramesFile, domain.mesh().vertices.size(), report);
  const TetSolid& solid = domain.data().solid;
  OntoTets tets = read_onto_tets(grid_path);
  field->matchings = matchings_of(tets, solid, grid_path);
  if (!solid.inner_faces.empty() && field->is_repaired() != (report.onto && report.onto->repair))
    fail_damaged(grid_path);
  field->tet_frames =
      field->is_repaired() ? std::move(tets.frames) : tet_frames_of(domain.mesh(), field->vertex_frames);
  return TetFrameField(std::move(grid), std::move(domain), std::move(field), std::move(report));
}

}  // namespace

std::optional<TetFrameField> read_tet_field(const std::filesystem::path& folder) {
  return read_one_solve(folder, [&] { return read_any_tet_field(folder); });
}

std::optional<SingularityGraph> read_onto_singularities(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kTetGridFile;
  if (!may_exist(path)) return std::nullopt;
  const OntoTets tets = read_onto_tets(path);
  std::vector<Warning> warnings;
  const std::size_t count = tets.mesh.tets.size();
  try {
    const TetSolid solid = prepare_tets(tets.mesh, warnings);
    if (solid.mesh.tets.size() != count) fail_damaged(path);
    return graph_of(solid, {{}, tets.frames, matchings_of(tets, solid, path)});
  } catch (const Error&) {
    // Written tets form a valid solid.
    fail_damaged(path);
  }
}

}  // namespace crossgrain

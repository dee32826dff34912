// SPDX-License-Identifier: Apache-2.0
#include "io/onto_files.hpp"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <vector>

#include "analysis/orthonormal_frame.hpp"
#include "base/parallel.hpp"
#include "crossgrain/io.hpp"
#include "io/field_arrays.hpp"
#include "io/field_file.hpp"
#include "io/frame_lines.hpp"
#include "io/singularity_file.hpp"
#include "io/vtu_arrays.hpp"
#include "io/vtu_writer.hpp"
#include "tets/inner_walls.hpp"

namespace crossgrain {
namespace {

constexpr const char* kFramesFile = kOntoFiles[0];
constexpr const char* kGridFile = kOntoFiles[1];
constexpr const char* kSingularityFile = kOntoFiles[2];

/// Frames made into text between two looks at the monitor: some 10 MB.
constexpr std::size_t kFramesAtOnce = 1 << 16;

void write_frames(OutputFile& file, const std::vector<Quaternion>& quaternions, const Monitor& monitor) {
  std::vector<Frame> frames;
  for (std::size_t begin = 0; begin < quaternions.size(); begin += kFramesAtOnce) {
    monitor.check();
    frames.resize(std::min(kFramesAtOnce, quaternions.size() - begin));
    parallel_for(frames.size(),
                 [&](std::size_t i) { frames[i] = orthonormal_frame(quaternions[begin + i]); });
    write_frame_lines(file, frames);
  }
  file.finish();
}

template <class Index>
void add_tets(const TetMesh& mesh, std::vector<VtuArray>& arrays) {
  arrays.push_back(vtu_array<Index>(
      VtuSection::kCells, "connectivity", 1, 4 * mesh.tets.size(),
      [&mesh](std::size_t begin, std::size_t end, Index* out) {
        for (std::size_t i = begin; i < end; ++i) *out++ = static_cast<Index>(mesh.tets[i / 4][i % 4]);
      },
      VtuPacking::kSingleBytes));
  constexpr std::uint8_t kVtkTetra = 10;
  add_uniform_cells<Index>(mesh.tets.size(), 4, kVtkTetra, arrays);
}

void add_mesh(const TetMesh& mesh, std::vector<VtuArray>& arrays) {
  arrays.push_back(vtu_array<double>(
      VtuSection::kPoints, "Points", 3, mesh.vertices.size(),
      [&mesh](std::size_t begin, std::size_t end, double* out) {
        for (std::size_t i = begin; i < end; ++i, out += 3) std::ranges::copy(mesh.vertices[i], out);
      },
      VtuPacking::kMeasured));
  if (fits_32_bits(mesh.vertices.size(), 4 * mesh.tets.size()))
    add_tets<std::int32_t>(mesh, arrays);
  else
    add_tets<std::int64_t>(mesh, arrays);
}

void write_grid(OutputFile& file, const TetMesh& mesh, const TetField& onto, const Monitor& monitor) {
  std::vector<VtuArray> arrays;
  add_axes(
      VtuSection::kPointData, onto.vertex_frames.size(),
      [&onto](std::size_t i) { return onto.vertex_frames[i]; }, arrays);
  add_axes(
      VtuSection::kCellData, onto.tet_frames.size(), [&onto](std::size_t i) { return onto.tet_frames[i]; },
      arrays);
  if (has_several_regions(mesh))
    arrays.push_back(stored_array(VtuSection::kCellData, field_arrays::kRegion, mesh.regions));
  add_mesh(mesh, arrays);
  watch(arrays, monitor);
  write_vtu(file, mesh.vertices.size(), mesh.tets.size(), arrays);
  file.finish();
}

}  // namespace

SolveReport write_field_onto(const FrameField& field, SolveReport report, const TetMesh& mesh,
                             const TetField& onto, const std::filesystem::path& folder,
                             const Monitor& monitor, const OutputOptions& options) {
  assert(onto.vertex_frames.size() == mesh.vertices.size() && onto.tet_frames.size() == mesh.tets.size());
  return write_field_and(field, std::move(report), folder, monitor, options, [&](OutputFolder& output) {
    write_frames(output.create(kFramesFile), onto.vertex_frames, monitor);
    write_grid(output.create(kGridFile), mesh, onto, monitor);
    write_singularities(onto.singularities, output.create(kSingularityFile), monitor);
  });
}

SolveReport write_field(const TetFrameField& field, SolveReport report, const std::filesystem::path& folder,
                        const Monitor& monitor, const OutputOptions& options) {
  return write_field_onto(field.grid(), std::move(report), field.domain().mesh(), field.data(), folder,
                          monitor, options);
}

SolveReport write_field(const TetFrameField& field, const std::filesystem::path& folder,
                        const Monitor& monitor, const OutputOptions& options) {
  return write_field(field, field.report(), folder, monitor, options);
}

void check_onto_folder(const std::filesystem::path& folder) {
  check_field_folder(folder);
  check_writable(folder, {kFramesFile, kGridFile, kSingularityFile});
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "results/tet_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "crossgrain/writing.hpp"
#include "mesh_files/hex/hex_writers.hpp"
#include "mesh_files/hex/map_writers.hpp"
#include "results/result_files.hpp"

namespace crossgrain {
namespace {

constexpr bool kAlways = true, kOnDemand = false;
constexpr bool kOfTets = true, kOfOthers = false;
constexpr bool kOfMap = true, kOfField = false;

void write_grid_hexex(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_hexex(file, *output.map, output.map->integer_grid, monitor);
}

void write_seamless_hexex(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_hexex(file, *output.map, output.map->seamless, monitor);
}

void write_map_grid(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  write_vtu_map(file, *output.map, monitor);
}

constexpr std::array kFiles = {
    TetFile{"frames", kTetFramesFile, "axes of each vertex, nine numbers a line", kAlways, kOfOthers,
            kOfField, write_vertex_axes},
    TetFile{"vtu", kTetGridFile, "tets with axes on vertices and tets, for ParaView", kAlways, kOfOthers,
            kOfField, write_tet_grid},
    TetFile{"singularities", kTetSingularityFile, "singular lines of the tets, for ParaView", kAlways,
            kOfOthers, kOfField, write_tet_singularities},
    TetFile{"mesh", "onto.mesh", "the tets of the frames, for CubeCover, mouette and gmsh", kOnDemand,
            kOfOthers, kOfField, write_medit},
    TetFile{"fra", "onto.fra", "axes of each tet, for CubeCover and Mint", kOnDemand, kOfTets, kOfField,
            write_fra},
    TetFile{"perm", "onto.perm", "matchings across faces, for CubeCover", kOnDemand, kOfTets, kOfField,
            write_perm},
    TetFile{"frame", "onto.frame", "axes of each tet, for mouette", kOnDemand, kOfTets, kOfField,
            write_frame},
    TetFile{"quaternions", "onto_vertices.quaternions", "unit quaternions of vertices and of tets", kOnDemand,
            kOfOthers, kOfField, write_vertex_quaternions},
    TetFile{"quaternions", "onto_tets.quaternions", "", kOnDemand, kOfTets, kOfField, write_tet_quaternions},
    TetFile{"features", "onto_features.vtu", "tagged edges and triangles, for ParaView", kOnDemand, kOfOthers,
            kOfField, write_feature_grid},
    TetFile{"hexex", "hexahedra.hexex", "the map of hexahedra, for libHexEx", kOnDemand, kOfOthers, kOfMap,
            write_grid_hexex},
    TetFile{"hexex", "hexahedra_seamless.hexex", "", kOnDemand, kOfOthers, kOfMap, write_seamless_hexex},
    TetFile{"map", "hexahedra_map.vtu", "the map of hexahedra before and after rounding, for ParaView",
            kOnDemand, kOfOthers, kOfMap, write_map_grid},
};

bool contains(const std::vector<std::string>& formats, const std::string& name) {
  return std::find(formats.begin(), formats.end(), name) != formats.end();
}

}  // namespace

std::span<const TetFile> tet_files() {
  return kFiles;
}

bool is_asked_for(const TetFile& file, const std::vector<std::string>& formats) {
  return file.is_always_written || contains(formats, file.format);
}

std::vector<OutputFormat> output_formats() {
  std::vector<OutputFormat> formats;
  for (const TetFile& file : kFiles) {
    if (formats.empty() || formats.back().name != file.format)
      formats.push_back({file.format, file.description, {}, file.is_always_written, file.is_of_map});
    formats.back().files.push_back(file.name);
  }
  return formats;
}

std::vector<std::string> result_files(const OutputOptions& options, bool on_tets) {
  std::vector<std::string> names;
  if (options.companion) names.push_back(options.companion->name);
  names.insert(names.end(), {kCellsFile, kSingularityFile, kSurfaceFile});
  for (const TetFile& file : kFiles)
    if (on_tets && is_asked_for(file, options.formats)) names.push_back(file.name);
  for (std::string& name : hexahedra_files(options)) names.push_back(std::move(name));
  names.push_back(kReportFile);
  return names;
}

std::vector<std::string> hexahedra_files(const OutputOptions& options) {
  if (!options.hexahedra) return {};
  const auto inverted =
      options.inverted_hexahedra ? InvertedHexahedra::kAllowed : InvertedHexahedra::kRefused;
  return hexahedra_file_names(hex_files_of(*options.hexahedra, inverted));
}

std::vector<std::string> result_files(OutputOptions options, const SolveReport& report) {
  options.hexahedra.reset();
  std::vector<std::string> names = result_files(options, report.onto.has_value());
  if (!report.hexahedra) return names;
  const HexReport& hexahedra = *report.hexahedra;
  const bool for_display_only = hexahedra.quality.inverted > 0 && !options.inverted_hexahedra;
  for (std::string& name :
       hexahedra_file_names({is_partial(hexahedra.outcome), for_display_only, hexahedra.hexahedra == 0}))
    names.insert(names.end() - 1, std::move(name));
  return names;
}

std::vector<std::string> all_result_files() {
  std::vector<std::string> names{kPageFile,        kStreamlinesFile, kCellsFile, kPiecesFile,
                                 kSingularityFile, kSurfaceFile,     kReportFile};
  for (const TetFile& file : kFiles) names.push_back(file.name);
  for (std::string& name : all_hexahedra_file_names()) names.push_back(std::move(name));
  return names;
}

void check_formats(const std::vector<std::string>& formats) {
  std::vector<std::string> names;
  for (const OutputFormat& format : output_formats()) names.push_back(format.name);
  for (const std::string& name : formats) {
    if (!contains(names, name))
      throw Error(ErrorKind::kUsage,
                  fmt::format("'{}' is not a format; choose from {}", name, fmt::join(names, ", ")));
  }
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <set>
#include <string>

#include "commands.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/tet_making.hpp"
#include "crossgrain/thread_limit.hpp"
#include "crossgrain/writing.hpp"
#include "interruption.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "output_places.hpp"
#include "progress_lines.hpp"

namespace crossgrain::app {
namespace {

template <class Features>
std::size_t tags_in(const Features& features) {
  std::set<std::int32_t> tags;
  for (const auto& feature : features) tags.insert(feature.tag);
  return tags.size();
}

/// "19 patches", of a CAD file or a surface with numbers "19 faces".
std::string faces_text(const TetMesh& mesh) {
  const bool are_patches =
      mesh.given && !mesh.given->faces.empty() && mesh.given->faces.front().kind == FaceKind::kPatch;
  const std::size_t count = tags_in(mesh.feature_faces);
  return are_patches ? counted(count, "patch", "patches") : counted(count, "face");
}

std::string summary_of(const TetMesh& mesh, double seconds, const std::string& output) {
  const TetQuality quality = quality_of(mesh);
  const auto creases =
      static_cast<std::size_t>(std::count_if(mesh.feature_edges.begin(), mesh.feature_edges.end(),
                                             [](const TetMesh::Edge& edge) { return edge.is_stated; }));
  const std::set<std::int32_t> regions(mesh.regions.begin(), mesh.regions.end());
  return fmt::format("tets       {} on {}, in {}\n", mesh.tets.size(),
                     counted(mesh.vertices.size(), "vertex", "vertices"), counted(regions.size(), "region")) +
         fmt::format("shape      mean ratio {:.3g} at worst, {:.3g} in the mean\n", quality.worst,
                     quality.mean) +
         fmt::format("surface    {} of {}, {} on creases\n", counted(mesh.feature_faces.size(), "triangle"),
                     faces_text(mesh), counted(creases, "edge")) +
         fmt::format("time       {:.3g} s\nresult     {}\n", seconds, output);
}

}  // namespace

void run_tets(const TetsArguments& arguments) {
  const auto start = std::chrono::steady_clock::now();
  if (!arguments.is_output_named) check_output_file(arguments.output);
  check_tets_output(arguments.output);
  const ThreadLimit limit(arguments.threads);
  TetMesh mesh;
  {
    ProgressLines lines(arguments.progress, arguments.quiet);
    Monitor monitor([&lines](const Progress& progress) { lines.show(progress); }, {},
                    [&](const ModelSummary& model) {
                      if (arguments.quiet) return;
                      lines.tell(model);
                      print_result(row("model", sentence_of(model)));
                    });
    const Interruption interruption(monitor, lines.is_moving());
    mesh = make_tets(std::filesystem::path(arguments.model), arguments.options, monitor);
    monitor.report({Phase::kWrite, 0, 0, 0, 0});
    write_tets(mesh, arguments.output, monitor);
    lines.end_line();
  }
  for (Warning warning : mesh.warnings) {
    if (warning.file.empty()) warning.file = arguments.model;
    print_message("warning: " + line_of(warning, Command::kTets));
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  if (!arguments.quiet) print_result(summary_of(mesh, seconds.count(), arguments.output));
}

}  // namespace crossgrain::app

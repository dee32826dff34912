// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hex_fit.hpp"

#include <fmt/format.h>

#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/system_memory.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex/model_fit.hpp"
#include "hex/model_fitting.hpp"
#include "meshing/read_model.hpp"
#include "meshing/shown_surface.hpp"
#include "surface/model_faces.hpp"

namespace crossgrain {
namespace {

/// Says so of faces between regions that have moved.
std::optional<Warning> moved_interfaces(const HexMesh& mesh, const HexReport& report) {
  const std::set<std::int32_t> regions(mesh.regions.begin(), mesh.regions.end());
  if (regions.size() < 2 || report.best_fit == 0) return std::nullopt;
  return Warning(
      WarningKind::kCrossedInterfaces,
      fmt::format("faces between the {} regions of the mesh have moved with the vertices inside, and "
                  "lie on no face of the model",
                  regions.size()));
}

template <class Read>
FittedHexahedra fitted_to(const HexMesh& mesh, const Read& read, const HexFitOptions& options,
                          const Monitor& monitor) {
  const ThreadLimit threads(options.threads);
  const ReadLimits limits(monitor, options.max_memory_bytes);
  const WatchedLoops watched(monitor, Stops::kIgnored, options.max_memory_bytes);
  Stopwatch stopwatch;
  check_fittable(mesh);
  monitor.report({Phase::kRead, 0, 0, 0, 0});
  ReadModel model = read();
  if (options.on_warning)
    for (const Warning& warning : model.warnings) options.on_warning(warning);
  check_same_place(mesh, model.model);
  FittedHexahedra fitted{mesh, {}, shown_surface(model.model.features)};
  SolveReport& report = fitted.report;
  report.model = std::move(model.description);
  report.faces = std::move(model.faces);
  report.warnings = mesh.warnings;
  report.warnings.insert(report.warnings.end(), model.warnings.begin(), model.warnings.end());
  report.seconds.read = stopwatch.restart();
  fitted.mesh.unit = report.model.unit;
  fitted.mesh.warnings.clear();
  const double edge = median_edge(mesh);
  report.hexahedra =
      fit_to_model(model.model, {edge, edge}, FitWays::kAll, monitor, fitted.mesh, report.warnings);
  count_quads(fitted.mesh, report.faces);
  for (auto& warning : {faces_without_quads(report.faces, model.model.solid, *report.hexahedra),
                        faces_off(report.faces, *report.hexahedra)})
    if (warning) report.warnings.push_back(*warning);
  if (auto moved = moved_interfaces(fitted.mesh, *report.hexahedra))
    report.warnings.push_back(*std::move(moved));
  report.answer.is_meshed = true;
  report.seconds.total = report.seconds.read + stopwatch.restart();
  report.peak_memory_bytes = peak_memory_bytes();
  return fitted;
}

}  // namespace

FittedHexahedra fit_hexahedra(const HexMesh& mesh, const std::filesystem::path& model,
                              const HexFitOptions& options, const Monitor& monitor) {
  const auto read = [&] { return read_model(model, options, monitor); };
  FittedHexahedra fitted = fitted_to(mesh, read, options, monitor);
  fitted.report.model.path = model.string();
  return fitted;
}

FittedHexahedra fit_hexahedra(const HexMesh& mesh, const TriangleMesh& surface, const HexFitOptions& options,
                              const Monitor& monitor) {
  return fitted_to(
      mesh, [&] { return model_of(surface, options); }, options, monitor);
}

}  // namespace crossgrain

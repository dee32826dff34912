// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/hex_meshing.hpp"

#include <memory>
#include <utility>

#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/thread_limit.hpp"
#include "hex/hex_making.hpp"
#include "meshing/asked_hexahedra.hpp"
#include "meshing/made_tets.hpp"
#include "meshing/read_model.hpp"

namespace crossgrain {
namespace {

/// Makes all attempts. `begin` is that of `best_of_attempts`; it checks what is asked for, and returns
/// seconds of making tets.
template <class Begin>
Hexahedra made_by_attempts(const Begin& begin, const HexMeshingOptions& options, const HexTuning& tuning,
                           const Monitor& monitor) {
  if (!options.solve.constraints.empty())
    throw Error(ErrorKind::kUsage,
                {"", "hexahedra", "their field takes no constraints, which a repair would leave"});
  const ThreadLimit limit(options.solve.threads);
  const WatchedLoops watched(monitor, Stops::kIgnored, options.solve.max_memory_bytes);
  Stopwatch stopwatch;
  double tet_seconds = 0;
  AskedHexahedra asked(options);
  const auto begin_heard = [&](AttemptQueue& queue) {
    queue.hear_ends(options.on_attempt_end);
    tet_seconds = begin(queue, asked);
  };
  Hexahedra made = best_of_attempts(begin_heard, options.hexahedra, tuning, monitor);
  SolveReport report = made.field.report();
  report.warnings.insert(report.warnings.begin(), asked.warnings().begin(), asked.warnings().end());
  for (const HexAttempt& attempt : report.hexahedra->attempts) tet_seconds += attempt.tet_seconds;
  report.seconds.read = tet_seconds;
  report.seconds.total = stopwatch.restart();
  made.field = made.field.with_report(std::move(report));
  return made;
}

/// Returns hexahedra in the tets that `make` gives.
template <class Make>
Hexahedra in_tets(const Make& make, const HexMeshingOptions& options, const Monitor& monitor) {
  const auto begin = [&](AttemptQueue& queue, AskedHexahedra& asked) {
    Stopwatch stopwatch;
    const TetDomain domain = make();
    asked.check(SearchableSurface(prepare_surface(domain.boundary())));
    const double seconds = stopwatch.restart();
    queue.start_on(solved_on(domain, options, queue));
    return seconds;
  };
  return made_by_attempts(begin, options, HexTuning(), monitor);
}

}  // namespace

Hexahedra hexahedra_in_tets_of(const MakeTets& make, const HexMeshingOptions& options,
                               const MeshingTuning& tuning, const Monitor& monitor) {
  const auto begin = [&](AttemptQueue& queue, AskedHexahedra& asked) {
    queue.add(std::make_unique<MadeTets>(make, options, tuning, asked));
    return 0.0;
  };
  return made_by_attempts(begin, options, tuning.hexahedra, monitor);
}

Hexahedra make_hexahedra(const std::filesystem::path& model, const HexMeshingOptions& options,
                         const Monitor& monitor) {
  try {
    if (!is_tet_file(model))
      return hexahedra_in_tets_of(
          [&](const auto& making, const Monitor& part) { return make_tets(model, making, part); }, options,
          MeshingTuning(), monitor);
    check_no_defeature(options.tets.defeature);
    const auto read = [&] {
      TetMesh mesh = read_tets(model);
      if (options.tets.unit != LengthUnit::kUnknown) mesh.unit = name_of(options.tets.unit);
      monitor.tell(summary_of(mesh));
      return mesh;
    };
    return in_tets([&] { return domain_of(read, options, true, monitor); }, options, monitor);
  } catch (const Error& error) {
    throw named(error, model);
  }
}

Hexahedra make_hexahedra(const TriangleMesh& surface, const HexMeshingOptions& options,
                         const Monitor& monitor) {
  return hexahedra_in_tets_of(
      [&](const auto& making, const Monitor& part) { return make_tets(surface, making, part); }, options,
      MeshingTuning(), monitor);
}

Hexahedra make_hexahedra(const TetDomain& tets, const HexMeshingOptions& options, const Monitor& monitor) {
  return in_tets([&] { return prepared(tets, options); }, options, monitor);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "tet_making/tet_program.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <string.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "base/required_memory.hpp"
#include "tets/tet_shape.hpp"
#include "tets/tet_solid.hpp"

namespace crossgrain {
namespace {

constexpr std::array kFaults{WarningKind::kRepeatedTets, WarningKind::kFlatTets,
                             WarningKind::kOverlappingTets, WarningKind::kStrayTags};

void drop_unused_vertices(TetMesh& mesh) {
  std::vector<std::uint32_t> new_index(mesh.vertices.size(), UINT32_MAX);
  for (const auto& tet : mesh.tets)
    for (const std::uint32_t vertex : tet) new_index[vertex] = 0;
  std::vector<Vector3> kept;
  for (std::size_t v = 0; v < new_index.size(); ++v) {
    if (new_index[v] == UINT32_MAX) continue;
    new_index[v] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(mesh.vertices[v]);
  }
  const auto is_unused = [&](const auto& feature) {
    return std::any_of(feature.vertices.begin(), feature.vertices.end(),
                       [&](std::uint32_t v) { return new_index[v] == UINT32_MAX; });
  };
  std::erase_if(mesh.feature_edges, is_unused);
  std::erase_if(mesh.feature_faces, is_unused);
  const auto renumber = [&](auto& vertices) {
    for (std::uint32_t& v : vertices) v = new_index[v];
  };
  for (auto& tet : mesh.tets) renumber(tet);
  for (TetMesh::Edge& edge : mesh.feature_edges) renumber(edge.vertices);
  for (TetMesh::Face& face : mesh.feature_faces) renumber(face.vertices);
  mesh.vertices = std::move(kept);
}

}  // namespace

bool is_near_its_limit(const HelperRun& run, const HelperOutcome& outcome) {
  constexpr std::size_t kShare = 2;
  if (may_lack_addresses(outcome)) return true;
  return run.max_memory_bytes > 0 &&
         outcome.peak_memory_bytes >= (run.max_memory_bytes + kHelperProgramBytes) / kShare;
}

TetFailure out_of_memory(const std::string& what, const HelperOutcome& outcome, std::size_t allowed) {
  if (may_lack_addresses(outcome))
    return {words_of_lacking_addresses(what), ErrorKind::kLimit, Remedy::kTakeLargerTets};
  return {fmt::format("{} needs more than the {:.3g} GB of memory that it may take", what,
                      static_cast<double>(allowed) / 1e9),
          ErrorKind::kLimit, Remedy::kAllowMemory};
}

HelperOutcome run_tet_program(const HelperRun& run, const std::string& what, const PrivateFolder& folder,
                              const Monitor& monitor) {
  using End = HelperOutcome::End;
  HelperOutcome outcome;
  try {
    outcome = run_helper(run, monitor);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again)
      throw TetFailure{
          "the system starts no more processes, and tets are made in one; end some, or raise their limit "
          "(ulimit -u)",
          ErrorKind::kLimit, Remedy::kNone};
    throw TetFailure{fmt::format("{} cannot be started: {}", run.program.string(), error.code().message()),
                     ErrorKind::kInput, Remedy::kInstallTetMaker};
  }
  // Its processor time is limited too.
  const bool is_late =
      outcome.end == End::kTimedOut || (outcome.end == End::kKilled && outcome.number == SIGXCPU);
  if (is_late)
    throw TetFailure{fmt::format("{} did not finish within {:.3g} s and was stopped", what, run.seconds),
                     ErrorKind::kLimit, Remedy::kAllowTetTime};
  if (outcome.end == End::kKilled && outcome.number == SIGKILL)
    throw TetFailure{fmt::format("the system stopped {}, usually because memory ran out", what),
                     ErrorKind::kLimit, Remedy::kTakeLargerTets};
  const bool has_crashed =
      outcome.end == End::kKilled &&
      (outcome.number == SIGABRT || outcome.number == SIGSEGV || outcome.number == SIGBUS);
  if (has_crashed && is_near_its_limit(run, outcome))
    throw out_of_memory(what, outcome, run.max_memory_bytes);
  if (outcome.end == End::kKilled && outcome.number == SIGXFSZ)
    folder.fail("the file is larger than allowed");
  if (outcome.end == End::kKilled)
    throw TetFailure{fmt::format("{} crashed on it ({})", what, ::strsignal(outcome.number))};
  if (outcome.end == End::kTooLong || outcome.end == End::kLost)
    throw TetFailure{fmt::format("{} gave no answer", what)};
  if (folder.is_full()) folder.fail("no space left");
  return outcome;
}

TetMesh checked_tets(TetMesh mesh, const std::string& program) {
  if (mesh.tets.empty()) throw TetFailure{fmt::format("{} makes no tets of it", program)};
  drop_unused_vertices(mesh);
  for (auto& tet : mesh.tets)
    if (shape_of_tet(mesh.vertices, tet) == TetShape::kInverted) std::swap(tet[2], tet[3]);
  std::vector<Warning> warnings;
  try {
    prepare_tets(mesh, warnings);
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kInput) throw;
    throw TetFailure{fmt::format("{} makes tets that are no solid: {}", program, error.what())};
  }
  for (Warning& warning : warnings) {
    if (std::find(kFaults.begin(), kFaults.end(), warning.kind) != kFaults.end())
      throw TetFailure{fmt::format("{} makes {}", program, warning.text)};
  }
  return mesh;
}

}  // namespace crossgrain

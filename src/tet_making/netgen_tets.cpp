// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <utility>

#include "crossgrain/version.hpp"
#include "process/answer_stream.hpp"
#include "process/helper_program.hpp"
#include "tet_making/netgen_messages.hpp"
#include "tet_making/tet_program.hpp"

namespace crossgrain {
namespace {

class NetgenTets : public TetProgram {
 public:
  using TetProgram::TetProgram;

  FilledTets fill(const ClosedTriangles& surface, const TetJob& job) const override {
    const PrivateFolder folder;
    folder.write(kNetgenSurface, netgen_surface_bytes({surface.vertices, surface.triangles}));
    TetMesh mesh = run(folder, NetgenWork::kFill, job);
    return {std::move(mesh.vertices), std::move(mesh.tets)};
  }

  TetMesh cut(const std::string& brep, const TetJob& job) const override {
    const PrivateFolder folder;
    folder.write(kNetgenSolids, brep);
    return run(folder, NetgenWork::kCut, job);
  }

 private:
  TetMesh run(const PrivateFolder& folder, NetgenWork work, const TetJob& job) const {
    const std::string place = folder.path().string();
    const NetgenRequest request{::getpid(), work, job.sizes, job.max_memory_bytes, place};
    const HelperRun run{
        program(), arguments_of(request), {"TMPDIR=" + place, "LC_ALL=C"}, job.seconds, job.max_memory_bytes};
    const HelperOutcome outcome = run_tet_program(run, name(), folder, job.monitor);
    std::optional<NetgenAnswer> answer = netgen_answer_in(outcome.answer);
    const bool has_mesh =
        answer && answer->end != NetgenEnd::kOutOfMemory && answer->end != NetgenEnd::kFault;
    if (!has_mesh && may_lack_addresses(outcome))
      throw out_of_memory("Netgen", outcome, job.max_memory_bytes);
    if (!answer) fail_without_answer(outcome);
    if (answer->end == NetgenEnd::kOutOfMemory) throw out_of_memory("Netgen", outcome, job.max_memory_bytes);
    if (answer->end == NetgenEnd::kFault) throw TetFailure{answer->fault};
    return std::move(answer->mesh);
  }

  [[noreturn]] void fail_without_answer(const HelperOutcome& outcome) const {
    if (outcome.number == kLibrariesMissing)
      throw TetFailure{fmt::format("{} cannot find libraries of Netgen", program().string()),
                       ErrorKind::kInput, Remedy::kInstallTetMaker};
    if (!outcome.answer.starts_with(greeting_of(kNetgenProgramName)))
      throw TetFailure{fmt::format("{} does not belong to Crossgrain {}", program().string(), kVersion),
                       ErrorKind::kInput, Remedy::kReinstall};
    throw TetFailure{"Netgen crashed on it (no complete answer)"};
  }
};

}  // namespace

std::unique_ptr<TetProgram> netgen_tets(const std::filesystem::path& program) {
  return std::make_unique<NetgenTets>("Netgen", program);
}

}  // namespace crossgrain

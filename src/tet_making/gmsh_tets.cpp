// SPDX-License-Identifier: Apache-2.0
// gmsh, by its command line: a script of its language in a private folder tells what to read, do and write.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <iterator>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "files/input_file.hpp"
#include "mesh_files/tets/tet_reader.hpp"
#include "process/answer_stream.hpp"
#include "tet_making/tet_program.hpp"

namespace crossgrain {
namespace {

constexpr const char* kScript = "job.geo";
constexpr const char* kResult = "tets.msh";

/// What gmsh prints is only searched for its first error.
constexpr std::size_t kMostPrinted = 10000000;

/// One thread, and no options of the user: the same result everywhere. Algorithms are those of gmsh's own
/// defaults, since others (HXT) need several threads to be of use.
constexpr std::string_view kSettings = R"(General.Terminal = 1;
General.Verbosity = 2;
General.NumThreads = 1;
Mesh.RandomSeed = 1;
Mesh.ElementOrder = 1;
Mesh.Algorithm3D = 1;
Mesh.Optimize = 1;
Mesh.MshFileVersion = 4.1;
Mesh.Binary = 1;
Mesh.SaveAll = 1;
)";

/// Returns the first error that gmsh printed, as one line; empty if it printed none.
std::string first_error(std::string_view printed) {
  constexpr std::string_view kBegin = "Error";
  constexpr std::size_t kMostShown = 200;
  while (!printed.empty()) {
    std::string_view line = printed.substr(0, printed.find('\n'));
    printed.remove_prefix(std::min(printed.size(), line.size() + 1));
    const std::size_t colon = line.find(": ");
    if (!line.starts_with(kBegin) || colon == std::string_view::npos) continue;
    return one_line(std::string(line.substr(colon + 2, kMostShown)));
  }
  return "";
}

/// MSH 2.2: the simplest that all versions of gmsh read. Each shell is a surface of its own: gmsh tells the
/// solid from a void by the surfaces around them.
std::string msh_of(const ClosedTriangles& surface) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n", surface.vertices.size());
  for (std::size_t v = 0; v < surface.vertices.size(); ++v) {
    const auto& [x, y, z] = surface.vertices[v];
    fmt::format_to(out, "{} {} {} {}\n", v + 1, x, y, z);
  }
  fmt::format_to(out, "$EndNodes\n$Elements\n{}\n", surface.triangles.size());
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& [a, b, c] = surface.triangles[t];
    const std::uint32_t shell = surface.shells[t] + 1;
    fmt::format_to(out, "{} 2 2 {} {} {} {} {}\n", t + 1, shell, shell, a + 1, b + 1, c + 1);
  }
  fmt::format_to(out, "$EndElements\n");
  return fmt::to_string(text);
}

struct HashOfBits {
  std::size_t operator()(const Vector3& v) const {
    std::array<std::uint64_t, 3> bits;
    for (std::size_t k = 0; k < 3; ++k) {
      const double positive = v[k] + 0.0;  // 0 and -0 are equal
      std::memcpy(&bits[k], &positive, sizeof positive);
    }
    return static_cast<std::size_t>((bits[0] * 31 + bits[1]) * 31 + bits[2]);
  }
};

/// Numbers the vertices of gmsh's mesh such that the given ones, which it keeps to the bit, come first.
FilledTets filled(const TetMesh& mesh, const ClosedTriangles& surface) {
  std::unordered_map<Vector3, std::uint32_t, HashOfBits> given;
  for (const Vector3& vertex : surface.vertices)
    given.emplace(vertex, static_cast<std::uint32_t>(given.size()));
  FilledTets result{surface.vertices, mesh.tets};
  std::vector<std::uint32_t> new_index;
  for (const Vector3& vertex : mesh.vertices) {
    const auto found = given.find(vertex);
    new_index.push_back(found != given.end() ? found->second
                                             : static_cast<std::uint32_t>(result.vertices.size()));
    if (found == given.end()) result.vertices.push_back(vertex);
  }
  for (auto& tet : result.tets)
    for (std::uint32_t& vertex : tet) vertex = new_index[vertex];
  return result;
}

class GmshTets : public TetProgram {
 public:
  using TetProgram::TetProgram;

  FilledTets fill(const ClosedTriangles& surface, const TetJob& job) const override {
    const PrivateFolder folder;
    folder.write("surface.msh", msh_of(surface));
    const std::string script = fmt::format(
        "Mesh.MeshSizeMax = {};\n"
        "Merge \"surface.msh\";\nSurface Loop(1) = Surface{{:}};\nVolume(1) = {{1}};\n",
        job.sizes.size);
    return filled(run(folder, script, job), surface);
  }

  TetMesh cut(const std::string& brep, const TetJob& job) const override {
    const PrivateFolder folder;
    folder.write("solids.brep", brep);
    const std::string script = fmt::format(
        "SetFactory(\"OpenCASCADE\");\n"
        "Mesh.MeshSizeMax = {};\nMesh.MeshSizeMin = {};\nMesh.MeshSizeFromCurvature = {};\n"
        "Merge \"solids.brep\";\n",
        job.sizes.size, job.sizes.smallest_share * job.sizes.size, job.sizes.edges_per_circle);
    return run(folder, script, job);
  }

 private:
  TetMesh run(const PrivateFolder& folder, const std::string& script, const TetJob& job) const {
    folder.write(kScript, fmt::format("{}{}Mesh 3;\nSave \"{}\";\n", kSettings, script, kResult));
    const std::string home = folder.path().string();
    HelperRun run{program(),
                  {(folder.path() / kScript).string(), "-"},
                  {"HOME=" + home, "GMSH_HOME=" + home, "TMPDIR=" + home, "LC_ALL=C", "OMP_NUM_THREADS=1"},
                  job.seconds,
                  kMostPrinted};
    run.is_foreign = true;
    run.max_memory_bytes = job.max_memory_bytes;
    const HelperOutcome outcome = run_tet_program(run, name(), folder, job.monitor);
    return result_in(folder, run, outcome);
  }

  TetMesh result_in(const PrivateFolder& folder, const HelperRun& run, const HelperOutcome& outcome) const {
    const std::string error = first_error(outcome.answer);
    try {
      TetMesh mesh = tets_of(InputFile(folder.path() / kResult), read_gmsh);
      if (error.empty()) return mesh;
    } catch (const Error& unreadable) {
      if (unreadable.kind() != ErrorKind::kInput) throw;
    }
    const bool is_short_of_memory = error.empty() || may_lack_addresses(outcome)
                                        ? is_near_its_limit(run, outcome)
                                        : error.find("ut of memory") != error.npos;
    if (is_short_of_memory) throw out_of_memory(name(), outcome, run.max_memory_bytes);
    if (error.empty()) throw TetFailure{"gmsh makes no tets of it"};
    TetFailure failure{fmt::format("gmsh gives up on it ({})", error)};
    // No size helps a surface whose triangles lie on each other.
    if (error.find("overlapping facets") != error.npos) failure.remedy = Remedy::kUniteParts;
    throw failure;
  }
};

}  // namespace

std::unique_ptr<TetProgram> gmsh_tets(const std::filesystem::path& program) {
  return std::make_unique<GmshTets>("gmsh", program);
}

}  // namespace crossgrain

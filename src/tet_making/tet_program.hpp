// SPDX-License-Identifier: Apache-2.0
// What the library asks of a program that makes tets.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/interface.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/tet_making.hpp"
#include "process/helper_process.hpp"
#include "process/private_folder.hpp"
#include "remeshing/remeshing_options.hpp"

namespace crossgrain {

/// Triangles that bound a solid, all of them looking outward.
struct ClosedTriangles {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<std::uint32_t> shells;  ///< of each triangle: 0 for the outer one, others for voids
};

/// Tets inside given triangles. The vertices begin with the given ones.
struct FilledTets {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 4>> tets;
};

struct TetJob {
  Remeshing sizes;
  double seconds;
  std::size_t max_memory_bytes;  ///< of the program
  const Monitor& monitor;
};

/// Thrown if a program makes no tets, while another one or another size may succeed.
struct TetFailure {
  std::string text;  ///< "gmsh crashed on it (Segmentation fault)"
  ErrorKind kind = ErrorKind::kInput;
  Remedy remedy = Remedy::kChangeTetSize;
};

/// A program that makes tets. Its functions throw TetFailure, Error(kOutput) for a full disk, and
/// Error(kInterrupted).
class TetProgram : public Interface {
 public:
  TetProgram(std::string name, std::filesystem::path program)
      : name_(std::move(name)), program_(std::move(program)) {}

  const std::string& name() const { return name_; }

  /// Fills triangles, which stay as they are, with tets.
  virtual FilledTets fill(const ClosedTriangles& surface, const TetJob& job) const = 0;

  /// Cuts solids in BREP into tets. Regions and tags of triangles and edges are the places of solids, faces
  /// and edges in TopExp::MapShapes, from 1.
  virtual TetMesh cut(const std::string& brep, const TetJob& job) const = 0;

 protected:
  const std::filesystem::path& program() const { return program_; }

 private:
  std::string name_;
  std::filesystem::path program_;
};

std::unique_ptr<TetProgram> gmsh_tets(const std::filesystem::path& program);
std::unique_ptr<TetProgram> netgen_tets(const std::filesystem::path& program);

/// Runs a program with files in a folder and returns its outcome. Throws TetFailure if it crashed, or
/// exceeded its time or memory, in the name of `what`, and if it cannot be started; Error(kOutput) for a full
/// disk.
HelperOutcome run_tet_program(const HelperRun& run, const std::string& what, const PrivateFolder& folder,
                              const Monitor& monitor);

/// Whether a program of others, which knows no limit of its memory, came near the one that it had: refused an
/// allocation, it stays below, the further the larger that was. Or that of its addresses.
bool is_near_its_limit(const HelperRun& run, const HelperOutcome& outcome);

/// What a program that ran out of memory failed by: the limit of its addresses, or what was `allowed`.
TetFailure out_of_memory(const std::string& what, const HelperOutcome& outcome, std::size_t allowed);

/// Returns what a program made as a mesh for a field: without vertices that no tet uses, all tets with a
/// positive volume by the order of their vertices. Throws TetFailure if a tet has no volume, or the tets
/// overlap or fold over themselves. Where the solid touches itself, TetMesh::warnings says so.
TetMesh checked_tets(TetMesh mesh, const std::string& program);

}  // namespace crossgrain

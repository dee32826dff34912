// SPDX-License-Identifier: Apache-2.0
// What the library asks of a program that makes tets.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/interface.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/tet_making.hpp"
#include "process/helper_process.hpp"
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
  double size;  ///< largest edge, model units
  double seconds;
  std::size_t max_memory_bytes;  ///< of the program
  CurvatureSizes curvature;
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
  virtual std::string name() const = 0;

  /// Fills triangles, which stay as they are, with tets.
  virtual FilledTets fill(const ClosedTriangles& surface, const TetJob& job) const = 0;

  /// Cuts solids in BREP into tets. Regions and tags of triangles and edges are the places of solids, faces
  /// and edges in TopExp::MapShapes, from 1.
  virtual TetMesh cut(const std::string& brep, const TetJob& job) const = 0;
};

std::unique_ptr<TetProgram> gmsh_tets(const std::filesystem::path& program);
std::unique_ptr<TetProgram> netgen_tets(const std::filesystem::path& program);

/// Runs a program of a job and returns its outcome. Throws TetFailure if it crashed, or exceeded its time or
/// memory, in the name of `what`, and if it cannot be started.
HelperOutcome run_tet_program(const HelperRun& run, const std::string& what, const Monitor& monitor);

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "archives/gzip.hpp"
#include "base/names.hpp"
#include "base/required_memory.hpp"
#include "base/vector3.hpp"
#include "cad_reading/cad_reader.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/features.hpp"
#include "crossgrain/model_summary.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/reading.hpp"
#include "crossgrain/tet_making.hpp"
#include "measure/part_size.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "surface/model_faces.hpp"
#include "surface/solid_split.hpp"
#include "surface/stitching.hpp"
#include "surface/topology.hpp"
#include "tet_making/given_model.hpp"
#include "tet_making/surface_faults.hpp"
#include "tet_making/surface_tets.hpp"
#include "tet_making/tet_making_tuning.hpp"
#include "tet_making/tet_program.hpp"
#include "tets/tet_shape.hpp"

namespace crossgrain {
namespace {

using Programs = std::vector<std::unique_ptr<TetProgram>>;

void check_range(double value, double least, double most, const char* name) {
  if (value >= least && value <= most) return;
  throw Error(ErrorKind::kUsage,
              fmt::format("{} is {}, but must be at least {} and at most {}", name, value, least, most));
}

void check_options(const TetMakingTuning& options) {
  constexpr double kInfinity = std::numeric_limits<double>::max();
  check_range(options.size, 0, kInfinity, "size");
  check_range(options.edges, 1, 1e6, "edges");
  check_range(options.seconds, 0, kInfinity, "seconds");
  check_range(options.defeature, 0, kInfinity, "defeature");
  check_range(options.edges_per_circle, 3, 1e6, "edges_per_circle");
}

/// Returns the programs to try, in this order.
Programs programs_of(const TetMakingTuning& options) {
  const bool any = options.maker == TetMaker::kAutomatic;
  Programs programs;
  const auto gmsh = options.gmsh.empty() ? gmsh_program() : options.gmsh;
  if ((any || options.maker == TetMaker::kGmsh) && !gmsh.empty()) programs.push_back(gmsh_tets(gmsh));
  const auto netgen = options.netgen.empty() ? netgen_program() : options.netgen;
  if ((any || options.maker == TetMaker::kNetgen) && !netgen.empty()) programs.push_back(netgen_tets(netgen));
  if (!programs.empty()) return programs;
  throw Error(ErrorKind::kInput,
              options.maker == TetMaker::kGmsh ? "the program gmsh, which would make the tets, is not in PATH"
              : options.maker == TetMaker::kNetgen ? "the program crossgrain_netgen is not installed"
                                                   : "there is no program that makes tets",
              Remedy::kInstallTetMaker);
}

/// Tets that may be expected at most.
constexpr double kMostTets = 20000000;

/// Returns the size of the tets in a closed surface. Throws if it does not suit the part, or if there would
/// be too many.
double size_for(const SearchableSurface& surface, const TetMakingTuning& options) {
  check_scale(surface.surface().box);
  const PartSize part = part_size(surface.surface());
  const double size = options.size_for(part.longest);
  const double expected = expected_tets(part, size);
  if (options.on_solid)
    options.on_solid(surface);
  else if (options.size > 0)
    check_asked_size({size, "tets", 1, 20, expected, Remedy::kGiveTetSize}, part);
  if (expected <= kMostTets) return size;
  throw Error(ErrorKind::kLimit,
              fmt::format("about {:.2g} tets of the size {:.4g} are to be expected in a part {} across, but "
                          "at most {:.2g} are allowed",
                          expected, size, length_text(part.longest, part.unit), kMostTets),
              Remedy::kTakeLargerTets);
}

TetJob job_of(double size, const TetMakingTuning& options, const Monitor& monitor) {
  return {{size, options.edges_per_circle, options.smallest_share},
          options.seconds,
          memory_for_helper(options.max_memory_bytes, "to make tets"),
          monitor};
}

/// Tries one way after the other until one succeeds. Failures become warnings, or the error of the first.
class Attempts {
 public:
  template <class Make>
  void attempt(const Make& make) {
    if (made_) return;
    try {
      made_ = make();
    } catch (TetFailure& failure) {
      failures_.push_back(std::move(failure));
    }
  }

  TetMesh result() && {
    if (!made_) throw Error(failures_.front().kind, failures_.front().text, failures_.front().remedy);
    for (const TetFailure& failure : failures_)
      made_->warnings.emplace_back(WarningKind::kTetMaker,
                                   failure.text + ", so the tets were made in another way");
    return *std::move(made_);
  }

 private:
  std::optional<TetMesh> made_;
  std::vector<TetFailure> failures_;
};

/// Fills a surface: first with new triangles, then with the given ones.
void attempt_surface(const PatchedSurface& given, const Programs& programs, const TetJob& job,
                     Attempts& attempts) {
  const PatchedSurface even = filled_triangles(given, job);
  for (const PatchedSurface* triangles : {&even, &given}) {
    for (const auto& program : programs)
      attempts.attempt([&] { return checked_tets(tets_in(*triangles, *program, job), program->name()); });
  }
}

void add_first(std::vector<Warning>& to, const std::vector<Warning>& warnings) {
  to.insert(to.begin(), warnings.begin(), warnings.end());
}

/// Replaces places in lists of the solids by the numbers of the model; edges that are no creases are not
/// stated.
void number_as_model(TetMesh& mesh, const CadModel& model) {
  const auto number = [](const std::vector<std::int32_t>& numbers, std::int32_t place) {
    const auto index = static_cast<std::size_t>(place) - 1;
    return index < numbers.size() ? numbers[index] : 0;
  };
  for (std::int32_t& region : mesh.regions) region = number(model.solids.solid_numbers, region) + 1;
  for (TetMesh::Face& face : mesh.feature_faces) face.tag = number(model.solids.face_numbers, face.tag);
  std::set<std::int32_t> creases;
  for (const CreaseCurve& crease : model.mesh.creases) creases.insert(crease.tag);
  for (TetMesh::Edge& edge : mesh.feature_edges) {
    edge.tag = number(model.solids.edge_numbers, edge.tag);
    edge.is_stated = creases.contains(edge.tag);
  }
}

CreaseAngles creases_of(const TetMakingTuning& options) {
  return {.least_deg = options.crease_angle_deg};
}

TetMesh triangle_tets(TriangleMesh given, const TetMakingTuning& options, const Monitor& monitor) {
  const std::string unit = given.unit, file_unit = given.file_unit;
  const ClosedModel model(std::move(given), options.crease_angle_deg, options.defeature);
  model.check_crossings();
  const TetJob job = job_of(size_for(model.surface(), options), options, monitor);
  const Programs programs = programs_of(options);
  monitor.report({Phase::kMakeTets, 0, 0, 0, 0});
  Attempts attempts;
  const PatchedSurface triangles = model.patches();
  attempt_surface(triangles, programs, job, attempts);
  TetMesh result = std::move(attempts).result();
  result.unit = unit;
  result.file_unit = file_unit;
  result.given = std::make_shared<const GivenModel>(model.given(triangles));
  add_first(result.warnings, model.warnings());
  return result;
}

TetMesh cad_tets(const InputFile& file, CadFormat format, const TetMakingTuning& options,
                 const Monitor& monitor) {
  if (options.defeature > 0)
    return triangle_tets(read_open_solids(file, format, options, monitor).mesh, options, monitor);
  CadModel model = read_solids(file, format, options, monitor);
  const SearchableSurface faces(prepare_surface(weld(model.mesh)));
  const TetJob job = job_of(size_for(faces, options), options, monitor);
  const Programs programs = programs_of(options);
  monitor.report({Phase::kMakeTets, 0, 0, 0, 0});
  Attempts attempts;
  for (const auto& program : programs) {
    attempts.attempt([&] {
      TetMesh mesh = checked_tets(program->cut(model.solids.brep, job), program->name());
      number_as_model(mesh, model);
      return mesh;
    });
  }
  // The triangles of the reader, where no program can cut the faces.
  if (model.solids.solid_numbers.size() == 1) {
    attempts.attempt([&] {
      const SearchableSurface surface(mend_surface(CheckedMesh(weld(model.mesh))));
      check_bounds_solid(surface);
      Attempts others;
      attempt_surface(surface_to_fill(surface.surface(), creases_of(options)), programs, job, others);
      return std::move(others).result();
    });
  }
  TetMesh mesh = std::move(attempts).result();
  mesh.unit = model.mesh.unit;
  mesh.file_unit = model.mesh.file_unit;
  mesh.given = std::make_shared<const GivenModel>(given_cad(model.mesh, options.crease_angle_deg));
  add_first(mesh.warnings, model.mesh.warnings);
  return mesh;
}

}  // namespace

const char* name_of(TetMaker maker) {
  constexpr std::array kNames{"automatic", "gmsh", "netgen"};
  return name_among<TetMaker::kNetgen>(kNames, maker);
}

TetQuality quality_of(const TetMesh& mesh) {
  TetQuality quality;
  double sum = 0;
  for (const auto& tet : mesh.tets) {
    std::array<Vector3, 4> corners;
    for (std::size_t k = 0; k < 4; ++k) corners[k] = mesh.vertices[tet[k]];
    const double shape = mean_ratio(corners);
    quality.worst = std::min(quality.worst, shape);
    sum += shape;
  }
  if (!mesh.tets.empty()) quality.mean = sum / static_cast<double>(mesh.tets.size());
  return quality;
}

TetMesh make_tets(const TriangleMesh& surface, const TetMakingOptions& options, const Monitor& monitor) {
  return make_tets(surface, TetMakingTuning{options}, monitor);
}

TetMesh make_tets(const std::filesystem::path& model, const TetMakingOptions& options,
                  const Monitor& monitor) {
  return make_tets(model, TetMakingTuning{options}, monitor);
}

TetMesh make_tets(const TriangleMesh& surface, const TetMakingTuning& options, const Monitor& monitor) {
  check_options(options);
  const ReadLimits limits(monitor, options.max_memory_bytes);
  return triangle_tets(surface, options, monitor);
}

TetMesh make_tets(const std::filesystem::path& model, const TetMakingTuning& options,
                  const Monitor& monitor) {
  check_options(options);
  const ReadLimits limits(monitor, options.max_memory_bytes);
  monitor.report({Phase::kRead, 0, 0, 0, 0});
  try {
    if (is_tet_file(model)) {
      read_tets(model);  // it may hold something else, and says so
      throw Error(ErrorKind::kInput, "holds tets already; solve on these, or give a surface or a CAD file");
    }
    if (const auto format = cad_format_of(model))
      return cad_tets(read_unpacked(model), *format, options, monitor);
    ReadOptions reading;
    reading.unit = options.unit;
    return triangle_tets(read_surface(model, reading, monitor), options, monitor);
  } catch (const Error& error) {
    // Usage: of sizes that do not suit the model.
    const bool is_of_model =
        error.file().empty() && (error.kind() == ErrorKind::kInput || error.kind() == ErrorKind::kLimit ||
                                 error.kind() == ErrorKind::kUsage);
    if (is_of_model) throw error.with_file(model.string());
    throw;
  }
}

}  // namespace crossgrain

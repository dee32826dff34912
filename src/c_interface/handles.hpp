// SPDX-License-Identifier: Apache-2.0
// What is behind the handles of the C interface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "c_interface/output_choices.hpp"
#include "crossgrain/c.h"
#include "crossgrain/crossgrain.hpp"
#include "crossgrain/streamlines.hpp"

/// The alternatives are in the order of crossgrain_options_kind.
struct crossgrain_options {
  std::variant<crossgrain::SolveOptions, crossgrain::ReadOptions, crossgrain::TetTagOptions,
               crossgrain::OutputChoices, crossgrain::StreamlineOptions, crossgrain::PictureOptions,
               crossgrain::MapPreparationOptions, crossgrain::TetMakingOptions, crossgrain::RepairOptions,
               crossgrain::HexOptions, crossgrain::HexMeshingOptions, crossgrain::HexFitOptions>
      values;
};

struct crossgrain_monitor {
  crossgrain_monitor(crossgrain_on_progress on_progress, crossgrain_on_expectation on_expectation,
                     void* state);
  crossgrain::Monitor monitor;
};

struct crossgrain_constraints {
  crossgrain::Constraints constraints;
};

struct crossgrain_mesh {
  explicit crossgrain_mesh(crossgrain::TriangleMesh its_mesh);

  /// Makes the views anew; call after each change.
  void renew();

  crossgrain::TriangleMesh mesh;
  std::vector<crossgrain_crease> creases;  ///< views of mesh.creases
  std::vector<std::string> warnings;
};

struct crossgrain_tets {
  crossgrain::TetMesh mesh;
};

struct crossgrain_domain {
  explicit crossgrain_domain(crossgrain::TetDomain its_domain);
  crossgrain::TetDomain domain;
  std::vector<std::string> warnings;
};

struct crossgrain_field {
  crossgrain::FrameField field;
};

struct crossgrain_tet_field {
  crossgrain::TetFrameField field;
};

struct crossgrain_hexahedra {
  using Made = std::variant<crossgrain::Hexahedra, crossgrain::FittedHexahedra>;

  explicit crossgrain_hexahedra(Made its_hexahedra);
  const crossgrain::HexMesh& mesh() const;
  const crossgrain::SolveReport& report() const;

  Made made;
  std::string sentence;
  std::vector<double> scaled_jacobians;
  std::vector<std::uint32_t> faces;  ///< of the boundary, row by row
  std::vector<std::int32_t> tags;
};

/// Row by row.
struct crossgrain_matchings {
  explicit crossgrain_matchings(const std::vector<crossgrain::FaceMatching>& all);
  std::vector<std::uint32_t> faces, tets;
  std::vector<std::int8_t> axes;
};

struct crossgrain_graph {
  explicit crossgrain_graph(crossgrain::SingularityGraph its_graph);
  crossgrain::SingularityGraph graph;
  crossgrain_graph_summary summary{};
  std::vector<crossgrain_arc> arcs;    ///< views of graph.arcs
  std::vector<crossgrain_node> nodes;  ///< views of graph.nodes
};

struct crossgrain_answer {
  explicit crossgrain_answer(crossgrain::Answer its_answer);
  crossgrain::Answer answer;
  std::string sentence;
  std::vector<std::string> next;           ///< of each reason, in words
  std::vector<crossgrain_reason> reasons;  ///< views of answer.reasons and of `next`
};

struct crossgrain_tracer {
  crossgrain::StreamlineTracer tracer;
};

/// Lines that were traced, or curves that were read.
struct crossgrain_lines {
  explicit crossgrain_lines(crossgrain::Streamlines its_lines);
  explicit crossgrain_lines(std::vector<crossgrain::AxisCurve> its_curves);
  crossgrain::Streamlines lines;
  std::vector<crossgrain::AxisCurve> curves;  ///< of lines that were read
  std::vector<crossgrain_line> views;
};

struct crossgrain_spectrum {
  explicit crossgrain_spectrum(crossgrain::SpectrumReport its_report);
  crossgrain::SpectrumReport report;
  std::vector<double> matrix, null_space;  ///< row by row
  crossgrain_form form{};
};

struct crossgrain_reservation {
  std::shared_ptr<crossgrain::FolderReservation> reservation;
};

struct crossgrain_numbers {
  std::size_t columns = 0;
  std::vector<double> values;
};

namespace crossgrain {

/// Returns the options of a handle, or the defaults if it is null. Throws Error(kUsage) for another kind.
template <class Options>
const Options& options_or_defaults(const crossgrain_options* handle) {
  // Not {}: GCC 12 warns of uninitialised members of nested structs then.
  static const Options defaults = Options();
  if (handle == nullptr) return defaults;
  const auto* const options = std::get_if<Options>(&handle->values);
  if (options == nullptr) throw Error(ErrorKind::kUsage, "the options are of another kind");
  return *options;
}

/// Returns the monitor of a handle, or one that nobody listens to if it is null.
const Monitor& monitor_of(const crossgrain_monitor* handle);

/// Returns the numbers of points, three each, as they are in memory.
inline const double* numbers_of(const std::vector<Vector3>& points) {
  static_assert(sizeof(Vector3) == 3 * sizeof(double));
  return points.empty() ? nullptr : points.front().data();
}

/// Returns a view of an array; null if it is empty.
template <class T>
const T* data_or_null(const std::vector<T>& values) {
  return values.empty() ? nullptr : values.data();
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "c_interface/field_calls.hpp"
#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"
#include "crossgrain/read_limits.hpp"
#include "crossgrain/repair.hpp"
#include "crossgrain/thread_limit.hpp"
#include "results/one_solve.hpp"
#include "solve/tet_field.hpp"

namespace crossgrain {
namespace {

const double* numbers_of(const std::vector<Quaternion>& quaternions) {
  static_assert(sizeof(Quaternion) == 4 * sizeof(double) && offsetof(Quaternion, w) == 0 &&
                offsetof(Quaternion, z) == 3 * sizeof(double));
  return quaternions.empty() ? nullptr : &quaternions.front().w;
}

/// The formats that may be chosen.
const std::vector<OutputFormat>& formats() {
  static const std::vector<OutputFormat> all = [] {
    std::vector<OutputFormat> chosen = output_formats();
    std::erase_if(chosen,
                  [](const OutputFormat& format) { return format.is_always_written || format.is_of_map; });
    return chosen;
  }();
  return all;
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_status crossgrain_solve_onto(const crossgrain_domain* domain, const crossgrain_options* options,
                                        crossgrain_monitor* monitor, crossgrain_tet_field** out,
                                        crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_tet_field{solve_onto(
        given(domain, "domain").domain, options_or_defaults<SolveOptions>(options), monitor_of(monitor))};
  });
}

crossgrain_status crossgrain_carry_onto(const crossgrain_field* field, const crossgrain_domain* domain,
                                        const crossgrain_options* options, crossgrain_monitor* monitor,
                                        crossgrain_tet_field** out, crossgrain_error** error) {
  return made(out, error, [&] {
    return new crossgrain_tet_field{carry_onto(given(field, "field").field, given(domain, "domain").domain,
                                               options_or_defaults<SolveOptions>(options),
                                               monitor_of(monitor))};
  });
}

crossgrain_status crossgrain_tet_field_repaired(const crossgrain_tet_field* field,
                                                const crossgrain_options* options, int threads,
                                                crossgrain_monitor* monitor, crossgrain_tet_field** out,
                                                crossgrain_error** error) {
  return made(out, error, [&] {
    const ThreadLimit limit(checked_threads(threads));
    return new crossgrain_tet_field{repaired(
        given(field, "field").field, options_or_defaults<RepairOptions>(options), monitor_of(monitor))};
  });
}

crossgrain_status crossgrain_tet_field_read(const char* folder, size_t max_memory_bytes,
                                            crossgrain_monitor* monitor, crossgrain_tet_field** out,
                                            crossgrain_error** error) {
  return made(out, error, [&] {
    const ReadLimits limits(monitor_of(monitor), max_memory_bytes);
    const std::filesystem::path path = &given(folder, "folder");
    std::optional<TetFrameField> field = read_one_solve(path, [&] { return read_tet_field(path); });
    return field ? new crossgrain_tet_field{*std::move(field)} : nullptr;
  });
}

void crossgrain_tet_field_free(crossgrain_tet_field* field) {
  delete field;
}

crossgrain_status crossgrain_tet_field_grid(const crossgrain_tet_field* field, crossgrain_field** out,
                                            crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_field{given(field, "field").field.grid()}; });
}

crossgrain_status crossgrain_tet_field_domain(const crossgrain_tet_field* field, crossgrain_domain** out,
                                              crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_domain(given(field, "field").field.domain()); });
}

crossgrain_status crossgrain_tet_field_frames(const crossgrain_tet_field* field, double* frames,
                                              crossgrain_error** error) {
  return guarded(error, [&] { put_frames(given(field, "field").field.tet_frames(), frames); });
}

crossgrain_status crossgrain_tet_field_vertex_frames(const crossgrain_tet_field* field, double* frames,
                                                     crossgrain_error** error) {
  return guarded(error, [&] { put_frames(given(field, "field").field.vertex_frames(), frames); });
}

const double* crossgrain_tet_field_quaternions(const crossgrain_tet_field* field) {
  return field == nullptr ? nullptr : numbers_of(field->field.data().tet_frames);
}

const double* crossgrain_tet_field_vertex_quaternions(const crossgrain_tet_field* field) {
  return field == nullptr ? nullptr : numbers_of(field->field.data().vertex_frames);
}

crossgrain_matchings::crossgrain_matchings(const std::vector<FaceMatching>& all) {
  for (const FaceMatching& matching : all) {
    faces.insert(faces.end(), matching.vertices.begin(), matching.vertices.end());
    tets.insert(tets.end(), matching.tets.begin(), matching.tets.end());
    axes.insert(axes.end(), matching.axes.begin(), matching.axes.end());
  }
}

crossgrain_status crossgrain_tet_field_matchings(const crossgrain_tet_field* field,
                                                 crossgrain_monitor* monitor, crossgrain_matchings** out,
                                                 crossgrain_error** error) {
  return made(out, error, [&] {
    const WatchedLoops watched(monitor_of(monitor), Stops::kHeeded);
    return new crossgrain_matchings(given(field, "field").field.matchings());
  });
}

size_t crossgrain_matchings_count(const crossgrain_matchings* matchings) {
  return matchings == nullptr ? 0 : matchings->tets.size() / 2;
}

const uint32_t* crossgrain_matchings_faces(const crossgrain_matchings* matchings) {
  return matchings == nullptr ? nullptr : data_or_null(matchings->faces);
}

const uint32_t* crossgrain_matchings_tets(const crossgrain_matchings* matchings) {
  return matchings == nullptr ? nullptr : data_or_null(matchings->tets);
}

const int8_t* crossgrain_matchings_axes(const crossgrain_matchings* matchings) {
  return matchings == nullptr ? nullptr : data_or_null(matchings->axes);
}

void crossgrain_matchings_free(crossgrain_matchings* matchings) {
  delete matchings;
}

CROSSGRAIN_FIELD_CALLS(crossgrain_tet_field)

const char* crossgrain_format_name(size_t index) {
  return value_or<const char*>(
      nullptr, [&] { return index < formats().size() ? formats()[index].name.c_str() : nullptr; });
}

const char* crossgrain_format_description(size_t index) {
  return value_or<const char*>(
      nullptr, [&] { return index < formats().size() ? formats()[index].description.c_str() : nullptr; });
}

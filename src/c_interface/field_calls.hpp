// SPDX-License-Identifier: Apache-2.0
// What the functions for fields on a grid and for those on tets have in common.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"
#include "crossgrain/page.hpp"
#include "crossgrain/picture.hpp"

namespace crossgrain {

/// Writes the nine numbers of each frame to an array.
inline void put_frames(const std::vector<Frame>& frames, double* out) {
  const auto numbers = elements(out, frames.size(), 9, "frames");
  parallel_for(frames.size(), [&](std::size_t i) {
    for (std::size_t k = 0; k < 9; ++k) numbers[9 * i + k] = frames[i].axes[k / 3][k % 3];
  });
}

/// Returns the options for writing a field, with its page if they want it.
template <class Field>
OutputOptions output_options_for(const Field& field, const crossgrain_options* handle) {
  const OutputChoices& choices = options_or_defaults<OutputChoices>(handle);
  OutputOptions options = choices;
  if (choices.page) {
    if (options.companion) throw Error(ErrorKind::kUsage, "the page and a companion cannot both be written");
    options.companion = page_of(field);
  }
  return options;
}

/// Writes a field with the name of its model; `json` may be null.
template <class Field>
void write_result(const Field& field, const char* folder, const OutputOptions& options, const char* model,
                  double read_seconds, crossgrain_monitor* monitor, char** json) {
  SolveReport report = field.report();
  if (model != nullptr) report.model.path = model;
  report.seconds.read += read_seconds;
  // Fields that were read keep theirs.
  if (report.seconds.total == 0)
    report.seconds.total =
        report.seconds.grid + report.seconds.solve + (report.onto ? report.onto->seconds : 0);
  report.seconds.total += read_seconds;
  const SolveReport written =
      write_field(field, std::move(report), &given(folder, "folder"), monitor_of(monitor), options);
  if (json != nullptr) *json = copy_of(report_json(written));
}

/// Draws a field; null for its own singular lines, and for no streamlines.
template <class Field>
void render_result(const Field& field, const char* path, const crossgrain_options* options,
                   const crossgrain_graph* singularities, const crossgrain_lines* lines,
                   crossgrain_monitor* monitor) {
  PictureCurves curves;
  if (singularities != nullptr) curves.singularities = &singularities->graph;
  if (lines != nullptr) {
    curves.streamlines = lines->curves;
    for (const Streamline& line : lines->lines.lines) curves.streamlines.push_back({line.points, line.axis});
  }
  render_picture(field, &given(path, "path"), options_or_defaults<PictureOptions>(options), curves,
                 monitor_of(monitor));
}

/// Returns the graph of a field.
template <class Field>
crossgrain_graph* graph_of(const Field& field, const crossgrain_monitor* monitor) {
  const WatchedLoops watched(monitor_of(monitor), Stops::kHeeded);
  return new crossgrain_graph(field.singularities());
}

}  // namespace crossgrain

/// The functions that are the same for both handles.
#define CROSSGRAIN_FIELD_CALLS(Handle)                                                                       \
  crossgrain_status Handle##_singularities(const Handle* field, crossgrain_monitor* monitor,                 \
                                           crossgrain_graph** out, crossgrain_error** error) {               \
    return made(out, error, [&] { return graph_of(given(field, "field").field, monitor); });                 \
  }                                                                                                          \
  crossgrain_status Handle##_report(const Handle* field, char** json, crossgrain_error** error) {            \
    return made(json, error, [&] { return copy_of(report_json(given(field, "field").field.report())); });    \
  }                                                                                                          \
  crossgrain_status Handle##_check(const Handle* field, char** json, crossgrain_error** error) {             \
    return made(json, error, [&] { return copy_of(check_json(given(field, "field").field.report())); });     \
  }                                                                                                          \
  crossgrain_status Handle##_answer(const Handle* field, crossgrain_answer** out,                            \
                                    crossgrain_error** error) {                                              \
    return made(out, error,                                                                                  \
                [&] { return new crossgrain_answer(given(field, "field").field.report().answer); });         \
  }                                                                                                          \
  crossgrain_status Handle##_write(                                                                          \
      const Handle* field, const char* folder, const crossgrain_options* options, const char* model,         \
      double read_seconds, crossgrain_monitor* monitor, char** json, crossgrain_error** error) {             \
    return guarded(error, [&] {                                                                              \
      const auto& written = given(field, "field").field;                                                     \
      write_result(written, folder, output_options_for(written, options), model, read_seconds, monitor,      \
                   json);                                                                                    \
    });                                                                                                      \
  }                                                                                                          \
  crossgrain_status Handle##_write_page(const Handle* field, const char* path, crossgrain_monitor* monitor,  \
                                        crossgrain_error** error) {                                          \
    return guarded(                                                                                          \
        error, [&] { write_page(given(field, "field").field, &given(path, "path"), monitor_of(monitor)); }); \
  }                                                                                                          \
  crossgrain_status Handle##_render(const Handle* field, const char* path,                                   \
                                    const crossgrain_options* options,                                       \
                                    const crossgrain_graph* singularities, const crossgrain_lines* lines,    \
                                    crossgrain_monitor* monitor, crossgrain_error** error) {                 \
    return guarded(error, [&] {                                                                              \
      render_result(given(field, "field").field, path, options, singularities, lines, monitor);              \
    });                                                                                                      \
  }

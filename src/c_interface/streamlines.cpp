// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"
#include "crossgrain/thread_limit.hpp"

namespace crossgrain {
namespace {

static_assert(static_cast<int>(StreamlineEnd::kCrowded) == CROSSGRAIN_CROWDED);

crossgrain_line view_of(const Streamline& line) {
  crossgrain_line view{};
  view.point_count = line.points.size();
  view.points = numbers_of(line.points);
  view.tangents = numbers_of(line.tangents);
  view.length = line.length;
  view.seed = line.seed;
  view.seed_point = line.seed_point;
  view.axis = line.axis;
  view.first_end = static_cast<crossgrain_line_end>(line.first_end);
  view.last_end = static_cast<crossgrain_line_end>(line.last_end);
  return view;
}

crossgrain_line view_of(const AxisCurve& curve) {
  crossgrain_line view{};
  view.point_count = curve.points.size();
  view.points = numbers_of(curve.points);
  view.axis = curve.axis;
  return view;
}

crossgrain_numbers* numbers_in(const std::vector<Vector3>& points) {
  crossgrain_numbers rows{3, {}};
  for (const Vector3& point : points) rows.values.insert(rows.values.end(), point.begin(), point.end());
  return new crossgrain_numbers(std::move(rows));
}

crossgrain_numbers* numbers_in(const std::vector<StreamlineSeed>& seeds) {
  crossgrain_numbers rows{6, {}};
  for (const auto& [point, across] : seeds) {
    rows.values.insert(rows.values.end(), point.begin(), point.end());
    rows.values.insert(rows.values.end(), across.begin(), across.end());
  }
  return new crossgrain_numbers(std::move(rows));
}

/// More are a negative number or a mistake, and would take years.
constexpr std::size_t kMostSeeds = 1000000000;

std::size_t checked_seeds(std::size_t count) {
  if (count > kMostSeeds) throw Error(ErrorKind::kUsage, "at most a thousand million seeds are made");
  return count;
}

std::vector<StreamlineSeed> seeds_of(const double* seeds, std::size_t count, std::size_t columns) {
  if (columns != 3 && columns != 6)
    throw Error(ErrorKind::kUsage, "seeds have three or six numbers each, a point and a direction");
  const auto all = elements(seeds, count, columns, "seeds");
  std::vector<StreamlineSeed> result(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double* const row = all.data() + columns * i;
    result[i].point = {row[0], row[1], row[2]};
    if (columns == 6) result[i].across = {row[3], row[4], row[5]};
  }
  return result;
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_lines::crossgrain_lines(Streamlines its_lines) : lines(std::move(its_lines)) {
  for (const Streamline& line : lines.lines) views.push_back(view_of(line));
}

crossgrain_lines::crossgrain_lines(std::vector<AxisCurve> its_curves) : curves(std::move(its_curves)) {
  for (const AxisCurve& curve : curves) views.push_back(view_of(curve));
}

crossgrain_status crossgrain_tracer_new(const crossgrain_field* field, const crossgrain_options* options,
                                        const crossgrain_mesh* surface, crossgrain_monitor* monitor,
                                        crossgrain_tracer** out, crossgrain_error** error) {
  return made(out, error, [&] {
    const WatchedLoops watched(monitor_of(monitor), Stops::kHeeded);
    return new crossgrain_tracer{StreamlineTracer(given(field, "field").field,
                                                  options_or_defaults<StreamlineOptions>(options),
                                                  surface == nullptr ? nullptr : &surface->mesh)};
  });
}

crossgrain_status crossgrain_tracer_new_on_tets(const crossgrain_tet_field* field,
                                                const crossgrain_options* options,
                                                crossgrain_monitor* monitor, crossgrain_tracer** out,
                                                crossgrain_error** error) {
  return made(out, error, [&] {
    const WatchedLoops watched(monitor_of(monitor), Stops::kHeeded);
    return new crossgrain_tracer{
        StreamlineTracer(given(field, "field").field, options_or_defaults<StreamlineOptions>(options))};
  });
}

void crossgrain_tracer_free(crossgrain_tracer* tracer) {
  delete tracer;
}

crossgrain_status crossgrain_tracer_spread_seeds(const crossgrain_tracer* tracer, size_t count,
                                                 crossgrain_monitor* monitor, crossgrain_numbers** out,
                                                 crossgrain_error** error) {
  return made(out, error, [&] {
    return numbers_in(given(tracer, "tracer").tracer.spread_seeds(checked_seeds(count), monitor_of(monitor)));
  });
}

crossgrain_status crossgrain_tracer_surface_seeds(const crossgrain_tracer* tracer, size_t count,
                                                  crossgrain_monitor* monitor, crossgrain_numbers** out,
                                                  crossgrain_error** error) {
  return made(out, error, [&] {
    return numbers_in(
        given(tracer, "tracer").tracer.surface_seeds(checked_seeds(count), monitor_of(monitor)));
  });
}

crossgrain_status crossgrain_tracer_cut_seeds(const crossgrain_tracer* tracer, int axis, double position,
                                              size_t count, crossgrain_monitor* monitor,
                                              crossgrain_numbers** out, crossgrain_error** error) {
  return made(out, error, [&] {
    const std::optional<double> place = std::isnan(position) ? std::nullopt : std::optional(position);
    return numbers_in(
        given(tracer, "tracer").tracer.cut_seeds(axis, place, checked_seeds(count), monitor_of(monitor)));
  });
}

crossgrain_status crossgrain_tracer_trace(const crossgrain_tracer* tracer, const double* seeds, size_t count,
                                          size_t columns, int threads, crossgrain_monitor* monitor,
                                          crossgrain_lines** out, crossgrain_error** error) {
  return made(out, error, [&] {
    const ThreadLimit limit(checked_threads(threads));
    return new crossgrain_lines(
        given(tracer, "tracer").tracer.trace(seeds_of(seeds, count, columns), monitor_of(monitor)));
  });
}

size_t crossgrain_lines_count(const crossgrain_lines* lines) {
  return lines == nullptr ? 0 : lines->views.size();
}

size_t crossgrain_lines_outside_seeds(const crossgrain_lines* lines) {
  return lines == nullptr ? 0 : lines->lines.outside_seeds;
}

size_t crossgrain_lines_arc_seeds(const crossgrain_lines* lines) {
  return lines == nullptr ? 0 : lines->lines.arc_seeds;
}

const crossgrain_line* crossgrain_lines_line(const crossgrain_lines* lines, size_t index) {
  return lines != nullptr && index < lines->views.size() ? &lines->views[index] : nullptr;
}

crossgrain_status crossgrain_lines_write(const crossgrain_lines* lines, const char* path, const char* solve,
                                         crossgrain_monitor* monitor, crossgrain_error** error) {
  return guarded(error, [&] {
    if (!given(lines, "lines").curves.empty())
      throw Error(ErrorKind::kUsage,
                  "lines that were read from a file lack what is written; trace them again");
    write_streamlines(lines->lines.lines, &given(path, "path"), monitor_of(monitor),
                      solve == nullptr ? "" : solve);
  });
}

crossgrain_status crossgrain_lines_read(const char* path, crossgrain_lines** out, crossgrain_error** error) {
  return made(out, error, [&] { return new crossgrain_lines(read_streamlines(&given(path, "path"))); });
}

void crossgrain_lines_free(crossgrain_lines* lines) {
  delete lines;
}

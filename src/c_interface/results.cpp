// SPDX-License-Identifier: Apache-2.0
// Files and folders of results.
#include <exception>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "c_interface/guarded.hpp"
#include "c_interface/handles.hpp"

namespace crossgrain {
namespace {

/// Bytes on their way into a file. What goes wrong there is kept, since no exception may pass through C.
struct Sink {
  const ByteSink& write;
  std::exception_ptr failure;
};

int write_to(void* sink_state, const char* bytes, std::size_t count) noexcept {
  auto& sink = *static_cast<Sink*>(sink_state);
  if (sink.failure) return 1;
  try {
    sink.write(std::string_view(bytes, count));
    return 0;
  } catch (...) {
    sink.failure = std::current_exception();
    return 1;
  }
}

CompanionFile companion_of(const std::string& name, crossgrain_companion_writer writer, void* state) {
  const auto write = [name, writer, state](const SolveReport& report, const ByteSink& bytes) {
    Sink sink{bytes, nullptr};
    const int result = writer(report_json(report).c_str(), write_to, &sink, state);
    if (sink.failure) std::rethrow_exception(sink.failure);
    if (result != 0) throw Error(ErrorKind::kOutput, {name, "", "its writer has failed"});
  };
  return {name, [write](const Monitor&) { return CompanionFile::Writer(write); }};
}

OutputChoices& output_choices(crossgrain_options* options) {
  auto* const found = std::get_if<OutputChoices>(&given(options, "options").values);
  if (found == nullptr) throw Error(ErrorKind::kUsage, "the options are not those of an output");
  return *found;
}

}  // namespace
}  // namespace crossgrain

using namespace crossgrain;

crossgrain_status crossgrain_options_set_companion(crossgrain_options* options, const char* name,
                                                   crossgrain_companion_writer writer, void* state,
                                                   crossgrain_error** error) {
  return guarded(error, [&] {
    if (writer == nullptr) throw_missing("writer");
    output_choices(options).companion = companion_of(&given(name, "name"), writer, state);
  });
}

crossgrain_status crossgrain_options_set_reservation(crossgrain_options* options,
                                                     const crossgrain_reservation* reservation,
                                                     crossgrain_error** error) {
  return guarded(error, [&] {
    output_choices(options).reservation = reservation == nullptr ? nullptr : reservation->reservation;
  });
}

crossgrain_status crossgrain_reserve_folder(const char* folder, const crossgrain_options* options,
                                            int on_tets, crossgrain_reservation** out,
                                            crossgrain_error** error) {
  return made(out, error, [&] {
    const OutputChoices& choices = options_or_defaults<OutputChoices>(options);
    const auto check = on_tets != 0 ? check_onto_folder : check_field_folder;
    return new crossgrain_reservation{check(&given(folder, "folder"), choices)};
  });
}

void crossgrain_reservation_free(crossgrain_reservation* reservation) {
  delete reservation;
}

crossgrain_status crossgrain_field_write_samples(const crossgrain_field* field, const double* points,
                                                 size_t count, const char* frames, const char* outside,
                                                 crossgrain_monitor* monitor, size_t* outside_count,
                                                 crossgrain_error** error) {
  return guarded(error, [&] {
    const std::vector<Vector3> all = rows_of<Vector3>(points, count, "points");
    SampleFiles files{&given(frames, "frames"), {}};
    if (outside != nullptr) files.outside = outside;
    const std::size_t result = write_samples(given(field, "field").field, all, files, monitor_of(monitor));
    if (outside_count != nullptr) *outside_count = result;
  });
}

crossgrain_status crossgrain_points_read(const char* path, crossgrain_numbers** out,
                                         crossgrain_error** error) {
  return made(out, error, [&] {
    crossgrain_numbers rows{3, {}};
    for (const Vector3& p : read_points(&given(path, "path")))
      rows.values.insert(rows.values.end(), p.begin(), p.end());
    return new crossgrain_numbers(std::move(rows));
  });
}

crossgrain_status crossgrain_normals_read(const char* path, crossgrain_numbers** out,
                                          crossgrain_error** error) {
  return made(out, error, [&] {
    crossgrain_numbers rows{4, {}};
    for (const auto& [normal, weight] : read_normals(&given(path, "path")))
      rows.values.insert(rows.values.end(), {normal[0], normal[1], normal[2], weight});
    return new crossgrain_numbers(std::move(rows));
  });
}

crossgrain_status crossgrain_model_of_result(const char* folder, char** out, crossgrain_error** error) {
  return made(out, error, [&] {
    const std::optional<std::string> model = model_of_result(&given(folder, "folder"));
    return model ? copy_of(*model) : nullptr;
  });
}

crossgrain_status crossgrain_solve_of_result(const char* folder, char** out, crossgrain_error** error) {
  return made(out, error, [&] { return copy_of(solve_of_result(&given(folder, "folder"))); });
}

crossgrain_status crossgrain_is_clipped_field(const char* folder, int* out, crossgrain_error** error) {
  return made(out, error, [&] { return is_clipped_field(&given(folder, "folder")) ? 1 : 0; });
}

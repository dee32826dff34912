// SPDX-License-Identifier: Apache-2.0
#include "output_places.hpp"

#include <filesystem>
#include <optional>
#include <string>

#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "results/result_files.hpp"

namespace crossgrain::app {
namespace {

bool are_same(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code unknown;
  return std::filesystem::weakly_canonical(a, unknown) == std::filesystem::weakly_canonical(b, unknown);
}

}  // namespace

std::shared_ptr<FolderReservation> reserve_output_folder(const SolveArguments& arguments) {
  const bool has_tets = !arguments.onto.empty() || solves_tets(arguments);
  const auto check = has_tets ? check_onto_folder : check_field_folder;
  auto reservation = check(arguments.output, arguments.output_options);
  // part.step and part.mesh have the same folder by default.
  const bool is_allowed = arguments.output_options.foreign_files == ForeignFiles::kReplace;
  if (arguments.is_output_named || is_allowed) return reservation;
  if (const std::optional<std::string> model = replaced_model(arguments))
    throw Error(ErrorKind::kOutput,
                {arguments.output, "", "holds the field of " + *model, Remedy::kChooseFolder});
  return reservation;
}

std::optional<std::string> replaced_model(const SolveArguments& arguments) {
  std::optional<std::string> model = model_of_result(arguments.output);
  if (model && (model->empty() || are_same(*model, arguments.model))) model.reset();
  return model;
}

void check_output_file(const std::string& path) {
  if (!may_exist(path) || is_unchanged_alone(path)) return;
  const char* text = is_own_file(path) ? "is there, and was changed since Crossgrain wrote it"
                                       : "is there, and Crossgrain did not write it";
  throw Error(ErrorKind::kOutput, {path, "", text, Remedy::kClearPlace});
}

}  // namespace crossgrain::app

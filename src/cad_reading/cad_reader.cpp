// SPDX-License-Identifier: Apache-2.0
#include "cad_reading/cad_reader.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <string.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/required_memory.hpp"
#include "cad_reading/cad_checks.hpp"
#include "cad_reading/cad_messages.hpp"
#include "cad_reading/freecad_document.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/features.hpp"
#include "crossgrain/version.hpp"
#include "process/answer_stream.hpp"
#include "process/helper_process.hpp"
#include "process/helper_program.hpp"
#include "process/private_folder.hpp"

namespace crossgrain {
namespace {

using End = HelperOutcome::End;

constexpr double kSecondsPerByte = 10e-6;

std::filesystem::path cad_program(const InputFile& file, const CadReading& options) {
  const std::filesystem::path program =
      options.cad_program.empty() ? crossgrain::cad_program() : options.cad_program;
  if (program.empty())
    fail_input(file, {}, fmt::format("this Crossgrain cannot read CAD files: {} is missing", kCadProgramName),
               Remedy::kInstallCadReader);
  return program;
}

/// Throws if memory did not suffice, or may be what made the reader fail.
void check_memory(const InputFile& file, const HelperRun& run, const HelperOutcome& outcome,
                  const std::optional<CadAnswer>& answer) {
  const auto fail = [&](const std::string& text, Remedy remedy) {
    throw Error(ErrorKind::kLimit, {file.name(), "", text, remedy});
  };
  if (answer && answer->end == CadEnd::kMesh) return;
  if (may_lack_addresses(outcome)) fail(words_of_lacking_addresses("OpenCASCADE"), Remedy::kSimplify);
  if ((answer && answer->end == CadEnd::kOutOfMemory) || outcome.end == End::kTooLong)
    fail(fmt::format("OpenCASCADE needs more than the {:.3g} GB of memory that it may take",
                     static_cast<double>(run.max_answer_bytes) / 1e9),
         Remedy::kSimplifyOrAllowMemory);
}

/// Returns the error for an outcome without an answer.
CadFault fault_of(const HelperRun& run, const HelperOutcome& outcome) {
  if (outcome.end == End::kTimedOut)
    return {
        fmt::format(
            "OpenCASCADE did not finish within {:.3g} s and was stopped: the file is damaged or very complex",
            run.seconds),
        Remedy::kAllowReadTime};
  if (outcome.end == End::kExited && outcome.number == kLibrariesMissing)
    return {fmt::format("the reader of CAD files, {}, cannot find libraries of OpenCASCADE",
                        run.program.string()),
            Remedy::kInstallOpenCascade};
  if (outcome.end == End::kExited && !outcome.answer.starts_with(greeting_of(kCadProgramName)))
    return {fmt::format("{} does not belong to Crossgrain {}", run.program.string(), kVersion),
            Remedy::kReinstall};
  if (outcome.end == End::kKilled && outcome.number == SIGKILL)
    return {"the system stopped OpenCASCADE while it read the file, usually because memory ran out",
            Remedy::kFreeMemory};
  return {
      fmt::format("OpenCASCADE crashed on it ({}): it is damaged, or has data that OpenCASCADE cannot read",
                  outcome.end == End::kKilled ? ::strsignal(outcome.number) : "no complete answer"),
      Remedy::kRepairFile};
}

[[noreturn]] void fail_input(const InputFile& file, const CadFault& fault) {
  fail_input(file, {}, fault.text, fault.remedy);
}

HelperOutcome outcome_of(const InputFile& file, const HelperRun& run, const Monitor& monitor) {
  try {
    return run_helper(run, monitor);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::resource_unavailable_try_again)
      throw Error(ErrorKind::kLimit,
                  {file.name(), "",
                   "the system starts no more processes, and CAD files are read in one; end some, or raise "
                   "their limit (ulimit -u)",
                   Remedy::kNone});
    fail_input(file, {},
               fmt::format("the reader of CAD files, {}, cannot be started: {}", run.program.string(),
                           error.code().message()),
               Remedy::kInstallCadReader);
  }
}

void check_range(double value, double most, const char* name) {
  if (value > 0 && value <= most) return;
  throw Error(ErrorKind::kUsage,
              fmt::format("{} is {}, but must be above 0 and at most {}", name, value, most));
}

void check_options(const CadReading& options) {
  check_range(options.facet_angle_deg, 90, "facet_angle_deg");
  check_range(options.crease_angle_deg, 180, "crease_angle_deg");
  check_range(options.read_seconds, std::numeric_limits<double>::max(), "read_seconds");
}

void check_format(const InputFile& file, CadFormat format) {
  switch (format) {
    case CadFormat::kStep:
      return check_step_file(file);
    case CadFormat::kIges:
      return check_iges_file(file);
    case CadFormat::kBrep:
      return check_brep_file(file);
    case CadFormat::kFreeCad:
      return;  // its shapes have checksums in the archive
  }
}

/// Where the program finds what it is to read: the file itself, or bytes that no file has, as one of its own.
class ReadPlace {
 public:
  explicit ReadPlace(const InputFile& file) : path_(file.name()) {
    if (!file.is_on_disk()) write(file.bytes());
  }
  explicit ReadPlace(std::string_view bytes) { write(bytes); }

  const std::string& path() const { return path_; }

 private:
  void write(std::string_view bytes) {
    constexpr const char* kName = "model";
    folder_.emplace();
    folder_->write(kName, bytes);
    path_ = (folder_->path() / kName).string();
  }

  std::optional<PrivateFolder> folder_;
  std::string path_;
};

}  // namespace

CadModel read_cad(const InputFile& file, CadFormat format, const CadReading& options, const Monitor& monitor,
                  CadContent content) {
  check_format(file, format);
  check_options(options);
  std::vector<Warning> warnings;
  const ReadPlace place = [&] {
    if (format != CadFormat::kFreeCad) return ReadPlace(file);
    FreeCadShapes shapes = read_freecad_document(file);
    warnings = std::move(shapes.warnings);
    return ReadPlace(shapes.placed_breps);
  }();
  CadRequest request{place.path(), format, options, ::getpid(), content == CadContent::kWithSolids};
  request.options.max_memory_bytes = memory_for_helper(options.max_memory_bytes, "to read it", file.name());
  const HelperRun run{cad_program(file, options),
                      arguments_of(request),
                      {},
                      options.read_seconds + kSecondsPerByte * static_cast<double>(file.bytes().size()),
                      request.options.max_memory_bytes};
  const HelperOutcome outcome = outcome_of(file, run, monitor);
  std::optional<CadAnswer> answer = cad_answer_in(outcome.answer);
  check_memory(file, run, outcome, answer);
  if (!answer) fail_input(file, fault_of(run, outcome));
  if (answer->end == CadEnd::kFault) fail_input(file, answer->fault);
  warnings.insert(warnings.end(), answer->mesh.warnings.begin(), answer->mesh.warnings.end());
  for (Warning& warning : warnings) warning.file = file.name();
  answer->mesh.warnings = std::move(warnings);
  return {std::move(answer->mesh), std::move(answer->solids)};
}

}  // namespace crossgrain

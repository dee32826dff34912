// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>
#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/version.hpp"
#include "io/cad_checks.hpp"
#include "io/cad_module.hpp"
#include "io/surface_reader.hpp"

namespace crossgrain {
namespace {

constexpr const char* kModuleName = "crossgrain_cad.so";

/// How many folders above the program the module is looked for: bin/crossgrain in an installed tree, and
/// apps/crossgrain/crossgrain in a build tree.
constexpr int kFoldersAbove = 2;

constexpr const char* kMend =
    "install libocct-data-exchange-dev and libocct-modeling-algorithms-dev, build Crossgrain again and "
    "install "
    "it as a whole, or export the model as STL";

/// The folders that hold this library, as a shared one, and the program.
std::vector<std::filesystem::path> own_folders() {
  std::vector<std::filesystem::path> folders;
  Dl_info info{};
  std::error_code ignored;
  if (::dladdr(&kModuleName, &info) != 0 && info.dli_fname != nullptr)
    folders.push_back(std::filesystem::canonical(info.dli_fname, ignored).parent_path());
  folders.push_back(std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path());
  return folders;
}

/// The module in the nearest folder lib/crossgrain (CROSSGRAIN_MODULE_FOLDER) beside or above this library or
/// the program; otherwise its mere name, for the linker's own search.
std::filesystem::path module_path() {
  for (std::filesystem::path folder : own_folders()) {
    for (int above = 0; above <= kFoldersAbove && !folder.empty(); ++above, folder = folder.parent_path()) {
      const std::filesystem::path path = folder / CROSSGRAIN_MODULE_FOLDER / kModuleName;
      std::error_code ignored;
      if (std::filesystem::exists(path, ignored)) return path;
    }
  }
  return kModuleName;
}

/// Never unloaded: OpenCASCADE does not survive that.
CadReadFunction* load_module(const InputFile& file) {
  const std::filesystem::path path = module_path();
  void* module = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (module == nullptr) {
    if (path == kModuleName)
      fail_input(
          file, {},
          fmt::format("this Crossgrain has no reader of CAD files: there is no {}; {}", kModuleName, kMend));
    fail_input(file, {}, fmt::format("the reader of CAD files cannot be loaded: {}; {}", ::dlerror(), kMend));
  }
  const auto* version = static_cast<const char* const*>(::dlsym(module, kCadVersionName));
  auto* read = reinterpret_cast<CadReadFunction*>(::dlsym(module, kCadReadName));
  if (version == nullptr || read == nullptr || std::string(*version) != kVersion)
    fail_input(file, {},
               fmt::format("{} is not of Crossgrain {}; install Crossgrain again as a whole", path.string(),
                           kVersion));
  return read;
}

void check_range(double value, double most, const char* name) {
  if (value > 0 && value <= most) return;
  throw Error(ErrorKind::kUsage, fmt::format("{} is {}; it is above 0 and at most {}", name, value, most));
}

TriangleMesh read_cad(const InputFile& file, CadFormat format, const ReadOptions& options) {
  check_range(options.chord_error_cells, std::numeric_limits<double>::max(), "chord_error_cells");
  check_range(options.facet_angle_deg, 90, "facet_angle_deg");
  check_range(options.crease_angle_deg, 180, "crease_angle_deg");
  // Once that has failed, the next call tries again.
  static CadReadFunction* const read = load_module(file);
  CadAnswer answer;
  read({file.name(), format, options}, answer);
  if (!answer.fault.empty()) fail_input(file, {}, answer.fault);
  return std::move(answer.mesh);
}

}  // namespace

TriangleMesh read_step(const InputFile& file, const ReadOptions& options) {
  check_step_file(file);
  return read_cad(file, CadFormat::kStep, options);
}

TriangleMesh read_iges(const InputFile& file, const ReadOptions& options) {
  check_iges_file(file);
  return read_cad(file, CadFormat::kIges, options);
}

TriangleMesh read_brep(const InputFile& file, const ReadOptions& options) {
  check_brep_file(file);
  return read_cad(file, CadFormat::kBrep, options);
}

}  // namespace crossgrain

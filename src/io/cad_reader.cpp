// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "crossgrain/version.hpp"
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

/// Whether a text stands in the first or last bytes of a file.
bool begins_with(const InputFile& file, std::string_view text) {
  constexpr std::size_t kHead = 200;
  return file.bytes().substr(0, kHead).find(text) != std::string_view::npos;
}
bool ends_with(const InputFile& file, std::string_view text) {
  constexpr std::size_t kTail = 2000;
  const std::string_view bytes = file.bytes();
  return bytes.substr(bytes.size() - std::min(bytes.size(), kTail)).find(text) != std::string_view::npos;
}

/// The last line that has something in it.
std::string_view last_line(const InputFile& file) {
  const std::string_view bytes = file.bytes();
  const std::string_view lines = bytes.substr(0, bytes.find_last_not_of("\r\n \x1a") + 1);
  return lines.substr(lines.find_last_of('\n') + 1);
}

// OpenCASCADE does not see that a file is damaged or ends too early, and crashes on it now and then; these
// checks are cheap and tell most of that.

/// Column 73 of every line of an IGES file names its section: S, G, D and P, in this order, and T at last.
void check_iges_sections(const InputFile& file) {
  constexpr std::size_t kSectionColumn = 72;
  constexpr std::string_view kSections = "SGDPT";
  std::string_view rest = file.bytes();
  std::size_t section = 0, number = 0;
  while (section + 1 < kSections.size()) {
    ++number;
    const std::string_view line = rest.substr(0, rest.find('\n'));
    const std::size_t here =
        line.size() > kSectionColumn ? kSections.find(line[kSectionColumn]) : std::string_view::npos;
    if (here == std::string_view::npos || here < section || (number == 1 && here > 0))
      fail_input(
          file, at_line(number),
          fmt::format("no {} in column 73, where IGES names its sections: damaged, cut short or no IGES "
                      "file in text; copy or export it again",
                      kSections[section]));
    section = here;
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
  }
}

/// Whether a line is how the text form of BREP ends: '+1 0', orientation and number of a shape, and place.
bool is_shape_reference(std::string_view line) {
  constexpr std::string_view kOrientations = "+-ie";
  return !line.empty() && kOrientations.find(line[0]) != std::string_view::npos &&
         line.find_first_not_of("0123456789 ", 1) == std::string_view::npos;
}

}  // namespace

TriangleMesh read_step(const InputFile& file, const ReadOptions& options) {
  if (!begins_with(file, "ISO-10303-21"))
    fail_input(file, {}, "is no STEP file: it does not begin with 'ISO-10303-21'; export it again");
  if (!ends_with(file, "END-ISO-10303-21"))
    fail_input(file, {}, "does not end with 'END-ISO-10303-21': cut short; copy or export it again");
  return read_cad(file, CadFormat::kStep, options);
}

TriangleMesh read_iges(const InputFile& file, const ReadOptions& options) {
  check_iges_sections(file);
  return read_cad(file, CadFormat::kIges, options);
}

TriangleMesh read_brep(const InputFile& file, const ReadOptions& options) {
  if (!begins_with(file, "CASCADE Topology V"))
    fail_input(file, {}, "is no BREP file: it does not name a 'CASCADE Topology'; export it again");
  const bool is_binary = begins_with(file, "Open CASCADE Topology V");
  if (!is_binary && !is_shape_reference(last_line(file)))
    fail_input(file, {}, "does not end with the shape that it is of: cut short; copy or export it again");
  return read_cad(file, CadFormat::kBrep, options);
}

}  // namespace crossgrain

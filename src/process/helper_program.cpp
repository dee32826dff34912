// SPDX-License-Identifier: Apache-2.0
#include "process/helper_program.hpp"

#include <dlfcn.h>
#include <link.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <system_error>
#include <vector>

#include "crossgrain/features.hpp"

namespace crossgrain {
namespace {

/// How many folders above the program libexec/ may be: bin/crossgrain in an installed tree,
/// apps/crossgrain/crossgrain in a build tree, and lib/x86_64-linux-gnu/libcrossgrain.so.
constexpr int kFoldersAbove = 2;

/// Returns the file that contains this code: a shared library, or the program.
std::filesystem::path own_file() {
  Dl_info info{};
  std::error_code ignored;
  if (::dladdr(&kCadProgramName, &info) == 0 || info.dli_fname == nullptr) return {};
  return std::filesystem::canonical(info.dli_fname, ignored);
}

std::filesystem::path running_program() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored);
}

/// Returns the folders in which the dynamic linker searches for libraries of the file that contains this
/// code.
std::vector<std::filesystem::path> library_folders() {
  // The program itself has a handle only under a null name.
  const std::filesystem::path file = own_file();
  const bool in_program = file.empty() || file == running_program();
  void* self = ::dlopen(in_program ? nullptr : file.c_str(), RTLD_LAZY | RTLD_NOLOAD);
  if (self == nullptr) return {};
  std::vector<std::filesystem::path> folders;
  Dl_serinfo size{};
  if (::dlinfo(self, RTLD_DI_SERINFOSIZE, &size) == 0) {
    // The list is longer than its type says.
    const auto bytes = std::make_unique<std::max_align_t[]>(size.dls_size / sizeof(std::max_align_t) + 1);
    auto* list = reinterpret_cast<Dl_serinfo*>(bytes.get());
    if (::dlinfo(self, RTLD_DI_SERINFOSIZE, list) == 0 && ::dlinfo(self, RTLD_DI_SERINFO, list) == 0) {
      const Dl_serpath* paths = list->dls_serpath;
      for (unsigned i = 0; i < list->dls_cnt; ++i) folders.emplace_back(paths[i].dls_name);
    }
  }
  ::dlclose(self);
  return folders;
}

bool is_there(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::exists(path, ignored);
}

}  // namespace

std::filesystem::path helper_program(const std::string& name) {
  for (std::filesystem::path folder : {own_file().parent_path(), running_program().parent_path()}) {
    for (int above = 0; above <= kFoldersAbove && !folder.empty(); ++above, folder = folder.parent_path()) {
      const std::filesystem::path program = folder / CROSSGRAIN_HELPER_FOLDER / name;
      if (is_there(program)) return program;
    }
  }
  for (const std::filesystem::path& folder : library_folders()) {
    if (is_there(folder / name)) return folder / name;
  }
  return {};
}

std::filesystem::path program_in_path(const std::string& name) {
  const char* const variable = std::getenv("PATH");
  std::string_view rest = variable == nullptr ? "" : variable;
  while (!rest.empty()) {
    const std::filesystem::path folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(rest.size(), folder.native().size() + 1));
    // An empty entry is the current folder, which is not to be trusted.
    std::error_code ignored;
    const std::filesystem::path program = folder / name;
    if (!folder.empty() && std::filesystem::is_regular_file(program, ignored) &&
        ::access(program.c_str(), X_OK) == 0)
      return program;
  }
  return {};
}

std::filesystem::path cad_program() {
  return helper_program(kCadProgramName);
}

std::filesystem::path netgen_program() {
  return helper_program(kNetgenProgramName);
}

std::filesystem::path gmsh_program() {
  return program_in_path("gmsh");
}

}  // namespace crossgrain

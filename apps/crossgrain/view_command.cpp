// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>

#include "commands.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/result_folder.hpp"
#include "view/page_name.hpp"

namespace crossgrain::app {
namespace {

/// How many folders above the program libexec/ may be: bin/crossgrain in an installed tree,
/// apps/crossgrain/crossgrain in a build tree.
constexpr int kFoldersAbove = 2;

/// The server of pages is a separate program: its HTTP library takes 6 MB and six milliseconds to load, which
/// other commands should not pay for.
std::filesystem::path find_view_program() {
  std::error_code failure;
  std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", failure).parent_path();
  for (int above = 0; above <= kFoldersAbove && !folder.empty(); ++above, folder = folder.parent_path()) {
    std::filesystem::path program = folder / CROSSGRAIN_HELPER_FOLDER / "crossgrain_view";
    if (std::filesystem::exists(program, failure)) return program;
  }
  return {};
}

void check_folder(const std::filesystem::path& folder) {
  solve_of_result(folder);
  std::error_code failure;
  if (!std::filesystem::is_regular_file(folder / kPageName, failure))
    throw Error(
        ErrorKind::kInput,
        {folder.string(), "",
         fmt::format("has no {}: draw it with 'crossgrain render', or make it again without --no-report",
                     kPageName)});
}

}  // namespace

void run_view(const ViewArguments& arguments) {
  check_folder(arguments.folder);
  const std::string program = find_view_program().string();
  const std::string port = std::to_string(arguments.port);
  std::signal(SIGPIPE, SIG_DFL);
  if (!program.empty()) {
    ::execl(program.c_str(), "crossgrain_view", arguments.folder.c_str(), port.c_str(),
            arguments.no_browser ? "no-browser" : "browser", static_cast<char*>(nullptr));
  }
  throw Error(ErrorKind::kInput,
              {std::string(CROSSGRAIN_HELPER_FOLDER) + "/crossgrain_view", "",
               "cannot be run: " + std::generic_category().message(program.empty() ? ENOENT : errno),
               Remedy::kReinstall});
}

}  // namespace crossgrain::app

// SPDX-License-Identifier: Apache-2.0
// Part of the build: writes man pages and completions of crossgrain and crossgrain-mpi to a folder.
// Usage: crossgrain_documents FOLDER
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "command_line.hpp"
#include "documents/completions.hpp"
#include "documents/manual_page.hpp"

namespace crossgrain::app {
namespace {

void write(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream out(file);
  out.exceptions(std::ios::failbit | std::ios::badbit);
  out << text << std::flush;
}

void write_completions(const ProgramDescription& program, const std::filesystem::path& folder) {
  write(folder / "bash" / program.name, bash_completion(program));
  write(folder / "zsh" / ("_" + program.name), zsh_completion(program));
  write(folder / "fish" / (program.name + ".fish"), fish_completion(program));
}

void write_documents(const std::filesystem::path& folder) {
  const ProgramDescription program = describe(CommandLine().app);
  write(folder / "man" / (program.name + ".1"), manual_page(program));
  for (const CommandDescription& command : program.commands)
    if (command.name != "help")
      write(folder / "man" / (program.name + "-" + command.name + ".1"), manual_page(program, command));
  write_completions(program, folder);

  const ProgramDescription of_processes = describe(CommandLineOfProcesses().app);
  write(folder / "man" / (of_processes.name + ".1"), manual_page_under_mpirun(of_processes));
  write_completions(of_processes, folder);
}

}  // namespace
}  // namespace crossgrain::app

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: crossgrain_documents FOLDER\n", stderr);
    return 2;
  }
  crossgrain::app::write_documents(argv[1]);
  return 0;
}

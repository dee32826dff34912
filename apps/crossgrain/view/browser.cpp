// SPDX-License-Identifier: Apache-2.0
#include "view/browser.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <unistd.h>

#include <cstdlib>
#include <sstream>
#include <vector>

namespace crossgrain::app {
namespace {

std::string environment(const char* name) {
  const char* const value = std::getenv(name);
  return value == nullptr ? "" : value;
}

/// Returns the command to run. $BROWSER may list several, separated by colons, each with arguments; the first
/// one counts, with %s replaced by the address.
std::vector<std::string> command_for(const std::string& address) {
  std::string browsers = environment("BROWSER");
  if (browsers.empty()) browsers = "xdg-open";
  std::istringstream words(browsers.substr(0, browsers.find(':')));
  std::vector<std::string> command;
  bool has_address = false;
  for (std::string word; words >> word; command.push_back(word)) {
    const std::size_t place = word.find("%s");
    if (place == std::string::npos) continue;
    word.replace(place, 2, address);
    has_address = true;
  }
  if (!has_address) command.push_back(address);
  return command;
}

}  // namespace

bool open_in_browser(const std::string& address) {
  if (environment("DISPLAY").empty() && environment("WAYLAND_DISPLAY").empty()) return false;
  std::vector<std::string> command = command_for(address);
  std::vector<char*> arguments;
  for (std::string& word : command) arguments.push_back(word.data());
  arguments.push_back(nullptr);

  // Nobody waits for the process, so the system must discard its exit status.
  ::signal(SIGCHLD, SIG_IGN);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    posix_spawn_file_actions_addopen(&files, descriptor, "/dev/null", O_RDWR, 0);
  // Signals are blocked in this process, and Ctrl-C must not reach the browser.
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  sigset_t none, all;
  sigemptyset(&none);
  sigfillset(&all);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &all);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSID);
  pid_t process = 0;
  const int failure =
      posix_spawnp(&process, arguments.front(), &files, &attributes, arguments.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&files);
  return failure == 0;
}

}  // namespace crossgrain::app

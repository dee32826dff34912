// SPDX-License-Identifier: Apache-2.0
// Stands in for crossgrain_cad: confines itself as that does, acts, and says what came of it.
//
//   confined_acts confined|free ACT FILE OTHER
//
// FILE is the one that it may read. Answers "done", or the number of the error.
#include <arpa/inet.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

#include "cad_reading/program/confinement.hpp"
#include "process/helper_process.hpp"

namespace {

bool opens(const std::string& path, int flags) {
  const int file = ::open(path.c_str(), flags, 0600);
  char byte = 'x';
  return file >= 0 &&
         ((flags & O_ACCMODE) == O_RDONLY ? ::read(file, &byte, 1) : ::write(file, &byte, 1)) == 1;
}

bool connects() {
  const int socket = ::socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(9);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return socket >= 0 && ::connect(socket, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0;
}

/// Becomes a program that answers for this one.
bool executes() {
  return ::execl("/bin/sh", "sh", "-c", "printf done >&3", nullptr) == 0;
}

bool forks() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  return child > 0 && ::waitpid(child, nullptr, 0) == child;
}

bool makes_memory_executable() {
  void* page = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return page != MAP_FAILED && ::mprotect(page, 4096, PROT_READ | PROT_EXEC) == 0;
}

bool act(const std::string& name, const std::string& file, const std::string& other) {
  const std::map<std::string, std::function<bool()>> acts = {
      {"read", [&] { return opens(file, O_RDONLY); }},
      {"read-other", [&] { return opens(other, O_RDONLY); }},
      {"write", [&] { return opens(file, O_WRONLY); }},
      {"write-other", [&] { return opens(other, O_WRONLY | O_APPEND); }},
      {"create", [&] { return opens(other + ".new", O_WRONLY | O_CREAT); }},
      {"create-empty", [&] { return ::open((other + ".new").c_str(), O_RDONLY | O_CREAT, 0600) >= 0; }},
      {"remove", [&] { return ::unlink(other.c_str()) == 0; }},
      {"rename", [&] { return ::rename(other.c_str(), (other + ".new").c_str()) == 0; }},
      {"chmod", [&] { return ::chmod(file.c_str(), 0777) == 0; }},
      {"connect", connects},
      {"execute", executes},
      {"fork", forks},
      {"signal", [] { return ::kill(::getppid(), 0) == 0; }},
      {"executable-memory", makes_memory_executable}};
  return acts.at(name)();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 5) return EXIT_FAILURE;
  if (std::string(argv[1]) == "confined") {
    const crossgrain::Confinement confinement = crossgrain::confine_to_reading(argv[3]);
    // The kernel of the machine says what can be tested.
    ::dprintf(crossgrain::kAnswerDescriptor, "%d%d ", confinement.of_calls, confinement.of_files);
  }
  errno = 0;
  if (act(argv[2], argv[3], argv[4])) {
    ::dprintf(crossgrain::kAnswerDescriptor, "done");
  } else {
    ::dprintf(crossgrain::kAnswerDescriptor, "%d", errno);
  }
  return EXIT_SUCCESS;
}

// SPDX-License-Identifier: Apache-2.0
// A library to load before others (LD_PRELOAD) that makes one system call of a program fail, or kills the
// program there. Calls count if they are about files below a folder; mmap, fork and posix_spawn always do. By
// environment variables:
//
//   FAULT_FOLDER   what only paths of these files contain
//   FAULT_CALL     which of their calls fails, counted from 1; none if missing
//   FAULT          how: a number of errno, "kill" before the call, or "short" (a write of half the bytes)
//   FAULT_LOG      a file that gets the name of each counted call, one a line
//   FAULT_ALWAYS   "exchange": folders cannot be exchanged; "link": files cannot be linked
#include <dirent.h>
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <string>

namespace {

std::atomic<long> calls = 0;
thread_local bool is_inside = false;

const char* variable(const char* name) {
  const char* const value = ::getenv(name);
  return value == nullptr ? "" : value;
}

bool is_always(const char* what) {
  return ::strcmp(variable("FAULT_ALWAYS"), what) == 0;
}

template <class Function>
Function* next(const char* name) {
  return reinterpret_cast<Function*>(::dlsym(RTLD_NEXT, name));
}

bool is_below(const std::string& path) {
  const char* const folder = variable("FAULT_FOLDER");
  return folder[0] != '\0' && path.find(folder) != std::string::npos;
}

std::string path_of(int descriptor) {
  char path[4096];
  const std::string link = "/proc/self/fd/" + std::to_string(descriptor);
  const long size = ::syscall(SYS_readlink, link.c_str(), path, sizeof path);
  return size > 0 ? std::string(path, static_cast<std::size_t>(size)) : "";
}

bool is_below(int folder, const char* name) {
  if (name == nullptr) return false;
  if (name[0] == '/' || folder == AT_FDCWD) return is_below(std::string(name));
  return is_below(path_of(folder) + "/" + name);
}

void log_call(const char* name) {
  const char* const log = variable("FAULT_LOG");
  if (log[0] == '\0') return;
  const int descriptor =
      static_cast<int>(::syscall(SYS_openat, AT_FDCWD, log, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666));
  const std::string line = std::string(name) + "\n";
  ::syscall(SYS_write, descriptor, line.data(), line.size());
  ::syscall(SYS_close, descriptor);
}

enum class Fate { kNormal, kFails, kShort };

/// What becomes of a counted call; errno is set if it fails.
Fate fate_of(const char* name, bool counts) {
  if (!counts || is_inside) return Fate::kNormal;
  is_inside = true;
  log_call(name);
  const long number = ++calls;
  Fate fate = Fate::kNormal;
  if (number == ::atol(variable("FAULT_CALL"))) {
    const std::string how = variable("FAULT");
    if (how == "kill") ::syscall(SYS_kill, ::getpid(), SIGKILL);
    fate = how == "short" ? Fate::kShort : Fate::kFails;
    if (fate == Fate::kFails) errno = ::atoi(how.c_str());
  }
  is_inside = false;
  return fate;
}

bool fails(const char* name, bool counts) {
  return fate_of(name, counts) == Fate::kFails;
}

}  // namespace

extern "C" {

#define OPEN(NAME)                                                     \
  int NAME(const char* path, int flags, ...) {                         \
    va_list rest;                                                      \
    va_start(rest, flags);                                             \
    const mode_t mode = va_arg(rest, mode_t);                          \
    va_end(rest);                                                      \
    if (fails("open", is_below(AT_FDCWD, path))) return -1;            \
    return next<int(const char*, int, ...)>(#NAME)(path, flags, mode); \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(NAME)                                                                \
  int NAME(int folder, const char* path, int flags, ...) {                          \
    va_list rest;                                                                   \
    va_start(rest, flags);                                                          \
    const mode_t mode = va_arg(rest, mode_t);                                       \
    va_end(rest);                                                                   \
    if (fails("open", is_below(folder, path))) return -1;                           \
    return next<int(int, const char*, int, ...)>(#NAME)(folder, path, flags, mode); \
  }
OPENAT(openat)
OPENAT(openat64)

#define FOPEN(NAME)                                                  \
  FILE* NAME(const char* path, const char* mode) {                   \
    if (fails("fopen", is_below(AT_FDCWD, path))) return nullptr;    \
    return next<FILE*(const char*, const char*)>(#NAME)(path, mode); \
  }
FOPEN(fopen)
FOPEN(fopen64)

ssize_t write(int file, const void* bytes, size_t size) {
  const Fate fate = fate_of("write", is_below(path_of(file)));
  if (fate == Fate::kFails) return -1;
  return next<ssize_t(int, const void*, size_t)>("write")(file, bytes,
                                                          fate == Fate::kShort ? (size + 1) / 2 : size);
}

#define PWRITE(NAME)                                                    \
  ssize_t NAME(int file, const void* bytes, size_t size, off_t at) {    \
    const Fate fate = fate_of("pwrite", is_below(path_of(file)));       \
    if (fate == Fate::kFails) return -1;                                \
    return next<ssize_t(int, const void*, size_t, off_t)>(#NAME)(       \
        file, bytes, fate == Fate::kShort ? (size + 1) / 2 : size, at); \
  }
PWRITE(pwrite)
PWRITE(pwrite64)

ssize_t read(int file, void* bytes, size_t size) {
  const Fate fate = fate_of("read", is_below(path_of(file)));
  if (fate == Fate::kFails) return -1;
  return next<ssize_t(int, void*, size_t)>("read")(file, bytes, fate == Fate::kShort ? (size + 1) / 2 : size);
}

#define PREAD(NAME)                                                     \
  ssize_t NAME(int file, void* bytes, size_t size, off_t at) {          \
    const Fate fate = fate_of("pread", is_below(path_of(file)));        \
    if (fate == Fate::kFails) return -1;                                \
    return next<ssize_t(int, void*, size_t, off_t)>(#NAME)(             \
        file, bytes, fate == Fate::kShort ? (size + 1) / 2 : size, at); \
  }
PREAD(pread)
PREAD(pread64)

#define DESCRIPTOR_CALL(NAME, PARAMETERS, ARGUMENTS)      \
  int NAME PARAMETERS {                                   \
    if (fails(#NAME, is_below(path_of(file)))) return -1; \
    return next<int PARAMETERS>(#NAME) ARGUMENTS;         \
  }
DESCRIPTOR_CALL(fsync, (int file), (file))
DESCRIPTOR_CALL(flock, (int file, int how), (file, how))
DESCRIPTOR_CALL(fchmod, (int file, mode_t mode), (file, mode))
DESCRIPTOR_CALL(fchown, (int file, uid_t user, gid_t group), (file, user, group))

/// Closes all the same, as Linux does.
int close(int file) {
  const bool is_failed = fails("close", is_below(path_of(file)));
  const int code = errno;
  const int result = next<int(int)>("close")(file);
  if (!is_failed) return result;
  errno = code;
  return -1;
}

DIR* fdopendir(int file) {
  if (fails("fdopendir", is_below(path_of(file)))) return nullptr;
  return next<DIR*(int)>("fdopendir")(file);
}

#define PATH_CALL(NAME, FOLDER, PARAMETERS, ARGUMENTS)   \
  int NAME PARAMETERS {                                  \
    if (fails(#NAME, is_below(FOLDER, path))) return -1; \
    return next<int PARAMETERS>(#NAME) ARGUMENTS;        \
  }
PATH_CALL(unlink, AT_FDCWD, (const char* path), (path))
PATH_CALL(unlinkat, folder, (int folder, const char* path, int flags), (folder, path, flags))
PATH_CALL(rmdir, AT_FDCWD, (const char* path), (path))
PATH_CALL(mkdir, AT_FDCWD, (const char* path, mode_t mode), (path, mode))
PATH_CALL(mkdirat, folder, (int folder, const char* path, mode_t mode), (folder, path, mode))
PATH_CALL(stat, AT_FDCWD, (const char* path, struct stat* out), (path, out))
PATH_CALL(lstat, AT_FDCWD, (const char* path, struct stat* out), (path, out))
PATH_CALL(fstatat, folder, (int folder, const char* path, struct stat* out, int flags),
          (folder, path, out, flags))
PATH_CALL(rename, AT_FDCWD, (const char* path, const char* to), (path, to))
PATH_CALL(renameat, folder, (int folder, const char* path, int to_folder, const char* to),
          (folder, path, to_folder, to))

int renameat2(int folder, const char* path, int to_folder, const char* to, unsigned flags) {
  if (fails("renameat2", is_below(folder, path))) return -1;
  if ((flags & RENAME_EXCHANGE) != 0 && is_always("exchange")) {
    errno = EINVAL;
    return -1;
  }
  return next<int(int, const char*, int, const char*, unsigned)>("renameat2")(folder, path, to_folder, to,
                                                                              flags);
}

int linkat(int folder, const char* path, int to_folder, const char* to, int flags) {
  if (fails("linkat", is_below(folder, path))) return -1;
  if (is_always("link")) {
    errno = EPERM;
    return -1;
  }
  return next<int(int, const char*, int, const char*, int)>("linkat")(folder, path, to_folder, to, flags);
}

#define MMAP(NAME)                                                                                        \
  void* NAME(void* place, size_t size, int access, int flags, int file, off_t at) {                       \
    if (fails("mmap", true)) return MAP_FAILED;                                                           \
    return next<void*(void*, size_t, int, int, int, off_t)>(#NAME)(place, size, access, flags, file, at); \
  }
MMAP(mmap)
MMAP(mmap64)

int posix_spawn(pid_t* process, const char* path, const posix_spawn_file_actions_t* actions,
                const posix_spawnattr_t* attributes, char* const arguments[], char* const environment[]) {
  if (fails("posix_spawn", true)) return errno;
  return next<decltype(posix_spawn)>("posix_spawn")(process, path, actions, attributes, arguments,
                                                    environment);
}

pid_t fork() {
  if (fails("fork", true)) return -1;
  return next<pid_t()>("fork")();
}

}  // extern "C"

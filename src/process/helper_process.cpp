// SPDX-License-Identifier: Apache-2.0
#include "process/helper_process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <optional>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>

#include "base/system_memory.hpp"
#include "files/descriptor.hpp"

namespace crossgrain {
namespace {

using Clock = std::chrono::steady_clock;
using End = HelperOutcome::End;

/// Interval in which a cancelled monitor is noticed.
constexpr int kMillisecondsToWait = 50;

/// Descriptor from which the guard of a helper reads to its end.
constexpr int kLifelineDescriptor = 4;

/// Starts a helper, "$0" with arguments "$@", in the process of the shell, and a guard beside it in the same
/// session. The guard kills the session once no process holds the other end of its pipe any more: when this
/// process has ended, however it did. So scripts end too, and what they have started.
constexpr const char* kGuardedStart =
    "(exec >/dev/null 2>&1 3>&-; read -r _ <&4; kill -s KILL -- -$$) & exec \"$0\" \"$@\" 4<&-";

void require(int code) {
  if (code != 0) throw std::system_error(code, std::generic_category());
}

/// File actions of posix_spawn for the new process.
class FileActions {
 public:
  /// `answer` and `lifeline` are above kLifelineDescriptor.
  FileActions(int answer, int lifeline, bool prints_answer) {
    require(::posix_spawn_file_actions_init(&actions_));
    int code = ::posix_spawn_file_actions_adddup2(&actions_, answer, kAnswerDescriptor);
    if (code == 0) code = ::posix_spawn_file_actions_adddup2(&actions_, lifeline, kLifelineDescriptor);
    for (const auto& [number, mode] :
         {std::pair{STDIN_FILENO, O_RDONLY}, {STDOUT_FILENO, O_WRONLY}, {STDERR_FILENO, O_WRONLY}}) {
      if (code != 0) break;
      code = prints_answer && number != STDIN_FILENO
                 ? ::posix_spawn_file_actions_adddup2(&actions_, kAnswerDescriptor, number)
                 : ::posix_spawn_file_actions_addopen(&actions_, number, "/dev/null", mode, 0);
    }
    if (code == 0) code = ::posix_spawn_file_actions_addclosefrom_np(&actions_, kLifelineDescriptor + 1);
    if (code == 0) return;
    ::posix_spawn_file_actions_destroy(&actions_);
    require(code);
  }
  ~FileActions() { ::posix_spawn_file_actions_destroy(&actions_); }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;

  const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_;
};

class Attributes {
 public:
  Attributes() {
    require(::posix_spawnattr_init(&attributes_));
    sigset_t all, none;
    ::sigfillset(&all);
    ::sigemptyset(&none);
    ::posix_spawnattr_setsigdefault(&attributes_, &all);
    ::posix_spawnattr_setsigmask(&attributes_, &none);
    ::posix_spawnattr_setflags(&attributes_,
                               POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSID);
  }
  ~Attributes() { ::posix_spawnattr_destroy(&attributes_); }
  Attributes(const Attributes&) = delete;
  Attributes& operator=(const Attributes&) = delete;

  const posix_spawnattr_t* get() const { return &attributes_; }

 private:
  posix_spawnattr_t attributes_;
};

std::vector<char*> pointers_to(const std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (const std::string& text : texts) pointers.push_back(const_cast<char*>(text.c_str()));
  pointers.push_back(nullptr);
  return pointers;
}

/// Returns the environment of this process with some settings, and one arithmetic, added or replaced.
std::vector<std::string> environment_with(std::vector<std::string> settings) {
  settings.emplace_back(kOneArithmetic);
  std::vector<std::string> all = settings;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable, name = text.substr(0, text.find('='));
    const bool is_set = std::any_of(settings.begin(), settings.end(), [name](const std::string& setting) {
      return setting.starts_with(name) && setting.substr(name.size()).starts_with('=');
    });
    if (!is_set) all.emplace_back(text);
  }
  return all;
}

/// The ends of a pipe, with numbers that helpers do not use.
struct Pipe {
  Pipe() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) require(errno);
    const Descriptor low_in(ends[0]), low_out(ends[1]);
    in = above_standard(low_in.number());
    out = above_standard(low_out.number());
  }

  Descriptor in, out;

 private:
  static Descriptor above_standard(int number) {
    Descriptor copy(::fcntl(number, F_DUPFD_CLOEXEC, kLifelineDescriptor + 1));
    if (!copy.is_open()) require(errno);
    return copy;
  }
};

/// A process that is killed when this object is destroyed.
class Child {
 public:
  Child(const HelperRun& run, int answer) {
    const std::string program = run.program.string();
    if (::access(program.c_str(), X_OK) != 0) require(errno);
    std::vector<std::string> words{"sh", "-c", kGuardedStart, program};
    words.insert(words.end(), run.arguments.begin(), run.arguments.end());
    const std::vector<std::string> environment = environment_with(run.environment);
    const FileActions actions(answer, lifeline_.in.number(), run.is_foreign);
    const Attributes attributes;
    require(::posix_spawn(&process_, "/bin/sh", actions.get(), attributes.get(), pointers_to(words).data(),
                          pointers_to(environment).data()));
    lifeline_.in.close();
    if (run.is_foreign) limit(run);
  }
  ~Child() {
    if (!is_waited_for_) kill_and_wait();
  }
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Returns how it ended; nothing while it runs.
  std::optional<HelperOutcome> outcome() {
    int status = 0;
    pid_t waited = 0;
    rusage used{};
    do {
      waited = ::wait4(process_, &status, WNOHANG, &used);
    } while (waited < 0 && errno == EINTR);
    if (waited == 0) return std::nullopt;
    is_waited_for_ = true;
    if (waited < 0) return HelperOutcome{End::kLost, 0, {}};
    const auto peak = static_cast<std::size_t>(used.ru_maxrss) * 1024;
    return WIFSIGNALED(status) ? HelperOutcome{End::kKilled, WTERMSIG(status), {}, peak}
                               : HelperOutcome{End::kExited, WEXITSTATUS(status), {}, peak};
  }

 private:
  /// Failure leaves the process without limits, which then only its time ends.
  void limit(const HelperRun& run) const {
    constexpr double kLongestSeconds = 1e9;
    const auto seconds = static_cast<rlim_t>(std::min(run.seconds, kLongestSeconds)) + 2;
    const rlimit time{seconds, seconds}, memory{run.max_memory_bytes, run.max_memory_bytes};
    ::prlimit(process_, RLIMIT_CPU, &time, nullptr);
    if (run.max_memory_bytes > 0) ::prlimit(process_, RLIMIT_DATA, &memory, nullptr);
  }

  void kill_and_wait() {
    // It leads a group of its own, as the first of its session.
    ::kill(-process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  }

  Pipe lifeline_;
  pid_t process_ = -1;
  bool is_waited_for_ = false;
};

/// Reads the answer from a pipe.
class Collector {
 public:
  explicit Collector(int pipe) : pipe_(pipe) {}

  /// Waits a while for data. Returns false at the end.
  bool collect() {
    pollfd waiting{pipe_, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, kMillisecondsToWait);
    if (ready == 0 || (ready < 0 && errno == EINTR)) return true;
    if (size_ == bytes_.size()) bytes_.resize(std::max(kLeast, 2 * size_));
    const ssize_t got = ::read(pipe_, bytes_.data() + size_, bytes_.size() - size_);
    if (got < 0) return errno == EINTR || errno == EAGAIN;
    size_ += static_cast<std::size_t>(got);
    return got > 0;
  }

  std::size_t size() const { return size_; }

  std::string bytes() && {
    bytes_.resize(size_);
    return std::move(bytes_);
  }

 private:
  static constexpr std::size_t kLeast = std::size_t{1} << 16;

  int pipe_;
  std::string bytes_;
  std::size_t size_ = 0;
};

}  // namespace

bool may_lack_addresses(const HelperOutcome& outcome) {
  // Beyond what is resident, gmsh 4.8 has 240 MB of addresses for its libraries, and OpenCASCADE's reader
  // 190. A refused allocation, of an array that grows, is at most as much again.
  constexpr std::size_t kMappedBytes = 250'000'000, kShare = 2;
  const std::size_t limit = address_space_limit_bytes();
  return limit > 0 && kShare * (outcome.peak_memory_bytes + kMappedBytes) >= limit;
}

std::string words_of_lacking_addresses(const std::string& what) {
  return fmt::format("{} needs more than the {:.3g} GB of memory that a process may take here (ulimit -v)",
                     what, static_cast<double>(address_space_limit_bytes()) / 1e9);
}

HelperOutcome run_helper(const HelperRun& run, const Monitor& monitor) {
  Pipe answers;
  const Clock::time_point start = Clock::now();
  const auto is_late = [&] {
    monitor.check_stop();
    return std::chrono::duration<double>(Clock::now() - start).count() > run.seconds;
  };
  Child child(run, answers.out.number());
  answers.out.close();

  Collector collector(answers.in.number());
  while (collector.collect()) {
    if (is_late()) return {End::kTimedOut, 0, {}};
    if (collector.size() > run.max_answer_bytes) return {End::kTooLong, 0, {}};
  }
  // No process has the pipe open any more: the helper has ended, or is about to.
  std::optional<HelperOutcome> outcome;
  while (!(outcome = child.outcome())) {
    if (is_late()) return {End::kTimedOut, 0, {}};
    std::this_thread::sleep_for(std::chrono::microseconds(200));
  }
  outcome->answer = std::move(collector).bytes();
  return *std::move(outcome);
}

}  // namespace crossgrain

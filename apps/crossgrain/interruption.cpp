// SPDX-License-Identifier: Apache-2.0
#include "interruption.hpp"

#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <string_view>

namespace crossgrain::app {
namespace {

// A signal handler can only access globals.
std::atomic<Monitor*> monitor_of_signals = nullptr;
std::atomic<std::int64_t> last_signal_ns = 0;
std::atomic<std::int64_t> cancelled_ns = 0;
std::atomic<bool> clears_line = false;
std::atomic<bool> has_field = false;
static_assert(std::atomic<Monitor*>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

constexpr std::int64_t kSameSignal_ns = 100'000'000;

/// Work that is cancelled ends within a second (docs/limits.md) and removes its partial files. Whoever keeps
/// pressing Ctrl-C must not keep it from that.
constexpr std::int64_t kTimeToEnd_ns = 3'000'000'000;

std::int64_t now_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

/// Limited to what a signal handler may do: no allocation, no lock.
void say(std::string_view text) {
  if (clears_line.load() && write(STDERR_FILENO, "\r\x1b[K", 4) < 0) return;
  // If the terminal is gone, there is nobody to tell.
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
}

void stop(Monitor& monitor) {
  monitor.stop();
  // The computation ends soon and reports which level it writes.
  if (has_field.load())
    say("crossgrain: interrupted: the result is complete and will be written; press Ctrl-C again to discard "
        "it\n");
}

extern "C" void on_signal(int signal) {
  const int error_before = errno;
  const std::int64_t now = now_ns(), last = last_signal_ns.exchange(now);
  Monitor* const monitor = monitor_of_signals.load();
  if (monitor == nullptr || (last != 0 && now - last < kSameSignal_ns)) {
    // Nothing to do.
  } else if (monitor->cancelled()) {
    if (now - cancelled_ns.load() >= kTimeToEnd_ns) {
      ::signal(signal, SIG_DFL);
      ::raise(signal);
    }
  } else if (monitor->may_be_stopped() && !monitor->stopped()) {
    stop(*monitor);
  } else {
    cancelled_ns = now;
    monitor->cancel();
  }
  errno = error_before;
}

/// A signal that is ignored (for instance under nohup) stays ignored.
void install(int signal, struct sigaction& before) {
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = on_signal;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption(Monitor& monitor, bool on_terminal) {
  last_signal_ns = 0;
  clears_line = on_terminal;
  has_field = false;
  monitor_of_signals = &monitor;
  for (std::size_t k = 0; k < kSignals.size(); ++k) install(kSignals[k], before_[k]);
}

Interruption::~Interruption() {
  for (std::size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &before_[k], nullptr);
  monitor_of_signals = nullptr;
}

void Interruption::set_has_field(bool has) {
  has_field = has;
}

}  // namespace crossgrain::app

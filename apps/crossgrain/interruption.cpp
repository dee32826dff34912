// SPDX-License-Identifier: Apache-2.0
#include "interruption.hpp"

#include <atomic>

namespace crossgrain::app {
namespace {

// A signal handler can be told what to do by a global only.
std::atomic<Monitor*> monitor_to_cancel = nullptr;
static_assert(std::atomic<Monitor*>::is_always_lock_free);

extern "C" void cancel_monitor(int) {
  if (Monitor* monitor = monitor_to_cancel.load()) monitor->cancel();
}

/// A signal that is ignored (a process under nohup, say) stays so.
void install(int signal, struct sigaction& before) {
  sigaction(signal, nullptr, &before);
  if (before.sa_handler == SIG_IGN) return;
  struct sigaction action {};
  action.sa_handler = cancel_monitor;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigaction(signal, &action, nullptr);
}

}  // namespace

Interruption::Interruption(Monitor& monitor) {
  monitor_to_cancel = &monitor;
  for (std::size_t k = 0; k < kSignals.size(); ++k) install(kSignals[k], before_[k]);
}

Interruption::~Interruption() {
  for (std::size_t k = 0; k < kSignals.size(); ++k) sigaction(kSignals[k], &before_[k], nullptr);
  monitor_to_cancel = nullptr;
}

}  // namespace crossgrain::app

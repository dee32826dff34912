// SPDX-License-Identifier: Apache-2.0
// The program that `crossgrain view` becomes: crossgrain_view FOLDER PORT browser|no-browser
#include <fmt/format.h>
#include <signal.h>

#include <atomic>
#include <exception>
#include <string>
#include <string_view>
#include <thread>

#include "crossgrain/error.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "view/browser.hpp"
#include "view/folder_server.hpp"
#include "view/page_name.hpp"

namespace crossgrain::app {
namespace {

/// Blocks SIGINT, SIGTERM and SIGHUP in this thread and its later threads; `come` receives them.
class EndingSignals {
 public:
  EndingSignals() {
    sigemptyset(&signals_);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&signals_, signal);
    pthread_sigmask(SIG_BLOCK, &signals_, nullptr);
  }

  /// Waits a fifth of a second at most. Returns whether a signal has come.
  bool come() const {
    const timespec interval{0, 200'000'000};
    return sigtimedwait(&signals_, nullptr, &interval) >= 0;
  }

 private:
  sigset_t signals_{};
};

void serve(const std::string& folder, int port, bool with_browser) {
  const EndingSignals signals;
  FolderServer server(folder);
  const std::string address = fmt::format("http://127.0.0.1:{}/{}", server.bind(port), kPageName);
  std::atomic<bool> is_over = false;
  std::thread serving([&] {
    server.serve();
    is_over = true;
  });
  try {
    print_result(address + "\n");
    if (with_browser && !open_in_browser(address))
      print_message("open this address in a browser; Ctrl-C ends");
    while (!is_over && !signals.come()) server.close_slow_connections();
  } catch (...) {
    server.stop();
    serving.join();
    throw;
  }
  server.stop();
  serving.join();
}

int run(int argc, char** argv) {
  if (argc != 4) return exit_code_of(ErrorKind::kUsage);
  try {
    serve(argv[1], std::stoi(argv[2]), std::string_view(argv[3]) == "browser");
    return 0;
  } catch (...) {
    const Failure failure = failure_of(std::current_exception(), argv[1], Command::kOther);
    print_message(failure.line);
    return failure.exit_code;
  }
}

}  // namespace
}  // namespace crossgrain::app

int main(int argc, char** argv) {
  return crossgrain::app::run(argc, argv);
}

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <mutex>

namespace crossgrain::app {

/// The connections of a server to clients, known by the clients' ports, which the HTTP library tells; it does
/// not tell their descriptors.
class OpenConnections {
 public:
  /// `port` is that of the server.
  void serve_on(int port) { port_ = port; }

  /// A request has been read whole, and its answer begins; the answer has ended.
  void begin_answer(int client);
  void end_answer(int client);

  /// Closes those that have not sent a whole request for too long. Call it again and again.
  void close_slow();

  /// Closes all, even in an answer.
  void close_all() const;

 private:
  using Clock = std::chrono::steady_clock;

  struct Connection {
    Clock::time_point waits_since = Clock::now();
    bool is_answered = false;
  };

  int port_ = 0;
  std::mutex mutex_;
  std::map<int, Connection> connections_;
};

}  // namespace crossgrain::app

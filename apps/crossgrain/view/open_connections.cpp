// SPDX-License-Identifier: Apache-2.0
#include "view/open_connections.hpp"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>

#include <set>

namespace crossgrain::app {
namespace {

/// From the first byte of a request to its last. Browsers on this machine take milliseconds.
constexpr std::chrono::seconds kLongestRequest{5};

/// Returns the port of one side of a socket, by getsockname or getpeername; 0 if there is none.
template <class Name>
int port_by(const Name& name, int descriptor) {
  sockaddr_in address{};
  socklen_t size = sizeof address;
  if (name(descriptor, reinterpret_cast<sockaddr*>(&address), &size) != 0) return 0;
  return address.sin_family == AF_INET ? ntohs(address.sin_port) : 0;
}

/// Calls act(descriptor, port of the client) for each connection to a port of this process.
template <class Act>
void for_each_connection(int port, const Act& act) {
  for (int descriptor = 0; descriptor < FD_SETSIZE; ++descriptor) {
    if (port_by(::getsockname, descriptor) != port) continue;
    if (const int client = port_by(::getpeername, descriptor)) act(descriptor, client);
  }
}

}  // namespace

void OpenConnections::begin_answer(int client) {
  const std::scoped_lock lock(mutex_);
  connections_[client].is_answered = true;
}

void OpenConnections::end_answer(int client) {
  const std::scoped_lock lock(mutex_);
  connections_[client] = {};
}

void OpenConnections::close_slow() {
  const std::scoped_lock lock(mutex_);
  const Clock::time_point now = Clock::now();
  std::set<int> open;
  for_each_connection(port_, [&](int descriptor, int client) {
    open.insert(client);
    const Connection& connection = connections_[client];
    if (!connection.is_answered && now - connection.waits_since > kLongestRequest)
      ::shutdown(descriptor, SHUT_RDWR);
  });
  std::erase_if(connections_, [&](const auto& item) { return !open.contains(item.first); });
}

void OpenConnections::close_all() const {
  for_each_connection(port_, [](int descriptor, int) { ::shutdown(descriptor, SHUT_RDWR); });
}

}  // namespace crossgrain::app

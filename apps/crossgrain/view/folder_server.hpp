// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

namespace crossgrain::app {

/// Serves the files of one folder to browsers on this machine: regular files in the folder itself, by GET and
/// HEAD, whole or in ranges. Names that begin with a dot and links that lead out of the folder are not found.
/// Requests for a host other than 127.0.0.1 or localhost are refused, so that no web page can make the
/// browser read the files under its own host name (DNS rebinding).
class FolderServer {
 public:
  explicit FolderServer(const std::filesystem::path& folder);
  ~FolderServer();

  /// Binds a port on 127.0.0.1, a free one for 0, and returns it. Throws Error(kOutput) if it is in use.
  int bind(int port);

  /// Serves until another thread calls `stop`, which may happen before `serve` has started. `stop` closes all
  /// connections and returns when `serve` is about to.
  void serve();
  void stop();

  /// Closes connections that take too long to send a request. Call it several times a second, from another
  /// thread than `serve`.
  void close_slow_connections();

 private:
  class Files;
  std::unique_ptr<Files> files_;
};

}  // namespace crossgrain::app

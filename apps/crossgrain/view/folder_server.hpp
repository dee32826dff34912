// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>

namespace crossgrain::app {

/// Serves the files of one folder to browsers on this machine, and nothing else: regular files that lie in
/// the folder itself, by GET and HEAD, whole or in ranges. Names that begin with a dot and links that lead
/// out of the folder are not there. Requests for another host than 127.0.0.1 or localhost are refused, so
/// that no page of the web can have the browser read the files under a name of its own (DNS rebinding).
class FolderServer {
 public:
  explicit FolderServer(const std::filesystem::path& folder);
  ~FolderServer();

  /// Takes a port on 127.0.0.1, for 0 a free one, and returns it. Throws Error(kOutput) where it is taken.
  int bind(int port);

  /// Serves until `stop`, which is for another thread, once `serve` is called there or is about to be.
  void serve();
  void stop();

 private:
  class Files;
  std::unique_ptr<Files> files_;
};

}  // namespace crossgrain::app

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace crossgrain {

/// A new folder for files that this process exchanges with another one, which nobody else may open. It is
/// made where the environment variable TMPDIR says, otherwise in /tmp, and removed with all that is in it.
class PrivateFolder {
 public:
  /// Throws Error(kOutput).
  PrivateFolder();
  ~PrivateFolder();
  PrivateFolder(const PrivateFolder&) = delete;
  PrivateFolder& operator=(const PrivateFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

  /// Writes a new file. Throws Error(kOutput).
  void write(const char* name, std::string_view bytes) const;

  /// Returns whether so little space is left that a file of another process may have been cut short.
  bool is_full() const;

  /// Throws the Error(kOutput) of a full disk.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  std::filesystem::path path_;
};

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

namespace crossgrain {

/// Creates a folder and its missing parents. Unless kept, they are removed again if empty.
class NewFolders {
 public:
  explicit NewFolders(const std::filesystem::path& folder);
  ~NewFolders() { remove(); }
  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;

  void keep() { made_.clear(); }

 private:
  bool make(const std::filesystem::path& folder);
  void remove() noexcept;

  std::vector<std::filesystem::path> made_;  ///< outermost first
};

}  // namespace crossgrain

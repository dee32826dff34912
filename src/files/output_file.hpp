// SPDX-License-Identifier: Apache-2.0
// Results are written to temporary files and renamed when complete, so that a run that fails or is
// interrupted leaves no partial file and keeps an earlier result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/checksum.hpp"
#include "files/descriptor.hpp"

namespace crossgrain {

/// A file being written. Every failure (no permission, disk full, on write or close) throws Error(kOutput)
/// with the path and the remedy. Anything but a regular file (a pipe, /dev/stdout) is written to directly.
class OutputFile {
 public:
  /// Opens a temporary file in the folder of `target`, which must exist.
  explicit OutputFile(const std::filesystem::path& target);

  /// Writes to standard output. Errors call it "standard output".
  static OutputFile standard_output();

  /// Removes the temporary file unless `commit` has been called.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& name() const { return name_; }

  void write(std::string_view bytes);
  void write(const void* bytes, std::size_t size) { write({static_cast<const char*>(bytes), size}); }

  /// Number of bytes written so far.
  std::uint64_t position() const { return flushed_ + buffer_.size(); }

  /// Makes the file sum up all bytes that are written from now on; none of them may be patched.
  void keep_checksum() { checksum_.emplace(); }

  /// The sum since `keep_checksum`; none without it.
  const std::optional<Checksum>& checksum() const { return checksum_; }

  /// Overwrites bytes already written; regular files only.
  void patch(std::uint64_t offset, std::string_view bytes);

  /// Writes everything to disk and closes the file; the last point where a full disk can show.
  void finish();

  /// Calls `finish` if that has not been done, then renames the file.
  void commit();

 private:
  OutputFile(std::string name, int descriptor);

  void flush();
  void start_writing_back();
  void write_at(std::uint64_t offset, std::string_view bytes);
  [[noreturn]] void fail(const char* doing, int code) const;

  std::string name_;
  std::string temporary_;  ///< empty if written to directly
  Descriptor descriptor_;
  std::uint64_t flushed_ = 0;
  std::uint64_t sent_ = 0;  ///< part of flushed_ whose write to disk has been started
  std::string buffer_;
  std::optional<Checksum> checksum_;
};

/// Creates a folder and its missing parents. Unless kept, they are removed again if empty.
class NewFolders {
 public:
  explicit NewFolders(const std::filesystem::path& folder);
  ~NewFolders() { remove(); }
  NewFolders(const NewFolders&) = delete;
  NewFolders& operator=(const NewFolders&) = delete;

  void keep() { made_.clear(); }

 private:
  void make(const std::filesystem::path& folder);
  void remove() noexcept;

  std::vector<std::filesystem::path> made_;  ///< outermost first
};

/// A folder that receives several files, all or none. Without `commit`, the temporary files and the folders
/// created for them are removed.
class OutputFolder {
 public:
  explicit OutputFolder(const std::filesystem::path& folder) : folder_(folder), made_(folder) {}

  /// Creates a file in the folder. The folder owns it.
  OutputFile& create(const std::string& name);

  /// Removes an earlier file or link of this name at `commit`. Anything else of this name stays.
  void remove_at_commit(const std::string& name) { outdated_.push_back(folder_ / name); }

  /// Finishes all files; only then renames them and removes the outdated ones.
  void commit();

 private:
  std::filesystem::path folder_;
  NewFolders made_;  // declared before the files, so that they are gone when it removes folders
  std::vector<std::unique_ptr<OutputFile>> files_;
  std::vector<std::filesystem::path> outdated_;
};

/// Throws Error(kOutput) if a folder with such files could not be written. Leaves no trace. Call before a
/// long computation to fail early.
void check_writable(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace crossgrain

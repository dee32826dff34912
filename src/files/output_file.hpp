// SPDX-License-Identifier: Apache-2.0
// Results are written beside their destination and renamed onto it once complete, so that a run which fails
// or is interrupted leaves nothing half-written and an earlier result as it was.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace crossgrain {

/// One file to be. Every failure (no permission, disk full, at writing or at closing) throws Error(kOutput)
/// with the path and the mend. What is no regular file (a pipe, /dev/stdout) is written to directly.
class OutputFile {
 public:
  /// Opens a temporary file in the folder of `target`, which must exist.
  explicit OutputFile(const std::filesystem::path& target);

  /// Standard output, which errors call so.
  static OutputFile standard_output();

  /// Removes the temporary file unless `commit` has been called.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& name() const { return name_; }

  void write(std::string_view bytes);
  void write(const void* bytes, std::size_t size) { write({static_cast<const char*>(bytes), size}); }

  /// Bytes written so far.
  std::uint64_t position() const { return flushed_ + buffer_.size(); }

  /// Overwrites bytes already written; only in regular files.
  void patch(std::uint64_t offset, std::string_view bytes);

  /// Everything on the disk and closed; the last point where a full disk can show.
  void finish();

  /// `finish` if that has not been, then the rename.
  void commit();

 private:
  OutputFile(std::string name, int descriptor);

  void flush();
  void start_writing_back();
  void write_at(std::uint64_t offset, std::string_view bytes);
  [[noreturn]] void fail(const char* doing, int code) const;

  std::string name_;
  std::string temporary_;  ///< empty where written to directly
  int descriptor_ = -1;
  std::uint64_t flushed_ = 0;
  std::uint64_t sent_ = 0;  ///< of these, what the disk has been asked to begin with
  std::string buffer_;
};

/// Makes a folder and its parents where they are missing, and removes them again unless they are kept or
/// something is in them.
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
/// that were made for them are removed.
class OutputFolder {
 public:
  explicit OutputFolder(const std::filesystem::path& folder) : folder_(folder), made_(folder) {}

  /// A new file in it, owned by it.
  OutputFile& create(const std::string& name);

  /// An earlier file of this name, or a link, goes when the new ones come. What else has the name stays.
  void remove_at_commit(const std::string& name) { outdated_.push_back(folder_ / name); }

  /// Completes all files, and only then renames the new ones and removes the outdated ones.
  void commit();

 private:
  std::filesystem::path folder_;
  NewFolders made_;  // before the files, so that they are gone when it removes folders
  std::vector<std::unique_ptr<OutputFile>> files_;
  std::vector<std::filesystem::path> outdated_;
};

/// Throws Error(kOutput) where a folder with such files could not be written, and leaves no trace. To be
/// asked before a long computation.
void check_writable(const std::filesystem::path& folder, const std::vector<std::string>& names);

}  // namespace crossgrain

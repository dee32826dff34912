// SPDX-License-Identifier: Apache-2.0
// Results are written to temporary files and renamed when complete, so that a run that fails or is
// interrupted leaves no partial file and keeps an earlier result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <utility>

#include "files/crc32.hpp"
#include "files/descriptor.hpp"

namespace crossgrain {

/// A file being written. Every failure (no permission, disk full, on write or close) throws Error(kOutput)
/// with the path and the remedy.
class OutputFile {
 public:
  /// Opens a temporary file in the folder of `target`, which must exist. `target` may be a link to a file.
  /// Anything else than a regular file, such as a pipe, a device or a folder, is an error: it would hang, or
  /// lose what was written.
  explicit OutputFile(const std::filesystem::path& target);

  /// Opens a new file in a folder that nobody reads yet, without a temporary name; errors call it `shown`.
  OutputFile(int folder, std::string name, std::string shown);

  /// Writes to standard output. Errors call it "standard output".
  static OutputFile standard_output();

  /// Removes the temporary file unless `commit` has been called.
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  const std::string& name() const { return name_; }

  void write(std::string_view bytes);
  void write(const void* bytes, std::size_t size) { write({static_cast<const char*>(bytes), size}); }

  /// The solve that the file belongs to (SolveReport::solve), for its writer; empty if there is none.
  const std::string& solve() const { return solve_; }
  void set_solve(std::string solve) { solve_ = std::move(solve); }

  /// Number of bytes written so far.
  std::uint64_t position() const { return flushed_ + buffer_.size(); }

  /// The sum of these bytes.
  const Crc32& crc() const { return crc_; }

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
  std::string read_at(std::uint64_t offset, std::size_t size) const;
  [[noreturn]] void fail(const char* doing, int code) const;

  std::string name_;  ///< in errors
  std::string solve_;
  Descriptor folder_;       ///< of the temporary file: it may be moved meanwhile
  std::string temporary_;   ///< name in the folder; empty if there is none
  std::string target_;      ///< name in the folder that the temporary file gets
  bool is_stream_ = false;  ///< standard output
  Descriptor descriptor_;
  std::uint64_t flushed_ = 0;
  std::uint64_t sent_ = 0;  ///< part of flushed_ whose write to disk has been started
  std::string buffer_;
  Crc32 crc_;
};

/// Returns whether a file has a name that OutputFile gives to temporary files. A run that was killed leaves
/// them.
bool is_temporary_name(const std::string& name);

}  // namespace crossgrain

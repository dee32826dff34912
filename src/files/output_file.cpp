// SPDX-License-Identifier: Apache-2.0
#include "files/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <system_error>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// Small writes (lines of text) are buffered up to this size; larger ones are written directly.
constexpr std::size_t kBufferBytes = 1 << 18;

/// The system is asked to start writing to disk in steps of this size. Otherwise it starts at the end, and
/// the final synchronisation waits for everything.
[[maybe_unused]] constexpr std::uint64_t kSentBytes = 1 << 23;

// The user's umask is subtracted.
constexpr mode_t kFileMode = 0666;
constexpr mode_t kFolderMode = 0777;

Remedy remedy_for(int code) {
  switch (code) {
    case EACCES:
    case EPERM:
    case EROFS:
      return Remedy::kChooseWritablePlace;
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
      return Remedy::kFreeSpace;
    case ENOENT:
    case ENOTDIR:
      return Remedy::kMakeFolder;
    default:
      return Remedy::kCheckOutputDisk;
  }
}

[[noreturn]] void fail_output(const std::string& name, const std::string& doing, int code) {
  throw Error(ErrorKind::kOutput,
              {name, "", fmt::format("cannot be {}: {}", doing, std::generic_category().message(code)),
               remedy_for(code)});
}

/// Removes a regular file or a link, if there is one.
void remove_file(const std::filesystem::path& path) {
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || !(S_ISREG(status.st_mode) || S_ISLNK(status.st_mode))) return;
  if (::unlink(path.c_str()) != 0 && errno != ENOENT) fail_output(path.string(), "removed", errno);
}

/// Opens a temporary file with an unused name in the same folder, since a rename works only within a file
/// system.
Descriptor open_temporary(const std::filesystem::path& target, std::string& temporary) {
  for (int attempt = 0;; ++attempt) {
    const std::string name = fmt::format(".{}.{}-{}.part", target.filename().string(), ::getpid(), attempt);
    temporary = (target.parent_path() / name).string();
    Descriptor descriptor(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, kFileMode));
    if (descriptor.is_open() || errno != EEXIST) return descriptor;
  }
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& target) : name_(target.string()) {
  if (target.filename().empty())
    throw Error(ErrorKind::kOutput, {"'" + name_ + "'", "", "names no file to write", Remedy::kNameOutput});
  struct stat status {};
  const bool exists = ::stat(name_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode))
    throw Error(ErrorKind::kOutput, {name_, "", "is a folder, but must be a file", Remedy::kClearPlace});
  if (exists && ::access(name_.c_str(), W_OK) != 0) fail("written", errno);
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = Descriptor(::open(name_.c_str(), O_WRONLY | O_CLOEXEC));
  } else {
    // Links are followed, so that the file is replaced and not the link.
    std::error_code unresolved;
    const auto resolved = std::filesystem::weakly_canonical(target, unresolved);
    if (!unresolved) name_ = resolved.string();
    descriptor_ = open_temporary(name_, temporary_);
  }
  if (!descriptor_.is_open()) {
    temporary_.clear();
    fail("created", errno);
  }
}

OutputFile::OutputFile(std::string name, int descriptor) : name_(std::move(name)), descriptor_(descriptor) {
  if (!descriptor_.is_open()) fail("opened", errno);
}

// Uses a copy of the descriptor, so that closing it leaves standard output open.
OutputFile OutputFile::standard_output() {
  return {"standard output", ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)};
}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void OutputFile::fail(const char* doing, int code) const {
  fail_output(name_, doing, code);
}

void OutputFile::write(std::string_view bytes) {
  if (checksum_) checksum_->add(bytes);
  if (buffer_.size() + bytes.size() > kBufferBytes) flush();
  if (bytes.size() > kBufferBytes) {
    write_at(flushed_, bytes);
    flushed_ += bytes.size();
    start_writing_back();
  } else {
    buffer_ += bytes;
  }
}

void OutputFile::flush() {
  write_at(flushed_, buffer_);
  flushed_ += buffer_.size();
  buffer_.clear();
  start_writing_back();
}

void OutputFile::start_writing_back() {
#ifdef SYNC_FILE_RANGE_WRITE
  if (temporary_.empty() || flushed_ - sent_ < kSentBytes) return;
  // Only a hint: errors show when the file is finished.
  ::sync_file_range(descriptor_.number(), static_cast<off_t>(sent_), static_cast<off_t>(flushed_ - sent_),
                    SYNC_FILE_RANGE_WRITE);
  sent_ = flushed_;
#endif
}

void OutputFile::write_at(std::uint64_t offset, std::string_view bytes) {
  assert(descriptor_.is_open());
  while (!bytes.empty()) {
    const ssize_t done = temporary_.empty() ? ::write(descriptor_.number(), bytes.data(), bytes.size())
                                            : ::pwrite(descriptor_.number(), bytes.data(), bytes.size(),
                                                       static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail("written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(done));
    offset += static_cast<std::uint64_t>(done);
  }
}

void OutputFile::patch(std::uint64_t offset, std::string_view bytes) {
  assert(!temporary_.empty() && !checksum_ && offset + bytes.size() <= position());
  flush();
  write_at(offset, bytes);
}

void OutputFile::finish() {
  if (!descriptor_.is_open()) return;
  flush();
  // Pipes and terminals cannot be synchronised.
  if (!temporary_.empty() && ::fsync(descriptor_.number()) != 0) fail("written", errno);
  if (descriptor_.close() != 0) fail("closed", errno);
}

void OutputFile::commit() {
  finish();
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), name_.c_str()) != 0) fail("put in place", errno);
  temporary_.clear();
}

NewFolders::NewFolders(const std::filesystem::path& folder) {
  if (folder.empty())
    throw Error(ErrorKind::kOutput, {"''", "", "names no folder to write into", Remedy::kNameOutput});
  try {
    make(folder);
  } catch (...) {
    remove();
    throw;
  }
}

void NewFolders::make(const std::filesystem::path& folder) {
  std::filesystem::path reached;
  for (const std::filesystem::path& step : folder) {
    reached /= step;
    if (::mkdir(reached.c_str(), kFolderMode) == 0) {
      made_.push_back(reached);
      continue;
    }
    const int code = errno;
    struct stat status {};
    if (::stat(reached.c_str(), &status) != 0) fail_output(reached.string(), "created", code);
    if (!S_ISDIR(status.st_mode))
      throw Error(ErrorKind::kOutput,
                  {reached.string(), "", "is a file, but must be a folder", Remedy::kClearPlace});
  }
}

void NewFolders::remove() noexcept {
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) ::rmdir(folder->c_str());
  made_.clear();
}

OutputFile& OutputFolder::create(const std::string& name) {
  files_.push_back(std::make_unique<OutputFile>(folder_ / name));
  return *files_.back();
}

void OutputFolder::commit() {
  for (const auto& file : files_) file->finish();
  for (const auto& file : files_) file->commit();
  for (const auto& path : outdated_) remove_file(path);
  made_.keep();
}

void check_writable(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  OutputFolder probe(folder);
  for (const std::string& name : names) probe.create(name);
}

}  // namespace crossgrain

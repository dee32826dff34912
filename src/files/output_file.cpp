// SPDX-License-Identifier: Apache-2.0
#include "files/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cassert>
#include <cerrno>
#include <regex>
#include <system_error>
#include <utility>

#include "crossgrain/error.hpp"
#include "files/folder_calls.hpp"

namespace crossgrain {
namespace {

/// Small writes (lines of text) are buffered up to this size; larger ones are written directly.
constexpr std::size_t kBufferBytes = 1 << 18;

/// The system is asked to start writing to disk in steps of this size. Otherwise it starts at the end, and
/// the final synchronisation waits for everything.
[[maybe_unused]] constexpr std::uint64_t kSentBytes = 1 << 23;

// The user's umask is subtracted.
constexpr mode_t kFileMode = 0666;

/// Returns the file that `target` names, behind all links. Throws Error(kOutput) unless a regular file may be
/// written there. Nothing is opened, since opening a pipe would wait for its reader.
std::filesystem::path behind_links(const std::filesystem::path& target) {
  const std::string& name = target.string();
  const auto refuse = [](const std::string& what, const std::string& text, Remedy remedy) {
    throw Error(ErrorKind::kOutput, {what, "", text, remedy});
  };
  if (target.filename().empty()) refuse("'" + name + "'", "names no file to write", Remedy::kNameOutput);
  struct stat status {};
  if (::stat(name.c_str(), &status) != 0) {
    if (errno == ENOENT && ::lstat(name.c_str(), &status) == 0)
      refuse(name, "is a link to nothing", Remedy::kClearPlace);
    return target;
  }
  if (S_ISDIR(status.st_mode)) refuse(name, "is a folder, but must be a file", Remedy::kClearPlace);
  if (!S_ISREG(status.st_mode)) refuse(name, "is not a regular file", Remedy::kClearPlace);
  if (::access(name.c_str(), W_OK) != 0) fail_output(name, "written", errno);
  std::error_code unresolved;
  const auto path = std::filesystem::canonical(target, unresolved);
  return unresolved ? target : path;
}

/// Opens a temporary file with an unused name, in the folder of its target, since a rename works only within
/// a file system.
Descriptor open_temporary(int folder, const std::string& target, std::string& temporary) {
  for (int attempt = 0;; ++attempt) {
    temporary = fmt::format(".{}.{}-{}.part", target, ::getpid(), attempt);
    Descriptor descriptor(
        ::openat(folder, temporary.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kFileMode));
    if (descriptor.is_open() || errno != EEXIST) return descriptor;
  }
}

}  // namespace

OutputFile::OutputFile(const std::filesystem::path& target) : name_(target.string()) {
  const std::filesystem::path path = behind_links(target);
  target_ = path.filename().string();
  folder_ = open_folder(path.parent_path());
  if (folder_.is_open()) descriptor_ = open_temporary(folder_.number(), target_, temporary_);
  if (!descriptor_.is_open()) {
    temporary_.clear();
    fail("created", errno);
  }
}

OutputFile::OutputFile(int folder, std::string name, std::string shown)
    : name_(std::move(shown)),
      target_(std::move(name)),
      descriptor_(::openat(folder, target_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, kFileMode)) {
  if (!descriptor_.is_open()) fail("created", errno);
}

OutputFile::OutputFile(std::string name, int descriptor)
    : name_(std::move(name)), is_stream_(true), descriptor_(descriptor) {
  if (!descriptor_.is_open()) fail("opened", errno);
}

// Uses a copy of the descriptor, so that closing it leaves standard output open.
OutputFile OutputFile::standard_output() {
  return {"standard output", ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)};
}

OutputFile::~OutputFile() {
  if (!temporary_.empty()) ::unlinkat(folder_.number(), temporary_.c_str(), 0);
}

void OutputFile::fail(const char* doing, int code) const {
  fail_output(name_, doing, code);
}

void OutputFile::write(std::string_view bytes) {
  crc_.add(bytes);
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
  if (is_stream_ || flushed_ - sent_ < kSentBytes) return;
  // Only a hint: errors show when the file is finished.
  ::sync_file_range(descriptor_.number(), static_cast<off_t>(sent_), static_cast<off_t>(flushed_ - sent_),
                    SYNC_FILE_RANGE_WRITE);
  sent_ = flushed_;
#endif
}

void OutputFile::write_at(std::uint64_t offset, std::string_view bytes) {
  assert(descriptor_.is_open());
  while (!bytes.empty()) {
    const ssize_t done =
        is_stream_ ? ::write(descriptor_.number(), bytes.data(), bytes.size())
                   : ::pwrite(descriptor_.number(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (done < 0 && errno == EINTR) continue;
    if (done < 0) fail("written", errno);
    bytes.remove_prefix(static_cast<std::size_t>(done));
    offset += static_cast<std::uint64_t>(done);
  }
}

std::string OutputFile::read_at(std::uint64_t offset, std::size_t size) const {
  std::string bytes(size, '\0');
  for (std::size_t begin = 0; begin < size;) {
    const ssize_t done =
        ::pread(descriptor_.number(), bytes.data() + begin, size - begin, static_cast<off_t>(offset + begin));
    if (done < 0 && errno == EINTR) continue;
    if (done <= 0) fail("read", done < 0 ? errno : EIO);
    begin += static_cast<std::size_t>(done);
  }
  return bytes;
}

void OutputFile::patch(std::uint64_t offset, std::string_view bytes) {
  assert(!is_stream_ && offset + bytes.size() <= position());
  flush();
  crc_.replace(read_at(offset, bytes.size()), bytes, position() - offset - bytes.size());
  write_at(offset, bytes);
}

void OutputFile::finish() {
  if (!descriptor_.is_open()) return;
  flush();
  // Pipes and terminals cannot be synchronised.
  if (!is_stream_ && ::fsync(descriptor_.number()) != 0) fail("written", errno);
  if (descriptor_.close() != 0) fail("closed", errno);
}

void OutputFile::commit() {
  finish();
  if (temporary_.empty()) return;
  const int folder = folder_.number();
  if (::renameat(folder, temporary_.c_str(), folder, target_.c_str()) != 0) fail("put in place", errno);
  temporary_.clear();
  if (!sync_folder(folder)) fail("put in place", errno);
}

bool is_temporary_name(const std::string& name) {
  static const std::regex pattern(R"(\..+\.[0-9]+-[0-9]+\.part)");
  return std::regex_match(name, pattern);
}

}  // namespace crossgrain

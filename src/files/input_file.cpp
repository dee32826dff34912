// SPDX-License-Identifier: Apache-2.0
#include "files/input_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "files/descriptor.hpp"
#include "files/read_memory.hpp"

namespace crossgrain {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& text, Remedy remedy) {
  throw Error(ErrorKind::kInput, {name, "", text, remedy});
}

[[noreturn]] void fail_to_open(const std::string& name, int code) {
  if (code == ENOENT) refuse(name, "there is no such file", Remedy::kCheckPath);
  if (code == EACCES) refuse(name, "no permission to read it", Remedy::kAllowReading);
  refuse(name, "cannot be read: " + std::generic_category().message(code), Remedy::kCheckDisk);
}

/// Reads up to `size` bytes; fewer if the file ends earlier.
std::size_t read_fully(int descriptor, char* out, std::size_t size, const std::string& name) {
  constexpr std::size_t kPiece = std::size_t{1} << 24;
  std::size_t done = 0;
  while (done < size) {
    check_watched();
    const ssize_t got = ::read(descriptor, out + done, std::min(kPiece, size - done));
    if (got == 0) break;
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail_to_open(name, errno);
    done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path) : name_(path.string()) {
  struct stat status {};
  // Checked before opening, since opening a pipe would wait for its writer.
  if (::stat(name_.c_str(), &status) != 0) fail_to_open(name_, errno);
  if (S_ISDIR(status.st_mode)) refuse(name_, "is a folder", Remedy::kGiveFile);
  if (!S_ISREG(status.st_mode)) refuse(name_, "is not a regular file", Remedy::kGiveFile);
  if (status.st_size == 0) refuse(name_, "is empty", Remedy::kCopyAgain);

  const auto size = static_cast<std::size_t>(status.st_size);
  require_read_memory(name_, static_cast<double>(size));
  try {
    bytes_ = std::make_unique_for_overwrite<char[]>(size);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorKind::kLimit,
                {name_, "", fmt::format("its {} bytes do not fit into memory", size), Remedy::kSimplify});
  }
  const Descriptor descriptor(::open(name_.c_str(), O_RDONLY | O_CLOEXEC));
  if (!descriptor.is_open()) fail_to_open(name_, errno);
  size_ = read_fully(descriptor.number(), bytes_.get(), size, name_);
}

InputFile InputFile::standard_input() {
  const std::string name = "standard input";
  std::size_t capacity = std::size_t{1} << 16, size = 0;
  auto bytes = std::make_unique_for_overwrite<char[]>(capacity);
  for (;;) {
    size += read_fully(STDIN_FILENO, bytes.get() + size, capacity - size, name);
    if (size < capacity) break;
    require_read_memory(name, 2 * static_cast<double>(capacity));
    auto larger = std::make_unique_for_overwrite<char[]>(2 * capacity);
    std::copy_n(bytes.get(), size, larger.get());
    bytes = std::move(larger);
    capacity *= 2;
  }
  if (size == 0) refuse(name, "is empty, but lines are expected", Remedy::kNone);
  return {name, std::move(bytes), size};
}

std::string in_words(const Place& place) {
  return place.unit == nullptr ? "" : fmt::format("{} {}", place.unit, place.number);
}

void fail_input(const InputFile& file, const Place& place, const std::string& text, Remedy remedy) {
  throw Error(ErrorKind::kInput, {file.name(), in_words(place), text, remedy});
}

std::string in_quotes(std::string_view word) {
  constexpr std::size_t kShown = 32;
  std::string text(word.substr(0, kShown));
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c > 0x7e; }, '?');
  return "'" + text + (word.size() > kShown ? "...'" : "'");
}

}  // namespace crossgrain

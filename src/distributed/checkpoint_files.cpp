// SPDX-License-Identifier: Apache-2.0
#include "distributed/checkpoint_files.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <utility>

#include "crossgrain/error.hpp"

namespace crossgrain {

void refuse_checkpoint(const std::string& path, std::string text, Remedy remedy) {
  throw Error(ErrorKind::kInput, {path, "", std::move(text), remedy});
}

void fail_to_keep(const std::string& path, int error) {
  throw Error(ErrorKind::kOutput, {path, "", std::strerror(error), Remedy::kMoveCheckpoint});
}

void read_bytes(const std::string& path, std::uint64_t offset, std::span<std::byte> bytes) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(static_cast<std::streamoff>(offset));
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!file) refuse_checkpoint(path, "cannot be read");
}

std::vector<int> numbers_of_files(const std::string& folder, const std::string& name) {
  std::vector<int> numbers;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string file = entry.path().filename().string();
    if (!file.starts_with(name)) continue;
    const std::string digits = file.substr(name.size());
    const bool is_number = !digits.empty() && digits.size() <= 2 &&
                           std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
    if (is_number) numbers.push_back(std::stoi(digits));
  }
  if (error) refuse_checkpoint(folder, error.message(), Remedy::kGiveCheckpoint);
  std::ranges::sort(numbers);
  return numbers;
}

int made_empty(const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file < 0) return errno;
  return ::close(file) == 0 ? 0 : errno;
}

int written(const std::string& path, std::span<const SharedFiles::Part> parts) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) return errno;
  int error = 0;
  for (const auto& [offset, bytes] : parts) {
    for (std::size_t done = 0; done < bytes.size() && error == 0;) {
      const ssize_t now =
          ::pwrite(file, bytes.data() + done, bytes.size() - done, static_cast<off_t>(offset + done));
      if (now > 0) done += static_cast<std::size_t>(now);
      if (now < 0 && errno != EINTR) error = errno;
    }
  }
  if (error == 0 && ::fsync(file) != 0) error = errno;
  if (::close(file) != 0 && error == 0) error = errno;
  return error;
}

}  // namespace crossgrain

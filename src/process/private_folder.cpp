// SPDX-License-Identifier: Apache-2.0
#include "process/private_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

/// Less than what a program writes at once.
constexpr std::uintmax_t kLeastSpace = std::uintmax_t{1} << 16;

struct Close {
  void operator()(std::FILE* file) const { std::fclose(file); }
};

}  // namespace

PrivateFolder::PrivateFolder() {
  std::error_code code;
  path_ = std::filesystem::temp_directory_path(code);
  if (code) path_ = "/tmp";
  std::string name = (path_ / "crossgrain-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr) fail(std::strerror(errno));
  path_ = name;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void PrivateFolder::write(const char* name, std::string_view bytes) const {
  const std::unique_ptr<std::FILE, Close> file(std::fopen((path_ / name).c_str(), "wbxe"));
  if (!file || std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() ||
      std::fflush(file.get()) != 0)
    fail(std::strerror(errno));
}

bool PrivateFolder::is_full() const {
  std::error_code code;
  const std::filesystem::space_info space = std::filesystem::space(path_, code);
  return !code && space.available < kLeastSpace;
}

void PrivateFolder::fail(const std::string& reason) const {
  throw Error(ErrorKind::kOutput, {path_.string(), "", "temporary files cannot be written: " + reason,
                                   Remedy::kFreeTemporarySpace});
}

}  // namespace crossgrain

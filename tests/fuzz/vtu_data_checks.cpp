// SPDX-License-Identifier: Apache-2.0
#include <optional>
#include <string>

#include "fuzz/reader_checks.hpp"
#include "vtu/vtu_data.hpp"

namespace crossgrain {

bool check_vtu_data(std::string_view bytes) {
  if (bytes.empty()) return false;
  const auto has = [flags = static_cast<unsigned char>(bytes[0])](unsigned flag) {
    return (flags & flag) != 0;
  };
  const VtuPackage package{has(VtuDataFlags::kWide) ? NumberType::kUint64 : NumberType::kUint32,
                           has(VtuDataFlags::kSwapped), has(VtuDataFlags::kCompressed)};
  std::optional<std::string> data;
  if (!succeeds(
          [&] { data = unpack_vtu_data("input.vtu", bytes.substr(1), has(VtuDataFlags::kBase64), package); }))
    return false;
  // Deflate reaches 1032 bytes a byte (zlib, "Maximum Compression Factor").
  const std::size_t most = (package.is_compressed ? 1032 : 1) * bytes.size();
  require(!data || data->size() <= most, "more data than the bytes can hold");
  return data.has_value();
}

}  // namespace crossgrain

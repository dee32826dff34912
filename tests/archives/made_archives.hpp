// SPDX-License-Identifier: Apache-2.0
// Archives made on the spot, with code of its own.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace crossgrain {

/// A stream of deflate; window_bits as for deflateInit2: negative for none around it, 16 more for gzip's.
inline std::string deflated(std::string_view bytes, int window_bits) {
  z_stream stream{};
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&stream, bytes.size()), '\0');
  stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<unsigned char*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  deflate(&stream, Z_FINISH);
  out.resize(out.size() - stream.avail_out);
  deflateEnd(&stream);
  return out;
}

inline std::string gzipped(std::string_view bytes) {
  return deflated(bytes, 16 + MAX_WBITS);
}

using Members = std::vector<std::pair<std::string, std::string>>;

/// A ZIP archive of members with their names, packed by deflate unless `is_stored`. `flags` are those of all.
inline std::string zipped(const Members& members, bool is_stored = false, std::uint16_t flags = 0) {
  std::string out, directory;
  const auto put = [](std::string& to, std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) to += static_cast<char>(value >> 8 * i & 255);
  };
  for (const auto& [name, content] : members) {
    const std::string data = is_stored ? content : deflated(content, -MAX_WBITS);
    std::string entry;  // what both headers have
    put(entry, 20, 2);
    put(entry, flags, 2);
    put(entry, is_stored ? 0 : Z_DEFLATED, 2);
    put(entry, 0, 4);
    put(entry,
        crc32(0, reinterpret_cast<const unsigned char*>(content.data()), static_cast<uInt>(content.size())),
        4);
    put(entry, data.size(), 4);
    put(entry, content.size(), 4);
    put(entry, name.size(), 2);
    put(entry, 0, 2);
    directory += "PK\x01\x02";
    put(directory, 20, 2);
    directory += entry;
    put(directory, 0, 10);
    put(directory, out.size(), 4);
    directory += name;
    out += "PK\x03\x04" + entry + name + data;
  }
  const std::size_t at = out.size();
  out += directory + "PK\x05\x06";
  put(out, 0, 4);
  put(out, members.size(), 2);
  put(out, members.size(), 2);
  put(out, directory.size(), 4);
  put(out, at, 4);
  put(out, 0, 2);
  return out;
}

}  // namespace crossgrain

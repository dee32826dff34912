// SPDX-License-Identifier: Apache-2.0
// The checksum of a file at its end, for files that no report lists (SolveReport::files): the report itself,
// and what commands write alone under names that nobody gave.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "crossgrain/monitor.hpp"
#include "files/output_file.hpp"

namespace crossgrain {

/// The form that a kind of file has for it.
enum class SealForm {
  kXml,   ///< a comment, after all elements
  kText,  ///< a line of comment that begins with #
  kJson,  ///< the last member of an object, `checksum`, and the end of that
  kPng    ///< a tEXt chunk, before the last chunk, which belongs to it
};

/// Returns the last bytes of a file, given the CRC-32 of all bytes before them.
std::string seal_text(SealForm form, std::uint32_t crc);

/// Writes the last bytes of a file.
void write_seal(OutputFile& file, SealForm form);

/// Returns whether a file ends with the checksum of all that stands before it, in any form; false for
/// anything but a readable regular file. Follows links. Throws Error(kInterrupted).
bool has_whole_seal(const std::filesystem::path& path, const Monitor& monitor = {});

/// Returns whether a file has so many bytes, with this CRC-32 (Crc32::text); false for anything but a
/// readable regular file. Looks at the size first. Follows links. Throws Error(kInterrupted).
bool has_content(const std::filesystem::path& path, std::uint64_t bytes, const std::string& crc,
                 const Monitor& monitor = {});

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// ZIP archives as the documents of other programs (3MF, FreeCAD) are.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "files/input_file.hpp"

namespace crossgrain {

/// The members of an archive in memory.
class ZipArchive {
 public:
  /// `file` must outlive the archive. Throws Error(kInput) if it is no ZIP archive, or its directory is
  /// damaged or cut off.
  explicit ZipArchive(const InputFile& file);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  /// Returns whether there is a member of this name, up to the case of its letters.
  bool holds(std::string_view name) const;

  /// Returns the bytes of a member. Takes memory for what comes out, within the limits of reading. Throws
  /// Error(kInput) if there is no such member, if it is encrypted or packed in an unknown manner, or if it is
  /// damaged, by its checksum; Error(kLimit).
  std::string read(std::string_view name) const;

  const InputFile& file() const { return file_; }

 private:
  struct Directory;

  [[noreturn]] void fail(std::string_view member, const std::string& text) const;

  const InputFile& file_;
  std::unique_ptr<Directory> directory_;
};

}  // namespace crossgrain

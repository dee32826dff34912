// SPDX-License-Identifier: Apache-2.0
#include "files/file_seal.hpp"

#include <gtest/gtest.h>

#include "files/crc32.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

constexpr SealForm kForms[] = {SealForm::kXml, SealForm::kText, SealForm::kJson, SealForm::kPng};

TEST(FileSeal, IsWholeWhileNoByteIsChangedAddedOrMissing) {
  const TemporaryFolder folder;
  for (const SealForm form : kForms) {
    OutputFile file(folder.path() / "a");
    file.write("some content\n");
    write_seal(file, form);
    file.commit();
    const std::string whole = content_of(folder.path() / "a");
    EXPECT_TRUE(has_whole_seal(folder.path() / "a")) << whole;
    EXPECT_FALSE(has_whole_seal(folder.write("b", whole + "\n"))) << whole;
    for (std::size_t k = 0; k < whole.size(); ++k) {
      std::string changed = whole;
      changed[k] ^= 1;
      EXPECT_FALSE(has_whole_seal(folder.write("b", changed))) << whole << " at byte " << k;
      EXPECT_FALSE(has_whole_seal(folder.write("b", std::string(whole).erase(k, 1))))
          << whole << " at byte " << k;
    }
  }
}

TEST(FileSeal, IsInNoFileWithoutOne) {
  const TemporaryFolder folder;
  EXPECT_FALSE(has_whole_seal(folder.write("a", "")));
  EXPECT_FALSE(has_whole_seal(folder.write("a", std::string(1000, '0'))));
  EXPECT_FALSE(has_whole_seal(folder.path() / "missing"));
  EXPECT_FALSE(has_whole_seal(folder.path()));
}

TEST(FileContent, IsKnownBySizeAndSum) {
  const TemporaryFolder folder;
  const std::string large(3'000'000, 'x');
  const auto path = folder.write("a", large);
  Crc32 crc;
  crc.add(large);
  EXPECT_TRUE(has_content(path, large.size(), crc.text()));
  EXPECT_FALSE(has_content(path, large.size() - 1, crc.text()));
  EXPECT_FALSE(has_content(path, large.size(), "00000000"));
  EXPECT_FALSE(has_content(folder.path(), 0, "00000000"));
}

}  // namespace
}  // namespace crossgrain

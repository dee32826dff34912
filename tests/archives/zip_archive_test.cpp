// SPDX-License-Identifier: Apache-2.0
#include "archives/zip_archive.hpp"

#include <gtest/gtest.h>

#include <random>

#include "archives/archive_errors.hpp"
#include "archives/made_archives.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

const Members kMembers{
    {"3D/a.model", std::string(300'000, 'a') + "b"}, {"empty", ""}, {"_rels/.rels", "<r/>"}};

InputFile file_of(const std::string& bytes) {
  const TemporaryFolder folder;
  return InputFile(folder.write("a.3mf", bytes));
}

TEST(ZipArchive, GivesItsMembersByNameInEitherCase) {
  for (const bool is_stored : {false, true}) {
    const InputFile file = file_of(zipped(kMembers, is_stored));
    const ZipArchive archive(file);
    for (const auto& [name, content] : kMembers) {
      EXPECT_TRUE(archive.holds(name));
      EXPECT_TRUE(archive.read(name) == content) << name;
    }
    EXPECT_EQ(archive.read("_RELS/.rels"), "<r/>");
    EXPECT_FALSE(archive.holds("a.model"));
  }
}

TEST(ZipArchive, NamesAMemberThatIsMissingEncryptedOrDamaged) {
  const InputFile sound = file_of(zipped(kMembers));
  const ZipArchive archive(sound);
  EXPECT_NE(input_error([&] { archive.read("none"); }).find("'none': is missing in the archive"),
            std::string::npos);

  const InputFile locked = file_of(zipped(kMembers, false, 1));
  const ZipArchive encrypted(locked);
  EXPECT_NE(input_error([&] { encrypted.read("3D/a.model"); }).find("'3D/a.model': is encrypted"),
            std::string::npos);

  std::string bytes = zipped(kMembers, true);
  bytes[bytes.find("aaab")] = 'c';
  const InputFile changed = file_of(bytes);
  const ZipArchive damaged(changed);
  EXPECT_NE(input_error([&] { damaged.read("3D/a.model"); }).find("is damaged"), std::string::npos);
  EXPECT_EQ(damaged.read("_rels/.rels"), "<r/>");
}

TEST(ZipArchive, RefusesWhatIsCutShortOrNoArchive) {
  const std::string sound = zipped(kMembers);
  const auto error_of = [&](const std::string& bytes) {
    const InputFile file = file_of(bytes);
    return input_error([&] { const ZipArchive archive(file); });
  };
  for (const std::size_t size : {std::size_t{4}, sound.size() / 2, sound.size() - 30})
    EXPECT_NE(error_of(sound.substr(0, size)).find("cut short or damaged"), std::string::npos) << size;
  EXPECT_NE(error_of("solid a").find("is no ZIP archive"), std::string::npos);
}

TEST(ZipArchive, SurvivesDamage) {
  const std::string sound = zipped({{"a", "some words"}, {"b", std::string(3000, 'b')}});
  std::mt19937 random(5);
  for (int trial = 0; trial < 2000; ++trial) {
    std::string bytes = sound;
    for (int flips = 0; flips < 3; ++flips) bytes[random() % bytes.size()] = static_cast<char>(random());
    const InputFile file = file_of(bytes);
    try {
      const ZipArchive archive(file);
      for (const char* name : {"a", "b"}) archive.read(name);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kInput);
    }
  }
}

}  // namespace
}  // namespace crossgrain

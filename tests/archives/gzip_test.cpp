// SPDX-License-Identifier: Apache-2.0
#include "archives/gzip.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "archives/archive_errors.hpp"
#include "archives/made_archives.hpp"
#include "crossgrain/read_limits.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

/// More than one step of reading, and not the same anywhere.
std::string long_text() {
  std::string text;
  for (std::int64_t i = 0; i < 400'000; ++i) text += std::to_string(i * 7919) + "\n";
  return text;
}

TEST(Gzip, GivesBackWhatWasPackedUnderTheNameOfTheFile) {
  const TemporaryFolder folder;
  for (const std::string& text : {std::string("a"), std::string(100'000, '\0'), long_text()}) {
    const auto path = folder.write("a.txt.GZ", gzipped(text));
    const InputFile file = read_unpacked(path);
    EXPECT_TRUE(file.bytes() == text);
    EXPECT_EQ(file.name(), path.string());
    EXPECT_FALSE(file.is_on_disk());
  }
}

TEST(Gzip, LeavesOtherNamesAlone) {
  const TemporaryFolder folder;
  const std::string packed = gzipped("a");
  const InputFile file = read_unpacked(folder.write("a.txt", packed));
  EXPECT_EQ(file.bytes(), packed);
  EXPECT_TRUE(file.is_on_disk());
  EXPECT_EQ(unpacked_name("b/a.step.gz"), "b/a.step");
  EXPECT_EQ(unpacked_name("b/a.STEP.GZ"), "b/a.STEP");
  EXPECT_EQ(unpacked_name("b/a.step"), "b/a.step");
}

TEST(Gzip, JoinsMembersAndPassesOverZerosBehindThem) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.gz", gzipped("one ") + gzipped("two") + std::string(700, '\0'));
  EXPECT_EQ(read_unpacked(path).bytes(), "one two");
}

TEST(Gzip, RefusesWhatIsCutShortDamagedOrNone) {
  const TemporaryFolder folder;
  const std::string sound = gzipped(long_text());
  const auto error_of = [&](const std::string& bytes) {
    return input_error([&] { read_unpacked(folder.write("a.gz", bytes)); });
  };
  for (const std::size_t size : {std::size_t{3}, std::size_t{12}, sound.size() / 2, sound.size() - 1})
    EXPECT_NE(error_of(sound.substr(0, size)).find("a.gz: is a gzip archive cut short; copy"),
              std::string::npos);
  std::string damaged = sound;
  damaged[damaged.size() - 6] ^= 1;  // of the checksum
  EXPECT_NE(error_of(damaged).find("is a damaged gzip archive"), std::string::npos);
  EXPECT_NE(error_of("solid a").find("does not begin like a gzip archive"), std::string::npos);
  EXPECT_NE(error_of(gzipped(gzipped("a"))).find("packed by gzip twice"), std::string::npos);
  EXPECT_NE(error_of(gzipped("")).find("of nothing"), std::string::npos);
  EXPECT_NE(error_of(gzipped("a") + "more").find("has other bytes behind"), std::string::npos);
}

TEST(Gzip, KeepsTheLimitOfMemoryWhateverItUnpacksTo) {
  const TemporaryFolder folder;
  // 200 MB in 200 kB.
  std::string bomb;
  const std::string member = gzipped(std::string(20'000'000, ' '));
  for (int i = 0; i < 10; ++i) bomb += member;
  const auto path = folder.write("a.gz", bomb);
  const Monitor monitor;
  const ReadLimits limits(monitor, std::size_t{100'000'000});
  try {
    read_unpacked(path);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kLimit);
    EXPECT_NE(std::string(error.what()).find("are allowed"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "files/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <optional>

#include "files/output_error.hpp"
#include "files/small_files.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

TEST(OutputFile, AppearsOnlyWhenCommitted) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "a.txt";
  OutputFile file(path);
  file.write("first ");
  file.write("second");
  EXPECT_FALSE(std::filesystem::exists(path));
  file.commit();
  EXPECT_EQ(content_of(path), "first second");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, LeavesTheEarlierFileAloneWithoutCommit) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.txt", "earlier");
  { OutputFile(path).write("half of a new on"); }
  EXPECT_EQ(content_of(path), "earlier");
  EXPECT_EQ(folder.names().size(), 1u);
}

TEST(OutputFile, ReplacesTheEarlierFile) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.txt", "a longer text than the new one");
  OutputFile file(path);
  file.write("new");
  file.commit();
  EXPECT_EQ(content_of(path), "new");
}

TEST(OutputFile, WritesThroughALink) {
  const TemporaryFolder folder;
  const auto path = folder.write("a.txt", "earlier");
  std::filesystem::create_symlink(path, folder.path() / "link");
  OutputFile file(folder.path() / "link");
  file.write("new");
  file.commit();
  EXPECT_EQ(content_of(path), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link"));
}

TEST(OutputFile, GetsThePermissionsOfTheUmask) {
  const TemporaryFolder folder;
  const mode_t before = ::umask(027);
  OutputFile file(folder.path() / "a.txt");
  file.commit();
  ::umask(before);
  struct stat status {};
  ASSERT_EQ(::stat((folder.path() / "a.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST(OutputFile, PatchesWhatHasBeenWritten) {
  const TemporaryFolder folder;
  OutputFile file(folder.path() / "a.txt");
  const std::string large(1'000'000, '.');
  file.write("offset=___ ");
  file.write(large);
  EXPECT_EQ(file.position(), 11 + large.size());
  file.patch(7, "123");
  file.write("end");
  file.patch(11 + large.size(), "END");
  file.commit();
  const std::string content = "offset=123 " + large + "END";
  EXPECT_EQ(content_of(folder.path() / "a.txt"), content);
  Crc32 crc;
  crc.add(content);
  EXPECT_EQ(file.crc().value(), crc.value());
}

TEST(OutputFile, SumsUpItsBytesHoweverTheyComeIn) {
  const TemporaryFolder folder;
  OutputFile file(folder.path() / "a.txt");
  file.write("foo");
  file.write("");
  file.write("bar");
  EXPECT_EQ(file.crc().text(), "9ef61f95") << "CRC-32 of foobar";
}

TEST(OutputFile, LeavesNothingBehindWhenTheDiskFillsUpAndSaysHowToMendIt) {
  const TemporaryFolder folder;
  const SmallFiles limit;
  const std::string message = output_error_of([&] {
    OutputFile file(folder.path() / "a.txt");
    file.write(std::string(300'000, 'x'));
    file.commit();
  });
  EXPECT_NE(message.find("a.txt: cannot be written: File too large; free some space"), std::string::npos)
      << message;
  EXPECT_TRUE(folder.names().empty());
}

TEST(OutputFile, RefusesPipesDevicesAndLinksToNothingAtOnce) {
  const TemporaryFolder folder;
  const auto pipe = folder.path() / "pipe", link = folder.path() / "link";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::filesystem::create_symlink("nowhere", link);
  for (const std::filesystem::path& path : {pipe, std::filesystem::path("/dev/full")}) {
    const std::string message = output_error_of([&] { OutputFile file(path); });
    EXPECT_NE(message.find(path.string() + ": is not a regular file; remove it"), std::string::npos)
        << message;
  }
  const std::string message = output_error_of([&] { OutputFile file(link); });
  EXPECT_NE(message.find("link: is a link to nothing; remove it"), std::string::npos) << message;
}

TEST(OutputFile, LeavesNothingInAFolderThatIsMovedMeanwhile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "a");
  std::optional<OutputFile> dropped, kept;
  dropped.emplace(folder.path() / "a" / "dropped");
  kept.emplace(folder.path() / "a" / "kept");
  std::filesystem::rename(folder.path() / "a", folder.path() / "b");
  dropped.reset();
  kept->commit();
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "b" / "kept"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path() / "b"), {}), 1);
}

TEST(OutputFile, RefusesAFolderInItsPlaceAndAMissingFolder) {
  const TemporaryFolder folder;
  EXPECT_NE(output_error_of([&] { OutputFile file(folder.path()); }).find("is a folder"), std::string::npos);
  output_error_of([&] { OutputFile file(folder.path() / ""); });
  const std::string message = output_error_of([&] { OutputFile file(folder.path() / "none" / "a.txt"); });
  EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
}

}  // namespace
}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "files/output_file.hpp"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <functional>

#include "crossgrain/error.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

/// The message of the Error(kOutput) that `action` gives.
std::string output_error_of(const std::function<void()>& action) {
  try {
    action();
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kOutput);
    return error.what();
  }
  return "";
}

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
  file.commit();
  EXPECT_EQ(content_of(folder.path() / "a.txt"), "offset=123 " + large + "end");
}

TEST(OutputFile, SumsUpItsBytesHoweverTheyComeIn) {
  const TemporaryFolder folder;
  OutputFile file(folder.path() / "a.txt");
  EXPECT_FALSE(file.checksum());
  file.keep_checksum();
  file.write("foo");
  file.write("bar");
  EXPECT_EQ(file.checksum()->value(), 0x85944171f73967e8u) << "FNV-1a of foobar";
}

TEST(OutputFile, SaysThatTheDiskIsFullAndHowToMendIt) {
  OutputFile file("/dev/full");
  file.write("some text");
  const std::string message = output_error_of([&] { file.commit(); });
  EXPECT_NE(message.find("/dev/full: cannot be written: No space left"), std::string::npos) << message;
  EXPECT_NE(message.find("free some space"), std::string::npos) << message;
}

TEST(OutputFile, LeavesNothingBehindWhenTheDiskFillsUp) {
  const TemporaryFolder folder;
  // A limit on the size of files stands in for the size of the disk.
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{100'000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const std::string message = output_error_of([&] {
    OutputFolder output(folder.path() / "out");
    OutputFile& file = output.create("field.vtu");
    file.write(std::string(300'000, 'x'));
    output.commit();
  });
  ::setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("field.vtu: cannot be written"), std::string::npos) << message;
  EXPECT_TRUE(folder.names().empty());
}

TEST(OutputFile, RefusesAFolderInItsPlaceAndAMissingFolder) {
  const TemporaryFolder folder;
  EXPECT_NE(output_error_of([&] { OutputFile file(folder.path()); }).find("is a folder"), std::string::npos);
  output_error_of([&] { OutputFile file(folder.path() / ""); });
  const std::string message = output_error_of([&] { OutputFile file(folder.path() / "none" / "a.txt"); });
  EXPECT_NE(message.find("No such file or directory"), std::string::npos) << message;
}

TEST(OutputFolder, PublishesAllItsFilesTogether) {
  const TemporaryFolder folder;
  OutputFolder output(folder.path() / "new" / "deeper");
  output.create("a").write("1");
  output.create("b").write("2");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "new/deeper/a"));
  output.commit();
  EXPECT_EQ(content_of(folder.path() / "new/deeper/a"), "1");
  EXPECT_EQ(content_of(folder.path() / "new/deeper/b"), "2");
}

TEST(OutputFolder, RemovesTheFoldersItMadeUnlessCommitted) {
  const TemporaryFolder folder;
  { OutputFolder(folder.path() / "new" / "deeper/").create("a").write("1"); }
  EXPECT_TRUE(folder.names().empty());
}

TEST(OutputFolder, LeavesAnExistingFolderAndItsFiles) {
  const TemporaryFolder folder;
  folder.write("other", "content");
  { OutputFolder(folder.path()).create("a").write("1"); }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"other"});
}

TEST(OutputFolder, RemovesOutdatedFilesOnlyOnceItsOwnAreComplete) {
  const TemporaryFolder folder;
  folder.write("outdated", "content");
  std::filesystem::create_symlink(folder.write("target", "content"), folder.path() / "link");
  const std::vector<std::string> before = folder.names();
  {
    OutputFolder output(folder.path());
    output.create("a").write("1");
    output.remove_at_commit("outdated");
  }
  EXPECT_EQ(folder.names(), before);
  OutputFolder output(folder.path());
  output.create("a").write("1");
  for (const char* name : {"outdated", "link", "missing"}) output.remove_at_commit(name);
  output.commit();
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "target"}));
}

TEST(OutputFolder, RemovesNothingThatIsNoFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "outdated");
  OutputFolder output(folder.path());
  output.create("a").write("1");
  output.remove_at_commit("outdated");
  output.commit();
  EXPECT_EQ(folder.names(), (std::vector<std::string>{"a", "outdated"}));
}

TEST(OutputFolder, RefusesAFileInTheWay) {
  const TemporaryFolder folder;
  folder.write("file", "content");
  for (const char* name : {"file", "file/deeper"}) {
    const std::string message = output_error_of([&] { OutputFolder output(folder.path() / name); });
    EXPECT_NE(message.find("is a file, but must be a folder"), std::string::npos) << message;
  }
}

TEST(OutputFolder, RefusesWhereNoFolderCanBeMade) {
  const std::string message = output_error_of([] { OutputFolder output("/proc/crossgrain/out"); });
  EXPECT_NE(message.find("/proc/crossgrain: cannot be created"), std::string::npos) << message;
}

TEST(CheckWritable, LeavesNoTrace) {
  const TemporaryFolder folder;
  check_writable(folder.path() / "new" / "deeper", {"field.vtu", "report.json"});
  EXPECT_TRUE(folder.names().empty());
}

TEST(CheckWritable, RefusesAFolderInThePlaceOfAFile) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "field.vtu");
  output_error_of([&] { check_writable(folder.path(), {"report.json", "field.vtu"}); });
}

TEST(CheckWritable, RefusesAProtectedFolder) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read);
  output_error_of([&] { check_writable(folder.path(), {"a"}); });
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

}  // namespace
}  // namespace crossgrain

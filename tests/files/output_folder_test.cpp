// SPDX-License-Identifier: Apache-2.0
#include "files/output_folder.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "files/folder_completion.hpp"
#include "files/output_error.hpp"
#include "files/replaced_names.hpp"
#include "files/temporary_folder.hpp"

namespace crossgrain {
namespace {

namespace fs = std::filesystem;

TEST(OutputFolder, PublishesAllItsFilesTogether) {
  const TemporaryFolder folder;
  OutputFolder output(folder.path() / "new" / "deeper");
  output.create("a").write("1");
  output.create("b").write("2");
  EXPECT_FALSE(fs::exists(folder.path() / "new/deeper/a"));
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
  fs::create_symlink(folder.write("target", "content"), folder.path() / "link");
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
  fs::create_directory(folder.path() / "outdated");
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

TEST(ReservedFolder, LeavesNoTraceWhenItIsNotUsed) {
  const TemporaryFolder folder;
  reserve_writable(folder.path() / "new" / "deeper", {"field.vtu", "report.json"});
  EXPECT_TRUE(folder.names().empty());
}

TEST(ReservedFolder, RefusesAFolderInThePlaceOfAFile) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "field.vtu");
  output_error_of([&] { reserve_writable(folder.path(), {"report.json", "field.vtu"}); });
}

TEST(ReservedFolder, RefusesAProtectedFolder) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  const TemporaryFolder folder;
  fs::permissions(folder.path(), fs::perms::owner_read);
  output_error_of([&] { reserve_writable(folder.path(), {"a"}); });
  fs::permissions(folder.path(), fs::perms::owner_all);
}

/// Writes a file `a` into a folder, replacing `outdated`.
void write_new(const fs::path& folder) {
  OutputFolder output(folder);
  output.create("a").write("new");
  output.remove_at_commit("outdated");
  output.commit();
}

/// A folder with an earlier `a`, an outdated file and one that is kept, and all that it has beside it.
struct EarlierFolder {
  EarlierFolder() {
    fs::create_directory(path);
    for (const char* name : {"a", "outdated", "kept"}) around.write(std::string("out/") + name, "old");
  }

  /// Names in the folder.
  std::vector<std::string> names() const {
    std::vector<std::string> found;
    for (const auto& entry : fs::directory_iterator(path)) found.push_back(entry.path().filename().string());
    std::sort(found.begin(), found.end());
    return found;
  }

  void expect_new() const {
    EXPECT_EQ(content_of(path / "a"), "new");
    EXPECT_EQ(content_of(path / "kept"), "old");
    EXPECT_EQ(names(), (std::vector<std::string>{"a", "kept"}));
    EXPECT_EQ(around.names(), std::vector<std::string>{"out"});
  }

  TemporaryFolder around;
  fs::path path = around.path() / "out";
};

ino_t number_of(const fs::path& path) {
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? status.st_ino : 0;
}

TEST(OutputFolder, IsExchangedAsAWholeWithItsPermissionsAndOtherFiles) {
  const EarlierFolder folder;
  ASSERT_EQ(::chmod(folder.path.c_str(), 0751), 0);
  const ino_t before = number_of(folder.path), kept = number_of(folder.path / "kept");
  write_new(folder.path);
  folder.expect_new();
  EXPECT_NE(number_of(folder.path), before);
  EXPECT_EQ(number_of(folder.path / "kept"), kept);
  struct stat status {};
  ASSERT_EQ(::stat(folder.path.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 07777, 0751u);
}

TEST(OutputFolder, IsFoundBehindALink) {
  const EarlierFolder folder;
  const TemporaryFolder elsewhere;
  fs::create_directory_symlink(folder.path, elsewhere.path() / "link");
  write_new(elsewhere.path() / "link");
  folder.expect_new();
  EXPECT_TRUE(fs::is_symlink(elsewhere.path() / "link"));
}

TEST(OutputFolder, StaysItselfWhereAFolderIsInItOrAroundIt) {
  const EarlierFolder with_folder, current;
  fs::create_directory(with_folder.path / "kept.d");
  const ino_t before = number_of(with_folder.path);
  write_new(with_folder.path);
  EXPECT_EQ(number_of(with_folder.path), before);
  EXPECT_EQ(with_folder.names(), (std::vector<std::string>{"a", "kept", "kept.d"}));

  const fs::path back = fs::current_path();
  fs::current_path(current.path);
  const ino_t number = number_of(".");
  write_new(".");
  EXPECT_EQ(number_of("."), number);
  fs::current_path(back);
  current.expect_new();
}

TEST(OutputFolder, IsNotReplacedWithoutPermissionToWriteIntoIt) {
  const EarlierFolder folder;
  ASSERT_EQ(::chmod(folder.around.path().c_str(), 0777), 0);
  ASSERT_EQ(::chmod(folder.path.c_str(), 0755), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    constexpr uid_t kNobody = 65534;
    if (::geteuid() == 0 && ::setuid(kNobody) != 0) ::_exit(2);
    if (::geteuid() != kNobody) ::chmod(folder.path.c_str(), 0555);
    try {
      reserve_writable(folder.path, {});
      ::_exit(1);
    } catch (const Error& error) {
      ::_exit(error.kind() == ErrorKind::kOutput ? 0 : 3);
    }
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  EXPECT_EQ(status, 0);
  ::chmod(folder.path.c_str(), 0755);
  EXPECT_EQ(content_of(folder.path / "a"), "old");
}

TEST(OutputFolder, IsRefusedWhileAnotherWritesToIt) {
  const TemporaryFolder folder;
  for (const char* name : {"new", "new", "there"}) {
    if (name == std::string("there")) fs::create_directory(folder.path() / name);
    const auto first = reserve_writable(folder.path() / name, {});
    const std::string message = output_error_of([&] { reserve_writable(folder.path() / name, {}); });
    EXPECT_NE(message.find(": another solve is writing to it; wait"), std::string::npos) << message;
  }
  EXPECT_EQ(folder.names(), std::vector<std::string>{"there"});
}

TEST(OutputFolder, ThatAppearsMeanwhileKeepsItsFiles) {
  const TemporaryFolder folder;
  OutputFolder output(folder.path() / "out");
  output.create("a").write("new");
  fs::create_directory(folder.path() / "out");
  folder.write("out/kept", "old");
  output.commit();
  EXPECT_EQ(content_of(folder.path() / "out" / "a"), "new");
  EXPECT_EQ(content_of(folder.path() / "out" / "kept"), "old");
  EXPECT_EQ(folder.names(), std::vector<std::string>{"out"});
}

TEST(OutputFolder, OfAKilledRunIsClearedOfItsUnfinishedFiles) {
  const EarlierFolder folder;
  for (const fs::path& part :
       {folder.around.path() / ".out.crossgrain-part", folder.path / ".crossgrain-part"}) {
    fs::create_directory(part);
    std::ofstream(part / "a") << "unfinished";
    fs::create_hard_link(folder.path / "kept", part / "kept");
  }
  write_new(folder.path);
  folder.expect_new();
}

TEST(OutputFolder, OfARunThatWasKilledAfterTheExchangeLosesNoOtherFile) {
  const EarlierFolder folder;
  // The old folder, with files that were put into it too late to be linked.
  const fs::path old = folder.around.path() / ".out.crossgrain-part";
  fs::create_directory(old);
  for (const char* name : {"a", "outdated", "late"}) std::ofstream(old / name) << "older";
  fs::create_hard_link(folder.path / "kept", old / "kept");
  std::ofstream(folder.path / kReplacedNames) << "a" << '\0' << "outdated" << '\0';
  write_new(folder.path);
  EXPECT_EQ(content_of(folder.path / "late"), "older");
  fs::remove(folder.path / "late");
  folder.expect_new();
}

TEST(OutputFolder, OfARunThatWasKilledAmongItsRenamesIsFinishedByTheNextReader) {
  const EarlierFolder folder;
  const fs::path complete = folder.path / kCompleteFiles;
  fs::create_directory(complete);
  std::ofstream(complete / "a") << "new";
  std::ofstream(complete / kReplacedNames) << "outdated" << '\0' << "../kept" << '\0';
  complete_folder(folder.path);
  folder.expect_new();
  complete_folder(folder.path);
  complete_folder(folder.path / "missing");
}

TEST(OutputFolder, HasNoLinkInThePlaceOfAFileAfterwards) {
  const EarlierFolder folder;
  const TemporaryFolder elsewhere;
  fs::remove(folder.path / "a");
  fs::create_symlink(elsewhere.write("a", "elsewhere"), folder.path / "a");
  write_new(folder.path);
  folder.expect_new();
  EXPECT_EQ(content_of(elsewhere.path() / "a"), "elsewhere");
}

TEST(OutputFolder, WritesAgainAfterAFailure) {
  const TemporaryFolder folder;
  const auto reservation = reserve_writable(folder.path() / "out", {});
  { OutputFolder(reservation).create("a").write("dropped"); }
  for (const char* content : {"first", "second"}) {
    OutputFolder output(reservation);
    output.create("a").write(content);
    output.commit();
    EXPECT_EQ(content_of(folder.path() / "out" / "a"), content);
  }
}

}  // namespace
}  // namespace crossgrain

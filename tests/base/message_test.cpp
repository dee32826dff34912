// SPDX-License-Identifier: Apache-2.0
#include "crossgrain/message.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

std::vector<Remedy> all_remedies() {
  std::vector<Remedy> remedies;
  for (int k = 0; k <= static_cast<int>(Remedy::kReportModel); ++k)
    remedies.push_back(static_cast<Remedy>(k));
  return remedies;
}

TEST(Message, IsASentenceOfFilePlaceTextAndRemedy) {
  EXPECT_EQ(sentence_of({"a.stl", "line 12", "a facet of 4 corners, not 3", Remedy::kRepairFile}),
            "a.stl: line 12: a facet of 4 corners, not 3; repair it or export it again");
}

TEST(Message, PassesOverWhatIsEmpty) {
  EXPECT_EQ(sentence_of({"", "", "interrupted"}), "interrupted");
  EXPECT_EQ(sentence_of({"", "vertex 7", "is no number"}), "vertex 7: is no number");
  EXPECT_EQ(sentence_of({"a.stl", "", "is empty", Remedy::kCopyAgain}),
            "a.stl: is empty; copy or export it again");
}

TEST(Message, TakesOtherWordsForItsRemedy) {
  EXPECT_EQ(sentence_of({"", "", "no room", Remedy::kFreeSpace}, "use --output"), "no room; use --output");
}

TEST(Message, CountsInSingularAndPlural) {
  EXPECT_EQ(counted(0, "arc"), "0 arcs");
  EXPECT_EQ(counted(1, "arc"), "1 arc");
  EXPECT_EQ(counted(2, "vertex", "vertices"), "2 vertices");
  EXPECT_EQ(counted(1, "vertex", "vertices"), "1 vertex");
}

TEST(Remedy, HasWordsAndANameOfItsOwn) {
  std::set<std::string> names, words;
  for (const Remedy remedy : all_remedies()) {
    EXPECT_TRUE(names.insert(name_of(remedy)).second) << name_of(remedy);
    EXPECT_TRUE(words.insert(words_of(remedy)).second) << words_of(remedy);
  }
  EXPECT_EQ(names.count(""), 0u);
}

TEST(Remedy, NamesNoOptionOfAProgram) {
  for (const Remedy remedy : all_remedies()) {
    const std::string words = std::string(" ") + words_of(remedy);
    EXPECT_EQ(words.find(" -"), std::string::npos) << words;
  }
}

TEST(Remedy, ThatThereIsNotHasNoWords) {
  EXPECT_STREQ(words_of(static_cast<Remedy>(1000000)), "");
  EXPECT_STREQ(name_of(static_cast<Remedy>(-1)), "");
}

TEST(Error, CarriesWhatItSays) {
  const Error error(ErrorKind::kInput, {"a.stl", "line 2", "is wrong", Remedy::kRepairFile});
  EXPECT_EQ(error.kind(), ErrorKind::kInput);
  EXPECT_EQ(error.file(), "a.stl");
  EXPECT_EQ(error.place(), "line 2");
  EXPECT_EQ(error.text(), "is wrong");
  EXPECT_EQ(error.remedy(), Remedy::kRepairFile);
  EXPECT_EQ(error.what(), sentence_of(error.message()));
}

TEST(Error, OfAMeshFromMemoryGetsTheNameOfItsFile) {
  const Error error =
      Error(ErrorKind::kLimit, {"", "tet 5", "is wrong", Remedy::kSimplify}).with_file("b.mesh");
  EXPECT_EQ(error.kind(), ErrorKind::kLimit);
  EXPECT_EQ(error.message(), (Message{"b.mesh", "tet 5", "is wrong", Remedy::kSimplify}));
  EXPECT_STREQ(error.what(), "b.mesh: tet 5: is wrong; simplify it");
}

}  // namespace
}  // namespace crossgrain

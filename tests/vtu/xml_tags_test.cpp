// SPDX-License-Identifier: Apache-2.0
#include "vtu/xml_tags.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace crossgrain {
namespace {

struct Listed {
  std::vector<XmlTag> tags;
  bool malformed;
  std::size_t end;
};

Listed tags_in(std::string_view text) {
  XmlTags tags(text);
  Listed listed{};
  while (const auto tag = tags.next()) listed.tags.push_back(*tag);
  return {listed.tags, tags.malformed(), tags.position()};
}

TEST(XmlTags, ListsTagsAndPassesOverTextAndComments) {
  const auto [tags, malformed, end] =
      tags_in("<?xml version='1.0'?>\n<!-- <no/> --><File type=\"A\">1 &lt; 2<Part/></File>\n");
  ASSERT_EQ(tags.size(), 3u);
  EXPECT_EQ(tags[0].name, "File");
  EXPECT_EQ(tags[0].attribute("type"), "A");
  EXPECT_EQ(tags[0].attribute("other"), "");
  EXPECT_EQ(tags[1].name, "Part");
  EXPECT_EQ(tags[2].name, "/File");
  EXPECT_FALSE(malformed);
}

TEST(XmlTags, TakesBlanksAroundTheSignBetweenAnAttributeAndItsValue) {
  const auto [tags, malformed, end] =
      tags_in("<File><Array Name = \"a=b\"\n  type= 'Int32'\toffset\n=\r\n\"7\" components=\"3\"/><Next/>");
  ASSERT_EQ(tags.size(), 3u);
  EXPECT_EQ(tags[1].attributes,
            (std::map<std::string, std::string, std::less<>>{
                {"Name", "a=b"}, {"type", "Int32"}, {"offset", "7"}, {"components", "3"}}));
  EXPECT_EQ(tags[2].name, "Next");
  EXPECT_FALSE(malformed);
}

TEST(XmlTags, SaysThatItEndsBeforeTheTextAndWhere) {
  for (const std::string tag :
       {"<Array Name=a/>", "<Array Name>", "<Array =\"a\"/>", "<Array Name \"a\"/>", "<Array Name=\"a/>",
        "<Array N", "<Array Name=", "<Array", "<=\"a\">", "<>", "</>", "<", "<!-- a comment", "<?xml"}) {
    const auto [tags, malformed, end] = tags_in("<File>\n" + tag);
    EXPECT_EQ(tags.size(), 1u) << tag;
    EXPECT_TRUE(malformed) << tag;
    EXPECT_GE(end, 7u) << tag;
    EXPECT_LE(end, 7 + tag.size()) << tag;
  }
}

TEST(XmlTags, EndsForGoodWhereItIsMalformed) {
  XmlTags tags("<File><Array Name=a/><Next/>");
  EXPECT_TRUE(tags.next());
  EXPECT_FALSE(tags.next());
  EXPECT_FALSE(tags.next());
}

}  // namespace
}  // namespace crossgrain

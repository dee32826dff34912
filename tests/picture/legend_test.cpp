// SPDX-License-Identifier: Apache-2.0
#include "picture/legend.hpp"

#include <gtest/gtest.h>

namespace crossgrain {
namespace {

LegendBlock block_with(std::vector<std::string> notes) {
  LegendBlock block{"Field"};
  block.notes = std::move(notes);
  return block;
}

TEST(Legend, BreaksNotesIntoLines) {
  const Legend one({block_with({"short"})}, 10);
  const Legend many(
      {block_with({"a sentence with so many words that it does not fit into one line of a legend"})}, 10);
  EXPECT_GT(many.height(), one.height() + 20);
  EXPECT_LT(many.width(), 200);
}

TEST(Legend, InWordsHasNotesWholeAndTheLargestNumberAboveAScale) {
  LegendBlock block =
      block_with({"a sentence with so many words that it does not fit into one line of a legend"});
  block.bar = ColourBar{ColourMap::heat(), {0, 5, false}, 29.71};
  EXPECT_EQ(text_of({block}),
            "Field\n  a sentence with so many words that it does not fit into one line of a legend\n"
            "  0 to 5 and above, up to 29.7\n");
}

}  // namespace
}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Reads Medit meshes in text: keywords, each with a number of rows.
#include <fmt/format.h>

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mesh_files/cells/cell_reader.hpp"
#include "mesh_files/cells/medit_mesh.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

bool begins_like_a_keyword(std::string_view word) {
  const char c = word.empty() ? '\0' : word[0];
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

class MeditReader {
 public:
  MeditReader(const InputFile& file, CellBuilder& builder)
      : scanner_(file, {.comments = true}), mesh_(file, builder) {}

  Place read() {
    std::string_view word = scanner_.word_anywhere();
    if (medit_section_named(word) == nullptr && !is_header(word))
      scanner_.fail(
          fmt::format(
              "{} instead of a keyword such as MeshVersionFormatted: this is not a Medit mesh in text",
              in_quotes(word)),
          Remedy::kExportAgain);
    while (!word.empty() && !equals_ignoring_case(word, "End")) word = read_part(word);
    if (!mesh_.has_vertices())
      scanner_.fail("the section Vertices is missing: cut short", Remedy::kCopyAgain);
    for (Rows& rows : postponed_) mesh_.read_rows(rows.stream, *rows.section, rows.count);
    mesh_.finish();
    return scanner_.place();
  }

 private:
  struct Rows {
    const MeditSection* section;
    std::uint64_t count;
    NumberStream stream;  ///< at the first row
  };

  static bool is_header(std::string_view word) {
    return equals_ignoring_case(word, "MeshVersionFormatted") || equals_ignoring_case(word, "Dimension");
  }

  /// Reads the section of a keyword. Returns the next keyword.
  std::string_view read_part(std::string_view keyword) {
    if (const MeditSection* section = medit_section_named(keyword)) {
      read_section(*section);
      const std::string_view next = scanner_.word_anywhere();
      if (!next.empty() && !begins_like_a_keyword(next))
        scanner_.fail(fmt::format("{} instead of a keyword after the last row of {}, whose rows have {} each",
                                  in_quotes(next), section->keyword, counted(section->columns, "number")));
      return next;
    }
    std::string_view word = scanner_.word_anywhere();
    if (equals_ignoring_case(keyword, "Dimension") && scanner_.integer(word, "the number of dimensions") != 3)
      scanner_.fail("not a mesh in three dimensions (Dimension 3)", Remedy::kExportAgain);
    // MeshVersionFormatted, bounds, names and unknown sections: skip to the next keyword.
    while (!word.empty() && !begins_like_a_keyword(word)) word = scanner_.word_anywhere();
    return word;
  }

  void read_section(const MeditSection& section) {
    NumberStream rows(scanner_);
    const std::string what = fmt::format("the number of {}", section.keyword);
    const std::uint64_t count =
        rows.checked_count(rows.integer(NumberType::kInt64, what.c_str()),
                           static_cast<std::uint64_t>(section.columns), NumberType::kInt64, what);
    scanner_ = rows.scanner();
    if (section.content != MeditContent::kPassedOver && !seen_.insert(&section).second)
      scanner_.fail(fmt::format("a second section {}", section.keyword));
    if (section.content != MeditContent::kPassedOver && mesh_.is_ready_for(section)) {
      mesh_.read_rows(rows, section, count);
      scanner_ = rows.scanner();
      return;
    }
    if (section.content != MeditContent::kPassedOver) postponed_.push_back({&section, count, rows});
    skip_rows(section, count);
  }

  void skip_rows(const MeditSection& section, std::uint64_t count) {
    for (std::uint64_t words = count * static_cast<std::uint64_t>(section.columns); words > 0; --words) {
      if (scanner_.word_anywhere().empty())
        scanner_.fail(fmt::format("the rows of {} end too early: cut short", section.keyword),
                      Remedy::kCopyAgain);
    }
  }

  TextScanner scanner_;
  MeditMesh mesh_;
  std::set<const MeditSection*> seen_;
  std::vector<Rows> postponed_;  ///< cells that come before the vertices
};

}  // namespace

Place read_medit(const InputFile& file, CellBuilder& builder) {
  return MeditReader(file, builder).read();
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "io/tet_reader.hpp"
#include "io/text_scanner.hpp"

namespace crossgrain {
namespace {

enum class Content : std::uint8_t {
  kPassedOver,
  kVertices,
  kTets,
  kTriangles,   ///< passed over too, but worth a word where there are no tets
  kOtherSolids  ///< that fill a part of the solid, so that the tets alone are not all of it
};

/// Six edges of each tet have numbers of 32 bits (tets/stiffness.cpp).
constexpr std::size_t kMostRows = UINT32_MAX / 6;

/// A section with a count and as many rows of as many words (libMeshb's list of keywords, for meshes in
/// three dimensions).
struct Section {
  std::string_view keyword;
  int columns;
  Content content = Content::kPassedOver;
};

constexpr std::array kSections = {
    Section{"Vertices", 4, Content::kVertices},
    Section{"Tetrahedra", 5, Content::kTets},
    Section{"Triangles", 4, Content::kTriangles},
    Section{"Hexahedra", 9, Content::kOtherSolids},
    Section{"Prisms", 7, Content::kOtherSolids},
    Section{"Pentahedra", 7, Content::kOtherSolids},
    Section{"Pyramids", 6, Content::kOtherSolids},
    Section{"TetrahedraP2", 11, Content::kOtherSolids},
    Section{"Edges", 3},
    Section{"Quadrilaterals", 5},
    Section{"Corners", 1},
    Section{"Ridges", 1},
    Section{"RequiredVertices", 1},
    Section{"RequiredEdges", 1},
    Section{"RequiredTriangles", 1},
    Section{"RequiredQuadrilaterals", 1},
    Section{"RequiredTetrahedra", 1},
    Section{"Normals", 3},
    Section{"NormalAtVertices", 2},
    Section{"NormalAtTriangleVertices", 3},
    Section{"NormalAtQuadrilateralVertices", 3},
    Section{"Tangents", 3},
    Section{"TangentAtVertices", 2},
    Section{"TangentAtEdges", 3},
    Section{"SubDomainFromMesh", 4},
    Section{"SubDomainFromGeom", 4},
};

const Section* section_of(std::string_view keyword) {
  for (const Section& section : kSections) {
    if (equals_ignoring_case(section.keyword, keyword)) return &section;
  }
  return nullptr;
}

bool begins_like_a_keyword(std::string_view word) {
  const char c = word.empty() ? '\0' : word[0];
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

class MeditReader {
 public:
  explicit MeditReader(const InputFile& file) : file_(&file), scanner_(file, {.comments = true}) {}

  TetMesh read() {
    std::string_view word = scanner_.word_anywhere();
    if (section_of(word) == nullptr && !is_header(word))
      scanner_.fail(
          fmt::format("{} where a keyword such as MeshVersionFormatted should stand; this is no Medit "
                      "mesh in text, export it again as one",
                      in_quotes(word)));
    while (!word.empty() && !equals_ignoring_case(word, "End")) word = read_part(word);
    if (!seen_vertices_) scanner_.fail("no section Vertices so far; the file is cut short, export it again");
    if (postponed_tets_) read_tet_rows(*postponed_tets_, tet_count_);
    check_solids();
    return std::move(mesh_);
  }

 private:
  static bool is_header(std::string_view word) {
    return equals_ignoring_case(word, "MeshVersionFormatted") || equals_ignoring_case(word, "Dimension");
  }

  /// What a keyword announces. Returns the next keyword.
  std::string_view read_part(std::string_view keyword) {
    if (const Section* section = section_of(keyword)) {
      read_section(*section);
      const std::string_view next = scanner_.word_anywhere();
      if (!next.empty() && !begins_like_a_keyword(next))
        scanner_.fail(
            fmt::format("{} where a keyword should stand after the last row of {}; mend its count or "
                        "its rows, which have {} numbers each",
                        in_quotes(next), section->keyword, section->columns));
      return next;
    }
    std::string_view word = scanner_.word_anywhere();
    if (equals_ignoring_case(keyword, "Dimension") && scanner_.integer(word, "the number of dimensions") != 3)
      scanner_.fail("not a mesh in three dimensions; export it with Dimension 3");
    // MeshVersionFormatted, bounds, names and what nobody knows: up to the next keyword.
    while (!word.empty() && !begins_like_a_keyword(word)) word = scanner_.word_anywhere();
    return word;
  }

  void read_section(const Section& section) {
    const std::size_t count = read_count(section);
    switch (section.content) {
      case Content::kVertices:
        refuse_second(seen_vertices_, section);
        return read_vertex_rows(count);
      case Content::kTets:
        refuse_second(seen_tets_, section);
        tet_count_ = count;
        if (seen_vertices_) return read_tet_rows(scanner_, count);
        postponed_tets_ = scanner_;
        break;
      case Content::kTriangles:
        triangles_ += count;
        break;
      case Content::kOtherSolids:
        if (count > 0 && !other_solids_) other_solids_ = {&section, count, scanner_.place()};
        break;
      case Content::kPassedOver:
        break;
    }
    skip_rows(section, count);
  }

  void refuse_second(bool& seen, const Section& section) {
    if (seen) scanner_.fail(fmt::format("a second section {}; join the two into one", section.keyword));
    seen = true;
  }

  /// At most as many rows as the rest of the file can hold, at a digit and a blank for each number.
  std::size_t read_count(const Section& section) {
    const std::string what = fmt::format("the number of {}", section.keyword);
    const std::int64_t count = scanner_.integer(scanner_.word_anywhere(), what.c_str());
    if (count < 0) scanner_.fail(fmt::format("{} is {}; repair the file", what, count));
    const auto row_bytes = 2 * static_cast<std::size_t>(section.columns);
    // One byte more, since the last line may lack its end.
    if (static_cast<std::uint64_t>(count) > (scanner_.bytes_left() + 1) / row_bytes)
      scanner_.fail(
          fmt::format("{} is {}, but only {} bytes follow: cut short, or damaged; copy or export the "
                      "file again",
                      what, count, scanner_.bytes_left()));
    if (static_cast<std::uint64_t>(count) > kMostRows)
      scanner_.fail(fmt::format("{} is {}, more than {}; split the mesh", what, count, kMostRows));
    return static_cast<std::size_t>(count);
  }

  /// x y z and a reference number each.
  void read_vertex_rows(std::size_t count) {
    mesh_.vertices.resize(count);
    for (Vector3& vertex : mesh_.vertices) {
      for (double& coordinate : vertex)
        coordinate = scanner_.number(scanner_.word_anywhere(), "a coordinate");
      scanner_.integer(scanner_.word_anywhere(), "the reference number of a vertex");
    }
  }

  /// Four vertices, numbered from 1, and a reference number each.
  void read_tet_rows(TextScanner& scanner, std::size_t count) {
    mesh_.tets.resize(count);
    for (auto& tet : mesh_.tets) {
      for (std::uint32_t& vertex : tet) {
        const std::int64_t number = scanner.integer(scanner.word_anywhere(), "the number of a vertex");
        if (number < 1 || static_cast<std::uint64_t>(number) > mesh_.vertices.size())
          scanner.fail(
              fmt::format("a tet refers to vertex {}, but they are numbered from 1 to {}; repair the "
                          "file or export it again",
                          number, mesh_.vertices.size()));
        vertex = static_cast<std::uint32_t>(number - 1);
      }
      scanner.integer(scanner.word_anywhere(), "the reference number of a tet");
    }
  }

  void skip_rows(const Section& section, std::size_t count) {
    for (std::size_t words = count * static_cast<std::size_t>(section.columns); words > 0; --words) {
      if (scanner_.word_anywhere().empty())
        scanner_.fail(fmt::format("the rows of {} end too early; the file is cut short, export it again",
                                  section.keyword));
    }
  }

  /// Without its other elements a solid would have holes, and without tets nothing would be left.
  void check_solids() const {
    if (other_solids_)
      fail_input(*file_, other_solids_->place,
                 fmt::format("{} {}, where only Tetrahedra can be used; cut them into tets",
                             other_solids_->count, other_solids_->section->keyword));
    if (!mesh_.tets.empty()) return;
    scanner_.fail(
        triangles_ > 0
            ? fmt::format("{} triangles but no tets; fill the surface with tets, or give it as STL, "
                          "OBJ, PLY or OFF",
                          triangles_)
            : std::string("no tets up to here; export the mesh with its Tetrahedra"));
  }

  struct OtherSolids {
    const Section* section;
    std::size_t count;
    Place place;
  };

  const InputFile* file_;
  TextScanner scanner_;
  TetMesh mesh_;
  bool seen_vertices_ = false, seen_tets_ = false;
  std::size_t tet_count_ = 0, triangles_ = 0;
  std::optional<TextScanner> postponed_tets_;  ///< at the first row of tets that stand before the vertices
  std::optional<OtherSolids> other_solids_;    ///< the first section of them
};

}  // namespace

TetMesh read_medit(const InputFile& file) {
  return MeditReader(file).read();
}

}  // namespace crossgrain

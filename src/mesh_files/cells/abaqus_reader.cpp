// SPDX-License-Identifier: Apache-2.0
// Reads meshes in input files of Abaqus and CalculiX: *NODE and *ELEMENT, and the sets and surfaces that tell
// regions and faces.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "crossgrain/error.hpp"
#include "files/read_memory.hpp"
#include "measure/hex_faces.hpp"
#include "mesh_files/cells/abaqus_lines.hpp"
#include "mesh_files/cells/cell_reader.hpp"
#include "mesh_files/cells/node_numbers.hpp"

namespace crossgrain {
namespace {

// Elements in space by the number of their nodes: C3D8R, DC3D8, AC3D8 and so on.
constexpr std::array kSolids{
    CellType{4, CellShape::kTet, 4, "tets"},
    CellType{10, CellShape::kTet, 10, "tets"},
    CellType{8, CellShape::kHexahedron, 8, "hexahedra"},
    CellType{20, CellShape::kHexahedron, 20, "hexahedra"},
    CellType{27, CellShape::kHexahedron, 27, "hexahedra"},
    CellType{6, CellShape::kOtherSolid, 6, "wedges"},
    CellType{15, CellShape::kOtherSolid, 15, "wedges"},
    CellType{5, CellShape::kOtherSolid, 5, "pyramids"},
    CellType{13, CellShape::kOtherSolid, 13, "pyramids"},
};
constexpr CellType kQuads{4, CellShape::kQuad, 4, "quads"};

/// Returns null for types that are passed over.
const CellType* type_named(std::string_view name) {
  constexpr std::array<std::string_view, 4> kInSpace{"C3D", "DC3D", "AC3D", "CC3D"};
  constexpr std::array<std::string_view, 7> kFlat{"CPS4", "CPE4", "S4", "S4R", "M3D4", "R3D4", "SFM3D4"};
  for (const std::string_view begin : kInSpace) {
    if (name.size() < begin.size() || !equals_ignoring_case(name.substr(0, begin.size()), begin)) continue;
    int nodes = 0;
    for (const char c : name.substr(begin.size())) {
      if (c < '0' || c > '9' || nodes > 99) break;
      nodes = 10 * nodes + (c - '0');
    }
    const auto found = std::ranges::find(kSolids, nodes, &CellType::code);
    return found == kSolids.end() ? nullptr : &*found;
  }
  const bool is_quad =
      std::ranges::any_of(kFlat, [&](std::string_view flat) { return equals_ignoring_case(name, flat); });
  return is_quad ? &kQuads : nullptr;
}

/// Returns the number of a name such as REGION_3 or FACE_MINUS_1.
std::optional<std::int64_t> number_in(std::string_view name, std::string_view begin) {
  if (name.size() <= begin.size() || !equals_ignoring_case(name.substr(0, begin.size()), begin))
    return std::nullopt;
  std::string_view digits = name.substr(begin.size());
  constexpr std::string_view kMinus = "MINUS_";
  const bool is_negative =
      digits.size() > kMinus.size() && equals_ignoring_case(digits.substr(0, kMinus.size()), kMinus);
  if (is_negative) digits.remove_prefix(kMinus.size());
  constexpr std::size_t kMostDigits = 10;
  if (digits.size() > kMostDigits) return std::nullopt;
  std::int64_t number = 0;
  for (const char c : digits) {
    if (c < '0' || c > '9') return std::nullopt;
    number = 10 * number + (c - '0');
  }
  return is_negative ? -number : number;
}

class AbaqusReader {
 public:
  AbaqusReader(const InputFile& file, CellBuilder& builder) : file_(&file), lines_(file), builder_(builder) {}

  Place read() {
    if (lines_.is_row())
      lines_.fail("does not begin with a keyword such as *NODE: this is not an input file");
    while (!lines_.is_at_end()) {
      read_block(lines_.take_keyword());
      lines_.skip_rows();
    }
    if (!has_nodes_) lines_.fail("no *NODE: cut short, or not a mesh", Remedy::kExportAgain);
    if (const auto twice = numbers_.finish())
      lines_.fail(fmt::format(
          "two nodes have the number {} (parts have numbers of their own: export one part)", *twice));
    add_elements();
    return lines_.place();
  }

 private:
  struct Element {
    const CellType* type;
    std::int64_t number;
    std::array<std::int64_t, 8> nodes;  ///< numbers of the corners
    std::size_t set;                    ///< in sets_
    Place place;
  };

  void read_block(const AbaqusKeyword& keyword) {
    if (keyword.is("NODE")) {
      read_nodes();
    } else if (keyword.is("ELEMENT")) {
      read_elements(keyword);
    } else if (keyword.is("ELSET")) {
      const auto region = number_in(keyword.find("ELSET").value_or(""), "REGION_");
      if (region) read_region(*region, keyword.find("GENERATE").has_value());
    } else if (keyword.is("SURFACE")) {
      const auto face = number_in(keyword.find("NAME").value_or(""), "FACE_");
      if (face) read_face(*face);
    } else if (keyword.is("INCLUDE")) {
      lines_.fail(
          fmt::format("parts of it are in the file {}", in_quotes(keyword.find("INPUT").value_or(""))),
          Remedy::kGivePartFiles);
    } else if (keyword.is("INSTANCE") && lines_.is_row()) {
      builder_.warn(WarningKind::kSkippedData, lines_.place(),
                    "the part is read where it was made, not where *INSTANCE moves it");
    }
  }

  void read_nodes() {
    has_nodes_ = true;
    while (lines_.is_row()) {
      const auto& row = lines_.take_row();
      Vector3 position{0, 0, 0};
      for (std::size_t k = 0; k < 3 && k + 1 < row.size(); ++k)
        if (!row[k + 1].empty()) position[k] = lines_.number(row[k + 1], "a coordinate");
      builder_.reserve_vertices(1);
      builder_.add_vertex(position, lines_.place());
      numbers_.add(lines_.integer(row.front(), "the number of a node"));
    }
  }

  void read_elements(const AbaqusKeyword& keyword) {
    const CellType* const type = type_named(keyword.find("TYPE").value_or(""));
    if (type == nullptr || (!is_solid(type->shape) && !builder_.takes(type->shape))) return;
    const std::size_t set = set_of(*type, keyword.find("ELSET").value_or(""));
    while (lines_.is_row()) read_element(*type, set);
  }

  /// An element may go on in the next lines.
  void read_element(const CellType& type, std::size_t set) {
    Element element{&type, 0, {}, set, {}};
    std::size_t numbers = 0;
    while (numbers < 1 + std::size_t{type.nodes}) {
      if (!lines_.is_row())
        lines_.fail(fmt::format("an element of {} has {}: cut short, or damaged", counted(type.nodes, "node"),
                                numbers == 0 ? 0 : numbers - 1),
                    Remedy::kCopyAgain);
      for (const std::string_view field : lines_.take_row()) {
        const std::int64_t number = lines_.integer(field, "the number of a node");
        if (numbers == 0) element.number = number;
        if (numbers > 0 && numbers <= corners_of(type.shape)) element.nodes[numbers - 1] = number;
        ++numbers;
      }
    }
    if (numbers > 1 + std::size_t{type.nodes})
      lines_.fail(fmt::format("an element of {} has {}", counted(type.nodes, "node"), numbers - 1));
    element.place = lines_.place();
    append_within_memory(file_->name(), elements_, element);
  }

  /// Index of a set of solids, or of quads.
  std::size_t set_of(const CellType& type, std::string_view name) {
    std::vector<std::string_view>& sets = is_solid(type.shape) ? solid_sets_ : quad_sets_;
    const auto found =
        std::ranges::find_if(sets, [&](std::string_view other) { return equals_ignoring_case(name, other); });
    const auto at = static_cast<std::size_t>(found - sets.begin());
    if (found == sets.end()) sets.push_back(name);
    return at;
  }

  void read_region(std::int64_t region, bool is_generated) {
    while (lines_.is_row()) {
      const auto& row = lines_.take_row();
      if (is_generated) {
        const auto number = [&](std::size_t k) { return lines_.integer(row[k], "the number of an element"); };
        if (row.size() < 2) lines_.fail("a row of GENERATE has the first and the last number");
        append_within_memory(file_->name(), ranges_,
                             {number(0), number(1), row.size() > 2 ? number(2) : 1, region});
        continue;
      }
      for (const std::string_view field : row) {
        const std::int64_t number = lines_.integer(field, "the number of an element");
        append_within_memory(file_->name(), ranges_, {number, number, 1, region});
      }
    }
  }

  /// Rows that name a set in place of an element are passed over.
  void read_face(std::int64_t face) {
    while (lines_.is_row()) {
      const auto& row = lines_.take_row();
      if (row.size() != 2 || row[1].size() != 2 || lower(row[1][0]) != 's') continue;
      const int side = row[1][1] - '1';
      if (side < 0 || side >= 6 || row[0].find_first_not_of("0123456789") != std::string_view::npos) continue;
      append_within_memory(file_->name(), sides_,
                           {lines_.integer(row[0], "the number of an element"),
                            static_cast<std::size_t>(side), face, lines_.place()});
    }
  }

  void add_elements() {
    NodeNumbers element_numbers;
    for (const Element& element : elements_) element_numbers.add(element.number);
    if (const auto twice = element_numbers.finish())
      lines_.fail(fmt::format("two elements have the number {}", *twice));
    const std::vector<std::int64_t> regions = regions_of(element_numbers);
    builder_.reserve_solids(static_cast<std::size_t>(std::ranges::count_if(
        elements_, [&](const Element& element) { return element.type->shape == builder_.solid(); })));
    for (std::size_t k = 0; k < elements_.size(); ++k) {
      const Element& element = elements_[k];
      const std::array<std::int64_t, 8> nodes = nodes_of(element);
      const bool has_sets = (is_solid(element.type->shape) ? solid_sets_ : quad_sets_).size() > 1;
      const std::int64_t of_set = has_sets ? static_cast<std::int64_t>(element.set) + 1 : 0;
      builder_.add_cell(*element.type, nodes, ranges_.empty() ? of_set : regions[k], element.place);
    }
    if (builder_.takes(CellShape::kQuad)) add_sides(element_numbers);
  }

  std::array<std::int64_t, 8> nodes_of(const Element& element) const {
    std::array<std::int64_t, 8> nodes{};
    for (std::size_t k = 0; k < builder_.nodes_needed(*element.type); ++k) {
      const auto node = numbers_.index_of(element.nodes[k]);
      if (!node)
        fail_input(*file_, element.place,
                   fmt::format("refers to node {}, which the file does not have", element.nodes[k]));
      nodes[k] = *node;
    }
    return nodes;
  }

  /// Of each element the region of a set, or 0. Ranges reach no further than the elements.
  std::vector<std::int64_t> regions_of(const NodeNumbers& element_numbers) const {
    std::vector<std::int64_t> regions(elements_.size(), 0);
    Checkpoint checkpoint;
    for (const Range& range : ranges_) {
      if (range.first == range.last) {
        checkpoint.pass();
        if (const auto index = element_numbers.index_of(range.first))
          regions[static_cast<std::size_t>(*index)] = range.region;
        continue;
      }
      for (std::size_t k = 0; k < elements_.size(); ++k) {
        checkpoint.pass();
        const std::int64_t number = elements_[k].number;
        const bool is_in = number >= range.first && number <= range.last && range.step > 0 &&
                           (static_cast<std::uint64_t>(number) - static_cast<std::uint64_t>(range.first)) %
                                   static_cast<std::uint64_t>(range.step) ==
                               0;
        if (is_in) regions[k] = range.region;
      }
    }
    return regions;
  }

  /// Faces of hexahedra as quads.
  void add_sides(const NodeNumbers& element_numbers) {
    for (const Side& side : sides_) {
      const auto index = element_numbers.index_of(side.element);
      if (!index) continue;
      const Element& element = elements_[static_cast<std::size_t>(*index)];
      if (element.type->shape != CellShape::kHexahedron) continue;
      const std::array<std::int64_t, 8> corners = nodes_of(element);
      std::array<std::int64_t, 4> nodes;
      for (std::size_t k = 0; k < 4; ++k) nodes[k] = corners[kHexFaces[side.side][k]];
      builder_.add_cell(kQuads, nodes, side.face, side.place);
    }
  }

  struct Range {
    std::int64_t first, last, step, region;
  };
  struct Side {
    std::int64_t element;
    std::size_t side;  ///< in kHexFaces, which are S1 to S6
    std::int64_t face;
    Place place;
  };

  const InputFile* file_;
  AbaqusLines lines_;
  CellBuilder& builder_;
  NodeNumbers numbers_;
  bool has_nodes_ = false;
  std::vector<Element> elements_;
  std::vector<std::string_view> solid_sets_, quad_sets_;  ///< names, as they come
  std::vector<Range> ranges_;                             ///< of REGION_N
  std::vector<Side> sides_;                               ///< of FACE_N
};

}  // namespace

Place read_abaqus(const InputFile& file, CellBuilder& builder) {
  return AbaqusReader(file, builder).read();
}

}  // namespace crossgrain

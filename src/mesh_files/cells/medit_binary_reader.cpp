// SPDX-License-Identifier: Apache-2.0
// Medit meshes in binary, as libMeshb writes them:
//
//   code | version | keyword | next | ... | keyword | next | ... | 54 | 0
//
// `code` is 1 in the byte order of the file. `next` is the place of the next keyword, of 32 bits in versions
// 1 and 2 and of 64 in 3 and 4. A keyword with rows has their count first. Real numbers have 32 bits in
// version 1 and 64 in others; counts and whole numbers have 64 bits in version 4 and 32 in others.
#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <vector>

#include "mesh_files/cells/cell_reader.hpp"
#include "mesh_files/cells/medit_mesh.hpp"

namespace crossgrain {
namespace {

constexpr std::int64_t kCode = 1, kSwappedCode = 1 << 24;
constexpr std::int64_t kDimension = 3, kEnd = 54;

class MeditBinaryReader {
 public:
  explicit MeditBinaryReader(const InputFile& file) : file_(&file), swapped_(is_swapped(file)) {
    NumberStream stream(file, sizeof(std::int32_t), swapped_);
    const std::int64_t version = stream.integer(NumberType::kInt32, "the version");
    if (version < 1 || version > 4)
      stream.fail(fmt::format("version {} of the format has no reader, only 1 to 4", version),
                  Remedy::kExportAgain);
    position_type_ = version >= 3 ? NumberType::kInt64 : NumberType::kInt32;
    numbers_.real = version == 1 ? NumberType::kFloat32 : NumberType::kFloat64;
    numbers_.integer = version == 4 ? NumberType::kInt64 : NumberType::kInt32;
    find_sections(stream);
  }

  void read(CellBuilder& builder) {
    MeditMesh mesh(*file_, builder, numbers_);
    for (const bool vertices : {true, false}) {
      for (Rows& rows : sections_) {
        const bool now = (rows.section->content == MeditContent::kVertices) == vertices;
        if (now) mesh.read_rows(rows.stream, *rows.section, rows.count);
      }
      if (!mesh.has_vertices()) fail_input(*file_, {}, "no vertices");
    }
    mesh.finish();
  }

 private:
  struct Rows {
    const MeditSection* section;
    std::uint64_t count;
    NumberStream stream;  ///< at the first row
  };

  static bool is_swapped(const InputFile& file) {
    const std::int64_t code = NumberStream(file, 0, false).integer(NumberType::kInt32, "the code");
    if (code != kCode && code != kSwappedCode)
      fail_input(file, {}, "does not begin with the number 1: this is not a binary Medit mesh",
                 Remedy::kExportAgain);
    return code == kSwappedCode;
  }

  /// Jumps from keyword to keyword. Every jump goes forward, so it terminates.
  void find_sections(NumberStream stream) {
    const std::size_t size = file_->bytes().size();
    while (stream.position() < size) {
      const std::size_t begin = stream.position();
      const std::int64_t keyword = stream.integer(NumberType::kInt32, "a keyword");
      if (keyword == kEnd) return;
      const std::int64_t next = stream.integer(position_type_, "the place of the next keyword");
      if (next != 0 && (next <= static_cast<std::int64_t>(begin) || static_cast<std::uint64_t>(next) > size))
        fail_input(
            *file_, {"byte", begin},
            fmt::format("the next keyword should stand at byte {} of {}: cut short, or damaged", next, size),
            Remedy::kCopyAgain);
      take_keyword(keyword, stream);
      if (next == 0) return;
      stream = NumberStream(*file_, static_cast<std::size_t>(next), swapped_);
    }
  }

  void take_keyword(std::int64_t keyword, NumberStream& stream) {
    if (keyword == kDimension && stream.integer(NumberType::kInt32, "the number of dimensions") != 3)
      stream.fail("not a mesh in three dimensions (Dimension 3)", Remedy::kExportAgain);
    const MeditSection* section = medit_section_coded(keyword);
    if (section == nullptr || section->content == MeditContent::kPassedOver) return;
    for (const Rows& rows : sections_) {
      if (rows.section == section) stream.fail(fmt::format("a second section {}", section->keyword));
    }
    const std::string what = fmt::format("the number of {}", section->keyword);
    const std::int64_t stated = stream.integer(numbers_.integer, what.c_str());
    // A vertex has three real numbers; the smaller of both types gives a valid lower bound.
    const NumberType least =
        size_of(numbers_.real) < size_of(numbers_.integer) ? numbers_.real : numbers_.integer;
    const auto columns = static_cast<std::uint64_t>(section->columns);
    sections_.push_back({section, stream.checked_count(stated, columns, least, what), stream});
  }

  const InputFile* file_;
  bool swapped_;
  NumberType position_type_ = NumberType::kInt32;
  MeditNumbers numbers_;
  std::vector<Rows> sections_;
};

}  // namespace

Place read_medit_binary(const InputFile& file, CellBuilder& builder) {
  MeditBinaryReader(file).read(builder);
  return {};
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "vtu/vtu_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cassert>
#include <optional>

#include "base/parallel.hpp"
#include "files/file_mark.hpp"

namespace crossgrain {
namespace {

static_assert(std::endian::native == std::endian::little, "arrays are written as they stand in memory");

/// Approximate raw bytes of a block. Files are 2 % smaller than with 32 KiB and 1 % larger than with 1 MiB,
/// for which the blocks in memory would take 100 MB.
constexpr std::size_t kBlockBytes = 1 << 18;

/// Blocks that are compressed at a time, while as many are written: enough for many threads, about 25 MB in
/// total.
constexpr std::size_t kBlocksAtOnce = 16;

/// Space for offset="..." with any 64-bit number; the rest is filled with blanks, which XML allows between
/// attributes.
constexpr std::size_t kOffsetBytes = 29;

/// VTK reads a file in blocks of this size and ends the XML at the tag before the data, which are none, by
/// passing the tag, "/>" and "</VTKFile>" to expat. Where expat has the fix of CVE-2023-52425 (2.6.0, and
/// stable distributions), it puts off a token until twice as much of it is there, so that ParaView 5.11 of
/// Debian 12 and 5.12.0 pass on data as XML, and fail. If a block ends with the name of the tag, VTK passes
/// its attributes one character at a time; expat looks at 13, 26 and 52 of them, and with 25 to 37 between
/// name and ">" the last is at the end. The blanks stand before the attribute, since meshio looks for a tag
/// that ends with '">'. tests/python/paraview_test.py opens files in such a ParaView, other_packages_test.py
/// in meshio and in VTK.
constexpr std::size_t kReadBlock = 4096;
constexpr std::string_view kDataAttributes = "                encoding=\"raw\"";
static_assert(kVtuDataTag.size() == 13 && kDataAttributes.size() == 30);

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '&')
      out += "&amp;";
    else if (c == '<')
      out += "&lt;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

/// What a kind of grid is called in a file.
struct GridNames {
  std::string_view grid;
  std::string_view count_of_cells;  ///< attribute of <Piece>
  std::string_view cells;           ///< section of VtuSection::kCells
};
constexpr GridNames kUnstructuredGrid{"UnstructuredGrid", "NumberOfCells", "Cells"};
constexpr GridNames kPolylines{"PolyData", "NumberOfLines", "Lines"};

class VtuWriter {
 public:
  VtuWriter(OutputFile& file, const GridNames& names, const std::vector<VtuArray>& arrays)
      : file_(file), names_(names), arrays_(arrays), offset_places_(arrays.size()) {}

  void write(std::size_t points, std::size_t cells) {
    write_header(points, cells);
    data_begin_ = file_.position();
    for (std::size_t i = 0; i < arrays_.size(); ++i) {
      const std::string offset = fmt::format("offset=\"{}\"", file_.position() - data_begin_);
      write_data(arrays_[i]);
      file_.patch(offset_places_[i], offset);
    }
    file_.write("\n  </AppendedData>\n</VTKFile>\n");
  }

 private:
  void write_header(std::size_t points, std::size_t cells) {
    file_.write("<?xml version=\"1.0\"?>\n");
    file_.write(kXmlMark);
    if (!file_.solve().empty()) file_.write(fmt::format("\n{}{} -->", kXmlSolve, file_.solve()));
    file_.write(
        fmt::format("\n<VTKFile type=\"{0}\" version=\"1.0\" byte_order=\"LittleEndian\" "
                    "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n  <{0}>\n",
                    names_.grid));
    write_section(VtuSection::kFieldData);
    file_.write(
        fmt::format("    <Piece NumberOfPoints=\"{}\" {}=\"{}\">\n", points, names_.count_of_cells, cells));
    for (const VtuSection section :
         {VtuSection::kPointData, VtuSection::kCellData, VtuSection::kPoints, VtuSection::kCells})
      write_section(section);
    file_.write(fmt::format("    </Piece>\n  </{}>\n", names_.grid));
    begin_data();
  }

  /// Writes the tag before the data so that its name ends a block.
  void begin_data() {
    const std::size_t rest = (file_.position() + kVtuDataTag.size()) % kReadBlock;
    file_.write(std::string((kReadBlock - rest) % kReadBlock, ' '));
    file_.write(kVtuDataTag);
    file_.write(kDataAttributes);
    file_.write(">\n   _");
  }

  void write_section(VtuSection section) {
    const std::string_view name = section == VtuSection::kCells ? names_.cells : name_of(section);
    file_.write(fmt::format("    <{}>\n", name));
    for (std::size_t i = 0; i < arrays_.size(); ++i) {
      const VtuArray& array = arrays_[i];
      if (array.section != section) continue;
      file_.write(fmt::format("      <DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" ",
                              vtu_name_of(array.type), escaped(array.name), array.components));
      if (section == VtuSection::kFieldData) file_.write(fmt::format("NumberOfTuples=\"{}\" ", array.tuples));
      file_.write("format=\"appended\" ");
      offset_places_[i] = file_.position();
      file_.write(std::string(kOffsetBytes, ' ') + "/>\n");
    }
    file_.write(fmt::format("    </{}>\n", name));
  }

  void write_data(const VtuArray& array) {
    const std::size_t row_bytes = array.components * size_of(array.type);
    // Whole rows, so that a block is a range of rows.
    const std::size_t block_rows = std::max<std::size_t>(1, kBlockBytes / row_bytes);
    const std::size_t blocks = (array.tuples + block_rows - 1) / block_rows;

    // The compressed sizes are known once the blocks are written.
    std::vector<std::uint64_t> header(3 + blocks, 0);
    header[0] = blocks;
    header[1] = block_rows * row_bytes;
    header[2] = array.tuples % block_rows * row_bytes;
    const std::uint64_t header_place = file_.position();
    const auto header_bytes = [&] {
      return std::string_view(reinterpret_cast<const char*>(header.data()), header.size() * sizeof header[0]);
    };
    file_.write(header_bytes());

    std::size_t written = 0;
    const auto write_blocks = [&](const Slots& slots, std::size_t count) {
      for (std::size_t i = 0; i < count; ++i) {
        header[3 + written++] = slots[i].compressed_bytes;
        file_.write(slots[i].compressed.data(), slots[i].compressed_bytes);
      }
    };
    std::size_t waiting = 0;  // compressed blocks of the other slots that are not yet written
    for (std::size_t first = 0; first < blocks; first += kBlocksAtOnce) {
      const std::size_t count = std::min(kBlocksAtOnce, blocks - first);
      Slots& slots = slots_[first / kBlocksAtOnce % 2];
      const Slots& others = slots_[1 - first / kBlocksAtOnce % 2];
      const auto write_or_compress = [&](std::size_t task) {
        if (task == 0) return write_blocks(others, waiting);
        const std::size_t begin = (first + task - 1) * block_rows;
        fill_and_compress(array, begin, std::min(begin + block_rows, array.tuples), row_bytes,
                          slots[task - 1]);
      };
      parallel_for(1 + count, write_or_compress, 1);
      waiting = count;
    }
    if (waiting > 0) write_blocks(slots_[(blocks - 1) / kBlocksAtOnce % 2], waiting);
    file_.patch(header_place, header_bytes());
  }

  /// Reused memory of one block. Raw data are stored in units of 8 bytes for alignment.
  struct Slot {
    std::vector<std::uint64_t> raw;
    std::vector<unsigned char> compressed;
    std::size_t compressed_bytes = 0;
    std::optional<ZlibPacker> packer;
  };
  using Slots = std::array<Slot, kBlocksAtOnce>;

  void fill_and_compress(const VtuArray& array, std::size_t begin, std::size_t end, std::size_t row_bytes,
                         Slot& slot) const {
    const std::size_t bytes = (end - begin) * row_bytes;
    slot.raw.resize((bytes + 7) / 8);
    array.produce(begin, end, slot.raw.data());
    if (!slot.packer) slot.packer.emplace();
    slot.compressed_bytes = slot.packer->pack(
        {reinterpret_cast<const unsigned char*>(slot.raw.data()), bytes}, array.packing, slot.compressed);
  }

  OutputFile& file_;
  const GridNames& names_;
  const std::vector<VtuArray>& arrays_;
  std::vector<std::uint64_t> offset_places_;
  std::uint64_t data_begin_ = 0;
  std::array<Slots, 2> slots_;
};

void write_grid(OutputFile& file, const GridNames& names, std::size_t points, std::size_t cells,
                const std::vector<VtuArray>& arrays) {
  for ([[maybe_unused]] const VtuArray& array : arrays) {
    assert(array.components > 0);
    assert(array.section != VtuSection::kPointData || array.tuples == points);
    assert(array.section != VtuSection::kCellData || array.tuples == cells);
  }
  VtuWriter(file, names, arrays).write(points, cells);
}

}  // namespace

void write_vtu(OutputFile& file, std::size_t points, std::size_t cells, const std::vector<VtuArray>& arrays) {
  write_grid(file, kUnstructuredGrid, points, cells, arrays);
}

void write_vtp(OutputFile& file, std::size_t points, std::size_t lines, const std::vector<VtuArray>& arrays) {
  write_grid(file, kPolylines, points, lines, arrays);
}

}  // namespace crossgrain

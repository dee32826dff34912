// SPDX-License-Identifier: Apache-2.0
// Reads Gmsh meshes, MSH 2 and 4.1, in text or binary ("Gmsh file formats"): sections from $Name to $EndName.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

#include "mesh_files/cells/cell_reader.hpp"
#include "mesh_files/cells/gmsh_mesh.hpp"
#include "text/text_scanner.hpp"

namespace crossgrain {
namespace {

/// Contents of $MeshFormat.
struct GmshFormat {
  bool is_version_4 = false;
  bool is_binary = false;
  bool is_swapped = false;
  NumberType size_type = NumberType::kInt64;
};

class GmshReader {
 public:
  explicit GmshReader(const InputFile& file) : file_(&file), scanner_(file, {}) {}

  Place read(CellBuilder& builder) {
    read_format();
    GmshMesh mesh(*file_, format_.size_type, builder);
    bool has_elements = false;
    for (std::string name = next_section(); !name.empty(); name = next_section()) {
      if (name == "Nodes" && mesh.has_nodes()) fail("a second section $Nodes");
      if (name == "Elements" && !mesh.has_nodes()) fail("$Elements before $Nodes");
      has_elements |= name == "Elements";
      read_section(name, mesh);
    }
    if (!mesh.has_nodes() || !has_elements)
      fail(fmt::format("the section {} is missing: cut short", mesh.has_nodes() ? "$Elements" : "$Nodes"),
           Remedy::kCopyAgain);
    return format_.is_binary ? Place{} : scanner_.place();
  }

 private:
  void read_format() {
    const std::string_view begin = scanner_.word_anywhere();
    if (begin == "$NOD") fail_version("1");
    if (begin != "$MeshFormat")
      scanner_.fail(fmt::format("{} instead of $MeshFormat: this is not a Gmsh mesh", in_quotes(begin)),
                    Remedy::kExportAgain);
    const std::string_view version = scanner_.word_anywhere();
    const bool is_version_2 = version == "2" || version.starts_with("2.");
    format_.is_version_4 = version == "4.1";
    if (!is_version_2 && !format_.is_version_4) fail_version(version);
    const std::int64_t kind = scanner_.integer(scanner_.word_anywhere(), "0 for text or 1 for binary");
    if (kind != 0 && kind != 1) scanner_.fail(fmt::format("{} instead of 0 for text or 1 for binary", kind));
    format_.is_binary = kind == 1;
    const std::int64_t size = scanner_.integer(scanner_.word_anywhere(), "the size of numbers");
    if (format_.is_binary && size != 8 && !(size == 4 && format_.is_version_4))
      scanner_.fail(fmt::format("numbers of {} bytes, where 8 are usual", size));
    if (size == 4) format_.size_type = NumberType::kUint32;
    scanner_.next_line();
    if (format_.is_binary) read_byte_order();
    end_section("MeshFormat");
  }

  void read_byte_order() {
    NumberStream stream(*file_, scanner_.position(), false);
    const std::int64_t one = stream.integer(NumberType::kInt32, "the number 1");
    if (one != 1 && one != 1 << 24) stream.fail("the number that tells the byte order is not 1");
    format_.is_swapped = one != 1;
    move_to(stream.position());
  }

  [[noreturn]] void fail_version(std::string_view version) const {
    fail(fmt::format("MSH {} has no reader, only 2.2 and 4.1 (to convert: gmsh -save -format msh41 -o "
                     "NEW.msh OLD.msh)",
                     in_quotes(version)),
         Remedy::kExportAgain);
  }

  /// Names the line, or in a binary file the byte.
  [[noreturn]] void fail(const std::string& text, Remedy remedy = Remedy::kRepairFile) const {
    fail_input(*file_, format_.is_binary ? Place{"byte", scanner_.position()} : scanner_.place(), text,
               remedy);
  }

  /// Returns the name of the next section without its $; empty at the end of the file.
  std::string next_section() {
    const std::string_view word = scanner_.word_anywhere();
    if (word.empty()) return "";
    if (!word.starts_with('$') || word.size() == 1 || word.starts_with("$End"))
      fail(fmt::format("{} instead of a section such as $Nodes", in_quotes(word)));
    scanner_.next_line();
    return std::string(word.substr(1));
  }

  void read_section(const std::string& name, GmshMesh& mesh) {
    const bool is_read =
        name == "Nodes" || name == "Elements" || (name == "Entities" && format_.is_version_4);
    if (!is_read) return skip_section(name);
    std::int64_t count = 0;
    if (!format_.is_version_4) {
      count = scanner_.integer(scanner_.word_anywhere(), "the number of rows");
      // In text, rows may begin on this line.
      if (format_.is_binary) scanner_.next_line();
    }
    NumberStream in = format_.is_binary ? NumberStream(*file_, scanner_.position(), format_.is_swapped)
                                        : NumberStream(scanner_);
    if (format_.is_version_4) {
      read_section_4(name, mesh, in);
    } else if (name == "Nodes") {
      mesh.read_nodes_2(in, count);
    } else {
      mesh.read_elements_2(in, count);
    }
    if (format_.is_binary) {
      move_to(in.position());
    } else {
      scanner_ = in.scanner();
    }
    end_section(name);
  }

  static void read_section_4(const std::string& name, GmshMesh& mesh, NumberStream& in) {
    if (name == "Entities") {
      mesh.read_entities_4(in);
    } else if (name == "Nodes") {
      mesh.read_nodes_4(in);
    } else {
      mesh.read_elements_4(in);
    }
  }

  void end_section(const std::string& name) {
    const std::string_view word = scanner_.word_anywhere();
    const std::string end = in_quotes("$End" + name);
    if (word.empty()) fail(fmt::format("the line {} is missing: cut short", end), Remedy::kCopyAgain);
    if (!word.starts_with("$End") || word.substr(4) != name)
      fail(fmt::format("{} instead of {}: the number of rows of {} is wrong", in_quotes(word), end,
                       in_quotes("$" + name)));
    scanner_.next_line();
  }

  void skip_section(const std::string& name) {
    const std::size_t end = file_->bytes().find("$End" + name, scanner_.position());
    if (end == std::string_view::npos)
      fail(fmt::format("{} has no {}: cut short", in_quotes("$" + name), in_quotes("$End" + name)),
           Remedy::kCopyAgain);
    move_to(end);
    end_section(name);
  }

  /// Also counts lines; in binary files the count is meaningless.
  void move_to(std::size_t position) {
    const std::string_view passed =
        file_->bytes().substr(scanner_.position(), position - scanner_.position());
    const auto lines = static_cast<std::size_t>(std::count(passed.begin(), passed.end(), '\n'));
    scanner_ = TextScanner(*file_, {}, position, scanner_.line() + lines);
  }

  const InputFile* file_;
  TextScanner scanner_;
  GmshFormat format_;
};

}  // namespace

Place read_gmsh(const InputFile& file, CellBuilder& builder) {
  return GmshReader(file).read(builder);
}

}  // namespace crossgrain

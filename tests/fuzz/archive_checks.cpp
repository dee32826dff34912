// SPDX-License-Identifier: Apache-2.0
#include "archives/made_archives.hpp"
#include "archives/zip_archive.hpp"
#include "cad_reading/freecad_document.hpp"
#include "cad_reading/placed_breps.hpp"
#include "crossgrain/reading.hpp"
#include "fuzz/input_folder.hpp"
#include "fuzz/mesh_promises.hpp"
#include "fuzz/reader_checks.hpp"
#include "mesh_files/made_3mf.hpp"

namespace crossgrain {
namespace {

bool check_surface(const std::filesystem::path& path) {
  TriangleMesh mesh;
  if (!succeeds([&] { mesh = read_surface(path); })) return false;
  require_triangles(mesh);
  return true;
}

}  // namespace

bool check_gzip(std::string_view bytes) {
  return check_surface(as_file("input.stl.gz", bytes));
}

bool check_zip(std::string_view bytes) {
  const auto path = as_file("input.zip", bytes);
  return succeeds([&] {
    const InputFile file(path);
    const ZipArchive archive(file);
    for (const char* name : {"a", "b"})
      if (archive.holds(name)) archive.read(name);
  });
}

bool check_threemf(std::string_view bytes) {
  return check_surface(as_file("input.3mf", made_3mf(std::string(bytes))));
}

bool check_freecad(std::string_view bytes) {
  const std::size_t end = bytes.find('\0');
  Members members{{"Document.xml", std::string(bytes.substr(0, end))}, {"a.brp", "CASCADE Topology V1"}};
  if (end != std::string_view::npos) members.emplace_back("GuiDocument.xml", bytes.substr(end + 1));
  const auto path = as_file("input.FCStd", zipped(members, true));
  return succeeds([&] {
    const FreeCadShapes shapes = read_freecad_document(InputFile(path));
    require(placed_breps_in(shapes.placed_breps).has_value(), "shapes that the program cannot read");
    for (const Warning& warning : shapes.warnings) require_one_line(warning.text);
  });
}

}  // namespace crossgrain

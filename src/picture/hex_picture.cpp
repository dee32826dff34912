// SPDX-License-Identifier: Apache-2.0
// Pictures of hexahedra.
#include <algorithm>
#include <cmath>
#include <string>

#include "crossgrain/error.hpp"
#include "crossgrain/picture.hpp"
#include "files/output_file.hpp"
#include "picture/hex_drawing.hpp"
#include "picture/sheet.hpp"

namespace crossgrain {
namespace {

void check_mesh(const HexMesh& mesh) {
  if (mesh.hexahedra.empty()) throw Error(ErrorKind::kInput, "there are no hexahedra to draw");
  const auto is_there = [&](std::uint32_t vertex) {
    return vertex < mesh.vertices.size() &&
           std::ranges::all_of(mesh.vertices[vertex], [](double x) { return std::isfinite(x); });
  };
  for (std::size_t h = 0; h < mesh.hexahedra.size(); ++h)
    if (!std::ranges::all_of(mesh.hexahedra[h], is_there))
      throw Error(ErrorKind::kUsage, {"", "hexahedron " + std::to_string(h) + " (counted from 0)",
                                      "has a corner that is no vertex of the mesh"});
}

}  // namespace

void render_picture(const HexMesh& mesh, const std::filesystem::path& picture, const PictureOptions& options,
                    const HexReport* report, const Monitor& monitor) {
  check_options(options);
  check_picture_name(picture);
  check_option(options.colour == PictureColour::kNone || options.colour == PictureColour::kFace ||
                   options.colour == PictureColour::kRegion,
               "hexahedra are coloured by their scaled Jacobian, by face or by region");
  check_mesh(mesh);
  OutputFile file(picture);
  monitor.check();
  const ViewDirection direction = direction_of(options);
  const ShownHexahedra shown(mesh, options, ViewAxes(direction).towards);
  monitor.check();
  const std::vector<LegendBlock> blocks =
      shows(options, PicturePart::kLegend) ? shown.legend(report) : std::vector<LegendBlock>();
  const Sheet sheet(options, direction, shown.kept_surface(), blocks);
  write_picture(file, shown.drawing(*sheet.camera, kLabelSize * sheet.text_size), sheet, options, blocks,
                monitor);
}

}  // namespace crossgrain

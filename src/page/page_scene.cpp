// SPDX-License-Identifier: Apache-2.0
#include "page/page_scene.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "display/leaf_corner_means.hpp"
#include "display/shown_faces.hpp"
#include "display/shown_field.hpp"
#include "display/surface_numbers.hpp"
#include "field/field_data.hpp"
#include "grid/merged_depth.hpp"
#include "page/scene_hexahedra.hpp"
#include "page/scene_parts.hpp"
#include "page/scene_streamlines.hpp"
#include "page/scene_tets.hpp"
#include "results/output_cells.hpp"

namespace crossgrain {
namespace {

constexpr std::size_t kMostTriangles = 150000;

/// Beside tets, which are what the page is for, of the grid from which they started.
constexpr std::size_t kMostGridCells = 50000, kMostGridTriangles = 50000;

void add_creases(const SolvedSurface& surface, const Vector3& origin, SceneWriter& scene) {
  Polylines creases(origin);
  for (const std::vector<Vector3>& crease : surface.creases) creases.add(crease);
  creases.write(scene, "crease_points", "crease_starts");
}

using Searched = std::function<std::shared_ptr<const SearchableSurface>()>;

/// Adds the face of each triangle that is drawn of `outside`, given those of the surface that is searched.
void add_faces(std::vector<std::int32_t> faces, const Searched& searched, const SolvedSurface& outside,
               const DrawnSurface& drawn, SceneWriter& scene) {
  if (!faces.empty() && drawn.vertices.size() != 3 * faces.size()) {
    std::vector<std::array<std::uint32_t, 3>> triangles(drawn.vertices.size() / 3);
    for (std::size_t k = 0; k < drawn.vertices.size(); ++k)
      triangles[k / 3][k % 3] = drawn.originals[drawn.vertices[k]];
    faces = faces_near(*searched(), faces, outside.vertices, triangles);
  }
  scene.add("surface_face", 1, column<std::uint32_t>(faces, [](std::int32_t face) { return face; }));
}

/// Adds the cells of `shown`, with corners in units of the smallest of them.
void add_cells(const FieldData& shown, const Vector3& origin, SceneWriter& scene) {
  const auto& leaves = shown.tree.leaves();
  int deepest = 0;
  for (const CellAddress leaf : leaves) deepest = std::max(deepest, leaf.depth());
  const int shift = kMaxDepth - deepest;
  const RootCube& root = shown.tree.root();
  SceneCells cells;
  cells.low = root.origin;
  cells.unit = root.cell_size(deepest);
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    for (const std::int32_t place : leaves[i].corner())
      cells.corners.push_back(static_cast<std::uint16_t>(place >> shift));
    cells.sizes.push_back(static_cast<std::uint16_t>(leaves[i].width() >> shift));
    const StoredQuaternion& q = shown.frames[i];
    add_quaternion({q.w, q.x, q.y, q.z}, cells.frames);
  }
  cells.energy_density = column<std::uint16_t>(shown.energy_density, to_bfloat16);
  cells.alignment_deg = column<std::uint16_t>(shown.alignment_deg, to_bfloat16);
  std::vector<CellConstraint> classes = shown.constraints;
  classes.resize(leaves.size(), CellConstraint::kNoSurface);
  cells.classes = column<std::uint8_t>(classes, [](CellConstraint c) { return c; });
  cells.regions = shown.regions;
  cells.write(shown.merged ? shown.merged->from : leaves.size(), origin, scene);
  if (shown.merged) scene.header["cells"]["merged_to"] = root.cell_size(shown.merged->level);
}

void add_forms(const KeptForms& forms, const FieldData& shown, SceneWriter& scene) {
  const auto& leaves = shown.tree.leaves();
  std::vector<std::uint32_t> cells;
  for (const CellAddress cell : forms.cells)
    cells.push_back(
        static_cast<std::uint32_t>(std::lower_bound(leaves.begin(), leaves.end(), cell) - leaves.begin()));
  const std::size_t size = shown.degree == Degree::kThree ? 7 : 9;
  scene.add("form_cell", 1, cells);
  scene.add("form_matrix", size * (size + 1) / 2, forms.matrices);
  scene.add("form_linear", size, forms.linear_parts);
  scene.add("form_constant", 1, forms.constants);
  scene.add("form_weight", 1, forms.weights);
}

/// Longest sides of the pieces of the surface from which numbers at corners are made, in cells: two or three
/// in a cell, as each corner has those of four cells.
constexpr double kLongestPieces = 2;

/// Adds the numbers at the corners of cells with surface, between which the page interpolates.
void add_corner_numbers(const ShownField& field, SceneWriter& scene) {
  const auto values = [](const std::vector<SurfaceNumbers::LeafCorners>& leaves) {
    std::vector<std::uint16_t> numbers;
    for (const auto& leaf : leaves)
      for (const float number : leaf.numbers) numbers.push_back(to_bfloat16(number));
    return numbers;
  };
  const CornersOfLeaves corners(field.grid());
  // Energy first: it keeps less while angles are made of the same pieces.
  const SurfaceNumbers energy(field, SurfaceNumber::kEnergy, kLongestPieces);
  const auto energies = energy.at_leaf_corners(corners);
  const auto tilts = SurfaceNumbers(energy, SurfaceNumber::kAlignment).at_leaf_corners(corners);
  scene.add("corner_cell", 1, column<std::uint32_t>(tilts, [](const auto& leaf) { return leaf.leaf; }));
  scene.add("corner_alignment_deg", 8, values(tilts));
  scene.add("corner_energy_density", 8, values(energies));
}

/// The axis of the largest of the areas that cuts across x, y and z show.
std::size_t widest_of(std::array<double, 3> areas) {
  // A view of a cut from the front is the most familiar: it is preferred to others that show about as much.
  constexpr double kFrontFirst = 1.15;
  areas[1] *= kFrontFirst;
  return static_cast<std::size_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
}

/// The axis across which the middle cut shows most of the part.
std::size_t widest_cut(const FieldData& field, const Box& box) {
  const Vector3 middle = 0.5 * (box.low + box.high);
  const RootCube& root = field.tree.root();
  std::array<double, 3> areas{};
  for (const CellAddress leaf : field.tree.leaves()) {
    const double size = root.cell_size(leaf.depth());
    const double unit = size / leaf.width();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double low = root.origin[axis] + unit * leaf.corner()[axis];
      if (low <= middle[axis] && middle[axis] < low + size) areas[axis] += size * size;
    }
  }
  return widest_of(areas);
}

/// The same of hexahedra, about: by the boxes around them.
std::size_t widest_cut(const HexMesh& mesh, const Box& box) {
  const Vector3 middle = 0.5 * (box.low + box.high);
  std::array<double, 3> areas{};
  for (const auto& hexahedron : mesh.hexahedra) {
    std::vector<Vector3> corners;
    for (const std::uint32_t vertex : hexahedron) corners.push_back(mesh.vertices[vertex]);
    const Box around = box_of(corners);
    const Vector3 sides = around.high - around.low;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (around.low[axis] <= middle[axis] && middle[axis] < around.high[axis])
        areas[axis] += sides[(axis + 1) % 3] * sides[(axis + 2) % 3];
  }
  return widest_of(areas);
}

/// The field on the grid with at most so many cells.
FrameField reduced(const FrameField& field, std::size_t most, const Monitor& monitor) {
  const FieldData& data = field.data();
  OutputOptions merged;
  merged.level = merged_depth(data.tree, most, kDeepestShown);
  if (ask_for_all(merged, data.tree)) return field;
  FieldData fewer = output_cells(data, merged, monitor);
  fewer.surface = data.surface;
  return FrameField(std::make_shared<const FieldData>(std::move(fewer)));
}

/// What is in every scene. The axis of the first cut is in the header.
class PageScene {
 public:
  /// `subject` is what the first cut is to show most of.
  template <class Subject>
  PageScene(const SolveReport::Model& model, const Subject& subject, const Monitor& monitor)
      : origin_(0.5 * (model.bounding_box.low + model.bounding_box.high)),
        first_cut_(widest_cut(subject, model.bounding_box)),
        monitor_(monitor) {
    scene_.header["origin"] = origin_;
    scene_.header["unit"] = model.unit;
    scene_.header["low"] = model.bounding_box.low - origin_;
    scene_.header["high"] = model.bounding_box.high - origin_;
    scene_.header["first_cut"] = std::string(1, "xyz"[first_cut_]);
  }

  std::string of_grid(const FrameField& field) {
    const ShownField whole(field);
    FrameField shown = reduced(field, kMostCellsOfPage, monitor_);
    if (auto fewer = clustered_surface(whole.surface(), origin_, kMostTriangles)) {
      add_outside(whole, *fewer);
      // Numbers at the corners of cells are those of the surface that is shown; lines end at the whole one.
      FieldData data = shown.data();
      data.surface = SurfaceSource(*std::move(fewer), field.data().surface.searchable());
      shown = FrameField(std::make_shared<const FieldData>(std::move(data)));
    } else {
      add_outside(whole, whole.surface());
    }
    add_beside_lines(shown, [&] { add_grid(field, shown); });
    return scene_.bytes();
  }

  std::string of_tets(const TetFrameField& field, const HexMesh* hexahedra) {
    add_beside_lines(field, [&] { add_all_tets(field); });
    if (hexahedra != nullptr) add_hexahedra(*hexahedra, origin_, kMostHexahedraOfPage, scene_);
    return scene_.bytes();
  }

  std::string of_hexahedra(const HexMesh& hexahedra, const SolvedSurface& surface) {
    add_outside(surface, surface, surface.faces, [&] { return searchable(surface); });
    add_hexahedra(hexahedra, origin_, kMostHexahedraOfPage, scene_);
    return scene_.bytes();
  }

 private:
  DrawnSurface add_outside(const SolvedSurface& surface, const SolvedSurface& outside,
                           std::vector<std::int32_t> faces, const Searched& searched) {
    DrawnSurface drawn = add_surface(surface, outside, origin_, "", kMostTriangles, scene_);
    add_faces(std::move(faces), searched, outside, drawn, scene_);
    add_creases(surface, origin_, scene_);
    monitor_.check();
    return drawn;
  }

  DrawnSurface add_outside(const ShownField& field, const SolvedSurface& outside) {
    DrawnSurface drawn =
        add_outside(field.surface(), outside, faces_of(field), [&] { return field.searchable(); });
    add_singularities(field, origin_, "", scene_);
    return drawn;
  }

  void add_all_tets(const TetFrameField& field) {
    const ShownField shown(field);
    const DrawnSurface drawn = add_outside(shown, shown.surface());
    add_boundary_numbers(shown, drawn, scene_);
    if (!add_tets(shown, origin_, kMostShownTets, kMostCellsOfPage, monitor_, scene_)) return;
    const ShownField grid(field.grid());
    add_surface(grid.surface(), grid.surface(), origin_, "grid_", kMostGridTriangles, scene_);
    add_singularities(grid, origin_, "grid_", scene_);
    add_grid(field.grid(), reduced(field.grid(), kMostGridCells, monitor_));
  }

  /// Adds the streamlines of a field after what add_rest adds, while which they are traced.
  template <class Field>
  void add_beside_lines(const Field& field, const std::function<void()>& add_rest) {
    std::optional<PageStreamlines> lines;
    run_side_by_side(add_rest, [&] {
      lines.emplace(page_tracer(field), origin_, static_cast<int>(first_cut_), monitor_);
    });
    lines->write(scene_);
  }

  void add_grid(const FrameField& field, const FrameField& shown) {
    add_cells(shown.data(), origin_, scene_);
    add_corner_numbers(ShownField(shown), scene_);
    add_forms(field.data().kept_forms, shown.data(), scene_);
  }

  Vector3 origin_;
  std::size_t first_cut_;
  const Monitor& monitor_;
  SceneWriter scene_;
};

}  // namespace

std::string page_scene(const FrameField& field, const Monitor& monitor) {
  return PageScene(field.data().report.model, field.data(), monitor).of_grid(field);
}

std::string page_scene(const TetFrameField& field, const HexMesh* hexahedra, const Monitor& monitor) {
  const FieldData& grid = field.grid().data();
  return PageScene(grid.report.model, grid, monitor).of_tets(field, hexahedra);
}

std::string page_scene(const FittedHexahedra& fitted, const Monitor& monitor) {
  return PageScene(fitted.report.model, fitted.mesh, monitor).of_hexahedra(fitted.mesh, *fitted.surface);
}

}  // namespace crossgrain

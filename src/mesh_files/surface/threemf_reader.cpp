// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/error.hpp"
#include "files/read_memory.hpp"
#include "mesh_files/surface/surface_reader.hpp"
#include "mesh_files/surface/threemf_document.hpp"

namespace crossgrain {
namespace {

/// Components in components; slicers nest them twice.
constexpr int kDeepestComponents = 50;

class Builder {
 public:
  Builder(const InputFile& file, const ThreeMfDocument& document) : file_(file), document_(document) {}

  TriangleMesh build() && {
    double triangles = 0;
    for (const ThreeMfPlaced& item : document_.items) triangles += measure(item.object, 0).triangles;
    if (triangles == 0)
      throw Error(ErrorKind::kInput,
                  {file_.name(), "", "has no item to build with triangles", Remedy::kExportAgain});
    // Vertices may be three for each.
    if (triangles > std::numeric_limits<std::uint32_t>::max() / 3)
      throw Error(
          ErrorKind::kLimit,
          {file_.name(), "", fmt::format("its items have {:.3g} triangles in all, too many", triangles),
           Remedy::kSimplify});
    // A closed surface has half as many vertices as triangles.
    require_read_memory(file_.name(), triangles * (sizeof(Vector3) / 2 + sizeof(mesh_.triangles[0])));
    ThreeMfTransform to_millimetres;
    for (std::size_t k = 0; k < 3; ++k) to_millimetres.rows[k][k] = document_.millimetres;
    for (const ThreeMfPlaced& item : document_.items) add(item, to_millimetres);
    mesh_.unit = "mm";
    mesh_.file_unit = document_.unit;
    if (left_out_ > 0)
      mesh_.warnings.emplace_back(
          WarningKind::kMissingParts,
          fmt::format("items and components that are supports or of type 'other', left out: {}", left_out_));
    for (Warning& warning : mesh_.warnings) warning.file = file_.name();
    return std::move(mesh_);
  }

 private:
  const ThreeMfObject& object(const ThreeMfName& name) const {
    const auto found = document_.objects.find(name);
    if (found == document_.objects.end())
      throw Error(ErrorKind::kInput,
                  {file_.name(), in_quotes(name.first),
                   fmt::format("object {} is missing", in_quotes(name.second)), Remedy::kExportAgain});
    return found->second;
  }

  /// Of an object with all its components.
  struct Extent {
    double triangles = 0;
    int height = 0;  ///< of the tree of components
  };

  [[noreturn]] void fail_too_deep(const ThreeMfName& name) const {
    throw Error(ErrorKind::kInput,
                {file_.name(), in_quotes(name.first),
                 fmt::format("components of object {} are nested in themselves or too deeply",
                             in_quotes(name.second)),
                 Remedy::kExportAgain});
  }

  /// Each object is measured once, since components of components multiply them.
  Extent measure(const ThreeMfName& name, int depth) {
    if (depth > kDeepestComponents) fail_too_deep(name);
    const ThreeMfObject& it = object(name);
    if (const auto known = extents_.find(&it); known != extents_.end()) return known->second;
    Extent extent;
    if (it.is_built) {
      extent.triangles = static_cast<double>(it.triangles.size());
      for (const ThreeMfPlaced& component : it.components) {
        const auto [triangles, height] = measure(component.object, depth + 1);
        extent = {extent.triangles + triangles, std::max(extent.height, height + 1)};
      }
    }
    if (extent.height > kDeepestComponents) fail_too_deep(name);
    return extents_[&it] = extent;
  }

  void add(const ThreeMfPlaced& placed, const ThreeMfTransform& outer) {
    check_watched();
    const ThreeMfObject& it = object(placed.object);
    left_out_ += !it.is_built;
    // What has no triangles is passed over: many of them could refer to as many others.
    if (extents_[&it].triangles == 0) return;
    const ThreeMfTransform transform = outer.after(placed.transform);
    for (const ThreeMfPlaced& component : it.components) add(component, transform);
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    reserve_more(file_.name(), mesh_.vertices, it.vertices.size());
    reserve_more(file_.name(), mesh_.triangles, it.triangles.size());
    for (const Vector3& vertex : it.vertices) add_vertex(transform(vertex));
    // A mirror image looks inwards.
    const bool is_mirrored = transform.determinant() < 0;
    for (auto [a, b, c] : it.triangles) {
      if (is_mirrored) std::swap(b, c);
      mesh_.triangles.push_back({first + a, first + b, first + c});
    }
  }

  void add_vertex(const Vector3& vertex) {
    if (!std::ranges::all_of(vertex, [](double x) { return std::isfinite(x); }))
      throw Error(ErrorKind::kInput,
                  {file_.name(), "", "transforms take a vertex to infinity", Remedy::kExportAgain});
    mesh_.vertices.push_back(vertex);
  }

  const InputFile& file_;
  const ThreeMfDocument& document_;
  std::map<const ThreeMfObject*, Extent> extents_;
  std::size_t left_out_ = 0;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh read_3mf(const InputFile& file) {
  const ThreeMfDocument document = read_3mf_document(file);
  return Builder(file, document).build();
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "tets/listed_topology.hpp"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>

#include "base/ascending.hpp"

namespace crossgrain {
namespace {

using Edge = std::array<std::uint32_t, 2>;
using Face = std::array<std::uint32_t, 3>;

/// The listed elements of one kind: their vertices, ascending, and tags.
template <class Vertices>
using Listed = std::vector<std::pair<Vertices, std::int32_t>>;

/// Which of the listed elements say nothing.
struct IgnoredTags {
  bool all = false;
  std::vector<std::int32_t> tags;  ///< ascending

  bool holds(std::int32_t tag) const { return all || std::binary_search(tags.begin(), tags.end(), tag); }
  bool empty() const { return !all && tags.empty(); }
};

/// A list that names at least this share of all faces inside, of all edges inside or of all edges of the
/// surface is one of the mesh, not of features. True features are far from it: in a mesh of n tets across,
/// surfaces have a share of about 1/n; of the 18 edges of a box of twelve triangles, twelve are sharp.
constexpr double kLeastShare = 0.9;

/// In such a list the most common tag is ignored, and the others count if together they name at most this
/// share; otherwise none does, because tags tell nothing apart. The sharp edges of a box are a quarter of
/// all its edges if there are three along a side, and the fewer the finer the mesh.
constexpr double kMostOtherShare = 0.25;

/// Regions of fewer tets than this in the mean are no bodies and become one: around a single vertex inside
/// there are about 20 tets, and a hexahedron is cut into 5 or 6.
constexpr double kFewestRegionTets = 10;

/// Shorter lists, and fewer regions, always count: in a mesh of a few tets a feature may be everything.
constexpr std::size_t kFewest = 20;

/// Decides for elements of one kind, of which the mesh has `total`.
template <class Vertices>
IgnoredTags ignored_tags(Listed<Vertices>& listed, std::size_t total) {
  std::sort(listed.begin(), listed.end());
  const auto same = [](const auto& a, const auto& b) { return a.first == b.first; };
  listed.erase(std::unique(listed.begin(), listed.end(), same), listed.end());
  const auto share_of_all = [&](std::size_t count) {
    return static_cast<double>(count) / static_cast<double>(total);
  };
  if (listed.size() < kFewest || share_of_all(listed.size()) < kLeastShare) return {};
  std::map<std::int32_t, std::size_t> counts;
  for (const auto& element : listed) ++counts[element.second];
  const auto most = std::max_element(counts.begin(), counts.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  const std::size_t others = listed.size() - most->second;
  if (share_of_all(others) > kMostOtherShare) return {true, {}};
  return {false, {most->first}};
}

std::string count_of(std::size_t listed, std::size_t total, const char* what) {
  return std::to_string(listed) + " of " + std::to_string(total) + " " + what;
}

/// Removes lists from a mesh, and collects what it has removed for a warning.
class ListRemoval {
 public:
  explicit ListRemoval(TetSolid& solid) : solid_(solid) {}

  void remove_regions() {
    std::vector<std::int32_t> regions = solid_.mesh.regions;
    sort_uniquely(regions);
    const std::size_t tets = solid_.mesh.tets.size();
    if (regions.size() < kFewest) return;
    if (static_cast<double>(tets) >= kFewestRegionTets * static_cast<double>(regions.size())) return;
    solid_.mesh.regions.clear();
    removed_.push_back(std::to_string(regions.size()) + " regions for " + std::to_string(tets) + " tets");
  }

  void remove_faces() {
    const auto is_inside = [&](const TetMesh::Face& face) {
      const Face key = ascending(face.vertices);
      const auto at = std::lower_bound(solid_.inner_faces.begin(), solid_.inner_faces.end(), key,
                                       [](const auto& inner, const Face& k) { return inner.vertices < k; });
      return at != solid_.inner_faces.end() && at->vertices == key;
    };
    std::vector<TetMesh::Face>& faces = solid_.mesh.feature_faces;
    remove(faces, solid_.inner_faces.size(), is_inside, "faces inside");
  }

  /// Edges of the surface that are not stated count only where it is sharp, whatever is listed.
  void remove_edges() {
    std::vector<TetMesh::Edge>& edges = solid_.mesh.feature_edges;
    if (edges.size() < kFewest) return;
    std::vector<Edge> surface, all;
    for (const Face& face : solid_.boundary)
      for (std::size_t k = 0; k < 3; ++k) surface.push_back(ascending(Edge{face[k], face[(k + 1) % 3]}));
    sort_uniquely(surface);
    // Shares of the surface and of the inside can only be large if the list is as long as one of them.
    if (static_cast<double>(edges.size()) < kLeastShare * static_cast<double>(surface.size())) return;
    for (const auto& tet : solid_.mesh.tets)
      for (std::size_t a = 0; a < 4; ++a)
        for (std::size_t b = a + 1; b < 4; ++b) all.push_back(ascending(Edge{tet[a], tet[b]}));
    sort_uniquely(all);
    const auto is_on_surface = [&](const TetMesh::Edge& edge) {
      return std::binary_search(surface.begin(), surface.end(), ascending(edge.vertices));
    };
    const auto is_inside = [&](const TetMesh::Edge& edge) {
      return !is_on_surface(edge) && std::binary_search(all.begin(), all.end(), ascending(edge.vertices));
    };
    const auto is_stated_on_surface = [&](const TetMesh::Edge& edge) {
      return edge.is_stated && is_on_surface(edge);
    };
    remove(edges, all.size() - std::min(all.size(), surface.size()), is_inside, "edges inside");
    remove(edges, surface.size(), is_stated_on_surface, "edges of the surface");
  }

  const std::vector<std::string>& removed() const { return removed_; }

 private:
  /// Removes those listed elements for which `is_of_kind` that say nothing.
  template <class Element, class IsOfKind>
  void remove(std::vector<Element>& elements, std::size_t total, const IsOfKind& is_of_kind,
              const char* what) {
    Listed<decltype(Element::vertices)> listed;
    for (const Element& element : elements)
      if (is_of_kind(element)) listed.emplace_back(ascending(element.vertices), element.tag);
    const IgnoredTags ignored = ignored_tags(listed, total);
    if (ignored.empty()) return;
    std::erase_if(elements,
                  [&](const Element& element) { return ignored.holds(element.tag) && is_of_kind(element); });
    const auto count = std::count_if(listed.begin(), listed.end(),
                                     [&](const auto& element) { return ignored.holds(element.second); });
    removed_.push_back(count_of(static_cast<std::size_t>(count), total, what));
  }

  TetSolid& solid_;
  std::vector<std::string> removed_;
};

}  // namespace

void drop_listed_topology(TetSolid& solid, const TetTagOptions& options, std::vector<Warning>& warnings) {
  if (options.keep_all) return;
  ListRemoval removal(solid);
  removal.remove_regions();
  removal.remove_faces();
  removal.remove_edges();
  if (removal.removed().empty()) return;
  std::string list;
  for (const std::string& part : removal.removed()) list += (list.empty() ? "" : ", ") + part;
  warnings.emplace_back(WarningKind::kListedTopology,
                        "lists and tags that name nearly everything are ignored: " + list, Remedy::kKeepTags);
}

}  // namespace crossgrain

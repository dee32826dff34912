// SPDX-License-Identifier: Apache-2.0
// Gmsh 4.1 in text. Elements and nodes are in blocks, one for each entity, with their own numbers: those of
// the mesh from 1, faces first.
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "files/file_mark.hpp"
#include "mesh_files/hex/hex_writers.hpp"
#include "text/text_lines.hpp"

namespace crossgrain {
namespace {

constexpr int kSurface = 2, kVolume = 3;         // dimensions of entities
constexpr int kQuadrangle = 3, kHexahedron = 5;  // types of elements

/// A surface or volume, and the physical group of the same number: all elements are in groups, since meshio
/// refuses files where only some are, and gmsh drops those that are in none when it saves a mesh.
struct Entity {
  int dimension;
  std::int32_t number;
  std::string name;  ///< of the group
  const HexGroup* group;
  std::vector<std::uint32_t> nodes;      ///< that no earlier entity has
  std::vector<std::int32_t> boundary{};  ///< numbers of the surfaces around a volume
  Vector3 low{}, high{};
};

/// Numbers of entities are positive. Tags that are not get the smallest free numbers; names have the tags.
std::vector<std::int32_t> numbers_of(const std::vector<HexGroup>& groups) {
  std::set<std::int32_t> used;
  for (const HexGroup& group : groups) used.insert(group.tag);
  std::vector<std::int32_t> numbers;
  std::int32_t free = 1;
  for (const HexGroup& group : groups) {
    while (used.contains(free)) ++free;
    numbers.push_back(group.tag > 0 ? group.tag : free++);
  }
  return numbers;
}

class GmshMeshWriter {
 public:
  GmshMeshWriter(OutputFile& file, const HexOutput& output, const Monitor& monitor)
      : file_(file), mesh_(output.mesh), content_(output.content()), monitor_(monitor) {
    make_entities(output);
    for (Entity& entity : entities_) measure(entity);
    share_nodes();
  }

  void write() {
    file_.write(fmt::format("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\n{}$EndComments\n",
                            text_mark(content_, file_.solve())));
    write_names();
    write_entities();
    write_nodes();
    write_elements();
  }

 private:
  void make_entities(const HexOutput& output) {
    const HexGroups& groups = output.groups;
    const std::vector<std::int32_t> surfaces = numbers_of(groups.faces), volumes = numbers_of(groups.regions);
    for (std::size_t k = 0; k < surfaces.size(); ++k)
      entities_.push_back(
          {kSurface,
           surfaces[k],
           groups.are_faces_untagged() ? "boundary" : fmt::format("face {}", groups.faces[k].tag),
           &groups.faces[k],
           {}});
    for (std::size_t k = 0; k < volumes.size(); ++k)
      entities_.push_back({kVolume,
                           volumes[k],
                           mesh_.regions.empty() ? "volume" : fmt::format("region {}", groups.regions[k].tag),
                           &groups.regions[k],
                           {}});
    std::vector<std::uint32_t> volume_of(mesh_.hexahedra.size());
    for (std::uint32_t k = 0; k < groups.regions.size(); ++k)
      for (const std::uint32_t hexahedron : groups.regions[k].members) volume_of[hexahedron] = k;
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      std::set<std::uint32_t> inside;
      for (const std::uint32_t face : groups.faces[k].members)
        inside.insert(volume_of[output.sides[face].hexahedron]);
      for (const std::uint32_t volume : inside)
        entities_[surfaces.size() + volume].boundary.push_back(surfaces[k]);
    }
  }

  template <class Use>
  void for_corners(const Entity& entity, const Use& use) const {
    for (const std::uint32_t member : entity.group->members) {
      if (entity.dimension == kSurface)
        for (const std::uint32_t corner : mesh_.boundary[member].vertices) use(corner);
      else
        for (const std::uint32_t corner : mesh_.hexahedra[member]) use(corner);
    }
  }

  void measure(Entity& entity) const {
    bool is_first = true;
    for_corners(entity, [&](std::uint32_t corner) {
      const Vector3& place = mesh_.vertices[corner];
      for (std::size_t a = 0; a < 3; ++a) {
        entity.low[a] = is_first ? place[a] : std::min(entity.low[a], place[a]);
        entity.high[a] = is_first ? place[a] : std::max(entity.high[a], place[a]);
      }
      is_first = false;
    });
  }

  /// Gives each node to the first entity that uses it, and those that none does to the last volume.
  void share_nodes() {
    std::vector<bool> is_given(mesh_.vertices.size(), false);
    for (Entity& entity : entities_) {
      for_corners(entity, [&](std::uint32_t corner) {
        if (is_given[corner]) return;
        is_given[corner] = true;
        entity.nodes.push_back(corner);
      });
    }
    for (std::uint32_t v = 0; v < mesh_.vertices.size(); ++v)
      if (!is_given[v]) entities_.back().nodes.push_back(v);
    for (Entity& entity : entities_) std::sort(entity.nodes.begin(), entity.nodes.end());
  }

  void write_names() {
    file_.write(fmt::format("$PhysicalNames\n{}\n", entities_.size()));
    for (const Entity& entity : entities_)
      file_.write(fmt::format("{} {} \"{}\"\n", entity.dimension, entity.number, entity.name));
    file_.write("$EndPhysicalNames\n");
  }

  void write_entities() {
    const auto surfaces = std::count_if(entities_.begin(), entities_.end(),
                                        [](const Entity& entity) { return entity.dimension == kSurface; });
    file_.write(fmt::format("$Entities\n0 0 {} {}\n", surfaces,
                            static_cast<std::ptrdiff_t>(entities_.size()) - surfaces));
    for (const Entity& entity : entities_) {
      std::string line = fmt::format("{}", entity.number);
      for (const Vector3& corner : {entity.low, entity.high})
        for (const double coordinate : corner) line += fmt::format(" {}", coordinate);
      line += fmt::format(" 1 {} {}", entity.number, entity.boundary.size());
      for (const std::int32_t surface : entity.boundary) line += fmt::format(" {}", surface);
      file_.write(line + "\n");
    }
    file_.write("$EndEntities\n");
  }

  void write_nodes() {
    const auto blocks = std::count_if(entities_.begin(), entities_.end(),
                                      [](const Entity& entity) { return !entity.nodes.empty(); });
    const std::size_t nodes = mesh_.vertices.size();
    file_.write(fmt::format("$Nodes\n{} {} {} {}\n", blocks, nodes, std::min<std::size_t>(nodes, 1), nodes));
    for (const Entity& entity : entities_) {
      if (entity.nodes.empty()) continue;
      file_.write(fmt::format("{} {} 0 {}\n", entity.dimension, entity.number, entity.nodes.size()));
      const auto put_number_of = [&](std::size_t k, char* out) {
        return put_integer(out, std::int64_t{entity.nodes[k]} + 1, '\n');
      };
      write_text_lines(file_, entity.nodes.size(), kIntegerBytes, put_number_of, monitor_);
      const auto put_place = [&](std::size_t k, char* out) {
        const auto& [x, y, z] = mesh_.vertices[entity.nodes[k]];
        return put_shortest(put_shortest(put_shortest(out, x, ' '), y, ' '), z, '\n');
      };
      write_text_lines(file_, entity.nodes.size(), 3 * kNumberBytes, put_place, monitor_);
    }
    file_.write("$EndNodes\n");
  }

  void write_elements() {
    const std::size_t faces = mesh_.boundary.size(), elements = faces + mesh_.hexahedra.size();
    const auto blocks = std::count_if(entities_.begin(), entities_.end(),
                                      [](const Entity& entity) { return !entity.group->members.empty(); });
    file_.write(fmt::format("$Elements\n{} {} {} {}\n", blocks, elements, std::min<std::size_t>(elements, 1),
                            elements));
    for (const Entity& entity : entities_) {
      const std::vector<std::uint32_t>& members = entity.group->members;
      if (members.empty()) continue;
      const bool is_surface = entity.dimension == kSurface;
      file_.write(fmt::format("{} {} {} {}\n", entity.dimension, entity.number,
                              is_surface ? kQuadrangle : kHexahedron, members.size()));
      const auto put = [&](std::size_t k, char* out) {
        const std::size_t number = members[k] + (is_surface ? 1 : faces + 1);
        out = put_integer(out, static_cast<std::int64_t>(number), ' ');
        return is_surface ? put_corners(out, mesh_.boundary[members[k]].vertices)
                          : put_corners(out, mesh_.hexahedra[members[k]]);
      };
      write_text_lines(file_, members.size(), 9 * kIntegerBytes, put, monitor_);
    }
    file_.write("$EndElements\n");
  }

  template <class Corners>
  static char* put_corners(char* out, const Corners& corners) {
    for (std::size_t k = 0; k < corners.size(); ++k)
      out = put_integer(out, std::int64_t{corners[k]} + 1, k + 1 < corners.size() ? ' ' : '\n');
    return out;
  }

  OutputFile& file_;
  const HexMesh& mesh_;
  const std::string_view content_;
  const Monitor& monitor_;
  std::vector<Entity> entities_;  ///< surfaces first, then volumes
};

}  // namespace

void write_gmsh_hexahedra(OutputFile& file, const HexOutput& output, const Monitor& monitor) {
  GmshMeshWriter(file, output, monitor).write();
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "results/axes_behind_faces.hpp"

#include <algorithm>
#include <cstddef>

#include "singularity/cube_group.hpp"

namespace crossgrain {
namespace {

/// Where the axes behind a face of a tet begin.
std::size_t place_of(const std::array<std::uint32_t, 4>& tet, const std::array<std::uint32_t, 3>& face) {
  std::size_t corner = 0;
  while (std::find(face.begin(), face.end(), tet[corner]) != face.end()) ++corner;
  return 3 * corner;
}

/// The rotation of the cube that takes axis k to |axes[k]|, with its sign; none if there is none.
std::optional<CubeRotation> rotation_with(const std::array<std::int8_t, 3>& axes) {
  const CubeGroup& group = CubeGroup::instance();
  for (std::uint8_t a = 0; a < CubeGroup::kCount; ++a)
    if (signed_axes(group[a]) == axes) return group[a];
  return std::nullopt;
}

}  // namespace

std::vector<AxesBehindFaces> axes_behind_faces(const TetSolid& solid,
                                               const std::vector<CubeRotation>& matchings) {
  std::vector<AxesBehindFaces> all(solid.mesh.tets.size(), AxesBehindFaces{});
  const auto put = [&](std::uint32_t tet, const std::array<std::uint32_t, 3>& face,
                       const CubeRotation& matching) {
    const auto axes = signed_axes(matching);
    std::copy(axes.begin(), axes.end(), all[tet].begin() + place_of(solid.mesh.tets[tet], face));
  };
  for (std::size_t f = 0; f < solid.inner_faces.size(); ++f) {
    const auto& [vertices, tets] = solid.inner_faces[f];
    if (tets[1] == kNoTet) continue;
    put(tets[0], vertices, matchings[f]);
    put(tets[1], vertices, inverse(matchings[f]));
  }
  return all;
}

std::optional<std::vector<CubeRotation>> matchings_in(const TetSolid& solid,
                                                      const std::vector<AxesBehindFaces>& axes) {
  std::vector<CubeRotation> matchings;
  matchings.reserve(solid.inner_faces.size());
  for (const auto& [vertices, tets] : solid.inner_faces) {
    if (tets[1] == kNoTet) return std::nullopt;
    const std::size_t place = place_of(solid.mesh.tets[tets[0]], vertices);
    const AxesBehindFaces& all = axes[tets[0]];
    const auto rotation = rotation_with({all[place], all[place + 1], all[place + 2]});
    if (!rotation) return std::nullopt;
    matchings.push_back(*rotation);
  }
  // The other side of each face, and the surface.
  if (axes_behind_faces(solid, matchings) != axes) return std::nullopt;
  return matchings;
}

}  // namespace crossgrain

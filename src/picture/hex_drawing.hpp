// SPDX-License-Identifier: Apache-2.0
// Hexahedra of a mesh as a drawing and in words.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "crossgrain/hex_mesh.hpp"
#include "crossgrain/hex_report.hpp"
#include "crossgrain/picture.hpp"
#include "display/hex_skin.hpp"
#include "field/solved_surface.hpp"
#include "picture/camera.hpp"
#include "picture/cut_drawing.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// The hexahedra of a mesh that a picture shows. Refers to the mesh.
class ShownHexahedra {
 public:
  /// Those of which the options ask for. Throws Error(kUsage) if a cut or a limit of shapes leaves none, for
  /// colours by region if there is only one, or as `picture_cut`; Error(kInput) for colours by face if the
  /// mesh has no tags.
  ShownHexahedra(const HexMesh& mesh, const PictureOptions& options, const Vector3& towards);

  /// What fills the picture: the outside of what the cut leaves, whether its shapes are shown or not.
  const SolvedSurface& kept_surface() const { return kept_surface_; }

  /// The outside of what is shown with the edges of its faces. What a limit of shapes leaves out is there as
  /// a pale outside.
  /// With colours by face, `text_size` is that of their numbers.
  Drawing drawing(const Camera& camera, double text_size) const;

  /// `report` may be null.
  std::vector<LegendBlock> legend(const HexReport* report) const;

 private:
  void take_below(double limit, std::vector<std::uint8_t>& is_shown);
  void choose_colours();

  const HexMesh& mesh_;
  const PictureOptions& options_;
  std::vector<double> shapes_;  ///< scaled Jacobians
  std::vector<std::uint8_t> is_inverted_;
  std::size_t shown_ = 0;              ///< number of hexahedra
  HexSkin skin_;                       ///< of these
  std::vector<std::int32_t> tags_;     ///< for colours by face, of the faces of skin_
  std::vector<std::int32_t> regions_;  ///< for colours by region, ascending
  SolvedSurface surface_;              ///< four triangles for each face of skin_
  SolvedSurface kept_surface_;
  std::vector<std::array<std::uint32_t, 2>> kept_edges_;  ///< sharp ones of it, for a limit of shapes
};

}  // namespace crossgrain

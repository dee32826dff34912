// SPDX-License-Identifier: Apache-2.0
// Colours and numbers of the faces of a model in a picture.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "picture/camera.hpp"
#include "picture/drawing.hpp"
#include "picture/legend.hpp"

namespace crossgrain {

/// A light tone; faces with numbers next to each other have different ones. That of a plain part for 0.
Colour colour_of_face(std::int32_t number);

/// Returns the number of each face that is seen, at the place of it that is farthest from its visible border;
/// none for faces too small for letters of `text_size` pixels. `faces` has the number of each triangle, 0 for
/// none. Behind `section`, if not null, only what it leaves is seen.
std::vector<Label> face_labels(const std::vector<Vector3>& vertices,
                               const std::vector<std::array<std::uint32_t, 3>>& triangles,
                               const std::vector<std::int32_t>& faces, const Camera& camera,
                               const std::array<int, 2>& size, double text_size, const Section* section);

/// Says how many faces there are, and which have no number in the picture.
LegendBlock face_legend(const std::vector<std::int32_t>& faces);

}  // namespace crossgrain

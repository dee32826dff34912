// SPDX-License-Identifier: Apache-2.0
// The class of a cell by what its constraints determine of the frame.
#pragma once

#include "constraint/quadratic_form.hpp"

namespace crossgrain {

enum class ConstraintClass {
  kFree,              ///< no direction: no surface, or all directions alike, as of a small sphere
  kPlane,             ///< one axis is known and fits
  kAxis,              ///< one axis is known, but only as a compromise: a thin rod, the end of a cone
  kFrame,             ///< the whole frame is known and fits: an edge or a corner with right angles
  kFrameCompromised,  ///< the whole frame is known, but only as a compromise: an edge of 60 degrees
  kConflicted         ///< none of the above
};

/// Limits of the classes, as eigenvalues of the degree-3 form over its weight, which lie in [0, 1]. Chosen by
/// bench/classification_sweep over planes, strips of cylinders and caps of spheres, creases, edges, corners,
/// rods, prisms, pyramids and spheres in random rotations: none of 6000 cells is in the wrong class for
/// same_eigenvalue 0.05 to 0.12 and fits 0.15 to 0.20.
struct ClassificationTolerances {
  /// Largest excess over the smallest eigenvalue within its eigenspace. The next eigenvalues of a cylinder
  /// exceed it by 0.19, so the limit is lower; a second, orthogonal plane raises one of the plane's two by
  /// its share of the area, so up to this share it is a speck that does not make a plane a frame.
  double same_eigenvalue = 0.1;
  /// Largest smallest eigenvalue that counts as zero. It is 4 times the mean squared angle in radians between
  /// surface and frame that no frame can avoid: strips of cylinders whose normals spread by 20 degrees to
  /// both sides have 0.14, edges of 72 degrees 0.10, a rod with a cap of twice its side's area 0.17.
  double fits = 0.15;
};

/// The class of a cell from the spectrum of its degree-3 form (docs/design.md section 3).
ConstraintClass classify(const QuadraticForm<3>& form, const ClassificationTolerances& tolerances = {});

/// Whether one frame can meet all constraints of a cell of this class, up to the variation of a smooth
/// surface's normal within a cell: true for planes and frames. In all other classes part of the surface is
/// off every axis of any frame, so its angle says nothing about the field; it is excluded from the alignment
/// and reported as such.
bool compatible(ConstraintClass constraint_class);

}  // namespace crossgrain

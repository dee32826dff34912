// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <TopoDS_Edge.hxx>
#include <vector>

#include "cad_reading/program/bodies.hpp"
#include "cad_reading/program/edge_nodes.hpp"
#include "cad_reading/program/face_surface.hpp"

namespace crossgrain {

/// Finds the edges where the exact surface of a body has a crease.
class SharpEdges {
 public:
  SharpEdges(const Bodies& bodies, const std::vector<FaceSurface>& surfaces, double crease_angle_deg);

  /// Checks all edges of a body. `inside_out`: its faces are oriented inwards.
  void add(const TopoDS_Shape& body, bool inside_out);

  /// Returns the edges found so far, in the order of `Bodies::edges`, as polylines through the vertices of
  /// their triangles, with the tangents of the exact curves.
  std::vector<CreaseCurve> creases(const EdgeNodes& nodes) const;

 private:
  /// A face along an edge; a seam has two sides in one face.
  struct Side {
    TopoDS_Edge edge;  ///< as oriented in `face`
    int face;          ///< in `Bodies::faces`
    double sign;       ///< of the surface's normal to point outwards
  };

  bool is_sharp(const std::vector<Side>& sides) const;

  const Bodies& bodies_;
  const std::vector<FaceSurface>& surfaces_;
  double smallest_cosine_;
  std::vector<bool> sharp_;  ///< of the edges, from 1
};

}  // namespace crossgrain

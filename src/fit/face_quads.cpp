// SPDX-License-Identifier: Apache-2.0
#include "fit/face_quads.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/nowhere.hpp"
#include "fit/quad_parts.hpp"
#include "surface/bvh.hpp"

namespace crossgrain {
namespace {

Vector3 centre_of_quad(const HexMesh& mesh, const QuadComplex::Quad& quad) {
  Vector3 sum{};
  for (const std::uint32_t vertex : quad.vertices) sum += mesh.vertices[vertex];
  return 0.25 * sum;
}

/// Triangles of some faces, in which faces are found by their nearest points.
class NearestFace {
 public:
  NearestFace(const FeatureComplex& features, const std::vector<std::uint32_t>& faces)
      : surface_(prepare_surface(CheckedMesh::derived(triangles_of(features, faces)))), tree_(surface_) {}

  std::uint32_t at(const Vector3& p) const {
    return static_cast<std::uint32_t>(surface_.mesh.faces[tree_.nearest(p).triangle]);
  }

 private:
  static TriangleMesh triangles_of(const FeatureComplex& features, const std::vector<std::uint32_t>& faces) {
    TriangleMesh mesh;
    for (const std::uint32_t face : faces) {
      for (const std::uint32_t t : features.faces[face].triangles) {
        const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
        for (const Vector3& point : features.points_of(t)) mesh.vertices.push_back(point);
        mesh.triangles.push_back({first, first + 1, first + 2});
        mesh.faces.push_back(static_cast<std::int32_t>(face));
      }
    }
    return mesh;
  }

  Surface surface_;
  TriangleBvh tree_;
};

class FaceSearch {
 public:
  FaceSearch(const HexMesh& mesh, const QuadComplex& surface, const FeatureComplex& features,
             Embedding& embedding)
      : mesh_(mesh),
        surface_(surface),
        features_(features),
        embedding_(embedding),
        parts_(parts_between(surface, embedding.path_of_curve)) {
    std::vector<bool> is_without(features.curves.size());
    for (std::size_t c = 0; c < is_without.size(); ++c) is_without[c] = embedding.path_of_curve[c].empty();
    groups_ = without_curves(features, is_without);
    faces_of_.resize(groups_.complex.faces.size());
    for (std::uint32_t f = 0; f < features.faces.size(); ++f) faces_of_[groups_.face_of[f]].push_back(f);
  }

  void run() {
    name_groups();
    find_expected_loops();
    parts_of_.resize(faces_of_.size());
    for (std::uint32_t p = 0; p < parts_.size(); ++p) {
      const std::uint32_t group = group_of(parts_[p]);
      if (group == kNowhere)
        embedding_.faults.push_back({Embedding::FaultKind::kFace, kNowhere, place_of(parts_[p])});
      else
        parts_of_[group].push_back(p);
    }
    for (std::uint32_t group = 0; group < faces_of_.size(); ++group)
      if (!is_right(group)) add_fault(group);
    find_torn_edges();
    name_quads();
  }

 private:
  Vector3 place_of(const QuadPart& part) const {
    return centre_of_quad(mesh_, surface_.quads()[part.quads[part.quads.size() / 2]]);
  }

  void name_groups() {
    embedding_.group_of_face.resize(features_.faces.size());
    for (std::uint32_t f = 0; f < features_.faces.size(); ++f)
      embedding_.group_of_face[f] = faces_of_[groups_.face_of[f]].front();
  }

  /// Loops of groups, by the curves that have a path.
  void find_expected_loops() {
    expected_ = loops_of_faces(groups_.complex);
    for (auto& loops : expected_) {
      for (FeatureLoop& loop : loops) {
        FeatureLoop steps;
        for (const LoopStep& step : loop) {
          std::vector<LoopStep> parts = groups_.parts_of_curve[step.curve];
          if (!step.is_forward) {
            std::ranges::reverse(parts);
            for (LoopStep& part : parts) part.is_forward = !part.is_forward;
          }
          steps.insert(steps.end(), parts.begin(), parts.end());
        }
        loop = from_least_step(std::move(steps));
      }
      std::ranges::sort(loops);
    }
  }

  bool lies_between(const QuadPart& part, const FeatureComplex::Face& face) const {
    const QuadComplex::Quad& quad = surface_.quads()[part.quads.front()];
    return quad.below == face.below && quad.above == face.above;
  }

  /// The group that most steps of the border have on their left.
  std::uint32_t group_of(const QuadPart& part) const {
    std::map<std::uint32_t, std::size_t> votes;
    for (const FeatureLoop& loop : part.loops)
      for (const LoopStep& step : loop)
        for (const FeatureComplex::Side& side : features_.curves[step.curve].sides)
          if (side.is_left == step.is_forward && lies_between(part, features_.faces[side.face]))
            ++votes[groups_.face_of[side.face]];
    std::uint32_t best = kNowhere;
    std::size_t most = 0;
    for (const auto& [group, count] : votes)
      if (count > most) most = count, best = group;
    return part.loops.empty() ? nearest_closed_group(part) : best;
  }

  std::uint32_t nearest_closed_group(const QuadPart& part) const {
    const Vector3 place = place_of(part);
    double least = INFINITY;
    std::uint32_t nearest = kNowhere;
    for (std::uint32_t group = 0; group < faces_of_.size(); ++group) {
      const FeatureComplex::Face& face = groups_.complex.faces[group];
      if (!expected_[group].empty() || !lies_between(part, face)) continue;
      for (const std::uint32_t t : face.triangles) {
        const double distance = norm(nearest_on_triangle(groups_.complex.points_of(t), place) - place);
        if (distance < least) least = distance, nearest = group;
      }
    }
    return nearest;
  }

  bool is_right(std::uint32_t group) const {
    if (parts_of_[group].size() != 1) return false;
    const QuadPart& part = parts_[parts_of_[group].front()];
    return !part.is_torn && part.euler == groups_.complex.faces[group].euler &&
           part.loops == expected_[group];
  }

  void add_fault(std::uint32_t group) {
    const auto& triangles = groups_.complex.faces[group].triangles;
    const auto corners = features_.points_of(triangles[triangles.size() / 2]);
    embedding_.faults.push_back({Embedding::FaultKind::kFace, faces_of_[group].front(),
                                 (1.0 / 3) * (corners[0] + corners[1] + corners[2])});
  }

  /// Adds a fault for edges of no path at which not just two quads meet, one for each number of quads.
  void find_torn_edges() {
    std::map<std::size_t, std::uint32_t> torn;
    std::vector<bool> is_on_path(surface_.edges().size(), false);
    for (const auto& path : embedding_.path_of_curve)
      for (std::size_t k = 1; k < path.size(); ++k)
        is_on_path[surface_.edge_between(path[k - 1], path[k])] = true;
    for (std::uint32_t e = 0; e < surface_.edges().size(); ++e)
      if (surface_.uses_of_edge(e).size() != 2 && !is_on_path[e])
        torn.try_emplace(surface_.uses_of_edge(e).size(), e);
    for (const auto& [uses, edge] : torn) {
      const auto& [a, b] = surface_.edges()[edge];
      embedding_.faults.push_back(
          {Embedding::FaultKind::kEdge, kNowhere, 0.5 * (mesh_.vertices[a] + mesh_.vertices[b])});
    }
  }

  void name_quads() {
    embedding_.face_of_quad.assign(surface_.quads().size(), kNowhere);
    for (std::uint32_t group = 0; group < faces_of_.size(); ++group) {
      std::vector<std::uint32_t> quads;
      for (const std::uint32_t part : parts_of_[group])
        quads.insert(quads.end(), parts_[part].quads.begin(), parts_[part].quads.end());
      if (quads.empty()) continue;
      if (faces_of_[group].size() == 1) {
        for (const std::uint32_t quad : quads) embedding_.face_of_quad[quad] = faces_of_[group].front();
        continue;
      }
      const NearestFace nearest(features_, faces_of_[group]);
      parallel_for(quads.size(), [&](std::size_t k) {
        embedding_.face_of_quad[quads[k]] = nearest.at(centre_of_quad(mesh_, surface_.quads()[quads[k]]));
      });
    }
  }

  const HexMesh& mesh_;
  const QuadComplex& surface_;
  const FeatureComplex& features_;
  Embedding& embedding_;
  const std::vector<QuadPart> parts_;
  CoarserFeatures groups_;
  std::vector<std::vector<std::uint32_t>> faces_of_, parts_of_;  // of each group
  std::vector<std::vector<FeatureLoop>> expected_;
};

}  // namespace

void find_face_quads(const HexMesh& mesh, const QuadComplex& surface, const FeatureComplex& features,
                     Embedding& embedding) {
  FaceSearch(mesh, surface, features, embedding).run();
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "fit/soft_paths.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "fit/curve_routing.hpp"
#include "fit/face_quads.hpp"
#include "fit/least_assignment.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

/// Farthest vertex for an end of a soft curve, in sizes: the next one of an even mesh is nearer.
constexpr double kSoftReach = 0.6;

/// Most that a soft curve's path may cost, as a multiple of its length: a fifth of a size beside the curve,
/// or 60 degrees aslant.
constexpr double kMostSoftCost = 1.5;

class SoftPaths {
 public:
  SoftPaths(const HexMesh& mesh, const QuadComplex& surface, const FeatureComplex& features,
            const SharpPaths& embedded, double size)
      : mesh_(mesh),
        surface_(surface),
        features_(features),
        embedded_(embedded),
        size_(size),
        sets_(surface, mesh.vertices.size(), features),
        is_left_out_(features.curves.size(), false),
        paths_(features.curves.size()),
        vertices_(features.corners.size(), kNowhere) {
    for (std::uint32_t c = 0; c < features.curves.size(); ++c)
      is_left_out_[c] = features.curves[c].is_soft && is_dispensable(features, c);
    const bool has_soft = std::ranges::find(is_left_out_, true) != is_left_out_.end();
    place_sharp_corners();
    cut_sharp_paths();
    if (has_soft) {
      place_soft_corners();
      route();
      leave_out_loose();
    }
  }

  /// Leaves soft curves out that border these faces of the result; whether there were any.
  bool leave_out_beside(const CoarserFeatures& result, const std::vector<Embedding::Fault>& faults) {
    bool are_any = false;
    for (const Embedding::Fault& fault : faults) {
      if (fault.kind != Embedding::FaultKind::kFace) continue;
      for (std::uint32_t c = 0; c < features_.curves.size(); ++c) {
        if (is_left_out_[c] || !features_.curves[c].is_soft || !is_dispensable(features_, c)) continue;
        for (const FeatureComplex::Side& side : features_.curves[c].sides) {
          if (fault.index != kNowhere && result.face_of[side.face] != fault.index) continue;
          is_left_out_[c] = are_any = true;
        }
      }
    }
    leave_out_loose();
    return are_any;
  }

  CoarserFeatures result() const { return without_curves(features_, is_left_out_); }

  Embedding embedding_of(const CoarserFeatures& result) const {
    Embedding embedding;
    for (const std::uint32_t corner : result.corner_of)
      embedding.vertex_of_corner.push_back(vertices_[corner]);
    for (const auto& parts : result.parts_of_curve) embedding.path_of_curve.push_back(path_along(parts));
    return embedding;
  }

 private:
  void place_sharp_corners() {
    for (std::size_t c = 0; c < embedded_.vertex_of_corner.size(); ++c)
      vertices_[embedded_.sharp.corner_of[c]] = embedded_.vertex_of_corner[c];
  }

  std::uint32_t corner_before(const LoopStep& part) const {
    return features_.curves[part.curve].corners[part.is_forward ? 0 : 1];
  }

  /// Puts corners inside sharp paths to vertices of these: the nearest ones, if these follow each other in
  /// the same order.
  void cut_sharp_paths() {
    chain_of_.assign(features_.curves.size(), kNowhere);
    place_in_chain_.assign(features_.curves.size(), 0);
    for (std::uint32_t chain = 0; chain < embedded_.path_of_curve.size(); ++chain) {
      const auto& parts = embedded_.sharp.parts_of_curve[chain];
      for (std::size_t k = 0; k < parts.size(); ++k) {
        chain_of_[parts[k].curve] = chain;
        place_in_chain_[parts[k].curve] = k;
      }
      cuts_.push_back(cuts_of(chain));
    }
  }

  /// Places in a path of the corners before each part of a chain; kNowhere without.
  std::vector<std::size_t> cuts_of(std::uint32_t chain) {
    const auto& parts = embedded_.sharp.parts_of_curve[chain];
    const auto& path = embedded_.path_of_curve[chain];
    std::vector<std::size_t> cuts(parts.size() + 1, kNowhere);
    if (path.empty()) return cuts;
    const bool is_round = embedded_.sharp.complex.curves[chain].corners[0] == FeatureComplex::kNone;
    const std::size_t last = path.size() - 1;
    if (!is_round) {
      cuts.front() = 0;
      cuts.back() = last;
    }
    struct Wish {
      double distance;
      std::size_t part, place;
    };
    std::vector<Wish> wishes;
    for (std::size_t k = is_round ? 0 : 1; k < parts.size(); ++k) {
      const std::uint32_t corner = corner_before(parts[k]);
      if (corner == FeatureComplex::kNone) continue;
      Wish wish{kSoftReach * size_, k, kNowhere};
      for (std::size_t p = is_round ? 0 : 1; p < last; ++p)
        if (const double distance = norm(mesh_.vertices[path[p]] - features_.corners[corner].point);
            distance < wish.distance)
          wish = {distance, k, p};
      if (wish.place != kNowhere) wishes.push_back(wish);
    }
    std::ranges::stable_sort(wishes, {}, &Wish::distance);
    for (const Wish& wish : wishes) {
      cuts[wish.part] = wish.place;
      if (!is_in_order(cuts, is_round)) cuts[wish.part] = kNowhere;
    }
    if (is_round) cuts.back() = cuts.front();
    for (std::size_t k = is_round ? 0 : 1; k < parts.size(); ++k)
      if (cuts[k] != kNowhere) vertices_[corner_before(parts[k])] = path[cuts[k]];
    return cuts;
  }

  /// Whether places ascend; around a closed path from any of them on.
  static bool is_in_order(const std::vector<std::size_t>& cuts, bool is_round) {
    std::vector<std::size_t> places;
    for (const std::size_t cut : cuts)
      if (cut != kNowhere) places.push_back(cut);
    std::size_t falls = 0;
    for (std::size_t k = 1; k < places.size(); ++k) falls += places[k] <= places[k - 1];
    if (!is_round) return falls == 0;
    if (places.size() > 1) falls += places.front() <= places.back();
    return falls <= 1 && std::ranges::adjacent_find(places) == places.end();
  }

  bool has_sharp_end(const FeatureComplex::Corner& corner) const {
    return std::ranges::any_of(corner.ends, [&](const auto& end) { return !is_left_out_[end.curve]; });
  }

  void place_soft_corners() {
    std::vector<bool> is_taken(mesh_.vertices.size(), false);
    for (const auto& path : embedded_.path_of_curve)
      for (const std::uint32_t vertex : path) is_taken[vertex] = true;
    for (const std::uint32_t vertex : vertices_)
      if (vertex != kNowhere) is_taken[vertex] = true;
    std::vector<AssignmentChoice> choices;
    for (std::uint32_t c = 0; c < features_.corners.size(); ++c) {
      check_watched();
      const FeatureComplex::Corner& corner = features_.corners[c];
      if (vertices_[c] != kNowhere || corner.ends.empty() || has_sharp_end(corner)) continue;
      for (const std::uint32_t v : surface_.vertices()) {
        if (is_taken[v] || sets_.of_vertex[v] != sets_.of_corner[c]) continue;
        const double distance = norm(mesh_.vertices[v] - corner.point) / size_;
        if (distance <= kSoftReach) choices.push_back({c, v, distance});
      }
    }
    const auto columns = least_assignment(features_.corners.size(), choices, 2 * kSoftReach);
    for (std::size_t c = 0; c < columns.size(); ++c)
      if (columns[c] != kNowhere) vertices_[c] = columns[c];
  }

  void route() {
    CurveRouting routing(mesh_, surface_, features_, sets_, size_);
    for (const auto& path : embedded_.path_of_curve)
      for (const std::uint32_t vertex : path) routing.block(vertex);
    for (const std::uint32_t vertex : vertices_)
      if (vertex != kNowhere) routing.block(vertex);
    std::vector<CurveNet> nets;
    for (std::uint32_t c = 0; c < features_.curves.size(); ++c) {
      if (!is_left_out_[c]) continue;
      CurveNet net{c, {kNowhere, kNowhere}, {kNowhere, kNowhere}};
      bool has_ends = true;
      for (std::size_t end = 0; end < 2; ++end) {
        const std::uint32_t corner = features_.curves[c].corners[end];
        if (corner == FeatureComplex::kNone) continue;
        net.ends[end] = vertices_[corner];
        has_ends = has_ends && net.ends[end] != kNowhere;
      }
      if (has_ends) nets.push_back(net);
    }
    const auto paths = routing.disjoint_paths(nets);
    for (std::size_t k = 0; k < nets.size(); ++k) {
      const std::uint32_t c = nets[k].curve;
      if (paths[k].empty() || !is_near(c, paths[k]) || !is_straight(paths[k])) continue;
      paths_[c] = paths[k];
      is_left_out_[c] = false;
    }
  }

  bool is_near(std::uint32_t curve, const std::vector<std::uint32_t>& path) const {
    const CurveLine line(features_, curve);
    double cost = 0;
    CurveLine::Nearest before = line.nearest(mesh_.vertices[path[0]], 0, line.length());
    for (std::size_t k = 1; k < path.size(); ++k) {
      const CurveLine::Nearest here = line.nearest(mesh_.vertices[path[k]], 0, line.length());
      const Vector3 along = mesh_.vertices[path[k]] - mesh_.vertices[path[k - 1]];
      const double length = norm(along), distance = (before.distance + here.distance) / (2 * size_);
      const double turn = 1 - (dot(along, before.tangent) + dot(along, here.tangent)) / (2 * length);
      cost += length * (1 + 8 * distance * distance + turn);
      before = here;
    }
    return cost <= kMostSoftCost * line.length();
  }

  bool is_straight(const std::vector<std::uint32_t>& path) const {
    const bool is_round = path.front() == path.back();
    for (std::size_t k = is_round ? 0 : 1; k + 1 < path.size(); ++k) {
      const std::uint32_t before = path[k == 0 ? path.size() - 2 : k - 1];
      const std::uint32_t edges[2] = {surface_.edge_between(path[k], before),
                                      surface_.edge_between(path[k], path[k + 1])};
      for (const std::uint32_t quad : surface_.quads_of(path[k])) {
        const auto [from, to] = surface_.edges_at(quad, path[k]);
        if ((from == edges[0] && to == edges[1]) || (from == edges[1] && to == edges[0])) return false;
      }
    }
    return true;
  }

  /// Leaves soft curves out that end alone where more curves meet.
  void leave_out_loose() {
    for (bool is_done = false; !is_done;) {
      is_done = true;
      for (const FeatureComplex::Corner& corner : features_.corners) {
        std::vector<std::uint32_t> kept;
        for (const auto& end : corner.ends)
          if (!is_left_out_[end.curve]) kept.push_back(end.curve);
        if (kept.size() != 1 || corner.ends.size() == 1 || !features_.curves[kept[0]].is_soft ||
            !is_dispensable(features_, kept[0]))
          continue;
        is_left_out_[kept[0]] = true;
        is_done = false;
      }
    }
  }

  /// The path of a curve of the result: of soft ones theirs one after the other, or a piece of a sharp one's.
  std::vector<std::uint32_t> path_along(const std::vector<LoopStep>& parts) const {
    if (chain_of_[parts.front().curve] != kNowhere) return piece_of_chain(parts);
    std::vector<std::uint32_t> whole;
    for (const LoopStep& part : parts) {
      std::vector<std::uint32_t> path = paths_[part.curve];
      if (path.empty()) return {};
      if (!part.is_forward) std::ranges::reverse(path);
      whole.insert(whole.end(), path.begin() + (whole.empty() ? 0 : 1), path.end());
    }
    return whole;
  }

  std::vector<std::uint32_t> piece_of_chain(const std::vector<LoopStep>& parts) const {
    const std::uint32_t chain = chain_of_[parts.front().curve];
    const auto& path = embedded_.path_of_curve[chain];
    const auto& whole = embedded_.sharp.parts_of_curve[chain];
    if (path.empty()) return {};
    const bool is_along = whole[place_in_chain_[parts.front().curve]].is_forward == parts.front().is_forward;
    const LoopStep &first = is_along ? parts.front() : parts.back(),
                   &last = is_along ? parts.back() : parts.front();
    const std::size_t from = cuts_[chain][place_in_chain_[first.curve]];
    const std::size_t to = cuts_[chain][place_in_chain_[last.curve] + 1];
    std::vector<std::uint32_t> piece;
    if (from == kNowhere || to == kNowhere) {
      // Only a closed path is not cut at its ends.
      if (parts.size() == whole.size()) piece = path;
    } else if (from < to) {
      piece.assign(path.begin() + static_cast<std::ptrdiff_t>(from),
                   path.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    } else {
      piece.assign(path.begin() + static_cast<std::ptrdiff_t>(from), path.end());
      piece.insert(piece.end(), path.begin() + 1, path.begin() + static_cast<std::ptrdiff_t>(to) + 1);
    }
    if (!is_along) std::ranges::reverse(piece);
    return piece;
  }

  const HexMesh& mesh_;
  const QuadComplex& surface_;
  const FeatureComplex& features_;
  const SharpPaths& embedded_;
  const double size_;
  const SolidSets sets_;
  std::vector<bool> is_left_out_;
  std::vector<std::vector<std::uint32_t>> paths_;  // of soft curves
  std::vector<std::uint32_t> vertices_;            // of corners
  std::vector<std::uint32_t> chain_of_;            // of sharp curves
  std::vector<std::size_t> place_in_chain_;
  std::vector<std::vector<std::size_t>> cuts_;  // of each chain
};

}  // namespace

Embedding with_soft_paths(const HexMesh& mesh, const QuadComplex& surface, FeatureComplex& features,
                          const SharpPaths& embedded, double size) {
  SoftPaths soft(mesh, surface, features, embedded, size);
  for (;;) {
    check_watched();
    CoarserFeatures result = soft.result();
    Embedding embedding = soft.embedding_of(result);
    find_face_quads(mesh, surface, result.complex, embedding);
    if (soft.leave_out_beside(result, embedding.faults)) continue;
    features = std::move(result.complex);
    return embedding;
  }
}

}  // namespace crossgrain

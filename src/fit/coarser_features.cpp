// SPDX-License-Identifier: Apache-2.0
#include "fit/coarser_features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/vector3.hpp"
#include "fit/nowhere.hpp"

namespace crossgrain {
namespace {

class Coarsening {
  using Corner = FeatureComplex::Corner;
  using Curve = FeatureComplex::Curve;
  using End = FeatureComplex::End;
  using Face = FeatureComplex::Face;
  using Sector = FeatureComplex::Sector;

 public:
  Coarsening(const FeatureComplex& fine, const std::vector<bool>& is_left_out)
      : fine_(fine),
        is_kept_(fine.curves.size()),
        is_used_(fine.curves.size(), false),
        groups_(fine.faces.size()) {
    for (std::uint32_t c = 0; c < fine.curves.size(); ++c)
      is_kept_[c] = !is_left_out[c] || !is_dispensable(fine, c);
  }

  CoarserFeatures result() && {
    coarse_.complex.vertices = fine_.vertices;
    coarse_.complex.triangles = fine_.triangles;
    coarse_.complex.source_of = fine_.source_of;
    coarse_.complex.corner_normals = fine_.corner_normals;
    join_faces();
    keep_corners();
    join_curves();
    for (std::uint32_t c = 0; c < coarse_.corner_of.size(); ++c) add_sectors(c);
    count_loops();
    return std::move(coarse_);
  }

 private:
  bool is_kept(const End& end) const { return is_kept_[end.curve]; }

  void join_faces() {
    for (std::uint32_t c = 0; c < fine_.curves.size(); ++c)
      if (!is_kept_[c]) groups_.join(fine_.curves[c].sides[0].face, fine_.curves[c].sides[1].face);
    coarse_.face_of.assign(fine_.faces.size(), kNowhere);
    std::vector<double> largest;
    for (std::uint32_t f = 0; f < fine_.faces.size(); ++f) {
      const Face& face = fine_.faces[f];
      const std::uint32_t root = groups_.root(f);
      auto& faces = coarse_.complex.faces;
      if (root == f) {
        coarse_.face_of[f] = static_cast<std::uint32_t>(faces.size());
        faces.push_back(face);
        largest.push_back(face.area);
        continue;
      }
      const std::uint32_t coarse = coarse_.face_of[f] = coarse_.face_of[root];
      Face& whole = faces[coarse];
      if (face.area > largest[coarse]) largest[coarse] = face.area, whole.number = face.number;
      whole.area += face.area;
      whole.euler += face.euler;
      whole.triangles.insert(whole.triangles.end(), face.triangles.begin(), face.triangles.end());
    }
    for (Face& face : coarse_.complex.faces) std::ranges::sort(face.triangles);
    for (const std::uint32_t face : fine_.face_of) coarse_.complex.face_of.push_back(coarse_.face_of[face]);
    // Euler numbers of faces without their borders add up: an open curve between them is -1, a closed one 0,
    // a corner 1.
    for (std::uint32_t c = 0; c < fine_.curves.size(); ++c) {
      const Curve& curve = fine_.curves[c];
      if (!is_kept_[c] && curve.corners[0] != kNowhere)
        --coarse_.complex.faces[coarse_.face_of[curve.sides[0].face]].euler;
    }
    for (const Corner& corner : fine_.corners) count_inner_fans(corner);
  }

  /// Adds a corner to the Euler number of a face for each fan of sectors at it that has lost all its ends.
  void count_inner_fans(const Corner& corner) {
    std::vector<bool> is_seen(corner.sectors.size(), false);
    for (std::size_t first = 0; first < corner.sectors.size(); ++first) {
      if (is_seen[first] || corner.sectors[first].from == kNowhere) continue;
      bool is_inner = true;
      for (std::size_t s = first; s != kNowhere && !is_seen[s]; s = next_sector(corner, s)) {
        is_seen[s] = true;
        is_inner &=
            !is_kept(corner.ends[corner.sectors[s].from]) && !is_kept(corner.ends[corner.sectors[s].to]);
      }
      if (is_inner) ++coarse_.complex.faces[coarse_.face_of[corner.sectors[first].face]].euler;
    }
  }

  /// The sector that begins where one ends, between the same solids; kNowhere if there is not just one.
  static std::size_t next_sector(const Corner& corner, std::size_t sector) {
    const Sector& own = corner.sectors[sector];
    std::size_t next = kNowhere, found = 0;
    for (std::size_t s = 0; s < corner.sectors.size(); ++s) {
      const Sector& other = corner.sectors[s];
      if (other.from != own.to || other.below != own.below || other.above != own.above) continue;
      ++found;
      next = s;
    }
    return found == 1 ? next : kNowhere;
  }

  Vector3 direction(const End& end) const {
    const auto& vertices = fine_.curves[end.curve].vertices;
    const std::size_t last = vertices.size() - 1;
    const Vector3& from = fine_.vertices[end.is_last ? vertices[last] : vertices[0]];
    return normalised(fine_.vertices[end.is_last ? vertices[last - 1] : vertices[1]] - from);
  }

  std::vector<std::int32_t> solids_beside(std::uint32_t curve) const {
    std::vector<std::int32_t> solids;
    for (const auto& side : fine_.curves[curve].sides)
      solids.insert(solids.end(), {fine_.faces[side.face].below, fine_.faces[side.face].above});
    std::ranges::sort(solids);
    return solids;
  }

  bool continue_each_other(const End& a, const End& b) const {
    static const double kLeast = std::cos(kCornerDeg * std::numbers::pi / 180);
    return -dot(direction(a), direction(b)) >= kLeast &&
           fine_.curves[a.curve].is_soft == fine_.curves[b.curve].is_soft &&
           solids_beside(a.curve) == solids_beside(b.curve);
  }

  void keep_corners() {
    coarse_corner_.assign(fine_.corners.size(), kNowhere);
    for (std::uint32_t c = 0; c < fine_.corners.size(); ++c) {
      const Corner& corner = fine_.corners[c];
      std::vector<End> kept;
      for (const End& end : corner.ends)
        if (is_kept(end)) kept.push_back(end);
      const bool is_whole = kept.size() == corner.ends.size();
      if (!is_whole && (kept.empty() || (kept.size() == 2 && continue_each_other(kept[0], kept[1]))))
        continue;
      coarse_corner_[c] = static_cast<std::uint32_t>(coarse_.corner_of.size());
      coarse_.corner_of.push_back(c);
      coarse_.complex.corners.push_back({corner.vertex, corner.point, {}, {}});
    }
  }

  void join_curves() {
    for (std::uint32_t c = 0; c < fine_.curves.size(); ++c) {
      if (!is_kept_[c] || is_used_[c]) continue;
      if (const LoopStep start = start_of_chain(c); start.curve != kNowhere) add_chain(start);
    }
    // Closed chains, through corners that have gone.
    for (std::uint32_t c = 0; c < fine_.curves.size(); ++c)
      if (is_kept_[c] && !is_used_[c]) add_chain({c, true});
  }

  std::uint32_t corner_at_end(const LoopStep& step) const {
    return fine_.curves[step.curve].corners[step.is_forward ? 1 : 0];
  }

  /// What continues a curve through a corner that has gone; its curve is kNowhere if the corner stays or
  /// there is none.
  LoopStep continued(const LoopStep& step) const {
    const std::uint32_t corner = corner_at_end(step);
    if (corner == kNowhere || coarse_corner_[corner] != kNowhere) return {kNowhere, false};
    for (const End& end : fine_.corners[corner].ends)
      if (is_kept(end) && end != End{step.curve, step.is_forward}) return {end.curve, !end.is_last};
    return {kNowhere, false};
  }

  /// The first step of the chain through a curve, forward along it; its curve is kNowhere if the chain is
  /// closed without a corner, or is a single closed curve.
  LoopStep start_of_chain(std::uint32_t curve) const {
    if (fine_.curves[curve].corners[0] == kNowhere) return {kNowhere, false};
    LoopStep back{curve, false};
    for (std::size_t steps = 0; steps <= fine_.curves.size(); ++steps) {
      const LoopStep before = continued(back);
      if (before.curve == kNowhere) return {back.curve, !back.is_forward};
      back = before;
    }
    return {kNowhere, false};
  }

  void add_chain(const LoopStep& start) {
    const auto coarse = static_cast<std::uint32_t>(coarse_.complex.curves.size());
    const Curve& model = fine_.curves[start.curve];
    Curve whole{{}, {kNowhere, kNowhere}, {}, model.is_soft, model.is_tagged, model.tag, 0};
    for (const auto& side : model.sides)
      whole.sides.push_back({coarse_.face_of[side.face], side.is_left == start.is_forward});
    std::vector<LoopStep> parts;
    for (LoopStep step = start; step.curve != kNowhere && !is_used_[step.curve]; step = continued(step)) {
      is_used_[step.curve] = true;
      parts.push_back(step);
      std::vector<std::uint32_t> vertices = fine_.curves[step.curve].vertices;
      if (!step.is_forward) std::ranges::reverse(vertices);
      whole.vertices.insert(whole.vertices.end(), vertices.begin() + (whole.vertices.empty() ? 0 : 1),
                            vertices.end());
      whole.length += fine_.curves[step.curve].length;
    }
    const auto coarse_at = [&](const LoopStep& outward) {
      const std::uint32_t corner = corner_at_end(outward);
      return corner == kNowhere ? kNowhere : coarse_corner_[corner];
    };
    whole.corners = {coarse_at({start.curve, !start.is_forward}), coarse_at(parts.back())};
    for (std::size_t end = 0; end < 2; ++end)
      if (whole.corners[end] != kNowhere)
        coarse_.complex.corners[whole.corners[end]].ends.push_back({coarse, end == 1});
    coarse_.complex.curves.push_back(std::move(whole));
    coarse_.parts_of_curve.push_back(std::move(parts));
  }

  /// The end of a coarse curve that an end of a fine one has become, in the list of a corner.
  std::uint32_t coarse_end(std::uint32_t corner, const End& end) const {
    const auto& ends = coarse_.complex.corners[corner].ends;
    for (std::uint32_t k = 0; k < ends.size(); ++k) {
      const auto& parts = coarse_.parts_of_curve[ends[k].curve];
      const LoopStep& part = ends[k].is_last ? parts.back() : parts.front();
      if (End{part.curve, ends[k].is_last == part.is_forward} == end) return k;
    }
    return kNowhere;
  }

  void add_sectors(std::uint32_t coarse) {
    const Corner& corner = fine_.corners[coarse_.corner_of[coarse]];
    std::vector<Sector>& sectors = coarse_.complex.corners[coarse].sectors;
    for (std::size_t first = 0; first < corner.sectors.size(); ++first) {
      Sector sector = corner.sectors[first];
      sector.face = coarse_.face_of[sector.face];
      if (sector.from != kNowhere) {
        if (!is_kept(corner.ends[sector.from])) continue;
        std::size_t s = first;
        for (std::size_t steps = 0; !is_kept(corner.ends[sector.to]) && steps <= corner.sectors.size();
             ++steps) {
          s = next_sector(corner, s);
          if (s == kNowhere) break;
          sector.to = corner.sectors[s].to;
          sector.angle_rad += corner.sectors[s].angle_rad;
        }
        sector.from = coarse_end(coarse, corner.ends[sector.from]);
        sector.to = coarse_end(coarse, corner.ends[sector.to]);
        if (sector.to == kNowhere) continue;
      }
      sectors.push_back(sector);
    }
    std::ranges::stable_sort(sectors, [](const Sector& a, const Sector& b) {
      return std::pair(a.from, a.face) < std::pair(b.from, b.face);
    });
  }

  void count_loops() {
    const auto loops = loops_of_faces(coarse_.complex);
    for (std::size_t f = 0; f < loops.size(); ++f) coarse_.complex.faces[f].loops = loops[f].size();
  }

  const FeatureComplex& fine_;
  std::vector<bool> is_kept_, is_used_;
  DisjointSets groups_;
  std::vector<std::uint32_t> coarse_corner_;
  CoarserFeatures coarse_;
};

}  // namespace

bool is_dispensable(const FeatureComplex& features, std::uint32_t curve) {
  const auto& sides = features.curves[curve].sides;
  if (sides.size() != 2 || sides[0].is_left == sides[1].is_left) return false;
  const FeatureComplex::Face &a = features.faces[sides[0].face], &b = features.faces[sides[1].face];
  return a.below == b.below && a.above == b.above;
}

CoarserFeatures without_curves(const FeatureComplex& features, const std::vector<bool>& is_left_out) {
  return Coarsening(features, is_left_out).result();
}

}  // namespace crossgrain

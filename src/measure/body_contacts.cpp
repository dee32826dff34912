// SPDX-License-Identifier: Apache-2.0
#include "measure/body_contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "base/elementary.hpp"
#include "base/parallel.hpp"
#include "base/vector3.hpp"
#include "crossgrain/finding.hpp"
#include "crossgrain/message.hpp"
#include "crossgrain/place.hpp"
#include "surface/bvh.hpp"
#include "surface/crease_angles.hpp"
#include "surface/edge_uses.hpp"
#include "surface/surface.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {
namespace {

/// Gap that rounding leaves, relative to the longest side of all tets.
constexpr double kRounding = 1e-6;

constexpr std::uint32_t kUnused = UINT32_MAX;

/// Gap between two triangulations of one curved surface, in sagittas of their triangles: of a circle's chord
/// the sagitta is exact, and triangles of a doubly curved surface are flatter in one direction than in
/// another.
constexpr double kSagittas = 1.5;

/// Of two normals that look at each other, or the same way.
constexpr double kLeastCosine = 0.9;

/// Where a triangle is looked at, as weights of its corners: inside, so that surfaces that share an edge or a
/// corner share none of these points.
constexpr std::array<std::array<double, 3>, 7> kSamples{{{1.0 / 3, 1.0 / 3, 1.0 / 3},
                                                         {0.90, 0.05, 0.05},
                                                         {0.05, 0.90, 0.05},
                                                         {0.05, 0.05, 0.90},
                                                         {0.05, 0.475, 0.475},
                                                         {0.475, 0.05, 0.475},
                                                         {0.475, 0.475, 0.05}}};

/// Returns for each triangle the largest distance of the middle of an edge from the curved surface that it
/// stands for: of an edge of length h between normals that differ by the angle a, h a / 8 (of a circle, to
/// second order). Sharp edges bound curved surfaces, so they do not count.
std::vector<double> sagittas_of(const Surface& surface) {
  constexpr double kSmooth_rad = CreaseAngles{}.least_deg * std::numbers::pi / 180;
  std::vector<double> sagittas(surface.size(), 0);
  const std::vector<EdgeUse> uses = sorted_edge_uses(surface.mesh.triangles);
  for_each_edge(uses, [&](std::span<const EdgeUse> edge) {
    if (edge.size() != 2) return;
    const auto& vertices = surface.mesh.vertices;
    const double length = norm(vertices[edge[0].low()] - vertices[edge[0].high()]);
    const double cosine = dot(surface.normals[edge[0].triangle], surface.normals[edge[1].triangle]);
    const double angle_rad = arc_cosine(std::clamp(cosine, -1.0, 1.0));
    if (angle_rad > kSmooth_rad) return;
    for (const EdgeUse& use : edge)
      sagittas[use.triangle] = std::max(sagittas[use.triangle], length * angle_rad / 8);
  });
  return sagittas;
}

/// A body with its surface. Must not be moved: the tree refers to the surface.
struct TetBody {
  Surface surface;
  TriangleBvh tree;
  WindingNumber winding;
  std::vector<double> sagittas;
  std::vector<std::int32_t> regions;  ///< of the triangles

  explicit TetBody(TriangleMesh mesh)
      : surface(prepare_surface(CheckedMesh::derived(std::move(mesh)))),
        tree(surface),
        winding(tree),
        sagittas(sagittas_of(surface)),
        regions(surface.mesh.faces) {}
  TetBody(const TetBody&) = delete;
  TetBody& operator=(const TetBody&) = delete;

  double area() const { return std::accumulate(surface.areas.begin(), surface.areas.end(), 0.0); }
  double largest_sagitta() const { return *std::max_element(sagittas.begin(), sagittas.end()); }
};

using Bodies = std::vector<std::unique_ptr<TetBody>>;

/// Faces of the boundary, of each component.
std::vector<std::vector<std::size_t>> boundaries_of(const TetSolid& solid) {
  std::vector<std::vector<std::size_t>> boundaries(solid.components);
  for (std::size_t f = 0; f < solid.boundary.size(); ++f) {
    const std::uint32_t tet = solid.boundary_tets[f];
    const std::uint32_t body =
        tet == kNoTet ? solid.vertex_components[solid.boundary[f][0]] : solid.tet_components[tet];
    if (body != kNoComponent) boundaries[body].push_back(f);
  }
  return boundaries;
}

/// The boundary of each component, as TriangleMesh::faces the regions of its tets; null without one.
Bodies bodies_of(const TetSolid& solid) {
  Bodies bodies;
  std::vector<std::uint32_t> new_index(solid.mesh.vertices.size(), kUnused);
  for (const std::vector<std::size_t>& faces : boundaries_of(solid)) {
    TriangleMesh mesh;
    for (const std::size_t f : faces) {
      for (const std::uint32_t v : solid.boundary[f]) {
        if (new_index[v] != kUnused) continue;
        new_index[v] = static_cast<std::uint32_t>(mesh.vertices.size());
        mesh.vertices.push_back(solid.mesh.vertices[v]);
      }
      const auto& [a, b, c] = solid.boundary[f];
      mesh.triangles.push_back({new_index[a], new_index[b], new_index[c]});
      const std::uint32_t tet = solid.boundary_tets[f];
      mesh.faces.push_back(tet == kNoTet || solid.mesh.regions.empty() ? 0 : solid.mesh.regions[tet]);
    }
    // Bodies may have vertices in common.
    for (const std::size_t f : faces)
      for (const std::uint32_t v : solid.boundary[f]) new_index[v] = kUnused;
    bodies.push_back(faces.empty() ? nullptr : std::make_unique<TetBody>(std::move(mesh)));
  }
  return bodies;
}

Box grown(Box box, double by) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.low[axis] -= by;
    box.high[axis] += by;
  }
  return box;
}

/// Returns how far apart two bodies may be and count as touching.
double reach_of(const TetBody& body, const TetBody& other, double rounding) {
  return rounding + kSagittas * (body.largest_sagitta() + other.largest_sagitta());
}

/// Largest gap between a point of a body, this far from the curved surface that its triangle stands for, and
/// a triangle of another one.
double gap_allowed(const TetBody& other, std::size_t triangle, double sagitta, double rounding) {
  return rounding + kSagittas * (sagitta + other.sagittas[triangle]);
}

/// Whether a triangle of a curved surface parts from another body, as a ball does from the plane that it lies
/// on: corners are on the curved surface itself.
bool parts(const TetBody& body, std::size_t triangle, const TetBody& other, double rounding) {
  if (body.sagittas[triangle] <= rounding) return false;
  for (const Vector3& corner : body.surface.corners(triangle)) {
    const NearestPoint nearest = other.tree.nearest(corner);
    const double away = dot(nearest.point - corner, body.surface.normals[triangle]);
    if (away > gap_allowed(other, nearest.triangle, 0, rounding)) return true;
  }
  return false;
}

/// How a triangle of one body lies to another body.
struct Relation {
  double touching = 0, inside = 0, alike = 0;  ///< shares of its samples
  std::int32_t other_region = 0;
};

/// Relations of the triangles of one body to another.
class Neighbourhood {
 public:
  Neighbourhood(const TetBody& body, const TetBody& other, double rounding)
      : body_(body), other_(other), rounding_(rounding), reach_(reach_of(body, other, rounding)) {}

  Relation of(std::size_t triangle) const {
    Relation relation;
    const auto corners = body_.surface.corners(triangle);
    if (!is_near(corners)) return relation;
    const bool may_touch = !parts(body_, triangle, other_, rounding_);
    constexpr double kShare = 1.0 / kSamples.size();
    for (const auto& [a, b, c] : kSamples) {
      const Vector3 point = a * corners[0] + b * corners[1] + c * corners[2];
      const NearestPoint nearest = other_.tree.nearest(point);
      const double sagitta = 4 * (a * b + b * c + c * a) * body_.sagittas[triangle];
      const double gap = gap_allowed(other_, nearest.triangle, sagitta, rounding_),
                   distance = std::sqrt(nearest.squared_distance);
      const double cosine = dot(body_.surface.normals[triangle], other_.surface.normals[nearest.triangle]);
      if (distance > 2 * gap && other_.winding.inside(point))
        relation.inside += kShare;
      else if (distance <= gap && cosine > kLeastCosine)
        relation.alike += kShare;
      else if (distance <= gap && cosine < -kLeastCosine && may_touch &&
               !parts(other_, nearest.triangle, body_, rounding_))
        relation.touching += kShare;
      else
        continue;
      relation.other_region = other_.regions[nearest.triangle];
    }
    return relation;
  }

 private:
  bool is_near(const std::array<Vector3, 3>& corners) const {
    const Box& box = other_.surface.box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax({corners[0][axis], corners[1][axis], corners[2][axis]});
      if (high < box.low[axis] - reach_ || low > box.high[axis] + reach_) return false;
    }
    return true;
  }

  const TetBody &body_, &other_;
  double rounding_, reach_;
};

/// Areas of one body in and on another.
struct Meeting {
  double touching = 0, inside = 0, alike = 0;
  std::optional<std::size_t> first_touching, first_inside;  ///< triangles
  std::vector<Relation> relations;
};

Meeting meeting_of(const TetBody& body, const TetBody& other, double rounding) {
  const Neighbourhood neighbourhood(body, other, rounding);
  Meeting meeting;
  meeting.relations.resize(body.surface.size());
  parallel_for(body.surface.size(), [&](std::size_t t) { meeting.relations[t] = neighbourhood.of(t); });
  for (std::size_t t = 0; t < meeting.relations.size(); ++t) {
    const Relation& relation = meeting.relations[t];
    meeting.touching += relation.touching * body.surface.areas[t];
    meeting.inside += relation.inside * body.surface.areas[t];
    meeting.alike += relation.alike * body.surface.areas[t];
    if (relation.touching > 0 && !meeting.first_touching) meeting.first_touching = t;
    if (relation.inside + relation.alike > 0 && !meeting.first_inside) meeting.first_inside = t;
  }
  return meeting;
}

/// Bodies overlap where one reaches into the other by more than what their triangles leave open, or where
/// their surfaces are one for the larger part: a body that is there twice.
bool is_overlap(const Meeting& meeting, const TetBody& body) {
  return meeting.inside > 0 || meeting.alike > 0.5 * body.area();
}

/// The vertices of a body that lie on the surface of another one: for each its nearest triangle there.
std::vector<std::uint32_t> triangles_at_vertices(const TetBody& body, const TetBody& other, double rounding) {
  const std::vector<Vector3>& vertices = body.surface.mesh.vertices;
  std::vector<std::uint32_t> at(vertices.size(), kUnused);
  const Box near = grown(other.surface.box, rounding);
  parallel_for(vertices.size(), [&](std::size_t v) {
    if (!boxes_meet({vertices[v], vertices[v]}, near)) return;
    const NearestPoint nearest = other.tree.nearest(vertices[v]);
    if (nearest.squared_distance <= rounding * rounding) at[v] = nearest.triangle;
  });
  return at;
}

/// Contact of vertices and edges of `body` with the surface of `other`; that along an edge, if there is any.
std::optional<BodyContact> contact_of_vertices(const TetBody& body, const TetBody& other, double rounding) {
  const std::vector<std::uint32_t> at = triangles_at_vertices(body, other, rounding);
  std::optional<BodyContact> contact;
  const auto& vertices = body.surface.mesh.vertices;
  for (std::size_t t = 0; t < body.surface.size(); ++t) {
    const auto& triangle = body.surface.mesh.triangles[t];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = triangle[k], next = triangle[(k + 1) % 3];
      if (at[v] == kUnused) continue;
      const std::array regions{body.regions[t], other.regions[at[v]]};
      if (!contact) contact = {{}, regions, ContactKind::kInPoint, 0, vertices[v]};
      if (at[next] == kUnused) continue;
      const Vector3 middle = 0.5 * (vertices[v] + vertices[next]);
      if (other.tree.nearest(middle).squared_distance > rounding * rounding) continue;
      return BodyContact{{}, regions, ContactKind::kInEdge, 0, middle};
    }
  }
  return contact;
}

/// Contact of bodies that share no area.
std::optional<BodyContact> contact_without_area(const Bodies& bodies, std::uint32_t a, std::uint32_t b,
                                                double rounding) {
  std::optional<BodyContact> contact = contact_of_vertices(*bodies[a], *bodies[b], rounding);
  if (!contact || contact->kind == ContactKind::kInPoint) {
    std::optional<BodyContact> reverse = contact_of_vertices(*bodies[b], *bodies[a], rounding);
    if (reverse) std::swap(reverse->regions[0], reverse->regions[1]);
    if (!contact || (reverse && reverse->kind == ContactKind::kInEdge)) contact = reverse;
  }
  if (contact) contact->bodies = {a, b};
  return contact;
}

std::optional<BodyContact> contact_of(const Bodies& bodies, std::uint32_t a, std::uint32_t b,
                                      double rounding) {
  std::optional<BodyContact> contact;
  for (const auto& [one, other] : {std::pair{a, b}, {b, a}}) {
    const TetBody& body = *bodies[one];
    const Meeting meeting = meeting_of(body, *bodies[other], rounding);
    const bool overlaps = is_overlap(meeting, body);
    const auto first = overlaps ? meeting.first_inside : meeting.first_touching;
    const double area = overlaps ? meeting.inside + meeting.alike : meeting.touching;
    if (!first || area == 0) continue;
    const ContactKind kind = overlaps ? ContactKind::kOverlap : ContactKind::kInFaces;
    if (contact && std::pair(contact->kind, -contact->area) <= std::pair(kind, -area)) continue;
    const auto [p, q, r] = body.surface.corners(*first);
    std::array<std::int32_t, 2> regions{body.regions[*first], meeting.relations[*first].other_region};
    if (one == b) std::swap(regions[0], regions[1]);
    contact = {{a, b}, regions, kind, area, (1.0 / 3) * (p + q + r)};
  }
  return contact ? contact : contact_without_area(bodies, a, b, rounding);
}

const char* words_of(ContactKind kind) {
  switch (kind) {
    case ContactKind::kOverlap:
      return "overlap, and both are meshed whole, one in the other";
    case ContactKind::kInFaces:
      return "touch, but are meshed apart, without common vertices";
    case ContactKind::kInEdge:
      return "meet only in an edge, where hexahedra of both share no vertices";
    case ContactKind::kInPoint:
      break;
  }
  return "meet only in a point, where hexahedra of both share no vertex";
}

}  // namespace

std::vector<BodyContact> body_contacts(const TetSolid& solid) {
  std::vector<BodyContact> contacts;
  if (solid.components < 2) return contacts;
  const Bodies bodies = bodies_of(solid);
  const double rounding = kRounding * longest_side(box_of_solid_triangles(boundary_surface(solid)));
  for (std::uint32_t a = 0; a < bodies.size(); ++a) {
    for (std::uint32_t b = a + 1; b < bodies.size(); ++b) {
      if (!bodies[a] || !bodies[b]) continue;
      const double reach = reach_of(*bodies[a], *bodies[b], rounding);
      if (!boxes_meet(grown(bodies[a]->surface.box, reach), bodies[b]->surface.box)) continue;
      if (const auto contact = contact_of(bodies, a, b, rounding)) contacts.push_back(*contact);
    }
  }
  std::ranges::stable_sort(contacts, [](const BodyContact& one, const BodyContact& other) {
    return std::pair(one.kind, -one.area) < std::pair(other.kind, -other.area);
  });
  return contacts;
}

Warning warning_of(const std::vector<BodyContact>& contacts) {
  const BodyContact& first = contacts.front();
  const bool by_region = first.regions[0] != first.regions[1];
  const auto number = [&](std::size_t k) {
    return by_region ? std::int64_t{first.regions[k]} : std::int64_t{first.bodies[k]} + 1;
  };
  const auto [low, high] = std::minmax({number(0), number(1)});
  std::string text =
      fmt::format("{} {} and {} {}", by_region ? "solids" : "bodies", low, high, words_of(first.kind));
  if (contacts.size() > 1) text += fmt::format(", and {}", counted(contacts.size() - 1, "more pair"));
  text += ", at " + words_of_place(first.place);
  if (first.kind == ContactKind::kOverlap)
    return {WarningKind::kOverlappingSolids, text, Remedy::kSeparateSolids};
  return {WarningKind::kTouchingSolids, text,
          first.kind == ContactKind::kInFaces ? Remedy::kGlueSolids : Remedy::kNone};
}

bool is_of_contact(const Warning& warning) {
  switch (warning.kind) {
    case WarningKind::kOverlappingSolids:
    case WarningKind::kTouchingSolids:
    case WarningKind::kTouchingEdges:
    case WarningKind::kTouchingVertices:
    case WarningKind::kUnmergedVertices:
      return true;
    case WarningKind::kSurfaceFinding:
      return std::ranges::any_of(
          std::array{FindingKind::kNonmanifoldEdge, FindingKind::kOverlappingComponents,
                     FindingKind::kTouchingComponents},
          [&](FindingKind kind) { return warning.text.starts_with(name_of(kind)); });
    default:
      return false;
  }
}

}  // namespace crossgrain

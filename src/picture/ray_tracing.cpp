// SPDX-License-Identifier: Apache-2.0
#include "picture/ray_tracing.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

namespace crossgrain {
namespace {

/// Distance of the start of rays before the nearest point, in ray space: rods and balls protrude from the
/// model.
constexpr double kHeadStart = 0.25;

/// Opacity behind which nothing is visible.
constexpr float kOpaque = 0.996f;

RaySpace space_around(const Drawing& drawing) {
  Box box = empty_box();
  for (const DrawnMesh& mesh : drawing.meshes)
    for (const Vector3& vertex : mesh.vertices) include(box, vertex);
  for (const DrawnRods& rods : drawing.rods) {
    for (const Rod& rod : rods.rods) include(box, rod.from), include(box, rod.to);
    for (const Ball& ball : rods.balls) include(box, ball.centre);
    for (const Facet& facet : rods.facets)
      for (const Vector3& corner : facet.corners) include(box, corner);
  }
  const auto& [low, high] = box;
  if (!(low[0] <= high[0])) return {};
  const double size = norm(high - low);
  return {0.5 * (low + high), size > 0 ? size : 1};
}

/// The signature of layers with one more of this kind.
std::uint32_t signature_with(std::uint32_t signature, std::uint32_t kind) {
  return (signature ^ (kind + 1)) * 0x9e3779b1u;
}

/// The component of a hit's normal along the ray: positive where the ray leaves the solid.
double along(const ShapeHit& hit, const Ray& ray) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += static_cast<double>(hit.normal[k]) * ray.direction[k];
  return sum;
}

SeenNormal turned_to_viewer(const SeenNormal& normal, bool is_seen_from_behind) {
  return is_seen_from_behind ? SeenNormal{-normal[0], -normal[1], -normal[2]} : normal;
}

}  // namespace

void RayTracing::Shapes::add(const DrawnMesh& mesh) {
  meshes.add_triangles(mesh.vertices, mesh.triangles);
  drawn_meshes.push_back(&mesh);
}

void RayTracing::Shapes::add(const DrawnRods& drawn) {
  rods.add_rods(drawn.rods);
  rods.add_balls(drawn.balls);
  rods.add_facets(drawn.facets);
  drawn_rods.push_back(&drawn);
}

/// The layers along one ray so far.
class RayTracing::Layers {
 public:
  void add(const Pixel& layer, std::uint32_t kind) {
    seen_ = {over(seen_.pixel, layer), signature_with(seen_.signature, kind)};
  }

  /// Adds a rod, at least `least` of which stays visible through the layers in front of it.
  void add_rod(const Colour& colour, float least) {
    Pixel& front = seen_.pixel;
    if (1 - front.opacity < least) {
      front.colour = ((1 - least) / front.opacity) * front.colour;
      front.opacity = 1 - least;
    }
    add(pixel_of(colour), 3);
  }

  bool is_opaque() const { return seen_.pixel.opacity > kOpaque; }
  const Seen& seen() const { return seen_; }

 private:
  Seen seen_;
};

RayTracing::RayTracing(const Drawing& drawing, const Camera& camera, const RenderOptions& options)
    : drawing_(drawing),
      camera_(camera),
      options_(options),
      space_(space_around(drawing)),
      cut_(device_, space_),
      whole_(device_, space_),
      ghosts_(device_, space_) {
  for (const DrawnMesh& mesh : drawing.meshes) (mesh.is_whole ? whole_ : cut_).add(mesh);
  for (const DrawnRods& rods : drawing.rods) (rods.is_whole ? whole_ : cut_).add(rods);
  if (drawing.section) ghosts_.add_rods(drawing.section->ghosts);
  for (RayScene* scene : {&cut_.meshes, &cut_.rods, &whole_.meshes, &whole_.rods, &ghosts_}) scene->commit();
  first_depth_ = kHeadStart;
  last_depth_ = kHeadStart + (camera.nearest() - camera.farthest()) / space_.size;
}

Ray RayTracing::ray_at(double x, double y) const {
  const ViewAxes& axes = camera_.axes();
  const Vector3 point =
      camera_.point_at(x, y) + (camera_.nearest() + kHeadStart * space_.size) * axes.towards;
  return {space_.from_model(point), -axes.towards};
}

RayTracing::Seen RayTracing::at(double x, double y, Scratch& scratch) const {
  const Ray whole = ray_at(x, y);
  Ray cut = whole;
  if (drawing_.section) {
    const Section& section = *drawing_.section;
    const Vector3 origin = space_.to_model(whole.origin);
    cut.nearest =
        (section.offset - dot(section.normal, origin)) / (space_.size * dot(section.normal, whole.direction));
    cut.nearest = std::max(cut.nearest, 0.0);
  }
  const auto rod = nearest_rod(cut, whole);
  const float rod_distance = rod ? rod->hit.distance : INFINITY;
  whole_.meshes.all_hits(whole, scratch.whole_hits);
  // Most rays of a cut end on it or on a rod upon it, without a look at what is behind.
  bool has_cut_hits = false;
  const auto cut_hits = [&]() -> const std::vector<ShapeHit>& {
    if (!has_cut_hits) cut_.meshes.all_hits(cut, scratch.cut_hits);
    has_cut_hits = true;
    return scratch.cut_hits;
  };

  Layers layers;
  if (drawing_.section) add_ghost(whole, cut.nearest, layers);
  auto next_whole = scratch.whole_hits.begin();
  const auto add_whole_before = [&](float distance) {
    for (; next_whole != scratch.whole_hits.end() && next_whole->distance < distance; ++next_whole)
      layers.add(mesh_pixel(*whole_.drawn_meshes[next_whole->shape], *next_whole, whole), 1);
  };
  const auto plane = static_cast<float>(cut.nearest);
  bool is_behind_cut = false;
  add_whole_before(std::min(plane, rod_distance));
  if (drawing_.section && !layers.is_opaque() && plane <= rod_distance) {
    const Vector3 place = space_.to_model(cut.origin + cut.nearest * cut.direction);
    const auto is_inside = [&] { return is_enclosed(cut_hits(), cut); };
    const auto colour = drawing_.section->colour_at(place, std::cref(is_inside));
    if (colour) layers.add(pixel_of(*colour), 2);
    is_behind_cut = colour.has_value();
  }
  if (!layers.is_opaque() && plane <= rod_distance) {
    for (const ShapeHit& hit : cut_hits()) {
      if (layers.is_opaque() || hit.distance > rod_distance) break;
      add_whole_before(hit.distance);
      const DrawnMesh& mesh = *cut_.drawn_meshes[hit.shape];
      if (mesh.has_front_only && along(hit, cut) > 0) continue;
      layers.add(mesh_pixel(mesh, hit, cut), 4 + hit.shape);
    }
  }
  add_whole_before(rod_distance);
  if (!rod) return layers.seen();
  float least = is_behind_cut ? options_.least_seen_through_cut : options_.least_seen_through;
  if (rod->rods->look != RodLook::kSolid) least = 0;
  if ((is_behind_cut && least > 0) || !layers.is_opaque()) layers.add_rod(rod_colour(*rod), least);
  return layers.seen();
}

/// Adds the rod that a section took away up to a distance along a ray, faintly.
void RayTracing::add_ghost(const Ray& ray, double distance, Layers& layers) const {
  Ray taken_away = ray;
  taken_away.farthest = distance;
  ShapeHit ghost;
  if (ghosts_.first_hit(taken_away, ghost))
    layers.add(pixel_of(drawing_.section->ghosts[ghost.primitive].colour, drawing_.section->ghost_opacity),
               0);
}

std::optional<RayTracing::RodHit> RayTracing::nearest_rod(const Ray& cut, const Ray& whole) const {
  ShapeHit of_cut, of_whole;
  const bool meets_cut = cut_.rods.first_hit(cut, of_cut);
  const bool meets_whole = whole_.rods.first_hit(whole, of_whole);
  if (meets_whole && (!meets_cut || of_whole.distance < of_cut.distance))
    return RodHit{of_whole, whole_.drawn_rods[of_whole.shape / kShapesOfRods]};
  if (meets_cut) return RodHit{of_cut, cut_.drawn_rods[of_cut.shape / kShapesOfRods]};
  return std::nullopt;
}

/// Whether the start of a ray is inside: it leaves the solid more often than it enters it.
bool RayTracing::is_enclosed(const std::vector<ShapeHit>& hits, const Ray& ray) const {
  int winding = 0;
  for (const ShapeHit& hit : hits) {
    if (!cut_.drawn_meshes[hit.shape]->bounds_solid) continue;
    winding += along(hit, ray) > 0 ? 1 : -1;
  }
  return winding > 0;
}

Vector3 RayTracing::place_of(const ShapeHit& hit, const Ray& ray) const {
  return space_.to_model(ray.origin + static_cast<double>(hit.distance) * ray.direction);
}

SeenNormal RayTracing::seen_normal(const std::array<float, 3>& normal) const {
  const Vector3 wide{normal[0], normal[1], normal[2]};
  const double length = norm(wide);
  if (!(length > 0)) return {0, 0, 1};
  const ViewAxes& axes = camera_.axes();
  return {static_cast<float>(dot(wide, axes.right) / length), static_cast<float>(dot(wide, axes.up) / length),
          static_cast<float>(dot(wide, axes.towards) / length)};
}

Pixel RayTracing::mesh_pixel(const DrawnMesh& mesh, const ShapeHit& hit, const Ray& ray) const {
  const SeenNormal flat = seen_normal(hit.normal);
  SeenNormal normal = flat;
  if (!mesh.corner_normals.empty()) {
    const auto& corners = mesh.corner_normals[hit.primitive];
    std::array<float, 3> blended;
    for (std::size_t k = 0; k < 3; ++k)
      blended[k] = (1 - hit.u - hit.v) * corners[0][k] + hit.u * corners[1][k] + hit.v * corners[2][k];
    normal = seen_normal(blended);
  }
  normal = turned_to_viewer(normal, flat[2] < 0);
  Colour colour = mesh.colour;
  if (mesh.colour_at) {
    const Vector3 wide{hit.normal[0], hit.normal[1], hit.normal[2]};
    colour = mesh.colour_at({place_of(hit, ray), normalised(wide), hit.primitive, hit.u, hit.v});
  }
  const float aside = 1 - std::clamp(normal[2], 0.0f, 1.0f);
  const float opacity = mesh.opacity + (mesh.grazing_opacity - mesh.opacity) * aside * aside * aside;
  const float light = std::min(0.22f + 0.86f * brightness(normal), 1.0f);
  const Colour lit = (1 - mesh.shading * (1 - light)) * colour;
  return pixel_of(mix(lit, options_.haze, options_.haze_share * depth_share(hit.distance)), opacity);
}

Colour RayTracing::rod_colour(const RodHit& rod) const {
  const std::uint32_t i = rod.hit.primitive;
  const std::uint32_t kind = rod.hit.shape % kShapesOfRods;
  const Colour colour = kind == 0   ? rod.rods->rods[i].colour
                        : kind == 1 ? rod.rods->balls[i].colour
                                    : rod.rods->facets[i].colour;
  const SeenNormal normal = seen_normal(rod.hit.normal);
  const Colour lit = rod.rods->look == RodLook::kInk ? colour
                     : kind == 2 ? facet_shade(colour, turned_to_viewer(normal, normal[2] < 0))
                                 : solid_shade(colour, normal);
  return mix(lit, options_.haze, options_.haze_share * depth_share(rod.hit.distance));
}

float RayTracing::depth_share(float distance) const {
  const double share = (distance - first_depth_) / std::max(last_depth_ - first_depth_, 1e-6);
  return static_cast<float>(std::clamp(share, 0.0, 1.0));
}

}  // namespace crossgrain

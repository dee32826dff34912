// SPDX-License-Identifier: Apache-2.0
#include "picture/ray_scene.hpp"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <new>
#include <tuple>

#include "base/parallel.hpp"

namespace crossgrain {
namespace {

constexpr const char* kEveryProcessor = "isa=sse2";

/// Distance within which two hits are at the same place, in ray space, whose shapes are about 1 large:
/// rounding of single precision.
constexpr float kSameDistance = 1e-6f;

/// The context of the filter below.
struct CollectingContext {
  RTCIntersectContext embree;  // first, so that its address is that of the whole
  std::vector<ShapeHit>* hits;
  bool is_out_of_memory = false;  ///< an exception must not leave the filter: Embree would swallow it
};

/// Records every triangle that a ray meets, and lets the ray continue.
void collect(const RTCFilterFunctionNArguments* arguments) {
  auto* context = reinterpret_cast<CollectingContext*>(arguments->context);
  const auto* ray = reinterpret_cast<const RTCRay*>(arguments->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(arguments->hit);
  try {
    context->hits->push_back(
        {ray->tfar, hit->geomID, hit->primID, hit->u, hit->v, {hit->Ng_x, hit->Ng_y, hit->Ng_z}});
  } catch (const std::bad_alloc&) {
    context->is_out_of_memory = true;
  }
  arguments->valid[0] = 0;
}

/// A part of a rod.
struct RodPiece {
  Vector3 from, to;
  std::array<double, 2> radii;
  std::uint32_t rod;
};

/// Adds a rod in pieces: the box around a long oblique rod is almost empty, and every ray through it would be
/// tested against the rod.
void add_pieces(const Rod& rod, std::uint32_t number, std::vector<RodPiece>& pieces) {
  constexpr double kLongest = 24, kMostPieces = 512;  // lengths in radii
  const double end_radius = rod.end_radius > 0 ? rod.end_radius : rod.radius;
  const double wanted = std::ceil(norm(rod.to - rod.from) / (kLongest * std::min(rod.radius, end_radius)));
  const int count = static_cast<int>(std::clamp(wanted, 1.0, kMostPieces));
  const Vector3 step = (1.0 / count) * (rod.to - rod.from);
  const double growth = (end_radius - rod.radius) / count;
  for (int i = 0; i < count; ++i)
    pieces.push_back({rod.from + static_cast<double>(i) * step,
                      i + 1 == count ? rod.to : rod.from + (i + 1.0) * step,
                      {rod.radius + i * growth, rod.radius + (i + 1) * growth},
                      number});
}

RTCRayHit embree_ray(const Ray& ray) {
  RTCRayHit out{};
  out.ray.org_x = static_cast<float>(ray.origin[0]);
  out.ray.org_y = static_cast<float>(ray.origin[1]);
  out.ray.org_z = static_cast<float>(ray.origin[2]);
  out.ray.dir_x = static_cast<float>(ray.direction[0]);
  out.ray.dir_y = static_cast<float>(ray.direction[1]);
  out.ray.dir_z = static_cast<float>(ray.direction[2]);
  out.ray.tnear = static_cast<float>(ray.nearest);
  out.ray.tfar = static_cast<float>(ray.farthest);
  out.ray.mask = ~0u;
  out.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  return out;
}

bool faces_viewer(const ShapeHit& hit, const Ray& ray) {
  return hit.normal[0] * ray.direction[0] + hit.normal[1] * ray.direction[1] +
             hit.normal[2] * ray.direction[2] <
         0;
}

}  // namespace

RayDevice::RayDevice() : device_(rtcNewDevice(kEveryProcessor), rtcReleaseDevice) {
  if (!device_) throw std::bad_alloc();
}

struct RayScene::Embree {
  RTCDevice device;
  RTCScene scene;
  std::uint32_t shapes = 0;
  bool is_empty = true;
  std::map<std::uint32_t, std::vector<RodPiece>> pieces;  ///< pieces of the shapes that are rods

  explicit Embree(RTCDevice of) : device(of), scene(rtcNewScene(of)) {
    if (!scene) throw std::bad_alloc();
  }
  ~Embree() { rtcReleaseScene(scene); }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;

  /// A new buffer of `geometry` with rows of T.
  template <class T>
  T* buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t rows) {
    void* memory = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), rows);
    if (!memory) throw std::bad_alloc();
    return static_cast<T*>(memory);
  }

  /// Counts a shape without content, which has a number too.
  void pass_over() { ++shapes; }

  void add(RTCGeometry geometry) {
    is_empty = false;
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(scene, geometry, shapes++);
    rtcReleaseGeometry(geometry);
  }
};

RayScene::RayScene(const RayDevice& device, const RaySpace& space)
    : space_(space), embree_(std::make_unique<Embree>(device.device_.get())) {
  rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION);
}

RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;

void RayScene::add_triangles(const std::vector<Vector3>& vertices,
                             const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  if (triangles.empty()) return embree_->pass_over();
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  using Place = std::array<float, 3>;
  auto* places = embree_->buffer<Place>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, vertices.size());
  for (const Vector3& vertex : vertices) {
    const Vector3 place = space_.from_model(vertex);
    *places++ = {static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2])};
  }
  using Corners = std::array<std::uint32_t, 3>;
  std::copy(triangles.begin(), triangles.end(),
            embree_->buffer<Corners>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, triangles.size()));
  embree_->add(geometry);
}

void RayScene::add_rods(const std::vector<Rod>& rods) {
  std::vector<RodPiece>& pieces = embree_->pieces[embree_->shapes];
  for (std::size_t i = 0; i < rods.size(); ++i) add_pieces(rods[i], static_cast<std::uint32_t>(i), pieces);
  if (pieces.empty()) return embree_->pass_over();
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_ROUND_LINEAR_CURVE);
  using End = std::array<float, 4>;  // position and radius
  auto* ends = embree_->buffer<End>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, 2 * pieces.size());
  auto* first =
      embree_->buffer<std::uint32_t>(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT, pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const auto radius = static_cast<float>(pieces[i].radii[k] / space_.size);
      const Vector3 place = space_.from_model(k == 0 ? pieces[i].from : pieces[i].to);
      *ends++ = {static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2]),
                 radius};
    }
    *first++ = static_cast<std::uint32_t>(2 * i);
  }
  embree_->add(geometry);
}

void RayScene::add_balls(const std::vector<Ball>& balls) {
  if (balls.empty()) return embree_->pass_over();
  RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
  using Sphere = std::array<float, 4>;
  auto* spheres = embree_->buffer<Sphere>(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT4, balls.size());
  for (const Ball& ball : balls) {
    const Vector3 place = space_.from_model(ball.centre);
    *spheres++ = {static_cast<float>(place[0]), static_cast<float>(place[1]), static_cast<float>(place[2]),
                  static_cast<float>(ball.radius / space_.size)};
  }
  embree_->add(geometry);
}

void RayScene::add_facets(const std::vector<Facet>& facets) {
  std::vector<Vector3> vertices;
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (const Facet& facet : facets) {
    const auto first = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), facet.corners.begin(), facet.corners.end());
    triangles.push_back({first, first + 1, first + 2});
  }
  add_triangles(vertices, triangles);
}

void RayScene::commit() {
  const ThreadLimit one_thread(1);
  run_within_limit([&] { rtcCommitScene(embree_->scene); });
  if (rtcGetDeviceError(embree_->device) != RTC_ERROR_NONE) throw std::bad_alloc();
}

bool RayScene::first_hit(const Ray& ray, ShapeHit& hit) const {
  if (embree_->is_empty) return false;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit cast = embree_ray(ray);
  rtcIntersect1(embree_->scene, &context, &cast);
  if (cast.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = {cast.ray.tfar, cast.hit.geomID, cast.hit.primID,
         cast.hit.u,    cast.hit.v,      {cast.hit.Ng_x, cast.hit.Ng_y, cast.hit.Ng_z}};
  const auto rods = embree_->pieces.find(hit.shape);
  if (rods != embree_->pieces.end()) hit.primitive = rods->second[hit.primitive].rod;
  return true;
}

void RayScene::all_hits(const Ray& ray, std::vector<ShapeHit>& hits) const {
  hits.clear();
  if (embree_->is_empty) return;
  CollectingContext context;
  rtcInitIntersectContext(&context.embree);
  context.embree.filter = collect;
  context.hits = &hits;
  RTCRayHit cast = embree_ray(ray);
  rtcIntersect1(embree_->scene, &context.embree, &cast);
  if (context.is_out_of_memory) throw std::bad_alloc();
  if (hits.size() < 2) return;
  std::sort(hits.begin(), hits.end(), [](const ShapeHit& a, const ShapeHit& b) {
    return std::tie(a.distance, a.shape, a.primitive) < std::tie(b.distance, b.shape, b.primitive);
  });
  const auto is_repeated = [&](const ShapeHit& a, const ShapeHit& b) {
    return a.shape == b.shape && b.distance - a.distance < kSameDistance &&
           faces_viewer(a, ray) == faces_viewer(b, ray);
  };
  hits.erase(std::unique(hits.begin(), hits.end(), is_repeated), hits.end());
}

}  // namespace crossgrain

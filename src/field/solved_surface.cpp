// SPDX-License-Identifier: Apache-2.0
#include "field/solved_surface.hpp"

#include <utility>

namespace crossgrain {
namespace {

template <class T>
std::shared_future<std::shared_ptr<const T>> ready(std::shared_ptr<const T> value) {
  std::promise<std::shared_ptr<const T>> now;
  now.set_value(std::move(value));
  return now.get_future().share();
}

/// A future that calls make() when it is first asked.
template <class Make>
auto on_demand(Make make) {
  return std::async(std::launch::deferred, std::move(make)).share();
}

}  // namespace

std::shared_ptr<const SearchableSurface> searchable(const SolvedSurface& surface) {
  TriangleMesh mesh;
  mesh.vertices = surface.vertices;
  mesh.triangles = surface.triangles;
  return std::make_shared<const SearchableSurface>(prepare_surface(CheckedMesh::derived(std::move(mesh))));
}

SurfaceSource::SurfaceSource(SolvedSurface surface, std::shared_ptr<const SearchableSurface> searched)
    : surface_(ready(std::make_shared<const SolvedSurface>(std::move(surface)))),
      searchable_(searched ? ready(std::move(searched)) : on_demand([from = surface_] {
        return from.get()->triangles.empty() ? nullptr : crossgrain::searchable(*from.get());
      })) {}

SurfaceSource::SurfaceSource(std::function<SolvedSurface()> read)
    : surface_(on_demand([read = std::move(read)] { return std::make_shared<const SolvedSurface>(read()); })),
      searchable_(on_demand([from = surface_] {
        return from.get()->triangles.empty() ? nullptr : crossgrain::searchable(*from.get());
      })) {}

}  // namespace crossgrain

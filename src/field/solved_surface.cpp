// SPDX-License-Identifier: Apache-2.0
#include "field/solved_surface.hpp"

#include <utility>

namespace crossgrain {

std::shared_ptr<const SearchableSurface> searchable(const SolvedSurface& surface) {
  TriangleMesh mesh;
  mesh.vertices = surface.vertices;
  mesh.triangles = surface.triangles;
  return std::make_shared<const SearchableSurface>(prepare_surface(CheckedMesh::derived(std::move(mesh))));
}

SurfaceSource::SurfaceSource(SolvedSurface surface, std::shared_ptr<const SearchableSurface> searched)
    : surface_(std::make_shared<MadeOnDemand<SolvedSurface>>(
          std::make_shared<const SolvedSurface>(std::move(surface)))) {
  if (searched)
    searchable_ = std::make_shared<MadeOnDemand<SearchableSurface>>(std::move(searched));
  else
    search_surface();
}

SurfaceSource::SurfaceSource(std::function<SolvedSurface()> read)
    : surface_(std::make_shared<MadeOnDemand<SolvedSurface>>(
          [read = std::move(read)] { return std::make_shared<const SolvedSurface>(read()); })) {
  search_surface();
}

void SurfaceSource::search_surface() {
  searchable_ = std::make_shared<MadeOnDemand<SearchableSurface>>(
      [from = surface_]() -> std::shared_ptr<const SearchableSurface> {
        const auto surface = from->get();
        return surface->triangles.empty() ? nullptr : crossgrain::searchable(*surface);
      });
}

}  // namespace crossgrain

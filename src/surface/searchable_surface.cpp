// SPDX-License-Identifier: Apache-2.0
#include "surface/searchable_surface.hpp"

#include <utility>

namespace crossgrain {
namespace {

MendedSurface as_mended(Surface surface) {
  MendedSurface mended;
  mended.surface = std::move(surface);
  return mended;
}

}  // namespace

SearchableSurface::SearchableSurface(MendedSurface mended)
    : mended_(std::move(mended)), bvh_(mended_.surface) {}

SearchableSurface::SearchableSurface(Surface surface) : SearchableSurface(as_mended(std::move(surface))) {}

const WindingNumber& SearchableSurface::winding() const {
  std::call_once(winding_once_, [this] { winding_.emplace(bvh_); });
  return *winding_;
}

}  // namespace crossgrain

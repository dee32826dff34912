// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mutex>
#include <optional>

#include "surface/bvh.hpp"
#include "surface/mending.hpp"
#include "surface/winding_number.hpp"

namespace crossgrain {

/// A surface with the trees that find places on it and tell inside from outside, which take most of the time
/// of opening a large one: made once, and shared by all that search. Refers to itself, so it can be neither
/// copied nor moved. Queries are thread-safe.
class SearchableSurface {
 public:
  explicit SearchableSurface(MendedSurface mended);

  /// Of a surface that was mended before; mended() has no more than it.
  explicit SearchableSurface(Surface surface);

  SearchableSurface(const SearchableSurface&) = delete;
  SearchableSurface& operator=(const SearchableSurface&) = delete;

  const MendedSurface& mended() const { return mended_; }
  const Surface& surface() const { return mended_.surface; }
  const TriangleBvh& bvh() const { return bvh_; }

  /// Made at the first call: rays and nearest places do not need it.
  const WindingNumber& winding() const;

 private:
  MendedSurface mended_;
  TriangleBvh bvh_;
  mutable std::once_flag winding_once_;
  mutable std::optional<WindingNumber> winding_;
};

}  // namespace crossgrain

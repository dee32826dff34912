// SPDX-License-Identifier: Apache-2.0
#include "singularity/vertex_link.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "singularity/sphere_triangulations.hpp"

namespace crossgrain {
namespace {

using testing::Neighbours;
using testing::Triangulation;
using testing::triangulations;

constexpr int kFewestVertices = 4, kMostVertices = 9;

using Numbers = std::vector<int>;

/// Singular valences, ascending, and creases in the cyclic order that is least.
using Link = std::pair<Numbers, Numbers>;

Numbers least_cyclic(Numbers word) {
  Numbers least = word;
  for (int side = 0; side < 2; ++side) {
    for (std::size_t k = 0; k < word.size(); ++k) {
      std::rotate(word.begin(), word.begin() + 1, word.end());
      least = std::min(least, word);
    }
    std::reverse(word.begin(), word.end());
  }
  return least;
}

/// The vertices around one, in cyclic order.
Numbers ring_around(const Triangulation& sphere, int centre) {
  std::map<int, Numbers> beside;
  for (const auto& face : sphere.faces) {
    if (!std::count(face.begin(), face.end(), centre)) continue;
    Numbers others;
    std::copy_if(face.begin(), face.end(), std::back_inserter(others), [&](int v) { return v != centre; });
    beside[others[0]].push_back(others[1]);
    beside[others[1]].push_back(others[0]);
  }
  Numbers ring{beside.begin()->first};
  for (int next = beside.begin()->second[0], before = ring[0]; next != ring[0];) {
    ring.push_back(next);
    const int after = beside[next][0] == before ? beside[next][1] : beside[next][0];
    before = std::exchange(next, after);
  }
  return ring;
}

/// Calls visit(triangulation) for all of the sphere with at most kMostVertices.
template <class Visit>
void visit_spheres(const Visit& visit) {
  visit(Triangulation{{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}, kFewestVertices});
  for (int vertices = kFewestVertices + 1; vertices <= kMostVertices; ++vertices)
    for (const Triangulation& sphere : triangulations(vertices)) visit(sphere);
}

/// Calls visit(list) for all ascending lists of these numbers, up to a length.
void visit_multisets(const Numbers& from, std::size_t longest,
                     const std::function<void(const Numbers&)>& visit) {
  Numbers list;
  const std::function<void(std::size_t)> extend = [&](std::size_t first) {
    visit(list);
    if (list.size() == longest) return;
    for (std::size_t k = first; k < from.size(); ++k) {
      list.push_back(from[k]);
      extend(k);
      list.pop_back();
    }
  };
  extend(0);
}

/// Calls visit(word) for all words of these numbers, up to a length.
void visit_words(const Numbers& from, std::size_t longest, const std::function<void(const Numbers&)>& visit) {
  Numbers word;
  const std::function<void()> extend = [&] {
    visit(word);
    if (word.size() == longest) return;
    for (const int number : from) {
      word.push_back(number);
      extend();
      word.pop_back();
    }
  };
  extend();
}

TEST(InnerLink, ExistsForTheValencesOfAllTriangulationsOfTheSphereAndNoOthers) {
  std::set<Numbers> possible;
  visit_spheres([&](const Triangulation& sphere) {
    Numbers valences;
    for (const auto& neighbours : sphere.neighbours())
      if (neighbours.size() != 4) valences.push_back(static_cast<int>(neighbours.size()));
    std::sort(valences.begin(), valences.end());
    possible.insert(valences);
  });
  std::size_t checked = 0;
  visit_multisets({3, 5, 6, 7}, kMostVertices, [&](const Numbers& valences) {
    int twice_regular = 12;
    for (const int valence : valences) twice_regular -= 6 - valence;
    if (2 * static_cast<int>(valences.size()) + twice_regular > 2 * kMostVertices) return;
    ++checked;
    EXPECT_EQ(has_inner_link(valences), possible.contains(valences)) << ::testing::PrintToString(valences);
  });
  EXPECT_GT(checked, 100u);
}

TEST(SurfaceLink, ExistsForTheDiscsOfAllTriangulationsOfTheSphereAndNoOthers) {
  // A disc and a vertex that is joined to all of its border make a sphere.
  std::set<Link> possible;
  visit_spheres([&](const Triangulation& sphere) {
    const Neighbours neighbours = sphere.neighbours();
    const auto valence = [&](int v) {
      return static_cast<int>(neighbours[static_cast<std::size_t>(v)].size());
    };
    for (int centre = 0; centre < sphere.vertices; ++centre) {
      const Numbers ring = ring_around(sphere, centre);
      Link link;
      for (const int v : ring)
        if (valence(v) != 4) link.second.push_back(valence(v) - 2);
      for (int v = 0; v < sphere.vertices; ++v)
        if (v != centre && !std::count(ring.begin(), ring.end(), v) && valence(v) != 4)
          link.first.push_back(valence(v));
      std::sort(link.first.begin(), link.first.end());
      link.second = least_cyclic(link.second);
      possible.insert(link);
    }
  });
  std::size_t checked = 0, found = 0;
  visit_multisets({3, 5, 6}, 3, [&](const Numbers& valences) {
    visit_words({1, 3, 4, 5}, 6, [&](const Numbers& creases) {
      if (creases != least_cyclic(creases)) return;
      const int vertices =
          hexahedra_at_surface_vertex(valences, creases) + 2 - static_cast<int>(valences.size());
      if (vertices + 1 > kMostVertices) return;
      ++checked;
      const bool expected = possible.contains({valences, creases});
      found += expected;
      EXPECT_EQ(has_surface_link(valences, creases), expected)
          << ::testing::PrintToString(valences) << ' ' << ::testing::PrintToString(creases);
    });
  });
  EXPECT_GT(checked, 1000u);
  EXPECT_GT(found, 50u);
}

TEST(SurfaceLink, OfCommonVerticesExists) {
  EXPECT_EQ(has_surface_link({}, {}), true) << "smooth surface";
  EXPECT_EQ(has_surface_link({}, std::vector{1, 1}), true) << "straight edge of a box";
  EXPECT_EQ(has_surface_link({}, std::vector{1, 1, 1}), true) << "corner of a box";
  EXPECT_EQ(has_surface_link({}, std::vector{3, 3}), true) << "straight reentrant edge";
  EXPECT_EQ(has_surface_link(std::vector{3}, {}), true) << "end of a line of three hexahedra";
  EXPECT_EQ(has_surface_link(std::vector{5}, {}), true) << "end of a line of five hexahedra";
}

TEST(SurfaceLink, OfKnifeEdgesAndApexesDoesNotExist) {
  EXPECT_EQ(has_surface_link({}, std::vector{0, 2}), false);
  EXPECT_EQ(has_surface_link({}, std::vector{1, 1, 1, 1}), false) << "apex of a pyramid, F = 0";
  EXPECT_EQ(has_surface_link(std::vector{3}, std::vector{1, 1, 1}), false);
  EXPECT_EQ(has_surface_link({}, std::vector{1}), false) << "a crease that ends, F = 3";
}

/// Whether one of the ways to distribute regular edges among the creases has a link.
bool has_link_for_some_sectors(const std::vector<int>& valences, const std::vector<int>& creases, int most) {
  std::vector<int> more(creases.size(), 0);
  while (true) {
    std::vector<int> border;
    for (std::size_t k = 0; k < creases.size(); ++k) {
      border.push_back(creases[k]);
      border.insert(border.end(), static_cast<std::size_t>(more[k]), 2);
    }
    if (has_link_within(border, valences).value_or(false)) return true;
    std::size_t k = 0;
    while (k < more.size() && ++more[k] > most) more[k++] = 0;
    if (k == more.size()) return false;
  }
}

TEST(VertexLink, ExistsForCreasesIfItDoesForSomeNumbersOfRegularEdgesBetweenThem) {
  const std::vector<std::vector<int>> all_creases{
      {1}, {3}, {1, 1}, {1, 3}, {3, 3}, {1, 1, 1}, {1, 1, 3}, {1, 3, 3}, {1, 1, 1, 1}, {3, 3, 1, 1}};
  for (const std::vector<int>& creases : all_creases)
    for (const std::vector<int>& valences :
         std::vector<std::vector<int>>{{}, {3}, {5}, {3, 3}, {3, 5}, {5, 5}})
      EXPECT_EQ(has_surface_link(valences, creases), has_link_for_some_sectors(valences, creases, 5));
}

TEST(VertexLink, OfACubesCornerEdgeAndFaceHasOneTwoAndFourTriangles) {
  EXPECT_EQ(has_link_within(std::vector{1, 1, 1}, {}), true);
  EXPECT_EQ(has_link_within(std::vector{1, 2, 1, 2}, {}), true);
  EXPECT_EQ(has_link_within(std::vector{2, 2, 2, 2}, {}), true);
  // A face that turns by three quarters around a point needs an arc of three hexahedra.
  EXPECT_EQ(has_link_within(std::vector{2, 2, 2}, {}), false);
  EXPECT_EQ(has_link_within(std::vector{2, 2, 2}, std::vector{3}), true);
}

}  // namespace
}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// All triangulations of the sphere with a few vertices.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace crossgrain::testing {

/// A triangulation of the sphere by the neighbours of each vertex.
using Neighbours = std::vector<std::set<int>>;

/// The two vertices that make triangles with an edge. In a triangulation of the sphere other common
/// neighbours may exist, across a triangle that is no face; so faces are kept.
struct Triangulation {
  std::set<std::array<int, 3>> faces;  ///< ascending
  int vertices;

  Neighbours neighbours() const {
    Neighbours found(static_cast<std::size_t>(vertices));
    for (const auto& face : faces)
      for (const int a : face)
        for (const int b : face)
          if (a != b) found[static_cast<std::size_t>(a)].insert(b);
    return found;
  }
};

inline std::array<int, 3> sorted(int a, int b, int c) {
  std::array<int, 3> face{a, b, c};
  std::sort(face.begin(), face.end());
  return face;
}

/// The same for all triangulations that differ in the numbers of vertices only: the least of the codes that
/// walks from every edge, either way round, make.
inline std::vector<int> code_of(const Triangulation& t) {
  std::map<std::pair<int, int>, std::vector<int>> third;
  for (const auto& [a, b, c] : t.faces)
    for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
      third[{p, q}].push_back(r);
      third[{q, p}].push_back(r);
    }
  std::vector<int> least;
  for (const auto& [edge, sides] : third) {
    for (const int side : sides) {
      // Number vertices as the walk over faces finds them.
      std::vector<int> number(static_cast<std::size_t>(t.vertices), -1), order{edge.first, edge.second, side},
          code;
      for (int k = 0; k < 3; ++k) number[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])] = k;
      std::set<std::array<int, 3>> seen{sorted(edge.first, edge.second, side)};
      std::vector<std::array<int, 3>> waiting{{edge.first, edge.second, side}};
      for (std::size_t k = 0; k < waiting.size(); ++k) {
        const auto [a, b, c] = waiting[k];
        for (const auto& [p, q, r] : {std::array{a, b, c}, std::array{b, c, a}, std::array{c, a, b}}) {
          const auto& both = third[{p, q}];
          const int other = both[0] == r ? both[1] : both[0];
          int& own = number[static_cast<std::size_t>(other)];
          if (own < 0) {
            own = static_cast<int>(order.size());
            order.push_back(other);
          }
          code.push_back(own);
          if (seen.insert(sorted(p, q, other)).second) waiting.push_back({q, p, other});
        }
      }
      if (least.empty() || code < least) least = code;
    }
  }
  return least;
}

/// All triangulations of the sphere with so many vertices: flips of edges lead from one to every other
/// (K. Wagner, 1936).
inline std::vector<Triangulation> triangulations(int vertices) {
  Triangulation first{{}, vertices};
  const auto at = [](int k) { return k; };
  // A double pyramid over a way of vertices - 2.
  const int ring = vertices - 2;
  for (int k = 0; k < ring; ++k)
    for (const int top : {vertices - 2, vertices - 1}) first.faces.insert(sorted(at(k), (k + 1) % ring, top));
  std::vector<Triangulation> found{first};
  std::set<std::vector<int>> codes{code_of(first)};
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Triangulation now = found[i];
    const Neighbours joined = now.neighbours();
    for (const auto& f : now.faces) {
      for (const auto& [a, b, c] :
           {std::array{f[0], f[1], f[2]}, std::array{f[1], f[2], f[0]}, std::array{f[2], f[0], f[1]}}) {
        int d = -1;
        for (const auto& g : now.faces)
          if (g != f && std::count(g.begin(), g.end(), a) && std::count(g.begin(), g.end(), b))
            d = g[0] + g[1] + g[2] - a - b;
        if (d < c || joined[static_cast<std::size_t>(c)].contains(d)) continue;
        Triangulation next = now;
        next.faces.erase(f);
        next.faces.erase(sorted(a, b, d));
        next.faces.insert(sorted(a, c, d));
        next.faces.insert(sorted(b, c, d));
        if (codes.insert(code_of(next)).second) found.push_back(next);
      }
    }
  }
  return found;
}

}  // namespace crossgrain::testing

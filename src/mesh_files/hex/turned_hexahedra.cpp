// SPDX-License-Identifier: Apache-2.0
#include "mesh_files/hex/turned_hexahedra.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "measure/hex_faces.hpp"
#include "measure/hex_quality.hpp"

namespace crossgrain {
namespace {

/// Whether two hexahedra have a common face, and so which way one turns beside the other.
enum class Turn : std::uint8_t { kSame, kOpposite, kUnknown };

struct Neighbour {
  std::uint32_t of, hexahedron;
  Turn turn;
};

/// How the second of two hexahedra goes around a face that the first has outward.
Turn turn_beside(const HexInnerFace& face, const std::array<std::uint32_t, 8>& second) {
  for (const auto& corners : kHexFaces) {
    const auto at = static_cast<std::size_t>(
        std::ranges::find(corners, face.vertices[0], [&](std::uint8_t k) { return second[k]; }) -
        corners.begin());
    if (at == 4) continue;
    const auto vertex = [&](std::size_t k) { return second[corners[(at + k) % 4]]; };
    if (vertex(2) != face.vertices[2]) continue;
    if (vertex(1) == face.vertices[3] && vertex(3) == face.vertices[1]) return Turn::kSame;
    if (vertex(1) == face.vertices[1] && vertex(3) == face.vertices[3]) return Turn::kOpposite;
  }
  return Turn::kUnknown;
}

/// Ascending by `of`.
std::vector<Neighbour> neighbours_in(const HexMesh& mesh) {
  std::vector<Neighbour> neighbours;
  for (const HexInnerFace& face : inner_faces_of(mesh)) {
    const auto [first, second] = face.hexahedra;
    const Turn turn = turn_beside(face, mesh.hexahedra[second]);
    neighbours.push_back({first, second, turn});
    neighbours.push_back({second, first, turn});
  }
  Checkpoint checkpoint;
  std::ranges::stable_sort(neighbours, [&](const Neighbour& a, const Neighbour& b) {
    checkpoint.pass();
    return a.of < b.of;
  });
  return neighbours;
}

/// Hexahedra that are connected over faces, with what makes them turn as the first does.
struct Body {
  std::vector<std::uint32_t> hexahedra;
  bool is_consistent = true;
};

class BodyWalk {
 public:
  explicit BodyWalk(const HexMesh& mesh)
      : neighbours_(neighbours_in(mesh)), states_(mesh.hexahedra.size(), State::kUnseen) {}

  bool is_seen(std::uint32_t hexahedron) const { return states_[hexahedron] != State::kUnseen; }
  bool is_turned(std::uint32_t hexahedron) const { return states_[hexahedron] == State::kTurned; }

  Body body_of(std::uint32_t first) {
    Body body{{first}};
    states_[first] = State::kKept;
    Checkpoint checkpoint;
    for (std::size_t next = 0; next < body.hexahedra.size(); ++next) {
      checkpoint.pass();
      for (const Neighbour& neighbour : neighbours_of(body.hexahedra[next])) step(neighbour, body);
    }
    return body;
  }

 private:
  enum class State : std::uint8_t { kUnseen, kKept, kTurned };

  std::span<const Neighbour> neighbours_of(std::uint32_t hexahedron) const {
    const auto [begin, end] = std::ranges::equal_range(neighbours_, hexahedron, {}, &Neighbour::of);
    return {begin, end};
  }

  void step(const Neighbour& neighbour, Body& body) {
    if (neighbour.turn == Turn::kUnknown) {
      body.is_consistent = false;
      return;
    }
    const bool is_turned = is_turned_beside(neighbour);
    State& state = states_[neighbour.hexahedron];
    if (state == State::kUnseen) {
      state = is_turned ? State::kTurned : State::kKept;
      body.hexahedra.push_back(neighbour.hexahedron);
    } else {
      body.is_consistent &= (state == State::kTurned) == is_turned;
    }
  }

  bool is_turned_beside(const Neighbour& neighbour) const {
    return is_turned(neighbour.of) != (neighbour.turn == Turn::kOpposite);
  }

  std::vector<Neighbour> neighbours_;
  std::vector<State> states_;
};

}  // namespace

std::size_t turn_right_handed(HexMesh& mesh) {
  const std::vector<double> volumes = volumes_of(mesh);
  if (std::ranges::all_of(volumes, [](double volume) { return volume > 0; })) return 0;
  BodyWalk walk(mesh);
  std::size_t turned = 0;
  for (std::uint32_t h = 0; h < mesh.hexahedra.size(); ++h) {
    if (walk.is_seen(h)) continue;
    const Body body = walk.body_of(h);
    if (!body.is_consistent) continue;
    double volume = 0;
    for (const std::uint32_t member : body.hexahedra)
      volume += walk.is_turned(member) ? -volumes[member] : volumes[member];
    for (const std::uint32_t member : body.hexahedra) {
      if (walk.is_turned(member) == (volume < 0)) continue;
      ++turned;
      auto& corners = mesh.hexahedra[member];
      std::swap_ranges(corners.begin(), corners.begin() + 4, corners.begin() + 4);
    }
  }
  return turned;
}

}  // namespace crossgrain

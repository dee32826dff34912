// SPDX-License-Identifier: Apache-2.0
// The .perm files of CubeCover, version 1:
//
//   PERM 1
//   tets faces 3
//   from to p1 p2 p3      a line for each face whose matching is not the identity
//
// Tets count from 0. Axis k of the frame of `from`, times the sign of p_k, goes on in `to` as its axis |p_k|,
// counted from 1.
#include <fmt/format.h>

#include <vector>

#include "results/tet_writers.hpp"
#include "text/text_lines.hpp"

namespace crossgrain {
void write_perm(OutputFile& file, const TetOutput& output, const Monitor& monitor) {
  const std::vector<CubeRotation> matchings = matchings_of(output.solid, output.field);
  std::vector<std::size_t> turning;
  for (std::size_t f = 0; f < matchings.size(); ++f)
    if (!matchings[f].is_identity()) turning.push_back(f);
  file.write(fmt::format("PERM 1\n{} {} 3\n", output.solid.mesh.tets.size(), turning.size()));
  const auto put = [&](std::size_t i, char* out) {
    const auto& [from, to] = output.solid.inner_faces[turning[i]].tets;
    const auto axes = signed_axes(matchings[turning[i]]);
    out = put_integer(out, from, ' ');
    out = put_integer(out, to, ' ');
    out = put_integer(out, axes[0], ' ');
    out = put_integer(out, axes[1], ' ');
    return put_integer(out, axes[2], '\n');
  };
  write_text_lines(file, turning.size(), 5 * kIntegerBytes, put, monitor);
  file.finish();
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include "solve/other_starts.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/parallel.hpp"
#include "crossgrain/error.hpp"
#include "crossgrain/solve.hpp"
#include "field/nested_solve.hpp"
#include "solve/carried_frames.hpp"
#include "solve/prepared_model.hpp"
#include "solve/tet_domain_data.hpp"
#include "solve/tuned_solve.hpp"

namespace crossgrain {

namespace {

/// OntoTuning::other_starts.
constexpr double kAlikeBoxes = 0.05;

bool are_alike(const Box& a, const Box& b, double share) {
  const double most = share * std::max(longest_side(a), longest_side(b));
  for (int axis = 0; axis < 3; ++axis)
    if (std::abs(a.low[axis] - b.low[axis]) > most || std::abs(a.high[axis] - b.high[axis]) > most)
      return false;
  return true;
}

/// Returns the frames of the vertices; none if the solid has parts too small for the cells.
std::vector<Quaternion> frames_on(const SolveTuning& options, const PreparedModel& model,
                                  const TetDomain& domain) {
  try {
    const SolvedField field = nested_solve(model.solid(), options, Monitor());
    return carried_frames({field.level.tree, field.frames, field.open_faces}, domain.data().solid).frames;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kInterrupted) throw;
    return {};
  }
}

}  // namespace

std::vector<StartFrames> other_starts(const TetDomain& domain, const Box& box, const SolveTuning& options) {
  const std::vector<OtherStart>& others = options.onto.other_starts;
  if (others.empty() || !options.constraints.faces.empty() || !are_alike(domain.data().box, box, kAlikeBoxes))
    return {};
  SolveTuning sized = options;
  sized.cell_size = 0;
  sized.resolution = 0;
  sized = sized_for(domain, std::move(sized));
  const PreparedModel model(domain.boundary(), sized);
  // Larger cells would be fewer than OntoTuning::fewest_cells across.
  const double largest = longest_side(model.surface().box) / options.onto.fewest_cells;
  const std::size_t vertices = domain.data().solid.mesh.vertices.size();
  std::vector<StartFrames> starts(others.size());
  const auto solve_from = [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      if (vertices > others[k].most_vertices) continue;
      SolveTuning own = sized;
      own.cell_size = std::min(others[k].cell_size * sized.cell_size, largest);
      own.solver.boundary_weight *= others[k].boundary_weight;
      starts[k] = {k + 1, frames_on(own, model, domain)};
    }
  };
  // The first grid has most of the cells; small ones do not keep two threads busy.
  run_side_by_side([&] { solve_from(0, 1); }, [&] { solve_from(1, others.size()); });
  std::erase_if(starts, [](const StartFrames& start) { return start.frames.empty(); });
  return starts;
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include <cstddef>
#include <memory>
#include <utility>

#include "hex/attempt_kinds.hpp"
#include "hex/feature_judgement.hpp"
#include "hex/lattice_search.hpp"
#include "hex/work.hpp"
#include "solve/tet_domain_data.hpp"

namespace crossgrain {
namespace {

FittingModel model_of(const TetDomain& domain) {
  if (const GivenModel* const given = domain.mesh().given.get()) return fitting_model(*given);
  return {domain.data().solid, features_of_model(domain)};
}

class LatticeAttempt : public AttemptKind {
 public:
  explicit LatticeAttempt(const HexOptions& options) : options_(options) {}

  const char* name() const override { return kLatticeKind; }
  bool is_last_resort() const override { return true; }

  std::optional<Turn> next(const AttemptQueue& queue) const override {
    if (is_made_ || !queue.start() || options_.preference == HexPreference::kMapOnly) return std::nullopt;
    return is_due_now(queue) ? Turn{} : Turn{SIZE_MAX, Turn::Step::kLattice};
  }

  std::string plan(const AttemptQueue&) const override { return "a lattice"; }

  std::vector<HexCandidate> make(AttemptQueue& queue) override {
    is_made_ = true;
    const StartingField& start = *queue.start();
    std::vector<HexAttemptEnd> ends;
    LatticeHexahedra found = lattice_hexahedra(model_of(start.field.domain()), start.size, queue.monitor(),
                                               [&](const HexAttemptEnd& end) { ends.push_back(end); });
    std::vector<HexCandidate> candidates;
    for (const HexAttempt& attempt : found.report.attempts) {
      HexCandidate& candidate = candidates.emplace_back();
      candidate.attempt = attempt;
      candidate.attempt.round = round(queue);
      candidate.attempt.work = kFittingWork * static_cast<double>(attempt.hexahedra);
      candidate.asked_size = start.size;
      const HexAttemptEnd& end = ends[candidates.size() - 1];
      candidate.text = end.text;
      if (candidates.size() < ends.size()) candidate.next = end.next;
    }
    HexCandidate& best = candidates[found.report.best_attempt];
    MadeHexahedra& made = best.made.emplace();
    made.mesh = std::exchange(found.mesh, {});
    made.quality = found.report.quality;
    made.fills = found.report.outcome != HexOutcome::kPartial || found.report.quality.inverted > 0;
    made.is_faithful = found.report.outcome == HexOutcome::kAllHex;
    best.lattice = std::make_shared<const LatticeHexahedra>(std::move(found));
    return candidates;
  }

 private:
  /// Once the first maps have led to no mesh that keeps the model: others do so seldom.
  bool is_due_now(const AttemptQueue& queue) const {
    if (options_.preference == HexPreference::kLattice) return true;
    return options_.preference != HexPreference::kMap && queue.best() != nullptr;
  }

  const HexOptions options_;
  bool is_made_ = false;
};

}  // namespace

std::unique_ptr<AttemptKind> lattice_attempt(const HexOptions& options) {
  return std::make_unique<LatticeAttempt>(options);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

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

/// Whether solids share a face that is to be kept.
bool has_faces_between_solids(const TetFrameField& field) {
  const TetSolid& solid = field.domain().data().solid;
  const std::vector<std::int32_t>& regions = solid.mesh.regions;
  const bool is_united = field.report().onto && field.report().onto->united;
  return !is_united && !regions.empty() &&
         std::ranges::any_of(solid.inner_faces, [&](const TetSolid::InnerFace& face) {
           return face.tets[1] != kNoTet && regions[face.tets[0]] != regions[face.tets[1]];
         });
}

class LatticeAttempt : public AttemptKind {
 public:
  explicit LatticeAttempt(const HexOptions& options) : options_(options) {}

  const char* name() const override { return kLatticeKind; }
  bool is_last_resort() const override { return true; }
  bool follows_field() const override { return false; }

  std::optional<Turn> next(const AttemptQueue& queue) const override {
    if (is_over_ || !queue.start() || options_.preference == HexPreference::kMapOnly) return std::nullopt;
    return is_due_now(queue) ? Turn{} : Turn{SIZE_MAX, Turn::Step::kLattice};
  }

  bool prepare(AttemptQueue& queue) override {
    is_over_ = true;  // unless it ends well
    if (!search_) {
      const StartingField& start = *queue.start();
      model_.emplace(model_of(start.field.domain()));
      asked_size_ = start.size;
      search_.emplace(*model_, start.size, queue.monitor());
    }
    is_over_ = !search_->prepare();
    return !is_over_;
  }

  std::string plan(const AttemptQueue&) const override { return search_->plan(); }

  std::vector<HexCandidate> make(AttemptQueue& queue) override {
    is_over_ = true;  // of an error too
    LatticeSearch::Trial trial = search_->make();
    is_over_ = false;
    std::vector<HexCandidate> candidates(1);
    HexCandidate& candidate = candidates.front();
    candidate.attempt = trial.attempt;
    candidate.attempt.round = round(queue);
    candidate.attempt.work =
        kFittingWork * std::max(trial.moved, static_cast<double>(trial.attempt.hexahedra));
    candidate.asked_size = asked_size_;
    candidate.text = std::move(trial.text);
    if (trial.better) {
      add_mesh(*std::move(trial.better), candidate);
      // Faces between solids are steps in it.
      candidate.made->is_faithful &= !has_faces_between_solids(queue.start()->field);
    }
    return candidates;
  }

 private:
  /// Once the first maps have led to no mesh that keeps the model: others do so seldom. Lattices that have
  /// begun go on.
  bool is_due_now(const AttemptQueue& queue) const {
    if (search_ || options_.preference == HexPreference::kLattice) return true;
    return options_.preference != HexPreference::kMap && queue.best() != nullptr;
  }

  static void add_mesh(LatticeHexahedra found, HexCandidate& candidate) {
    MadeHexahedra& made = candidate.made.emplace();
    made.mesh = std::exchange(found.mesh, {});
    made.quality = found.report.quality;
    made.fills = found.report.outcome != HexOutcome::kPartial || found.report.quality.inverted > 0;
    made.is_faithful = found.report.outcome == HexOutcome::kAllHex;
    candidate.lattice = std::make_shared<const LatticeHexahedra>(std::move(found));
  }

  const HexOptions options_;
  std::optional<FittingModel> model_;
  std::optional<LatticeSearch> search_;
  double asked_size_ = 0;
  bool is_over_ = false;
};

}  // namespace

std::unique_ptr<AttemptKind> lattice_attempt(const HexOptions& options) {
  return std::make_unique<LatticeAttempt>(options);
}

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hex/attempt_queue.hpp"
#include "meshing/asked_hexahedra.hpp"
#include "meshing/hexahedra_of_models.hpp"

namespace crossgrain {

/// Attempts at tets of one size after the other, with a field on them: each begins a round.
class MadeTets : public AttemptKind {
 public:
  /// The options, the tuning and what is asked for must outlive the object.
  MadeTets(MakeTets make, const HexMeshingOptions& options, const MeshingTuning& tuning,
           AskedHexahedra& asked)
      : make_(std::move(make)), options_(options), tuning_(tuning), asked_(asked) {}

  const char* name() const override { return "tets"; }
  std::optional<Turn> next(const AttemptQueue& queue) const override;
  std::string plan(const AttemptQueue& queue) const override;
  std::size_t round(const AttemptQueue& queue) const override { return queue.rounds(); }
  std::size_t rounds_left(const AttemptQueue& queue) const override;
  bool makes_meshes() const override { return false; }
  bool prepare(AttemptQueue& queue) override;
  std::vector<HexCandidate> make(AttemptQueue& queue) override;

 private:
  /// Tets, and the least and the largest share of the first size that makes them.
  struct Made {
    double least_share, most_share;
    TetDomain domain;
  };

  std::size_t next_share() const;
  bool may_be_new(double share) const;
  std::optional<TetDomain> next_domain(const Monitor& monitor, HexAttempt& attempt);
  std::optional<TetDomain> coarse_domain(const Monitor& monitor, HexAttempt& attempt);
  std::optional<TetDomain> domain_of(double share, bool may_be_large, const Monitor& monitor,
                                     HexAttempt& attempt);

  MakeTets make_;
  const HexMeshingOptions& options_;
  const MeshingTuning& tuning_;
  AskedHexahedra& asked_;
  std::size_t sizes_ = 0;   ///< that were tried
  std::size_t at_ = 0;      ///< the next of MeshingTuning::tet_shares
  double large_share_ = 0;  ///< this and finer sizes have too many tets
  bool has_warned_ = false;
  HexExpectation::TetSize size_;  ///< of the last tets
  std::vector<Made> made_;        ///< in all rounds
  HexAttempt next_;               ///< of the tets that are ready
  std::optional<TetDomain> next_tets_;
};

/// Returns tets ready for a solve that leads to hexahedra; those that are not are prepared for a map.
TetDomain prepared(const TetDomain& domain, const HexMeshingOptions& options);

/// Returns a mesh of tets likewise; hands its warnings out if asked to.
TetDomain domain_of(const std::function<TetMesh()>& make, const HexMeshingOptions& options, bool warns,
                    const Monitor& monitor);

/// Solves on tets, for a round of the queue. Of the first, listeners and the queue hear before what is to be
/// expected, with the size of tets that were made, and afterwards the answer about the field.
StartingField solved_on(const TetDomain& domain, const HexMeshingOptions& options, AttemptQueue& queue,
                        const HexExpectation::TetSize& made = {});

}  // namespace crossgrain

// SPDX-License-Identifier: Apache-2.0
// Hexahedra of lattices put onto a model: the sizes that are tried.
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "crossgrain/hexahedra.hpp"
#include "crossgrain/monitor.hpp"
#include "crossgrain/warning.hpp"
#include "hex/lattice_faults.hpp"
#include "hex/model_fitting.hpp"
#include "lattice/lattice.hpp"
#include "surface/surface.hpp"

namespace crossgrain {

/// Returns the surface that a lattice is cut to: that of the features, on which all solids are one.
Surface outer_surface(const FeatureComplex& features);

struct LatticeHexahedra {
  HexMesh mesh;  ///< with boundary and tags
  HexReport report;
  std::vector<Warning> warnings;
  bool has_joined = false;  ///< parts of the surface that touch or overlap, which no size separates
};

/// Hexahedra that fill a model: cells of lattices (lattice_of), fitted to its features. Where something is
/// lacking, thin walls and narrow holes get planes on both sides: they may be lost without a change of
/// topology, where a wall ends at an edge; then planes are made finer there (places_to_refine),
/// kMostRefinements times; then smaller sizes follow (kSmallerSize), until all is kept with good shapes, or
/// their cells would be more than kMostOfLattice times those of the size (and than kFew); lattices of another
/// topology than the model are left out if there is one of the same. Where the surface touches or crosses
/// itself, its shells are none that hexahedra can have: the first lattice with as many tunnels is the last.
/// Of two, all-hex is better; then the one that lacks less; then the better shaped, by classes and then by
/// the number of poor ones; then the one with fewer hexahedra.
class LatticeSearch {
 public:
  /// Model and monitor must outlive it. `size` is about that of the hexahedra.
  LatticeSearch(const FittingModel& model, double size, const Monitor& monitor);
  ~LatticeSearch();
  LatticeSearch(const LatticeSearch&) = delete;
  LatticeSearch& operator=(const LatticeSearch&) = delete;

  /// Makes the cells of the next lattice, if that is not done yet; returns whether there is one.
  bool prepare();

  /// What the next lattice is, for the user: "a lattice of 2.1, about 1200 hexahedra"; less where it could
  /// not be prepared.
  std::string plan() const;

  /// Of the lattice that is prepared: its size; and about how many hexahedra it becomes, most often within a
  /// factor of two.
  double size() const;
  double expected() const;

  struct Trial {
    HexAttempt attempt;
    std::string text;                        ///< how it ended
    std::optional<LatticeHexahedra> better;  ///< if it is better than all before; without attempts
    double moved = 0;                        ///< hexahedra that were moved all at once, in all ways
  };

  /// Fits what is prepared to the model. Throws Error(kLimit), and Error(kInterrupted) by the monitor; the
  /// lattice is over then.
  Trial make();

 private:
  struct Prepared;

  HexAttempt begin(const Prepared& prepared);
  Trial skipped(Prepared& prepared);
  Trial fitted(Prepared& prepared);
  void next_coarse();
  void choose_next(const LatticeHexahedra& last, const Prepared& prepared, bool is_better);
  void refine(std::vector<FinePlace> places);
  void give_up_level();
  double most_fitted() const;
  bool may_take(double size) const;
  bool may_be_joined(const Lattice& lattice);
  bool touches_itself();
  bool is_done() const;
  NarrowFeatures narrow_features() const;
  Lattice lattice_at(double size) const;
  void require_memory_to_fit(const Lattice& lattice) const;

  const FittingModel& model_;
  const Surface surface_;
  std::optional<bool> touches_itself_;  ///< once it is known
  const std::vector<int> shells_;
  const std::vector<Hole> holes_;
  const std::vector<std::vector<Vector3>> lines_;
  const Monitor& monitor_;
  const double asked_size_;
  double next_size_;
  const double expected_;        ///< hexahedra of the size asked for
  double fitted_ = 0;            ///< hexahedra that were moved all at once, in all ways of all lattices
  std::vector<FinePlace> fine_;  ///< of the next lattice
  int refinements_ = 0;          ///< of lattices of this size
  NarrowLevel level_ = NarrowLevel::kNothing;  ///< at least, of the next lattices
  bool is_raised_ = false;                     ///< the next lattice, of the same size, to that level
  bool has_raised_ = false;                    ///< that was tried
  std::vector<FinePlace> places_;              ///< that are refined if it does not help
  std::exception_ptr ended_;                   ///< by which there is no next lattice
  std::size_t tried_ = 0;
  std::unique_ptr<Prepared> prepared_;
  std::unique_ptr<Prepared> other_;  ///< the last of another topology, fitted only where there is no other
  std::optional<HexReport> best_;
  bool has_joined_ = false;  ///< the best
};

/// Sets what may help of what the best of lattices lacks: the size that would come next, or a smaller one
/// that is known to; none where only shapes are bad, since smaller ones were no help, and where it has joined
/// parts of the model. The report has all attempts.
void choose_remedy_of_lattices(HexReport& report, bool has_joined);

/// How often a lattice is made again with planes nearer to each other where the last one fails.
inline constexpr int kMostRefinements = 2;

/// Most hexahedra that are moved all at once, in all ways of all lattices, once there is one of the model's
/// topology: most of a minute of two cores; and once there is one that keeps all of the model.
inline constexpr double kMostFitted = 50000, kMostForShapes = 30000;

/// Most cells beside those that fill the model at the size asked for, unless they are few: a rod of one cell
/// needs 27 times as many to be round.
inline constexpr double kMostOfLattice = 12, kFew = 1500;

}  // namespace crossgrain

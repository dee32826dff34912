// SPDX-License-Identifier: Apache-2.0
// Hexahedra of an attempt put onto the features of the model.
#pragma once

#include "fit/feature_fit.hpp"
#include "hex/hex_candidate.hpp"

namespace crossgrain {

/// Gives the quads of a candidate's mesh the tags of the faces of the model, and its hexahedra their regions.
void add_tags(HexCandidate& candidate);

/// Makes a candidate's hexahedra, which fill the model, keep its features (fitted_to_features): sets its
/// mesh, with tags, what is known of it, and HexCandidate::fit. Leaves all as it is where hexahedra are not
/// fitted: in several regions, whose interfaces would be torn; of bodies that touch each other; on models of
/// more faces than are listed. Stopped and limited as watched loops say: the mesh is the best by then.
void fit(HexCandidate& candidate);

/// Does so if they are valid.
void fit_if_complete(HexCandidate& candidate);

/// Does so if hexahedra that fill the model are not all valid, and keeps what becomes valid by it: with its
/// quality, and the work and seconds that it took.
void mend_by_fitting(HexCandidate& candidate);

}  // namespace crossgrain

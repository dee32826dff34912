// SPDX-License-Identifier: Apache-2.0
// The figures of docs/method.md. Each has the same pixels every time.
#pragma once

#include "figure.hpp"

namespace crossgrain::figures {

/// The harmonics of degrees 4 and 3, with their polynomials.
Figure basis_figure();

/// A frame as it turns, and its harmonics.
Figure frames_figure();

/// What a plane asks for: harmonics with an axis along a normal, others, and what these cost.
Figure normal_figure();

/// What forms of some shapes know: their eigenvalues, and those of a crease by its angle.
Figure spectra_figure();

/// Solves of a bar that end one level after another, cut open.
Figure levels_figure();

}  // namespace crossgrain::figures

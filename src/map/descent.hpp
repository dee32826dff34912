// SPDX-License-Identifier: Apache-2.0
// Descent to a minimum of a smooth function.
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <functional>

namespace crossgrain {

struct DescentOptions {
  int steps = 60;
  double least_gain = 1e-5;  ///< of a step, relative to the value, with which the descent goes on
};

struct Descent {
  Eigen::VectorXd x;
  double first_value = 0, value = 0;
  int steps = 0;
};

/// Returns the value, and fills in the gradient, which may hold an earlier one.
using DifferentiableFunction = std::function<double(const Eigen::VectorXd& x, Eigen::VectorXd& gradient)>;

/// Makes `result` about the inverse of the function's second derivative, applied to a vector: symmetric and
/// positive. They are not the same object.
using Preconditioner = std::function<void(const Eigen::VectorXd& vector, Eigen::VectorXd& result)>;

/// Preconditioned L-BFGS from x on, with weak Wolfe conditions (Nocedal and Wright, "Numerical Optimization",
/// algorithm 7.4). The value never rises. Interrupted as the watched loops of the caller say.
Descent minimised(const DifferentiableFunction& function, const Preconditioner& preconditioner,
                  Eigen::VectorXd x, const DescentOptions& options);

}  // namespace crossgrain

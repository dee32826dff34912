// SPDX-License-Identifier: Apache-2.0
// Exact elimination of unknowns by linear equations with integer factors.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace crossgrain {

/// A sum of unknowns with integer factors, ascending by unknown, without zeros.
struct LinearForm {
  struct Term {
    std::uint32_t unknown;
    std::int64_t factor;
    bool operator==(const Term&) const = default;
  };
  std::vector<Term> terms;

  LinearForm() = default;
  LinearForm(std::uint32_t unknown, std::int64_t factor) : terms{{unknown, factor}} {}

  bool is_zero() const { return terms.empty(); }
  bool operator==(const LinearForm&) const = default;
};

/// a + factor * b. Throws Error(kLimit) if a factor exceeds 2^53, beyond which it is none in double
/// precision.
LinearForm added(const LinearForm& a, const LinearForm& b, std::int64_t factor = 1);

LinearForm multiplied(const LinearForm& a, std::int64_t factor);

inline LinearForm operator-(const LinearForm& a) {
  return multiplied(a, -1);
}

/// Unknowns and the equations between them. Where an equation leaves no factor of 1 or -1, unknowns are
/// replaced by others with smaller factors, as in Euclid's algorithm: over the integers the solutions stay
/// the same.
class IntegerElimination {
 public:
  explicit IntegerElimination(std::uint32_t unknowns) : forms_(unknowns) {}

  /// Number of unknowns, with those that were introduced.
  std::uint32_t size() const { return static_cast<std::uint32_t>(forms_.size()); }

  bool is_eliminated(std::uint32_t unknown) const { return forms_[unknown].has_value(); }

  /// The form in unknowns that are not eliminated.
  LinearForm reduced(const LinearForm& form);

  /// Makes a form zero. Of the unknowns with the factor of least size, one from `preferred` on is
  /// eliminated, if there is one, and of these the first.
  void impose(const LinearForm& form, std::uint32_t preferred = 0);

 private:
  LinearForm of_unknown(std::uint32_t unknown);

  std::vector<std::optional<LinearForm>> forms_;  ///< of the unknowns that are eliminated
};

}  // namespace crossgrain

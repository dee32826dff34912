// SPDX-License-Identifier: Apache-2.0
#include "reduction/integer_elimination.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <tuple>
#include <utility>

#include "crossgrain/error.hpp"

namespace crossgrain {
namespace {

constexpr std::int64_t kLargest = std::int64_t{1} << 53;

[[noreturn]] void refuse() {
  throw Error(ErrorKind::kLimit, "the equations between lines of the map have factors beyond 2^53");
}

std::int64_t checked(std::int64_t factor) {
  if (factor > kLargest || factor < -kLargest) refuse();
  return factor;
}

std::int64_t product(std::int64_t a, std::int64_t b) {
  // In double precision, since the product may be no number of 64 bits.
  if (std::abs(static_cast<double>(a) * static_cast<double>(b)) > static_cast<double>(kLargest)) refuse();
  return a * b;
}

}  // namespace

LinearForm added(const LinearForm& a, const LinearForm& b, std::int64_t factor) {
  LinearForm sum;
  sum.terms.reserve(a.terms.size() + b.terms.size());
  auto i = a.terms.begin();
  for (const LinearForm::Term& term : b.terms) {
    while (i != a.terms.end() && i->unknown < term.unknown) sum.terms.push_back(*i++);
    std::int64_t total = product(factor, term.factor);
    if (i != a.terms.end() && i->unknown == term.unknown) total += (i++)->factor;
    if (total != 0) sum.terms.push_back({term.unknown, checked(total)});
  }
  sum.terms.insert(sum.terms.end(), i, a.terms.end());
  return sum;
}

LinearForm multiplied(const LinearForm& a, std::int64_t factor) {
  LinearForm result;
  if (factor == 0) return result;
  for (const auto& [unknown, its_factor] : a.terms)
    result.terms.push_back({unknown, product(its_factor, factor)});
  return result;
}

LinearForm IntegerElimination::of_unknown(std::uint32_t unknown) {
  if (!forms_[unknown]) return {unknown, 1};
  const bool is_short = std::none_of(forms_[unknown]->terms.begin(), forms_[unknown]->terms.end(),
                                     [&](const auto& term) { return is_eliminated(term.unknown); });
  // Kept, so that the next one that asks has a short way.
  if (!is_short) forms_[unknown] = reduced(*std::exchange(forms_[unknown], LinearForm{}));
  return *forms_[unknown];
}

LinearForm IntegerElimination::reduced(const LinearForm& form) {
  const bool is_reduced = std::none_of(form.terms.begin(), form.terms.end(),
                                       [&](const auto& term) { return is_eliminated(term.unknown); });
  if (is_reduced) return form;
  LinearForm sum;
  for (const auto& [unknown, factor] : form.terms) sum = added(sum, of_unknown(unknown), factor);
  return sum;
}

void IntegerElimination::impose(const LinearForm& given, std::uint32_t preferred) {
  LinearForm form = reduced(given);
  while (!form.is_zero()) {
    std::int64_t divisor = 0;
    for (const auto& term : form.terms) divisor = std::gcd(divisor, term.factor);
    for (auto& term : form.terms) term.factor /= divisor;
    const auto rank = [&](const LinearForm::Term& term) {
      return std::tuple(std::abs(term.factor), term.unknown < preferred, term.unknown);
    };
    const auto pivot = *std::min_element(form.terms.begin(), form.terms.end(),
                                         [&](const auto& a, const auto& b) { return rank(a) < rank(b); });
    LinearForm rest;  // without the pivot
    for (const auto& term : form.terms)
      if (term.unknown != pivot.unknown) rest.terms.push_back(term);
    if (std::abs(pivot.factor) == 1) {
      forms_[pivot.unknown] = multiplied(rest, -pivot.factor);
      return;
    }
    // pivot = other - sum q x, with the quotients q of the rest: the rest keeps its remainders.
    forms_.emplace_back();
    LinearForm replaced(size() - 1, 1);
    form = LinearForm(size() - 1, pivot.factor);
    for (const auto& [unknown, factor] : rest.terms) {
      const std::int64_t quotient = factor / pivot.factor, remainder = factor % pivot.factor;
      if (quotient != 0) replaced = added(replaced, LinearForm(unknown, quotient), -1);
      if (remainder != 0) form = added(form, LinearForm(unknown, remainder));
    }
    forms_[pivot.unknown] = replaced;
  }
}

}  // namespace crossgrain

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// SPEC.md, "Data section": a period is proven from the text.
#include <optional>

#include "certify/second/expression.hpp"

namespace crest::recheck {

/// The value of a constant expression as a + b pi, if the rules give it.
struct Linear {
  Rational a, b;
};
std::optional<Linear> linear_in_pi(const Expression& e);

/// Whether the rules show that e is invariant under variable -> variable + 2 pi q.
bool is_invariant(const Expression& e, int variable, const Rational& q);

}  // namespace crest::recheck

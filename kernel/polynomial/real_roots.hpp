// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// All real roots of a polynomial, on the open unit interval or on the line, with multiplicities.
//
// Laws. (1) Roots increase strictly. (2) Their multiplicities are those of the polynomial; on the
// line their sum has the parity of the degree. (3) mirrored: p(-x) has the negated roots. (4) A
// positive or negative factor changes nothing.
#include <optional>
#include <span>
#include <vector>

#include "kernel/polynomial/algebraic_number.hpp"

namespace crest::kernel {

struct RealRoot {
  AlgebraicNumber value;
  int multiplicity;
};

struct RealRoots {
  /// The zero polynomial: every number is a root, none is listed.
  bool everywhere = false;
  std::vector<RealRoot> roots;
  /// triage: doubles with a proven error isolated all roots, all simple. exact: square-free factors
  /// and Descartes' rule in integers.
  Stage stage = Stage::exact;
};

/// Roots x with 0 < x < 1. A root at an end is not listed.
RealRoots unit_roots(const IntegerPolynomial& p);
/// From Bernstein coefficients on [0, 1]; nothing unless all are finite.
std::optional<RealRoots> unit_roots(std::span<const double> bernstein);

RealRoots real_roots(const IntegerPolynomial& p);

/// k with |x| < 2^k for all complex roots x (Fujiwara). Requires: degree at least 1.
long root_bound(const IntegerPolynomial& p);

}  // namespace crest::kernel

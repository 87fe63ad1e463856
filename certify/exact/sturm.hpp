// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Distinct roots of a polynomial on the unit interval, by Sturm's theorem in integers.
#include <vector>

#include "certify/exact/simplex_forms.hpp"

namespace crest::certify::modes {

/// A place in [0, 1]: numerator / 2^exponent.
struct Place {
  Integer numerator;
  unsigned exponent;
};
/// Requires: 0 <= x <= 1.
Place place(double x);
/// a + (b - a) k / 8.
Place between(const Place& a, const Place& b, unsigned k);

/// The sign of sum a_i t^i (1 - t)^(d - i).
int sign_at(const std::vector<Integer>& a, const Place& t);

/// sum a_i t^i (1 - t)^(d - i): in u = t / (1 - t) >= 0, the polynomial with these coefficients.
class Sturm {
 public:
  /// Requires: a is not empty, its first and last numbers are not 0.
  explicit Sturm(std::vector<Integer> a);

  /// No root is multiple, real or not.
  bool square_free() const { return chain_.back().size() == 1; }
  /// The greatest common divisor with the derivative.
  const std::vector<Integer>& multiple() const { return chain_.back(); }
  int sign(const Place& t) const { return modes::sign_at(chain_[0], t); }
  /// Distinct roots strictly between two places. Requires: it is not zero at either.
  int distinct(const Place& low, const Place& high) const;

 private:
  int variations(const Place& t) const;

  std::vector<std::vector<Integer>> chain_;
};

}  // namespace crest::certify::modes

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Greatest common divisors and square-free factors of integer polynomials.
#include <vector>

#include "kernel/polynomial/integer_polynomial.hpp"

namespace crest::kernel {

/// Whether a and b have no common root, decided modulo the prime 2^61 - 1: true is proven, false
/// means not decided. (Where the prime does not divide a leading coefficient, a common divisor
/// keeps its degree.) Cost: a few microseconds at degree 12.
bool coprime_modulo_prime(const IntegerPolynomial& a, const IntegerPolynomial& b);

/// Primitive, leading coefficient positive; zero iff a and b are. Cost: the primitive remainder
/// sequence, unless the prime above decides.
IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b);

/// a / b. Requires: b divides a in the integers' polynomials.
IntegerPolynomial quotient(const IntegerPolynomial& a, const IntegerPolynomial& b);

struct SquareFreeFactor {
  IntegerPolynomial p;  ///< primitive, of positive degree, only simple roots
  int multiplicity;
};
/// Yun's factorisation: p is a constant times the product of the powers. Factors are coprime,
/// multiplicities increase. Requires: p not zero.
std::vector<SquareFreeFactor> square_free_factors(const IntegerPolynomial& p);

}  // namespace crest::kernel

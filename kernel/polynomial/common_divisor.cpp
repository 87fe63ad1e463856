// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/polynomial/common_divisor.hpp"

#include <cstdint>
#include <utility>

namespace crest::kernel {
namespace {

constexpr std::uint64_t kPrime = (std::uint64_t{1} << 61) - 1;

std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  __extension__ using Wide = unsigned __int128;
  const Wide product = static_cast<Wide>(a) * b;
  const std::uint64_t sum =
      static_cast<std::uint64_t>(product & kPrime) + static_cast<std::uint64_t>(product >> 61);
  return sum >= kPrime ? sum - kPrime : sum;
}
std::uint64_t minus(std::uint64_t a, std::uint64_t b) {
  return a >= b ? a - b : a + kPrime - b;
}

using Residues = std::vector<std::uint64_t>;

void trim(Residues& c) {
  while (!c.empty() && c.back() == 0) c.pop_back();
}

Residues residues(const IntegerPolynomial& p) {
  Residues r;
  for (const Integer& x : p.coefficients()) r.push_back(mpz_fdiv_ui(x.backend().data(), kPrime));
  return r;
}

// a becomes its pseudo-remainder modulo b.
void reduce(Residues& a, const Residues& b) {
  while (a.size() >= b.size()) {
    const std::uint64_t la = a.back(), lb = b.back();
    const std::size_t shift = a.size() - b.size();
    for (std::size_t i = 0; i < a.size(); ++i) {
      a[i] = times(a[i], lb);
      if (i >= shift) a[i] = minus(a[i], times(b[i - shift], la));
    }
    trim(a);
  }
}

IntegerPolynomial pseudo_remainder(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  std::vector<Integer> r(a.coefficients().begin(), a.coefficients().end());
  const auto d = b.coefficients();
  while (r.size() >= d.size()) {
    const Integer common = gcd(r.back(), d.back());
    const Integer up = d.back() / common, down = r.back() / common;
    const std::size_t shift = r.size() - d.size();
    for (std::size_t i = 0; i < r.size(); ++i) {
      r[i] *= up;
      if (i >= shift)
        mpz_submul(r[i].backend().data(), d[i - shift].backend().data(), down.backend().data());
    }
    while (!r.empty() && r.back().is_zero()) r.pop_back();
  }
  return IntegerPolynomial(std::move(r));
}

IntegerPolynomial normal(const IntegerPolynomial& p) {
  if (p.is_zero() || p.leading() > 0) return p.primitive();
  return (IntegerPolynomial() - p).primitive();
}

}  // namespace

bool coprime_modulo_prime(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  Residues r = residues(a), s = residues(b);
  if (r.empty() || s.empty() || (r.back() == 0 && s.back() == 0)) return false;
  trim(r);
  trim(s);
  while (!s.empty()) {
    reduce(r, s);
    std::swap(r, s);
  }
  return r.size() == 1;
}

IntegerPolynomial common_divisor(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  if (coprime_modulo_prime(a, b)) return IntegerPolynomial({Integer(1)});
  IntegerPolynomial r = a.primitive(), s = b.primitive();
  while (!s.is_zero()) {
    r = pseudo_remainder(r, s).primitive();
    std::swap(r, s);
  }
  return normal(r);
}

IntegerPolynomial quotient(const IntegerPolynomial& a, const IntegerPolynomial& b) {
  if (a.is_zero()) return {};
  std::vector<Integer> r(a.coefficients().begin(), a.coefficients().end());
  const auto d = b.coefficients();
  std::vector<Integer> q(r.size() - d.size() + 1);
  for (std::size_t shift = q.size(); shift-- > 0;) {
    mpz_divexact(q[shift].backend().data(), r[shift + d.size() - 1].backend().data(),
                 d.back().backend().data());
    for (std::size_t i = 0; i < d.size(); ++i)
      mpz_submul(r[shift + i].backend().data(), d[i].backend().data(), q[shift].backend().data());
  }
  return IntegerPolynomial(std::move(q));
}

std::vector<SquareFreeFactor> square_free_factors(const IntegerPolynomial& p) {
  if (p.degree() < 1) return {};
  const IntegerPolynomial f = p.primitive(), derivative = f.derivative();
  const IntegerPolynomial g = common_divisor(f, derivative);
  if (g.degree() == 0) return {{f, 1}};
  std::vector<SquareFreeFactor> factors;
  IntegerPolynomial b = quotient(f, g);
  IntegerPolynomial d = quotient(derivative, g) - b.derivative();
  for (int multiplicity = 1; b.degree() > 0; ++multiplicity) {
    const IntegerPolynomial a = common_divisor(b, d);
    if (a.degree() > 0) factors.push_back({a, multiplicity});
    b = quotient(b, a);
    d = quotient(d, a) - b.derivative();
  }
  return factors;
}

}  // namespace crest::kernel

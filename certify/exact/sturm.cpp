// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/exact/sturm.hpp"

namespace crest::certify::modes {
namespace {

void trim(std::vector<Integer>& a) {
  while (!a.empty() && a.back() == 0) a.pop_back();
}

/// Divides by the numbers' greatest common divisor.
void make_primitive(std::vector<Integer>& a) {
  Integer divisor = 0;
  for (const Integer& x : a) divisor = gcd(divisor, x);
  if (divisor > 1)
    for (Integer& x : a) x /= divisor;
}

/// A positive multiple of the remainder's negative.
std::vector<Integer> negative_remainder(std::vector<Integer> a, const std::vector<Integer>& b) {
  const Integer lead = abs(b.back());
  const bool minus = b.back() < 0;
  while (a.size() >= b.size()) {
    // lead a - (sign of b's lead) a's lead u^k b: its lead is 0.
    const Integer factor = minus ? Integer(-a.back()) : a.back();
    const std::size_t shift = a.size() - b.size();
    for (Integer& x : a) x *= lead;
    for (std::size_t i = 0; i < b.size(); ++i) a[i + shift] -= factor * b[i];
    a.pop_back();
    trim(a);
  }
  for (Integer& x : a) x = -x;
  make_primitive(a);
  return a;
}

}  // namespace

Place place(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const Integer mantissa = static_cast<long long>(std::ldexp(fraction, 53));
  exponent -= 53;
  if (exponent >= 0) return {mantissa << static_cast<unsigned>(exponent), 0};
  if (mantissa == 0) return {mantissa, 0};
  const unsigned zeros = std::min(static_cast<unsigned>(lsb(Integer(abs(mantissa)))),
                                  static_cast<unsigned>(-exponent));
  return {mantissa >> zeros, static_cast<unsigned>(-exponent) - zeros};
}

Place between(const Place& a, const Place& b, unsigned k) {
  const unsigned exponent = std::max(a.exponent, b.exponent);
  const Integer x = a.numerator << (exponent - a.exponent);
  const Integer y = b.numerator << (exponent - b.exponent);
  return {x * (8 - k) + y * k, exponent + 3};
}

Sturm::Sturm(std::vector<Integer> a) {
  make_primitive(a);
  std::vector<Integer> derivative;
  for (std::size_t i = 1; i < a.size(); ++i) derivative.push_back(a[i] * static_cast<unsigned>(i));
  make_primitive(derivative);
  chain_.push_back(std::move(a));
  while (!derivative.empty()) {
    chain_.push_back(std::move(derivative));
    derivative = negative_remainder(chain_[chain_.size() - 2], chain_.back());
  }
}

int sign_at(const std::vector<Integer>& a, const Place& t) {
  const Integer rest = (Integer(1) << t.exponent) - t.numerator;
  // Horner's rule in both: sum a_i p^i q^(d - i).
  Integer sum = 0, power = 1;
  for (std::size_t i = a.size(); i-- > 0;) {
    sum = sum * t.numerator + a[i] * power;
    power *= rest;
  }
  return sum > 0 ? 1 : sum < 0 ? -1 : 0;
}

int Sturm::variations(const Place& t) const {
  int count = 0, last = 0;
  for (const auto& a : chain_) {
    const int sign = sign_at(a, t);
    if (sign == 0) continue;
    count += last * sign < 0;
    last = sign;
  }
  return count;
}

int Sturm::distinct(const Place& low, const Place& high) const {
  return variations(low) - variations(high);
}

}  // namespace crest::certify::modes

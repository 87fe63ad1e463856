// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Taylor coefficients of the functions of expressions, for balls, intervals and models alike.
#include <vector>

#include "certify/second/interval.hpp"

namespace crest::recheck {

struct Function {
  enum class Kind { inverse, sqrt, exp, log, sin, cos, power } kind;
  unsigned exponent = 0;  ///< of a power, at least 1
};

template <class T>
T value_of(const Function& f, const T& x) {
  switch (f.kind) {
    case Function::Kind::inverse:
      return inverse(x);
    case Function::Kind::sqrt:
      return sqrt(x);
    case Function::Kind::exp:
      return exp(x);
    case Function::Kind::log:
      return log(x);
    case Function::Kind::sin:
      return sin(x);
    case Function::Kind::cos:
      return cos(x);
    case Function::Kind::power:
      break;
  }
  return power(x, f.exponent);
}

inline Ball applied(const Function& f, const Ball& x) {
  return value_of(f, x);
}
inline Interval applied(const Function& f, const Interval& x) {
  return value_of(f, x);
}

/// f^(k)(x) / k! for k <= n.
/// Throws: Undefined where f is not defined, or for n > 0 not analytic.
template <class T>
std::vector<T> series(const Function& f, const T& x, int n) {
  using Kind = Function::Kind;
  std::vector<T> c = {value_of(f, x)};
  if (n == 0) return c;
  const bool rational = f.kind == Kind::inverse || f.kind == Kind::sqrt || f.kind == Kind::log;
  const T q = rational ? inverse(x) : T();
  T other;  // the derivative of sin and cos, the powers of 1 / x for log
  if (f.kind == Kind::sin) other = cos(x);
  if (f.kind == Kind::cos) other = -sin(x);
  if (f.kind == Kind::log) other = q;
  slong binomial = 1;
  for (int k = 1; k <= n; ++k) {
    switch (f.kind) {
      case Kind::inverse:
        c.push_back(-(c.back() * q));
        break;
      case Kind::sqrt:
        c.push_back(scaled(c.back() * q, 3 - 2 * k, 2 * k));
        break;
      case Kind::exp:
        c.push_back(scaled(c.back(), 1, k));
        break;
      case Kind::log:
        c.push_back(scaled(other, k % 2 == 1 ? 1 : -1, k));
        other = other * q;
        break;
      case Kind::sin:
      case Kind::cos:
        c.push_back(k == 1 ? other : scaled(c[static_cast<std::size_t>(k) - 2], -1, k * (k - 1)));
        break;
      case Kind::power: {
        const slong left = static_cast<slong>(f.exponent) - k;
        binomial = left < 0 ? 0 : binomial * (left + 1) / k;
        if (left < 0)
          c.emplace_back();
        else if (left == 0)
          c.emplace_back(1.0);
        else
          c.push_back(scaled(power(x, static_cast<unsigned>(left)), binomial));
        break;
      }
    }
  }
  return c;
}

}  // namespace crest::recheck

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Homogeneous polynomials on a simplex, in barycentrics, over doubles with one error bound for all
// coefficients, over eight such at once (lanes), or over integers. A coefficient is that of a
// monomial: the Bernstein coefficient times a positive number, so that products need no division
// and signs are the same.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "kernel/arithmetic/lanes.hpp"
#include "kernel/arithmetic/rational.hpp"

namespace crest::certify::modes {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;

/// Monomials of degree d in n variables.
constexpr std::size_t monomials(std::size_t n, std::size_t d) {
  std::size_t count = 1;
  for (std::size_t i = 1; i < n; ++i) count = count * (d + i) / i;
  return count;
}

template <std::size_t n>
using Exponents = std::array<std::uint8_t, n>;

/// Exponents of all monomials, the first variable's falling first: place 0 is b0^d.
template <std::size_t n, std::size_t d>
constexpr auto all_exponents() {
  std::array<Exponents<n>, monomials(n, d)> list{};
  Exponents<n> e{};
  e[0] = d;
  for (auto& entry : list) {
    entry = e;
    std::size_t i = n - 1;  // past the last variable but one that can give
    while (i > 0 && e[i - 1] == 0) --i;
    if (i == 0) break;
    const std::uint8_t rest = e[n - 1];
    e[n - 1] = 0;
    --e[i - 1];
    e[i] = static_cast<std::uint8_t>(rest + 1);
  }
  return list;
}

template <std::size_t n>
constexpr std::size_t place_of(const Exponents<n>& e) {
  // Monomials before it: those with a larger exponent in the first variable where they differ.
  std::size_t place = 0, rest = 0;
  for (std::size_t i = n - 1; i > 0; --i) {
    rest += e[i];
    if (rest > 0) place += monomials(n - i + 1, rest - 1);
  }
  return place;
}

/// Places of the monomials' products.
template <std::size_t n, std::size_t a, std::size_t b>
constexpr auto product_places() {
  std::array<std::array<std::uint8_t, monomials(n, b)>, monomials(n, a)> table{};
  const auto left = all_exponents<n, a>();
  const auto right = all_exponents<n, b>();
  for (std::size_t i = 0; i < left.size(); ++i)
    for (std::size_t j = 0; j < right.size(); ++j) {
      Exponents<n> e = left[i];
      for (std::size_t k = 0; k < n; ++k) e[k] = static_cast<std::uint8_t>(e[k] + right[j][k]);
      table[i][j] = static_cast<std::uint8_t>(place_of<n>(e));
    }
  return table;
}

using kernel::Lanes;
inline Lanes& operator+=(Lanes& a, const Lanes& b) {
  return a = a + b;
}

/// An error bound: one a lane.
template <class Number>
using Bound = std::conditional_t<std::is_same_v<Number, Lanes>, Lanes, double>;

/// For doubles, |coefficient - exact| <= error, for all; error is infinite or not a number where
/// that is not known.
template <class Number, std::size_t n, std::size_t d>
struct Form {
  std::array<Number, monomials(n, d)> c{};
  Bound<Number> error = 0;
};

inline constexpr double kUnit = 0x1p-53;
/// What roundings of a bound and underflow below it may lose.
template <class Number>
Number widened(const Number& bound) {
  return bound * 1.001 + 0x1p-900;
}

template <class Number>
inline constexpr bool kApproximate =
    std::is_same_v<Number, double> || std::is_same_v<Number, Lanes>;

template <class Number, std::size_t n, std::size_t d>
Number largest(const Form<Number, n, d>& a) {
  Number most = 0;
  for (const Number& x : a.c) most = kernel::larger(most, kernel::magnitude(x));
  return most;
}
template <class Number, std::size_t n, std::size_t d>
Number total(const Form<Number, n, d>& a) {
  Number sum = 0;
  for (const Number& x : a.c) sum += kernel::magnitude(x);
  return sum;
}

/// A coefficient of the product is a sum of at most k = min(count, count) products; with |a|_1 the
/// sum and |b| the largest of the absolute values,
///   |error| <= ea |b|_1 + eb (|a|_1 + count ea) + (k + 1) u (1 + ...) |a|_1 |b|.
template <class Number, std::size_t n, std::size_t a, std::size_t b>
Form<Number, n, a + b> operator*(const Form<Number, n, a>& x, const Form<Number, n, b>& y) {
  static constexpr auto places = product_places<n, a, b>();
  Form<Number, n, a + b> z;
  for (std::size_t i = 0; i < x.c.size(); ++i)
    for (std::size_t j = 0; j < y.c.size(); ++j) z.c[places[i][j]] += x.c[i] * y.c[j];
  if constexpr (kApproximate<Number>) {
    const Number sum = total(x) + static_cast<double>(x.c.size()) * x.error;
    const double terms = static_cast<double>(std::min(x.c.size(), y.c.size()) + 2);
    z.error = widened(x.error * total(y) + y.error * sum + terms * kUnit * sum * largest(y));
  }
  return z;
}

template <class Number, std::size_t n, std::size_t d>
Form<Number, n, d> operator+(const Form<Number, n, d>& x, const Form<Number, n, d>& y) {
  Form<Number, n, d> z;
  for (std::size_t i = 0; i < z.c.size(); ++i) z.c[i] = x.c[i] + y.c[i];
  if constexpr (kApproximate<Number>) z.error = widened(x.error + y.error + kUnit * largest(z));
  return z;
}
template <class Number, std::size_t n, std::size_t d>
Form<Number, n, d> operator-(const Form<Number, n, d>& x, const Form<Number, n, d>& y) {
  Form<Number, n, d> z;
  for (std::size_t i = 0; i < z.c.size(); ++i) z.c[i] = x.c[i] - y.c[i];
  if constexpr (kApproximate<Number>) z.error = widened(x.error + y.error + kUnit * largest(z));
  return z;
}
/// The factor may be wrong by `relative`.
template <class Number, std::size_t n, std::size_t d>
Form<Number, n, d> scaled(const Number& factor, const Form<Number, n, d>& x, double relative = 0) {
  Form<Number, n, d> z;
  for (std::size_t i = 0; i < z.c.size(); ++i) z.c[i] = factor * x.c[i];
  if constexpr (kApproximate<Number>)
    z.error = widened(kernel::magnitude(factor) * x.error * (1 + relative) +
                      (relative + 2 * kUnit) * largest(z));
  return z;
}

/// What the coefficients say of a form on the closed simplex (SPEC.md, H4).
enum class Hull : std::uint8_t {
  positive,     ///< all >= 0, those of the corners > 0: the form is positive
  nonnegative,  ///< all >= 0
  negative,     ///< all <= 0, those of the corners < 0
  mixed,        ///< neither
  unknown       ///< the errors are too large
};

/// Certainly positive; negative. Not so if the error is infinite or not a number.
template <class Number>
bool certainly_above(const Number& x, double error) {
  if constexpr (kApproximate<Number>)
    return x > error;
  else
    return x > 0;
}
template <class Number>
bool certainly_below(const Number& x, double error) {
  if constexpr (kApproximate<Number>)
    return x < -error;
  else
    return x < 0;
}

/// What is certain of a form's coefficients: counts.
struct CoefficientSigns {
  std::int64_t above = 0, below = 0, open = 0;
  std::int64_t corners_above = 0, corners_below = 0;

  Hull hull(std::size_t corners) const {
    const auto all = static_cast<std::int64_t>(corners);
    if (above > 0 && below > 0) return Hull::mixed;
    if (open > 0) return Hull::unknown;
    if (corners_above == all) return Hull::positive;
    if (corners_below == all) return Hull::negative;
    return below > 0 ? Hull::mixed : Hull::nonnegative;
  }
};

/// Whether coefficient i is that of a corner.
template <std::size_t n, std::size_t d>
constexpr auto corner_places() {
  std::array<bool, monomials(n, d)> corner{};
  constexpr auto exponents = all_exponents<n, d>();
  for (std::size_t i = 0; i < corner.size(); ++i)
    for (const auto e : exponents[i]) corner[i] |= e == d;
  return corner;
}

template <class Number, std::size_t n, std::size_t d>
Hull hull(const Form<Number, n, d>& f) {
  constexpr auto corner = corner_places<n, d>();
  CoefficientSigns signs;
  for (std::size_t i = 0; i < f.c.size(); ++i) {
    const bool above = certainly_above(f.c[i], f.error), below = certainly_below(f.c[i], f.error);
    signs.above += above, signs.below += below;
    signs.open += kApproximate<Number> && !above && !below;
    signs.corners_above += corner[i] && above, signs.corners_below += corner[i] && below;
  }
  return signs.hull(n);
}

/// Of each lane.
using Hulls = std::array<Hull, Lanes::count>;
template <std::size_t n, std::size_t d>
Hulls hulls(const Form<Lanes, n, d>& f) {
  constexpr auto corner = corner_places<n, d>();
  using Counts = std::array<std::int64_t, Lanes::count>;
  Counts above{}, below{}, open{}, corners_above{}, corners_below{};
  for (std::size_t i = 0; i < f.c.size(); ++i)
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      const double x = f.c[i].x[lane], error = f.error.x[lane];
      const std::int64_t up = x > error ? 1 : 0, down = x < -error ? 1 : 0;
      above[lane] += up, below[lane] += down, open[lane] += 1 - (up | down);
      if (corner[i]) corners_above[lane] += up, corners_below[lane] += down;
    }
  Hulls found;
  for (std::size_t lane = 0; lane < Lanes::count; ++lane)
    found[lane] = CoefficientSigns{above[lane], below[lane], open[lane], corners_above[lane],
                                   corners_below[lane]}
                      .hull(n);
  return found;
}

}  // namespace crest::certify::modes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/lines.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/modes/forms.hpp"
#include "algorithms/modes/mode_function.hpp"
#include "kernel/polynomial/descartes.hpp"
#include "kernel/polynomial/real_roots.hpp"

namespace crest::modes {

using kernel::AlgebraicNumber;
using kernel::Dyadic;
using kernel::IntegerPolynomial;
using kernel::Rational;
using kernel::Sign;

namespace {

/// Bernstein coefficients of a polynomial on a segment, each within `error` of the exact one.
struct Segment {
  std::array<double, 7> b{};
  std::size_t count = 0;
  double error = 0;

  template <class B>
  explicit Segment(const kernel::Form<Real, B>& f) : count(B::count), error(f.error) {
    double size = 0;
    for (std::size_t i = 0; i < count; ++i) {
      b[i] = f.s[i] / B::weights[i];
      size = std::fmax(size, std::fabs(b[i]));
    }
    // The division, and twice n levels of averages (at, on), n <= 6, three roundings each.
    error += 48 * kernel::kUnitRoundoff * size + 0x1p-1000;
  }
  double value(double t) const {
    auto c = b;
    for (std::size_t level = 1; level < count; ++level)
      for (std::size_t k = 0; k + level < count; ++k) c[k] = (1 - t) * c[k] + t * c[k + 1];
    return c[0];
  }
  kernel::MaybeSign at(double t) const {
    const double x = value(t);
    if (x > error) return Sign::positive;
    if (x < -error) return Sign::negative;
    return std::nullopt;
  }
  /// A sign on all of [low, high], if the coefficients there show one.
  kernel::MaybeSign on(double low, double high) const {
    auto c = b;
    for (std::size_t level = 1; level < count; ++level)  // to [low, 1]
      for (std::size_t k = 0; k + level < count; ++k) c[k] = (1 - low) * c[k] + low * c[k + 1];
    const double t = (high - low) / (1 - low);
    // To [low, high]: the left part, a column at a time from the right.
    for (std::size_t level = 1; level < count; ++level)
      for (std::size_t k = count - 1; k >= level; --k) c[k] = (1 - t) * c[k - 1] + t * c[k];
    bool positive = true, negative = true;
    for (std::size_t k = 0; k < count; ++k) {
      positive = positive && c[k] > error;
      negative = negative && c[k] < -error;
    }
    if (positive) return Sign::positive;
    if (negative) return Sign::negative;
    return std::nullopt;
  }
};

IntegerPolynomial from_form(const auto& form) {
  using B = typename std::decay_t<decltype(form)>::Basis;
  constexpr long kMultiple = 60;  // of all weights of degrees 3 and 6
  std::vector<Integer> b;
  for (std::size_t i = 0; i < B::count; ++i)
    b.push_back(form.s[i] * (kMultiple / static_cast<long>(B::weights[i])));
  return IntegerPolynomial::from_bernstein(b);
}

Side side_of(const Level& level, Sign det) {
  if (level.neutral()) return Side::neutral;
  return det == Sign::positive ? Side::plus : Side::minus;
}

}  // namespace

struct Lines::Polynomials {
  Segment f, c;
};

Index Lines::add(Index a, Index b) {
  lines_.push_back({a, b, false, {}});
  return static_cast<Index>(lines_.size() - 1);
}

const std::vector<Index>& Lines::roots(Index line) {
  if (!lines_[line].known) {
    isolate(line);
    lines_[line].known = true;
  }
  return lines_[line].roots;
}

void Lines::isolate(Index line) {
  const auto [a, b, known, roots] = lines_[line];
  const auto forms = real_forms<1>({vertices_.tensor(a), vertices_.tensor(b)});
  const Segment c(forms.c);
  const bool found =
      isolate_in_doubles(line, {level_.neutral() ? c : Segment(level_form(forms, level_)), c});
  if (!found) {
    lines_[line].roots.clear();
    isolate_exactly(line);
  }
  separate(line);
}

/// Near the root, where the mode itself crosses its level in doubles.
double Lines::crossing(Index line, const Root& r) const {
  const Symmetric &a = vertices_.tensor(lines_[line].a).t, &b = vertices_.tensor(lines_[line].b).t;
  const ModeFunction function(level_, r.side);
  // Above the level is f > 0, on the minus side f < 0.
  const bool falls = (r.shift > 0) == (r.side != Side::minus);
  double low = r.low, high = r.high;
  for (int i = 0; i < 60; ++i) {
    const double t = 0.5 * (low + high);
    if (!(t > low && t < high)) break;
    Symmetric x;
    for (std::size_t k = 0; k < 6; ++k) x[k] = (1 - t) * a[k] + t * b[k];
    ((function.height(x) > 0) == falls ? low : high) = t;
  }
  return 0.5 * (low + high);
}

bool Lines::isolate_in_doubles(Index line, const Polynomials& p) {
  const auto places = kernel::triage_unit_places({p.f.b.data(), p.f.count}, p.f.error);
  if (!places) return false;
  const auto kept = roots_.size();
  const auto fail = [&] {
    roots_.resize(kept);
    return false;
  };
  for (const auto& [low, high] : *places) {
    Root r{line, Side::neutral, 0, low, high, 0, {}};
    const auto before = p.f.at(low);
    if (!before) return fail();
    r.shift = *before == Sign::positive ? 1 : -1;
    for (int i = 0; i < 60; ++i) {
      const double t = 0.5 * (r.low + r.high);
      if (!(t > r.low && t < r.high)) break;
      const auto s = p.f.at(t);
      if (!s) break;
      (*s == *before ? r.low : r.high) = t;
    }
    if (!level_.neutral()) {
      const auto det = p.c.on(r.low, r.high);
      if (!det) return fail();
      r.side = side_of(level_, *det);
    }
    r.t = crossing(line, r);
    lines_[line].roots.push_back(static_cast<Index>(roots_.size()));
    roots_.push_back(std::move(r));
  }
  return true;
}

void Lines::add_root(Index line, Side side, int shift, AlgebraicNumber place) {
  place.refine(64);
  const auto [low, high] = place.bracket();
  lines_[line].roots.push_back(static_cast<Index>(roots_.size()));
  roots_.push_back({line, side, static_cast<std::int8_t>(shift), low, high, 0.5 * (low + high),
                    std::move(place)});
}

IntegerPolynomial Lines::polynomial(Index line) {
  const auto forms = integer_forms<1>(vertices_.exact(std::array{lines_[line].a, lines_[line].b}));
  return level_.neutral() ? from_form(forms.c) : from_form(level_form(forms, level_));
}

void Lines::isolate_exactly(Index line) {
  const Index ends[2] = {lines_[line].a, lines_[line].b};
  const auto forms = integer_forms<1>(vertices_.exact(std::array{ends[0], ends[1]}));
  const IntegerPolynomial c = from_form(forms.c), f = polynomial(line);
  if (f.is_zero()) return;
  const PointSigns at[2] = {vertices_.signs(ends[0]), vertices_.signs(ends[1])};
  Sign now = at[0].f;
  if (now == Sign::zero) {
    for (const Integer& x : kernel::bernstein_coefficients(f))
      if (now == Sign::zero) now = kernel::sign_of(x);
    if (now == Sign::negative)
      add_root(line, side_of(level_, at[0].det), 1, AlgebraicNumber(Rational(0)));
  }
  for (const kernel::RealRoot& r : kernel::unit_roots(f).roots) {
    const Side side =
        level_.neutral() ? Side::neutral : side_of(level_, kernel::sign_at(c, r.value).sign);
    if (r.multiplicity % 2 == 1) {
      add_root(line, side, now == Sign::positive ? 1 : -1, r.value);
      now = -now;
    } else if (now == Sign::negative) {
      add_root(line, side, -1, r.value);
      add_root(line, side, 1, r.value);
    }
  }
  if (at[1].f == Sign::zero && now == Sign::negative)
    add_root(line, side_of(level_, at[1].det), -1, AlgebraicNumber(Rational(1)));
}

/// Output parameters increase strictly inside the line: roots at one place, or at an end, or so
/// near that doubles do not separate them, share the room there is.
void Lines::separate(Index line) {
  const auto& list = lines_[line].roots;
  constexpr double room = 1e-9;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Root& r = roots_[list[i]];
    if (r.number && r.number->rational()) {
      const bool alone = r.t > 0 && r.t < 1 && (i == 0 || roots_[list[i - 1]].t < r.t) &&
                         (i + 1 == list.size() || roots_[list[i + 1]].t > r.t);
      if (!alone) r.t += r.shift * room;
    }
  }
  double last = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Root& r = roots_[list[i]];
    const double most = i + 1 < list.size() ? std::fmin(1, roots_[list[i + 1]].t) : 1;
    if (!(r.t > last)) r.t = 0.5 * (last + std::fmax(most, std::nextafter(last, 2)));
    r.t = std::fmin(r.t, std::nextafter(1, 0));
    last = r.t;
  }
}

AlgebraicNumber& Lines::number(Index root) {
  Root& r = roots_[root];
  if (!r.number)
    r.number.emplace(std::make_shared<const IntegerPolynomial>(polynomial(r.line).primitive()),
                     kernel::dyadic(r.low), kernel::dyadic(r.high));
  return *r.number;
}

Sign Lines::compare_place(Index root, const Dyadic& t) {
  const Root& r = roots_[root];
  if (r.high < t.lower()) return Sign::negative;
  if (r.low > t.upper()) return Sign::positive;
  return kernel::compare(number(root), t.value());
}

bool Lines::is_below(Index root, const Dyadic& t) {
  const Sign s = compare_place(root, t);
  return s == Sign::negative || (s == Sign::zero && roots_[root].shift < 0);
}

std::array<Rational, 2> Lines::bounds(Index root, long bits) {
  AlgebraicNumber& x = number(root);
  if (!x.rational()) x.refine(bits);
  if (x.rational()) return {*x.rational(), *x.rational()};
  return {x.low().value(), x.high().value()};
}

}  // namespace crest::modes

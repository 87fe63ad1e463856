// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/modes/lines.hpp"

#include <tbb/blocked_range.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "algorithms/modes/forms.hpp"
#include "algorithms/modes/mode_function.hpp"
#include "kernel/geometry/parallel.hpp"
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
template <std::size_t count>
struct Segment {
  std::array<double, count> b{};
  double error = 0;

  template <class B>
  explicit Segment(const kernel::Form<Real, B>& f) : error(f.error) {
    static_assert(B::count == count);
    double size = 0;
    for (std::size_t i = 0; i < count; ++i) {
      b[i] = f.s[i] / B::weights[i];
      size = std::fmax(size, std::fabs(b[i]));
    }
    // The division, and twice n levels of averages (at, on), n <= 6, three roundings each.
    error += 48 * kernel::kUnitRoundoff * size + 0x1p-1000;
  }
  double value(double t) const { return averaged<count - 1>(b, t)[0]; }
  kernel::MaybeSign at(double t) const {
    const double x = value(t);
    if (x > error) return Sign::positive;
    if (x < -error) return Sign::negative;
    return std::nullopt;
  }
  /// At t, with the derivative over the degree.
  std::array<double, 2> value_and_slope(double t) const {
    const auto c = averaged<count - 2>(b, t);
    return {(1 - t) * c[0] + t * c[1], c[1] - c[0]};
  }
  /// The coefficients on [low, high].
  std::array<double, count> part(double low, double high) const {
    auto c = b;
    for (std::size_t level = 1; level < count; ++level)  // to [low, 1]
      for (std::size_t k = 0; k + level < count; ++k) c[k] = (1 - low) * c[k] + low * c[k + 1];
    const double t = (high - low) / (1 - low);
    // To [low, high]: the left part, a column at a time from the right.
    for (std::size_t level = 1; level < count; ++level)
      for (std::size_t k = count - 1; k >= level; --k) c[k] = (1 - t) * c[k - 1] + t * c[k];
    return c;
  }
  /// A sign on all of [low, high], if the coefficients there show one.
  kernel::MaybeSign on(double low, double high) const {
    const auto c = part(low, high);
    bool positive = true, negative = true;
    for (std::size_t k = 0; k < count; ++k) {
      positive = positive && c[k] > error;
      negative = negative && c[k] < -error;
    }
    if (positive) return Sign::positive;
    if (negative) return Sign::negative;
    return std::nullopt;
  }
  /// 1, -1: increasing, decreasing on [low, high], as coefficients show; 0: they do not.
  int growth(double low, double high) const {
    const auto c = part(low, high);
    bool rises = true, falls = true;
    for (std::size_t k = 1; k < count; ++k) {
      rises = rises && c[k] - c[k - 1] > 2.01 * error;
      falls = falls && c[k - 1] - c[k] > 2.01 * error;
    }
    return rises ? 1 : falls ? -1 : 0;
  }

 private:
  /// That many levels of de Casteljau's scheme, each in registers of its own.
  template <std::size_t levels, std::size_t n>
  static std::array<double, n - levels> averaged(const std::array<double, n>& c, double t) {
    if constexpr (levels == 0) {
      return c;
    } else {
      std::array<double, n - 1> d;
      for (std::size_t k = 0; k + 1 < n; ++k) d[k] = (1 - t) * c[k] + t * c[k + 1];
      return averaged<levels - 1>(d, t);
    }
  }
};

/// Places around the one root in (low, high) up to which, and from which on, at() is certain.
/// Where the polynomial is monotonic, a value of more than three errors says so: between it and
/// the stored coefficients' polynomial there is one at most.
template <std::size_t count>
std::pair<double, double> certain_up_to(const Segment<count>& f, double low, double high) {
  const int growth = f.growth(low, high);
  if (growth == 0) return {low, high};
  double t = 0.5 * (low + high), slope = 0;
  for (int i = 0; i < 8; ++i) {
    const auto [value, s] = f.value_and_slope(t);
    slope = static_cast<double>(count - 1) * s;
    if (std::fabs(value) <= f.error) break;
    const double next = t - value / slope;
    t = next > low && next < high ? next : 0.5 * (t + (value * growth > 0 ? low : high));
  }
  double room = 4 * f.error / std::fabs(slope);
  double up_to = low, from = high;
  for (int i = 0; i < 3 && (up_to == low || from == high); ++i, room *= 8) {
    const double a = t - room, b = t + room;
    if (up_to == low && a > low && f.value(a) * growth < -3 * f.error) up_to = a;
    if (from == high && b < high && f.value(b) * growth > 3 * f.error) from = b;
  }
  return {up_to, from};
}

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

Index Lines::add(Index a, Index b) {
  lines_.push_back({a, b});
  return static_cast<Index>(lines_.size() - 1);
}

Lines::RootList Lines::isolated(Index line) {
  const Index a = lines_[line].a, b = lines_[line].b;
  const auto forms = real_forms<1>({vertices_.tensor(a), vertices_.tensor(b)});
  const Segment<4> c(forms.c);
  RootList roots;
  const bool done = level_.neutral()
                        ? isolate_in_doubles(line, c, c, roots)
                        : isolate_in_doubles(line, Segment<7>(level_form(forms, level_)), c, roots);
  if (!done) roots = isolate_exactly(line);
  separate(roots);
  return roots;
}

void Lines::isolate(std::span<const Index> lines) {
  std::vector<RootList> found(lines.size());
  if (lines.size() == 1)
    found[0] = isolated(lines[0]);
  else
    kernel::parallel_for(tbb::blocked_range<std::size_t>(0, lines.size(), 64),
                         [&](const auto& range) {
                           for (std::size_t i = range.begin(); i < range.end(); ++i)
                             found[i] = isolated(lines[i]);
                         });
  for (std::size_t i = 0; i < lines.size(); ++i) {
    Line& line = lines_[lines[i]];
    line.known = true;
    line.roots = {static_cast<Index>(roots_.size()), static_cast<Index>(found[i].size())};
    for (Root& root : found[i]) roots_.push_back(std::move(root));
  }
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

template <class F, class C>
bool Lines::isolate_in_doubles(Index line, const F& f, const C& c, RootList& roots) const {
  const auto places = kernel::triage_unit_places({f.b.data(), f.b.size()}, f.error);
  if (!places) return false;
  for (const auto& [low, high] : *places) {
    Root r{line, Side::neutral, 0, low, high, 0, {}};
    const auto before = f.at(low);
    if (!before) return false;
    r.shift = *before == Sign::positive ? 1 : -1;
    double up_to = low, from = high;
    bool narrow = false;
    for (int i = 0; i < 60; ++i) {
      if (!narrow && (i == 0 || i == 3 || i == 6)) {
        std::tie(up_to, from) = certain_up_to(f, r.low, r.high);
        narrow = up_to > r.low || from < r.high;
      }
      const double t = 0.5 * (r.low + r.high);
      if (!(t > r.low && t < r.high)) break;
      const auto s = t <= up_to ? before : t >= from ? kernel::MaybeSign(-*before) : f.at(t);
      if (!s) break;
      (*s == *before ? r.low : r.high) = t;
    }
    if (!level_.neutral()) {
      const auto det = c.on(r.low, r.high);
      if (!det) return false;
      r.side = side_of(level_, *det);
    }
    r.t = crossing(line, r);
    roots.push_back(std::move(r));
  }
  return true;
}

IntegerPolynomial Lines::polynomial(Index line) {
  const auto forms = integer_forms<1>(vertices_.exact(std::array{lines_[line].a, lines_[line].b}));
  return level_.neutral() ? from_form(forms.c) : from_form(level_form(forms, level_));
}

Lines::RootList Lines::isolate_exactly(Index line) {
  RootList roots;
  const auto add = [&](Side side, int shift, AlgebraicNumber place) {
    place.refine(64);
    const auto [low, high] = place.bracket();
    roots.push_back({line, side, static_cast<std::int8_t>(shift), low, high, 0.5 * (low + high),
                     std::move(place)});
  };
  const Index ends[2] = {lines_[line].a, lines_[line].b};
  const auto forms = integer_forms<1>(vertices_.exact(std::array{ends[0], ends[1]}));
  const IntegerPolynomial c = from_form(forms.c), f = polynomial(line);
  if (f.is_zero()) return roots;
  const PointSigns at[2] = {vertices_.signs(ends[0]), vertices_.signs(ends[1])};
  Sign now = at[0].f;
  if (now == Sign::zero) {
    for (const Integer& x : kernel::bernstein_coefficients(f))
      if (now == Sign::zero) now = kernel::sign_of(x);
    if (now == Sign::negative) add(side_of(level_, at[0].det), 1, AlgebraicNumber(Rational(0)));
  }
  for (const kernel::RealRoot& r : kernel::unit_roots(f).roots) {
    const Side side =
        level_.neutral() ? Side::neutral : side_of(level_, kernel::sign_at(c, r.value).sign);
    if (r.multiplicity % 2 == 1) {
      add(side, now == Sign::positive ? 1 : -1, r.value);
      now = -now;
    } else if (now == Sign::negative) {
      add(side, -1, r.value);
      add(side, 1, r.value);
    }
  }
  if (at[1].f == Sign::zero && now == Sign::negative)
    add(side_of(level_, at[1].det), -1, AlgebraicNumber(Rational(1)));
  return roots;
}

/// Output parameters increase strictly inside the line: roots at one place, or at an end, or so
/// near that doubles do not separate them, share the room there is.
void Lines::separate(RootList& list) {
  constexpr double room = 1e-13;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Root& r = list[i];
    if (r.number && r.number->rational()) {
      const bool alone = r.t > 0 && r.t < 1 && (i == 0 || list[i - 1].t < r.t) &&
                         (i + 1 == list.size() || list[i + 1].t > r.t);
      if (!alone) r.t += r.shift * room;
    }
  }
  double last = 0;
  for (std::size_t i = 0; i < list.size(); ++i) {
    Root& r = list[i];
    const double most = i + 1 < list.size() ? std::fmin(1, list[i + 1].t) : 1;
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
  // What an order has needed, the certificate states.
  const auto [low, high] = x.bracket();
  roots_[root].low = std::fmax(roots_[root].low, low);
  roots_[root].high = std::fmin(roots_[root].high, high);
  if (x.rational()) return {*x.rational(), *x.rational()};
  return {x.low().value(), x.high().value()};
}

}  // namespace crest::modes

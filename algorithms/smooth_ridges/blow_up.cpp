// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/blow_up.hpp"

#include <cmath>
#include <vector>

namespace crest::smooth_ridges {
namespace {

using kernel::Interval;
using Vector = std::array<Interval, 2>;
constexpr int kDepth = 16;

double middle(const Interval& x) {
  return x.inf() + 0.5 * (x.sup() - x.inf());
}

/// A quintic form and its gradient by the coordinates: E(v) before v is put in.
struct Quintic {
  std::array<Interval, 6> k;  ///< of v1^5, v1^4 v2, ...
  Interval operator()(const Vector& v) const {
    // Powers of the smaller component rise along the form: Horner in both.
    Interval sum = k[0], power = v[1];
    for (std::size_t n = 1; n < 6; ++n) {
      sum = sum * v[0] + k[n] * power;
      power = power * v[1];
    }
    return sum;
  }
  /// Derivative along d.
  Interval along(const Vector& v, const Vector& d) const {
    Interval first = k[0] * 5.0, second = k[1], power = v[1];
    for (std::size_t n = 1; n < 5; ++n) {
      first = first * v[0] + k[n] * (5.0 - static_cast<double>(n)) * power;
      second = second * v[0] + k[n + 1] * (static_cast<double>(n) + 1.0) * power;
      power = power * v[1];
    }
    return first * d[0] + second * d[1];
  }
};

/// I(v, v) T(v, v, v) - 3 L(v, v) D(v) as coefficients.
std::array<IntervalJet1, 6> quintic_of(const Forms<IntervalJet1>& f) {
  std::array<IntervalJet1, 6> k;
  for (std::size_t a = 0; a < 3; ++a) {
    const IntervalJet1 i = a == 1 ? f.i[1] * 2.0 : f.i[a];
    const IntervalJet1 l = a == 1 ? f.l[1] * 6.0 : f.l[a] * 3.0;
    for (std::size_t b = 0; b < 4; ++b) k[a + b] = k[a + b] + i * f.t[b] - l * f.d[b];
  }
  return k;
}

/// Everything on one interval of t, for 0 <= r <= R.
struct Cell {
  Vector e, turn;                       ///< e(t), e'(t)
  std::array<Interval, 3> i, i_t, i_r;  ///< I and its derivatives by t and r
  Vector v1, v2, v1_t, v2_t, v1_r, v2_r;
  bool regular = false;  ///< I(w, P w) > 0
};

class BlowUp {
 public:
  BlowUp(const UmbilicEnclosures& x, double radius)
      : x_(x), at_(quintic_of(x.at)), over_(quintic_of(x.over)), r_(0, radius) {}

  std::optional<Branches> run() {
    Branches result{index(), {0, 0}};
    if (result.twice_index == 0) return std::nullopt;
    for (int side = 0; side < 4; ++side)
      if (!divide(side, -1, 1, 0)) return std::nullopt;
    for (std::size_t j = 0; j < 2; ++j) {
      result.count[j] = count_branches(j);
      if (result.count[j] != 1 && result.count[j] != 3) return std::nullopt;
    }
    return result;
  }

 private:
  /// Sign of det D(a, b), 0 if not certain.
  int index() const {
    const auto &a = x_.shape_at.a, &b = x_.shape_at.b;
    const Interval det =
        a.coefficient(1, 0) * b.coefficient(0, 1) - a.coefficient(0, 1) * b.coefficient(1, 0);
    return det.inf() > 0 ? 1 : det.sup() < 0 ? -1 : 0;
  }

  /// What is known of a colour on a small interval of t, for all r.
  struct State {
    bool free = false;  ///< no zero
    int sign = 0;       ///< of E if free, else of dE/dt
  };

  /// Appends the states of [t0, t1], divided as needed.
  bool divide(int side, double t0, double t1, int depth) {
    if (decide(side, t0, t1)) return true;
    if (depth == kDepth) return false;
    const double t = 0.5 * (t0 + t1);
    return divide(side, t0, t, depth + 1) && divide(side, t, t1, depth + 1);
  }

  bool decide(int side, double t0, double t1) {
    const double t = 0.5 * (t0 + t1);
    const std::array<double, 2> w = direction(side, t);
    const Cell all = cell(side, Interval(t0, t1), w), centre = cell(side, Interval(t), w);
    if (!all.regular || !centre.regular) return false;
    const double half = (Interval(t1) - Interval(t0)).sup();
    std::array<State, 2> states;
    std::array<Interval, 2> slopes;
    for (std::size_t j = 0; j < 2; ++j) {
      const Interval slope = slopes[j] = derivative_by_t(all, j);
      const Interval e = value(centre, j) + slope * Interval(-half, half);
      states[j].free = !holds_zero(e);
      const Interval& sure = states[j].free ? e : slope;
      if (holds_zero(sure)) return false;
      states[j].sign = sure.inf() > 0 ? 1 : -1;
      if (!states[j].free && holds_zero(along_line(all, j, slope))) return false;
    }
    // Blue and red branches stay apart: no purple point.
    if (!states[0].free && !states[1].free && !apart(centre, slopes, half)) return false;
    // Frames are compared where two intervals meet: E changes sign with w.
    const int turned = directions_.empty() ? 1 : same_side(directions_.back(), w, all.i);
    if (turned == 0) return false;
    orientation_ *= turned;
    for (State& state : states) state.sign *= orientation_;
    last_i_ = all.i;
    directions_.push_back(w);
    states_.push_back(states);
    return true;
  }

  /// A combination of E1 and E2 nearly constant in t has no zero.
  bool apart(const Cell& centre, const std::array<Interval, 2>& slopes, double half) const {
    const Interval k0(1 / middle(slopes[0])), k1(1 / middle(slopes[1]));
    return !holds_zero(value(centre, 0) * k0 - value(centre, 1) * k1 +
                       (slopes[0] * k0 - slopes[1] * k1) * Interval(-half, half));
  }

  /// 1 if v1 of one direction is that of the other, -1 if its opposite, 0 if not certain.
  static int same_side(const std::array<double, 2>& w, const std::array<double, 2>& x,
                       const std::array<Interval, 3>& i) {
    const Interval product =
        (i[0] * w[0] + i[1] * w[1]) * x[0] + (i[1] * w[0] + i[2] * w[1]) * x[1];
    return product.inf() > 0 ? 1 : product.sup() < 0 ? -1 : 0;
  }

  /// Runs of intervals that are not free: one branch each if E changes sign over it. -1: undecided.
  int count_branches(std::size_t j) const {
    const std::size_t n = states_.size();
    const int closing = orientation_ * same_side(directions_.back(), directions_[0], last_i_);
    std::size_t start = 0;
    while (start < n && !states_[start][j].free) ++start;
    if (start == n || closing == 0) return -1;
    int count = 0, before = states_[start][j].sign, slope = 0;
    for (std::size_t k = start + 1; k <= start + n; ++k) {
      State s = states_[k % n][j];
      if (k >= n) s.sign *= closing;
      if (!s.free) {
        if (slope != 0 && slope != s.sign) return -1;
        slope = s.sign;
        continue;
      }
      if (s.sign != before) {
        if (slope != s.sign) return -1;
        ++count;
      }
      before = s.sign;
      slope = 0;
    }
    return count;
  }

  /// A double direction near d1 at (r = 0, t).
  std::array<double, 2> direction(int side, double t) const {
    const Vector e = ray(side, Interval(t));
    const auto slope = [&](const IntervalJet1& f) {
      return middle(f.coefficient(1, 0) * e[0] + f.coefficient(0, 1) * e[1]);
    };
    const double a = slope(x_.shape_at.a), b = slope(x_.shape_at.b), c = slope(x_.shape_at.c);
    const double sigma = std::sqrt(std::fmax(a * a + b * c, 0));
    std::array<double, 2> w =
        a > 0 ? std::array<double, 2>{a + sigma, c} : std::array<double, 2>{b, sigma - a};
    const double size = std::fmax(std::fabs(w[0]), std::fabs(w[1]));
    return {w[0] / size, w[1] / size};
  }

  static Vector ray(int side, const Interval& t) {
    switch (side) {
      case 0:
        return {Interval(1), t};
      case 1:
        return {-t, Interval(1)};
      case 2:
        return {Interval(-1), -t};
      default:
        return {t, Interval(-1)};
    }
  }
  static Vector turn(int side) {
    const double x[] = {0, -1, 0, 1}, y[] = {1, 0, -1, 0};
    return {Interval(x[side]), Interval(y[side])};
  }

  /// D f [d].
  template <class Field>
  static Interval first(const Field& f, const Vector& d) {
    return f.coefficient(1, 0) * d[0] + f.coefficient(0, 1) * d[1];
  }
  /// D^2 f [c, d].
  static Interval second(const IntervalJet2& f, const Vector& c, const Vector& d) {
    return f.coefficient(2, 0) * 2.0 * c[0] * d[0] +
           f.coefficient(1, 1) * (c[0] * d[1] + c[1] * d[0]) +
           f.coefficient(0, 2) * 2.0 * c[1] * d[1];
  }

  Cell cell(int side, const Interval& t, const std::array<double, 2>& w) const {
    Cell c;
    c.e = ray(side, t);
    c.turn = turn(side);
    // P and its derivatives by t and r, for a, b, c.
    std::array<Interval, 3> p, p_t, p_r;
    const std::array<const IntervalJet1*, 3> at = {&x_.shape_at.a, &x_.shape_at.b, &x_.shape_at.c};
    const std::array<const IntervalJet2*, 3> over = {&x_.shape_over.a, &x_.shape_over.b,
                                                     &x_.shape_over.c};
    for (std::size_t k = 0; k < 3; ++k) {
      p_r[k] = second(*over[k], c.e, c.e) * 0.5;
      p[k] = first(*at[k], c.e) + r_ * p_r[k];
      p_t[k] = first(*at[k], c.turn) + r_ * second(*over[k], c.e, c.turn);
      c.i_r[k] = first(x_.over.i[k], c.e);
      c.i[k] = x_.at.i[k][0] + r_ * c.i_r[k];
      c.i_t[k] = r_ * first(x_.over.i[k], c.turn);
    }
    const auto image = [&](const std::array<Interval, 3>& m) -> Vector {
      return {m[0] * w[0] + m[1] * w[1], m[2] * w[0] - m[0] * w[1]};
    };
    const Vector pw = image(p);
    const Interval squared = p[0] * p[0] + p[1] * p[2];
    const Interval s =
        (c.i[0] * w[0] + c.i[1] * w[1]) * pw[0] + (c.i[1] * w[0] + c.i[2] * w[1]) * pw[1];
    c.regular = s.inf() > 0 && squared.inf() > 0;
    if (!c.regular) return c;
    const Interval sigma = sqrt(squared), inverse = Interval(1) / sigma;
    c.v1 = {w[0] + pw[0] * inverse, w[1] + pw[1] * inverse};
    // d(P w / sigma) = (dP w - P w dsigma / sigma) / sigma, dsigma / sigma = d(sigma^2) / 2
    // sigma^2.
    const auto change = [&](const std::array<Interval, 3>& d) -> Vector {
      const Interval growth = (p[0] * d[0] * 2.0 + d[1] * p[2] + p[1] * d[2]) / (squared * 2.0);
      const Vector dw = image(d);
      return {(dw[0] - pw[0] * growth) * inverse, (dw[1] - pw[1] * growth) * inverse};
    };
    c.v1_t = change(p_t);
    c.v1_r = change(p_r);
    const auto turned = [](const std::array<Interval, 3>& i, const Vector& v) -> Vector {
      return {-(i[1] * v[0] + i[2] * v[1]), i[0] * v[0] + i[1] * v[1]};
    };
    const auto turned_change = [&](const std::array<Interval, 3>& di, const Vector& dv) -> Vector {
      const Vector x = turned(di, c.v1), y = turned(c.i, dv);
      return {x[0] + y[0], x[1] + y[1]};
    };
    c.v2 = turned(c.i, c.v1);
    c.v2_t = turned_change(c.i_t, c.v1_t);
    c.v2_r = turned_change(c.i_r, c.v1_r);
    return c;
  }

  /// The quintic form on the cell, and its derivative along d (per unit of r d).
  Quintic form(const Vector& e) const {
    Quintic q;
    for (std::size_t n = 0; n < 6; ++n) q.k[n] = at_[n][0] + r_ * first(over_[n], e);
    return q;
  }
  Quintic form_along(const Vector& d) const {
    Quintic q;
    for (std::size_t n = 0; n < 6; ++n) q.k[n] = first(over_[n], d);
    return q;
  }

  Interval value(const Cell& c, std::size_t j) const {
    if (!c.regular) return Interval(-HUGE_VAL, HUGE_VAL);
    return form(c.e)(j == 0 ? c.v1 : c.v2);
  }
  Interval derivative_by_t(const Cell& c, std::size_t j) const {
    const Vector& v = j == 0 ? c.v1 : c.v2;
    return form(c.e).along(v, j == 0 ? c.v1_t : c.v2_t) + r_ * form_along(c.turn)(v);
  }
  /// r G_j.
  Interval along_line(const Cell& c, std::size_t j, const Interval& by_t) const {
    const Vector& v = j == 0 ? c.v1 : c.v2;
    const Interval by_r = form(c.e).along(v, j == 0 ? c.v1_r : c.v2_r) + form_along(c.e)(v);
    const Interval radial = v[0] * c.turn[1] - v[1] * c.turn[0];
    const Interval across = c.e[0] * v[1] - c.e[1] * v[0];
    return r_ * radial * by_r + across * by_t;
  }

  const UmbilicEnclosures& x_;
  std::array<IntervalJet1, 6> at_, over_;
  Interval r_;
  // The intervals in order, signs in one frame carried along.
  std::vector<std::array<State, 2>> states_;
  std::vector<std::array<double, 2>> directions_;
  int orientation_ = 1;
  std::array<Interval, 3> last_i_;
};

}  // namespace

std::optional<Branches> blow_up(const UmbilicEnclosures& enclosures, double radius) {
  return BlowUp(enclosures, radius).run();
}

}  // namespace crest::smooth_ridges

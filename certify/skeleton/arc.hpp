// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Barriers: paths of Bezier pieces in a triangle that flow crosses one way only. How they are made
// proves nothing; what is checked of the rounded control points is exact (SPEC.md, "Barriers").
#include <atomic>
#include <vector>

#include "certify/skeleton/frame.hpp"

namespace crest::certify::skeleton {

/// The signs of sum_k C(n-1, k) D_k (first_j da_k + second_j db_k) C(n, j) for k + j = m, m < 2n:
/// Bernstein coefficients of a form along the curve with these control points, times positive
/// numbers.
template <class Number>
class Products {
 public:
  void compute(const std::vector<Point<Number>>& control, const LinearForms<Number>& forms) {
    const std::size_t n = control.size() - 1;
    sums_.assign(2 * n, Number(0.0));
    first_.resize(n + 1);
    second_.resize(n + 1);
    Number binomial = 1.0;
    for (std::size_t j = 0; j <= n; ++j) {
      const auto& [a, b] = control[j];
      first_[j] = binomial * along(forms.first, a, b);
      second_[j] = binomial * along(forms.second, a, b);
      binomial = next_binomial(binomial, n, j);
    }
    binomial = 1.0;
    for (std::size_t k = 0; k < n; ++k) {
      const Number da = binomial * (control[k + 1].a - control[k].a),
                   db = binomial * (control[k + 1].b - control[k].b);
      for (std::size_t j = 0; j <= n; ++j)
        sums_[k + j] = sums_[k + j] + (da * first_[j] + db * second_[j]);
      binomial = next_binomial(binomial, n - 1, k);
    }
  }
  const std::vector<Number>& sums() const { return sums_; }

 private:
  static Number along(const std::array<Number, 3>& f, const Number& a, const Number& b) {
    return f[0] + (a * (f[1] - f[0]) + b * (f[2] - f[0]));
  }
  /// C(n, k + 1) of C(n, k): whole numbers below 2^53, exact (n <= 50), or of 128 bits.
  static Number next_binomial(const Number& binomial, std::size_t n, std::size_t k) {
    return k < n ? Number(binomial * Number(static_cast<double>(n - k)) /
                          Number(static_cast<double>(k + 1)))
                 : binomial;
  }
  std::vector<Number> sums_, first_, second_;
};

/// Makes and checks barriers over double or Big; keeps its memory.
template <class Number>
class ArcMaker {
 public:
  /// `extra`: pieces beyond 64 a path are taken from it.
  ArcMaker(const Field& field, bool backward, std::atomic<std::int64_t>& extra)
      : field_(field), backward_(backward), extra_(extra) {}

  struct Task {
    u32 corner;           ///< of the frame
    Point<Number> start;  ///< on a side, at o, or inside
    int turn;             ///< +1: L, turned to the left; -1: R
    bool zero;            ///< the closed triangle holds a zero: x'.v > 0, too
    int exit;             ///< coordinate of the side where it ends, -1: where `trapped` says
    SkeletonBarrier barrier;
  };

  /// Appends pieces until the exit or the trap. Returns what failed, or null.
  template <class Trapped>
  const char* run(const Task& task, const Trapped& trapped, Point<Number>& end) {
    prepare(task);
    Point<Number> at = task.start;
    for (int pieces = 0; pieces < 4096; ++pieces) {
      if (pieces >= 64 && extra_.fetch_sub(std::is_same_v<Number, double> ? 1 : 64) < 64) break;
      const bool last = make_piece(task, at);
      if (failure_ != nullptr) return failure_;
      if (!inside(last ? task.exit : -1)) return "a barrier is not inside the triangle";
      if (!has_sign(frame_.determinant, &Frame<Rational>::determinant, -task.turn))
        return "a barrier is not one-way";
      if (task.zero && !has_sign(frame_.product, &Frame<Rational>::product, 1))
        return "a barrier turns away from the field";
      at = control_.back();
      if (last || (task.exit < 0 && trapped(at))) {
        end = at;
        return nullptr;
      }
    }
    return "a barrier does not end";
  }
  std::uint64_t pieces() const { return pieces_; }
  std::uint64_t exact_pieces() const { return exact_; }

 private:
  void prepare(const Task& task) {
    if (frame_.corner != task.corner) frame_ = make_frame<Number>(field_, task.corner, backward_);
    // w = (det(v, e2), det(e1, v)) = (-second, first) of the determinant.
    const Number theta = power_of_half<Number>(task.barrier.angle);
    for (std::size_t k = 0; k < 3; ++k) {
      const Number a = -frame_.determinant.second[k], b = frame_.determinant.first[k];
      const Number s = task.turn > 0 ? theta : Number(-theta);
      w_[k] = {a - s * b, b + s * a};
    }
    for (std::size_t k = 1; k < 3; ++k) w_[k] = {w_[k].a - w_[0].a, w_[k].b - w_[0].b};
    norm_ = std::max(std::fabs(to_double(w_[1].a)) + std::fabs(to_double(w_[2].a)),
                     std::fabs(to_double(w_[1].b)) + std::fabs(to_double(w_[2].b)));
  }
  Point<Number> linear(const Point<Number>& c) const {
    return {w_[1].a * c.a + w_[2].a * c.b, w_[1].b * c.a + w_[2].b * c.b};
  }
  static Number coordinate(const Point<Number>& p, int i, double sum) {
    return i == 1 ? p.a : i == 2 ? p.b : (Number(sum) - p.a) - p.b;
  }

  /// Control points from `at` on. True: it ends at the exit.
  bool make_piece(const Task& task, const Point<Number>& at) {
    failure_ = nullptr;
    const std::size_t degree = task.barrier.degree;
    const Point<Number> moved = linear(at);
    Point<Number> c{w_[0].a + moved.a, w_[0].b + moved.b};
    const double speed = std::max(std::fabs(to_double(c.a)), std::fabs(to_double(c.b)));
    const Number h = power_of_half<Number>(task.barrier.shrink) / Number(2 * norm_ + speed / 2);
    control_.assign(1, at);
    for (std::size_t k = 1; k <= degree; ++k) {
      const Number factor = h / Number(static_cast<double>(k));
      c = {factor * c.a, factor * c.b};
      control_.push_back(c);
      c = linear(c);
    }
    const bool last = task.exit >= 0 && cut(task.exit);
    to_bernstein();
    if (last) put_on_side(task.exit);
    return last;
  }

  /// Cuts the power series where it meets the exit, if it does.
  bool cut(int exit) {
    const std::size_t n = control_.size();
    series_.clear();
    for (std::size_t k = 0; k < n; ++k)
      series_.push_back(coordinate(control_[k], exit, k == 0 ? 1.0 : 0.0));
    if (series_[0] == Number(0.0)) series_.erase(series_.begin());
    Number end = 0.0;
    for (const Number& x : series_) end = end + x;
    if (end > Number(0.0)) return false;
    const Number s = root();
    Number power = s;
    for (std::size_t k = 1; k < n; ++k, power = power * s)
      control_[k] = {power * control_[k].a, power * control_[k].b};
    return true;
  }
  /// Of the series, which changes its sign on (0, 1]; found where it is not, the checks say so.
  Number root() const {
    double low = 0, high = 1, s = 0.5;
    for (int i = 0; i < 100; ++i) {
      double value = 0, slope = 0;
      for (std::size_t k = series_.size(); k-- > 0;) {
        slope = slope * s + value;
        value = value * s + to_double(series_[k]);
      }
      (value > 0 ? low : high) = s;
      double next = s - value / slope;
      if (!(next > low && next < high)) next = (low + high) / 2;
      if (std::fabs(next - s) <= 0x1p-52 * s) break;
      s = next;
    }
    Number x = s;
    if constexpr (!std::is_same_v<Number, double>)
      for (mpfr_prec_t known = 45; known < 2 * Number::bits; known *= 2) {
        Number value = 0.0, slope = 0.0;
        for (std::size_t k = series_.size(); k-- > 0;) {
          slope = slope * x + value;
          value = value * x + series_[k];
        }
        if (slope == Number(0.0)) break;
        x = x - value / slope;
      }
    return x;
  }
  /// b_j = sum_k C(j, k) / C(n, k) c_k.
  void to_bernstein() {
    const std::size_t n = control_.size() - 1;
    Number binomial = 1.0;
    for (std::size_t k = 1; k <= n; ++k) {
      binomial = binomial * Number(static_cast<double>(n - k + 1)) / Number(static_cast<double>(k));
      control_[k] = {control_[k].a / binomial, control_[k].b / binomial};
    }
    for (std::size_t i = 1; i <= n; ++i)
      for (std::size_t j = n; j >= i; --j)
        control_[j] = {control_[j].a + control_[j - 1].a, control_[j].b + control_[j - 1].b};
  }
  /// Exactly: 1 - a is a number for a multiple a of 2^(1 - bits).
  void put_on_side(int exit) {
    auto& [a, b] = control_.back();
    if (exit == 1) {
      a = 0.0;
    } else if (exit == 2) {
      b = 0.0;
    } else {
      a = (a + Number(1.0)) - Number(1.0);
      b = Number(1.0) - a;
    }
  }

  /// All control points are, but for the first on a side, at o or inside, and the last on the exit.
  bool inside(int exit) const {
    const Number zero = 0.0, one = 1.0;
    for (std::size_t j = 0; j < control_.size(); ++j) {
      const auto& [a, b] = control_[j];
      if (!is_finite(a) || !is_finite(b)) return false;
      const bool first = j == 0, last = j + 1 == control_.size();
      const bool good_a = a > zero || (first && a == zero) || (last && exit == 1),
                 good_b = b > zero || (first && b == zero) || (last && exit == 2);
      // Rounding is monotonous: a + b >= 1 would round to 1 or more.
      const bool good = last && exit == 0 ? a > zero && b > zero : a + b < one;
      if (!good_a || !good_b || !good) return false;
      if (last && ((exit == 1 && !(b > zero)) || (exit == 2 && !(a > zero)))) return false;
    }
    return true;
  }

  /// All Bernstein coefficients of a form have the sign. In numbers with this bound, where S bounds
  /// max |da| |first| + max |db| |second| and u is half a unit: e1, e2 round once, a form's value
  /// at a corner is within 4 u M, M its magnitude; at a control point (a, b >= 0, a + b <= 1) all
  /// terms are below 5 M and the value within 40 u M; da within u |da|; n <= 128 products a sum,
  /// each rounded thrice with its binomials: below (128 + 16 n) u S C(2n-1, m). Underflow (below
  /// 2^-1074 an operation) is what the last term covers.
  bool has_sign(const LinearForms<Number>& forms, LinearForms<Rational> Frame<Rational>::*exact,
                int wanted) {
    ++pieces_;
    products_.compute(control_, forms);
    const std::size_t n = control_.size() - 1;
    double da = 0, db = 0;
    for (std::size_t k = 0; k < n; ++k) {
      da = std::max(da, std::fabs(to_double(control_[k + 1].a - control_[k].a)));
      db = std::max(db, std::fabs(to_double(control_[k + 1].b - control_[k].b)));
    }
    const double unit = static_cast<double>(128 + 16 * n) * unit_roundoff<Number>() *
                        (da * forms.magnitude_first + db * forms.magnitude_second);
    double binomial = 1;
    bool certain = true;
    const auto& sums = products_.sums();
    for (std::size_t m = 0; m < sums.size(); ++m) {
      const double bound = unit * binomial + 0x1p-1030 * binomial;
      const double value = wanted * to_double(sums[m]);
      if (value < -bound) return false;
      certain = certain && value > bound;
      binomial = binomial * static_cast<double>(2 * n - 1 - m) / static_cast<double>(m + 1);
    }
    return certain || has_exact_sign(exact, wanted);
  }
  bool has_exact_sign(LinearForms<Rational> Frame<Rational>::*forms, int wanted) {
    ++exact_;
    if (exact_frame_.corner != frame_.corner)
      exact_frame_ = make_frame<Rational>(field_, frame_.corner, backward_);
    exact_control_.clear();
    for (const auto& [a, b] : control_) exact_control_.push_back({to_rational(a), to_rational(b)});
    exact_products_.compute(exact_control_, exact_frame_.*forms);
    return std::all_of(exact_products_.sums().begin(), exact_products_.sums().end(),
                       [&](const Rational& x) { return wanted * x > 0; });
  }

  const Field& field_;
  bool backward_;
  std::atomic<std::int64_t>& extra_;
  Frame<Number> frame_;
  Frame<Rational> exact_frame_;
  std::array<Point<Number>, 3> w_;  ///< turned field: at o, and its differences
  double norm_ = 0;
  std::vector<Point<Number>> control_;
  std::vector<Number> series_;
  Products<Number> products_;
  std::vector<Point<Rational>> exact_control_;
  Products<Rational> exact_products_;
  const char* failure_ = nullptr;
  std::uint64_t pieces_ = 0, exact_ = 0;
};

}  // namespace crest::certify::skeleton

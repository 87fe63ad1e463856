// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One piece of a barrier: a Taylor polynomial of the turned flow, cut at the exit. Nothing here
// proves anything (SPEC.md, "Barriers").
#include "certify/skeleton/signs.hpp"

namespace crest::certify::skeleton {

template <class Number>
struct ArcTask {
  u32 corner;           ///< of the frame
  Point<Number> start;  ///< on a side, at o, or inside
  int turn;             ///< +1: L, turned to the left; -1: R
  bool zero;            ///< the closed triangle holds a zero: x'.v > 0, too
  int exit;             ///< coordinate of the side where it ends, -1: where `trapped` says
  SkeletonBarrier barrier;
};

template <class Number>
class PieceMaker {
 public:
  /// Turns the field of the task's frame.
  void prepare(const ArcTask<Number>& task, const Frame<Number>& frame) {
    if (binomials_.degree.size() != task.barrier.degree + 1U)
      binomials_ = Binomials<Number>(task.barrier.degree);
    // w = (det(v, e2), det(e1, v)) = (-second, first) of the determinant.
    const Number theta = power_of_half<Number>(task.barrier.angle);
    for (std::size_t k = 0; k < 3; ++k) {
      const Number a = -frame.determinant.second[k], b = frame.determinant.first[k];
      const Number s = task.turn > 0 ? theta : Number(-theta);
      w_[k] = {a - s * b, b + s * a};
    }
    for (std::size_t k = 1; k < 3; ++k) w_[k] = {w_[k].a - w_[0].a, w_[k].b - w_[0].b};
    norm_ = std::max(std::fabs(to_double(w_[1].a)) + std::fabs(to_double(w_[2].a)),
                     std::fabs(to_double(w_[1].b)) + std::fabs(to_double(w_[2].b)));
  }
  /// Control points from `at` on. True: it ends at the exit.
  bool make(const ArcTask<Number>& task, const Point<Number>& at) {
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
  const std::vector<Point<Number>>& control() const { return control_; }
  const Binomials<Number>& binomials() const { return binomials_; }

 private:
  Point<Number> linear(const Point<Number>& c) const {
    return {w_[1].a * c.a + w_[2].a * c.b, w_[1].b * c.a + w_[2].b * c.b};
  }
  static Number coordinate(const Point<Number>& p, int i, double sum) {
    return i == 1 ? p.a : i == 2 ? p.b : (Number(sum) - p.a) - p.b;
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
      if (std::fabs(next - s) <= 0x1p-50 * s) break;
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
    for (std::size_t k = 1; k <= n; ++k)
      control_[k] = {control_[k].a / binomials_.degree[k], control_[k].b / binomials_.degree[k]};
    for (std::size_t i = 1; i <= n; ++i)
      for (std::size_t j = n; j >= i; --j) {
        control_[j].a += control_[j - 1].a;
        control_[j].b += control_[j - 1].b;
      }
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

  std::array<Point<Number>, 3> w_;  ///< turned field: at o, and its differences
  double norm_ = 0;
  std::vector<Point<Number>> control_;
  std::vector<Number> series_;
  Binomials<Number> binomials_;
};

}  // namespace crest::certify::skeleton

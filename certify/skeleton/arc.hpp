// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Barriers: paths of Bezier pieces in a triangle that flow crosses one way only. How they are made
// proves nothing; what is checked of the rounded control points is exact (SPEC.md, "Barriers").
#include <atomic>

#include "certify/skeleton/piece.hpp"

namespace crest::certify::skeleton {

/// Makes and checks barriers over double or Big; keeps its memory.
template <class Number>
class ArcMaker {
 public:
  /// `extra`: pieces beyond 64 a path are taken from it.
  ArcMaker(const Field& field, bool backward, std::atomic<std::int64_t>& extra)
      : field_(field), backward_(backward), extra_(extra) {}

  using Task = ArcTask<Number>;

  /// Appends pieces until the exit or the trap. Returns what failed, or null.
  template <class Trapped>
  const char* run(const Task& task, const Trapped& trapped, Point<Number>& end) {
    if (frame_.corner != task.corner) frame_ = make_frame<Number>(field_, task.corner, backward_);
    maker_.prepare(task, frame_);
    Point<Number> at = task.start;
    for (int pieces = 0; pieces < 4096; ++pieces) {
      constexpr std::int64_t weight = std::is_same_v<Number, double> ? 1 : 64;
      if (pieces >= 64 && extra_.fetch_sub(weight) < weight) break;
      const bool last = maker_.make(task, at);
      if (!inside(last ? task.exit : -1)) return "a barrier is not inside the triangle";
      if (!has_sign(
              [](const auto& f) -> const auto& { return f.determinant; }, -task.turn))
        return "a barrier is not one-way";
      if (task.zero && !has_sign(
                           [](const auto& f) -> const auto& { return f.product; }, 1))
        return "a barrier turns away from the field";
      at = maker_.control().back();
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
  /// All control points are, but for the first on a side, at o or inside, and the last on the exit.
  bool inside(int exit) const {
    const Number zero = 0.0, one = 1.0;
    const auto& control = maker_.control();
    for (std::size_t j = 0; j < control.size(); ++j) {
      const auto& [a, b] = control[j];
      if (!is_finite(a) || !is_finite(b)) return false;
      const bool first = j == 0, last = j + 1 == control.size();
      const bool good_a = a > zero || (first && a == zero) || (last && exit == 1),
                 good_b = b > zero || (first && b == zero) || (last && exit == 2);
      // Rounding is monotonous: a + b >= 1 would round to 1 or more.
      const bool good = last && exit == 0 ? a > zero && b > zero : a + b < one;
      if (!good_a || !good_b || !good) return false;
      if (last && ((exit == 1 && !(b > zero)) || (exit == 2 && !(a > zero)))) return false;
    }
    return true;
  }

  /// In numbers of the path, then (from doubles) of 133 bits, then in rationals.
  template <class Form>
  bool has_sign(const Form& form, int wanted) {
    ++pieces_;
    const auto& control = maker_.control();
    const Answer answer = have_sign(control, form(frame_), maker_.binomials(), products_, wanted);
    if (answer != Answer::open) return answer == Answer::yes;
    ++exact_;
    if constexpr (std::is_same_v<Number, double>) {
      Big::bits = 133;
      if (wide_frame_.corner != frame_.corner)
        wide_frame_ = make_frame<Big>(field_, frame_.corner, backward_);
      wide_control_.clear();
      for (const auto& [a, b] : control) wide_control_.push_back({Big(a), Big(b)});
      const Answer wide = have_sign(wide_control_, form(wide_frame_),
                                    Binomials<Big>(control.size() - 1), wide_products_, wanted);
      if (wide != Answer::open) return wide == Answer::yes;
    }
    if (exact_frame_.corner != frame_.corner)
      exact_frame_ = make_frame<Rational>(field_, frame_.corner, backward_);
    return exact_signs_.have(control, form(exact_frame_), wanted);
  }

  const Field& field_;
  bool backward_;
  std::atomic<std::int64_t>& extra_;
  Frame<Number> frame_;
  Frame<Rational> exact_frame_;
  PieceMaker<Number> maker_;
  Products<Number> products_;
  Frame<Big> wide_frame_;
  std::vector<Point<Big>> wide_control_;
  Products<Big> wide_products_;
  ExactSigns exact_signs_;
  std::uint64_t pieces_ = 0, exact_ = 0;
};

}  // namespace crest::certify::skeleton

// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/turn_in_time.hpp"

#include <cmath>

#include "kernel/predicates/quadratic_root_order.hpp"
#include "kernel/predicates/stages.hpp"

namespace crest::kernel {

namespace {

struct PositiveRoots {
  int count = 0;
  std::array<QuadraticRoot, 2> roots{};
  bool doubled = false, everywhere = false;
  bool at_zero = false, at_infinity = false;
};

template <class P>
struct QuadraticConstant {
  P p;
  static constexpr int depth = P::depth;
  template <class T>
  T value() const {
    return p.template value<T>().c;
  }
};

template <class P>
PositiveRoots positive_roots(const P& p) {
  PositiveRoots r;
  const Sign c = climb(QuadraticConstant<P>{p}).sign, a = climb(QuadraticLeading<P>{p}).sign;
  r.at_zero = c == Sign::zero;
  r.at_infinity = a == Sign::zero;
  if (a * c == Sign::negative) {
    r.count = 1;
    r.roots[0] = QuadraticRoot::larger;
    return r;
  }
  const Sign b = climb(QuadraticMiddle<P>{p}).sign;
  if (a == Sign::zero && c == Sign::zero) {
    r.everywhere = b == Sign::zero;
  } else if (a == Sign::zero || c == Sign::zero) {
    // One root is 0 or infinite.
    r.count = (a == Sign::zero ? c : a) * b == Sign::negative ? 1 : 0;
    r.roots[0] = QuadraticRoot::larger;
  } else if (b * a == Sign::negative) {
    const Sign d = discriminant_sign(p).sign;
    r.doubled = d == Sign::zero;
    if (d == Sign::positive) r.count = 2;
    if (r.doubled) r.count = 1;
    r.roots = {QuadraticRoot::smaller, QuadraticRoot::larger};
  }
  return r;
}

double time_of(const QuadraticOf<double>& q, QuadraticRoot which) {
  const double size = std::fmax(std::fabs(q.a), std::fmax(std::fabs(q.b), std::fabs(q.c)));
  const double a = q.a / size, b = q.b / size, c = q.c / size;
  const double root = std::sqrt(std::fmax(b * b - 4 * a * c, 0));
  const double s = -(b + std::copysign(root, b)) / 2;
  // u = s / a or c / s, t = u / (1 + u).
  const double one = a == 0 ? 1 : s / (s + a), other = c / (c + s);
  const bool positive_one = a != 0 && s / a > 0, positive_other = c / s > 0;
  if (positive_one != positive_other) return positive_one ? one : other;
  return which == QuadraticRoot::smaller ? std::fmin(one, other) : std::fmax(one, other);
}

}  // namespace

OppositeTimes opposite_times(const MovingPair& pair) {
  const TurnInTime turn{pair};
  const DotInTime dot{pair};
  OppositeTimes r;
  const PositiveRoots roots = positive_roots(turn);
  if (roots.everywhere) {
    // Parallel at all times: harmless where they always point the same way.
    const PositiveRoots still = positive_roots(dot);
    r.tied = still.everywhere || still.count > 0 || still.at_zero || still.at_infinity ||
             climb(QuadraticLeading<DotInTime>{dot}).sign == Sign::negative;
    return r;
  }
  if (roots.at_zero) r.tied = climb(QuadraticConstant<DotInTime>{dot}).sign != Sign::positive;
  if (roots.at_infinity)
    r.tied = r.tied || climb(QuadraticLeading<DotInTime>{dot}).sign != Sign::positive;
  for (int i = 0; i < roots.count; ++i) {
    const QuadraticRoot which = roots.roots[static_cast<std::size_t>(i)];
    const Sign s = sign_at_root(turn, which, dot)->sign;
    if (s == Sign::positive) continue;
    if (s == Sign::zero || roots.doubled) {
      r.tied = true;
      continue;
    }
    r.roots[static_cast<std::size_t>(r.count)] = which;
    r.times[static_cast<std::size_t>(r.count++)] = time_of(turn.value<double>(), which);
  }
  return r;
}

Sign event_order(const MovingPair& p, QuadraticRoot i, const MovingPair& q, QuadraticRoot k) {
  return root_order(TurnInTime{p}, i, TurnInTime{q}, k)->sign;
}

}  // namespace crest::kernel

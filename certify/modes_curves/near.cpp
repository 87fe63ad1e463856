// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes_curves/near.hpp"

#include <algorithm>
#include <numeric>

#include "certify/modes_curves/quartic_roots.hpp"
#include "certify/modes_curves/span.hpp"

namespace crest::certify::curves {
namespace {

/// c[i] x^i.
template <class Number, std::size_t n>
using Power = std::array<Number, n>;

template <class Number, std::size_t a, std::size_t b>
Power<Number, a + b - 1> operator*(const Power<Number, a>& x, const Power<Number, b>& y) {
  Power<Number, a + b - 1> z{};
  for (std::size_t i = 0; i < a; ++i)
    for (std::size_t j = 0; j < b; ++j) z[i + j] = z[i + j] + x[i] * y[j];
  return z;
}
template <class Number, std::size_t n>
Power<Number, n> operator-(const Power<Number, n>& x, const Power<Number, n>& y) {
  Power<Number, n> z;
  for (std::size_t i = 0; i < n; ++i) z[i] = x[i] - y[i];
  return z;
}
template <class Number, std::size_t n>
Power<Number, n> operator*(const Number& factor, Power<Number, n> x) {
  for (Number& c : x) c = factor * c;
  return x;
}
template <class Number, std::size_t n>
Number value(const Power<Number, n>& c, const Number& x) {
  Number sum = c[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}
template <class Number, std::size_t n>
Power<Number, n> reversed(Power<Number, n> c) {
  std::ranges::reverse(c);
  return c;
}

/// A change of coordinates, so that no two points lie on a line with the centre; columns are near a
/// rotation's.
constexpr std::array<std::array<double, 3>, 3> kTurn = {
    {{0.75, 0.28125, 0.59375}, {-0.5, 0.8125, 0.25}, {-0.40625, -0.5, 0.765625}}};

template <class Number>
Symmetric<Number> turned(const Symmetric<Number>& m) {
  const auto column = [](std::size_t j) {
    return Vector<Number>{Number(kTurn[0][j]), Number(kTurn[1][j]), Number(kTurn[2][j])};
  };
  const std::array<Vector<Number>, 3> c = {column(0), column(1), column(2)};
  const std::array<Vector<Number>, 3> half = {times(m, c[0]), times(m, c[1]), times(m, c[2])};
  return {dot(c[0], half[0]), dot(c[1], half[1]), dot(c[2], half[2]),
          dot(c[0], half[1]), dot(c[1], half[2]), dot(c[0], half[2])};
}

/// The conics' resultant by z, where y = 1, and what gives z = -a / b.
template <class Number>
struct NearElimination {
  Power<Number, 3> a;
  Power<Number, 2> b;
  Power<Number, 5> quartic;

  NearElimination(const Symmetric<Number>& p, const Symmetric<Number>& q) {
    // p0 z^2 + p1 z + p2.
    const Power<Number, 2> p1 = {p[4] + p[4], p[5] + p[5]}, q1 = {q[4] + q[4], q[5] + q[5]};
    const Power<Number, 3> p2 = {p[1], p[3] + p[3], p[0]}, q2 = {q[1], q[3] + q[3], q[0]};
    a = p[2] * q2 - q[2] * p2;
    b = p[2] * q1 - q[2] * p1;
    quartic = a * a - b * (p1 * q2 - q1 * p2);
  }
};

/// Bernstein's coefficients of a quartic on [-1, 1].
template <class Number>
std::array<Number, 5> on_unit_interval(const Power<Number, 5>& c) {
  const Number odd = Number(0.5) * (c[1] - c[3]);
  return {c[0] - c[1] + c[2] - c[3] + c[4], c[0] - c[4] - odd, c[0] - c[2] / Number(3) + c[4],
          c[0] - c[4] + odd, c[0] + c[1] + c[2] + c[3] + c[4]};
}

Ball middle(const Ball& x) {
  return {x.mid, 0};
}
WideBall middle(const WideBall& x) {
  return x.middle();
}
double radius(const Ball& x) {
  return x.rad;
}
double radius(const WideBall& x) {
  return x.rad;
}
Ball widened(const Ball& x, double radius) {
  return {x.mid, radius};
}
WideBall widened(const WideBall& x, double radius) {
  return {x.hi, x.lo, radius};
}

/// The root in a bracket by Newton's steps, in doubles, and the slope there.
template <class Number>
std::array<double, 2> approximate_root(const Power<Number, 5>& c, const Bracket& at) {
  double low = at.low, high = at.high, x = low + (high - low) / 2, slope = 0;
  for (int i = 0; i < 60; ++i) {
    double f = near(c[4]);
    slope = 0;
    for (std::size_t k = 4; k-- > 0;) slope = slope * x + f, f = f * x + near(c[k]);
    (f * at.sign > 0 ? low : high) = x;
    double next = x - f / slope;
    if (!(low < next && next < high)) next = low + (high - low) / 2;
    const double moved = std::fabs(next - x);
    x = next;
    if (moved <= 0x1p-50 * std::fabs(x) + 0x1p-60) break;
  }
  return {x, slope};
}

/// A ball around the root in a bracket: signs beside it prove it.
template <class Number>
std::optional<Number> narrow(const Power<Number, 5>& c, const Bracket& at) {
  const auto [start, slope] = approximate_root(c, at);
  constexpr bool wide = std::is_same_v<Number, WideBall>;
  constexpr double unit = wide ? 0x1p-98 : 0x1p-52;
  Number x(start);
  if constexpr (wide)
    for (int i = 0; i < 2; ++i) x = middle(x - middle(value(c, x)) * Number(1 / slope));
  const Number there = value(c, x);
  double step = 2 * (std::fabs(near(there)) + radius(there)) / std::fabs(slope) +
                unit * std::fabs(near(x)) + 0x1p-110;
  for (int i = 0; i < 4; ++i, step *= 8) {
    const Number below = middle(x - Number(step)), above = middle(x + Number(step));
    if (!(near(below) > at.low && near(above) < at.high)) break;
    if (sign_of(value(c, below)) == at.sign && sign_of(value(c, above)) == -at.sign)
      return widened(x, 1.001 * step + unit * std::fabs(near(x)));
  }
  // A root close to the bracket's end, or a small one: from end to end.
  const double half = (at.high - at.low) / 2;
  return widened(Number(at.low + half), 1.001 * half);
}

/// The common points of two conics, up to factors.
template <class Number>
std::optional<std::vector<Vector<Number>>> common_points(const Symmetric<Number>& p,
                                                         const Symmetric<Number>& q) {
  const NearElimination<Number> by_z(turned(p), turned(q));
  std::vector<Vector<Number>> points;
  std::vector<Bracket> brackets;
  for (const bool swapped : {false, true}) {
    const Power<Number, 5> c = swapped ? reversed(by_z.quartic) : by_z.quartic;
    brackets.clear();
    if (!isolate(on_unit_interval(c), -1, 1, 0x1p-30, brackets)) return std::nullopt;
    for (const Bracket& bracket : brackets) {
      const auto root = narrow(c, bracket);
      if (!root) return std::nullopt;
      // (x, y) = (root, 1), or (1, root): homogeneous of degree 1, 2.
      const Number x = swapped ? Number(1) : *root, y = swapped ? *root : Number(1);
      const Number b = by_z.b[0] * y + by_z.b[1] * x;
      const Number a = (by_z.a[0] * y + by_z.a[1] * x) * y + by_z.a[2] * x * x;
      if (sign_of(b) == 0) return std::nullopt;
      const Vector<Number> v = {x * b, y * b, -a};
      Vector<Number> back;
      for (std::size_t i = 0; i < 3; ++i)
        back[i] =
            Number(kTurn[i][0]) * v[0] + Number(kTurn[i][1]) * v[1] + Number(kTurn[i][2]) * v[2];
      points.push_back(back);
    }
  }
  return points;
}

template <class Number>
const Box* box_of(const std::array<Number, 3>& weights, const std::vector<Box>& boxes) {
  const Number sum = weights[0] + weights[1] + weights[2];
  const std::array<Number, 2> share = {weights[0] / sum, weights[1] / sum};
  const auto holds = [&](const Box& box) {
    for (unsigned k = 0; k < 2; ++k)
      if (sign_of(share[k] - Number(box.low[k])) <= 0 ||
          sign_of(Number(box.high[k]) - share[k]) <= 0)
        return false;
    return true;
  };
  const auto at = std::ranges::find_if(boxes, holds);
  return at == boxes.end() ? nullptr : &*at;
}

template <class Number>
std::optional<std::vector<NearPoint>> find(const Corners<3>& tensors,
                                           const std::vector<Box>& boxes) {
  const Span<Number, 3> span(tensors);
  if (!span.independent()) return std::nullopt;
  const auto all = common_points(span.conic(0), span.conic(1));
  if (!all) return std::nullopt;
  const std::array<Symmetric<Number>, 3> dual = {span.dual(0), span.dual(1), span.dual(2)};
  std::vector<NearPoint> found;
  std::array<bool, 4> used{};
  for (const Vector<Number>& v : *all) {
    std::array<Number, 3> weights;
    int least = 1, most = -1;
    for (std::size_t i = 0; i < 3; ++i) {
      weights[i] = dot(v, times(dual[i], v));
      const int sign = sign_of(weights[i]);
      least = std::min(least, sign), most = std::max(most, sign);
    }
    if (least < 0 && most > 0) continue;  // outside, whatever a third sign is
    if (least != most || least == 0) return std::nullopt;
    const Box* box = box_of(weights, boxes);
    if (box == nullptr || box->type != least) return std::nullopt;
    bool& once = used[static_cast<std::size_t>(box - boxes.data())];
    if (once) return std::nullopt;
    once = true;
    found.push_back({least, box->listed, {WideBall(v[0]), WideBall(v[1]), WideBall(v[2])}});
  }
  if (found.size() != boxes.size()) return std::nullopt;
  return found;
}

}  // namespace

std::optional<std::vector<NearPoint>> find_near_points(const Corners<3>& tensors,
                                                       const std::vector<Box>& boxes) {
  if (auto found = find<Ball>(tensors, boxes)) return found;
  return find<WideBall>(tensors, boxes);
}

namespace {

/// The points in their order around a vector inside the conic; unknown where errors do not tell.
template <class Number>
class NearOrder {
 public:
  NearOrder(const Symmetric<Number>& conic, int sign, std::span<const NearTetPoint> points)
      : conic_(conic), size_(points.size()) {
    // Vectors around the axis of the eigenvalue that has another sign than the others, to 45
    // degrees at least, as the trace is 0: one of these is there.
    double best = 0;
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          const Vector<Number> c = {Number(x), Number(y), Number(z)};
          const Number form = dot(c, times(conic, c));
          if (const double at = sign * near(form); at > best && sign_of(form) == sign)
            best = at, centre_ = c;
        }
    known_ = best > 0;
    const Vector<Number> polar = times(conic, centre_);
    for (const NearTetPoint& point : points) {
      const auto& [x, y, z] = point.point->v;
      Vector<Number> v = {Number(x), Number(y), Number(z)};
      const int side = sign_of(dot(polar, v)) * sign;
      known_ &= side != 0;
      if (side < 0) v = {-v[0], -v[1], -v[2]};
      directions_.push_back(v);
    }
  }

  /// Ascending from point 0 on.
  bool sort(std::vector<std::size_t>& order) const {
    bool certain = known_;
    order.resize(size_);
    std::iota(order.begin(), order.end(), 0);
    // By insertion, which no answer can lead astray.
    for (std::size_t i = 2; i < order.size(); ++i)
      for (std::size_t k = i; k > 1; --k) {
        const int turn = orientation(order[k - 1], order[k]);
        certain &= turn != 0;
        if (turn >= 0) break;
        std::swap(order[k - 1], order[k]);
      }
    return certain;
  }

  /// Whether a form rises from 0 at point 0 where the order goes on; 0 if unknown.
  int rise(const Symmetric<Number>& form) const {
    const Vector<Number>& v = directions_[0];
    const Vector<Number> w = cross(times(conic_, v), v);
    return sign_of(dot(centre_, cross(v, w))) * sign_of(dot(v, times(form, w)));
  }

 private:
  /// Of points 0, a, b round the cone.
  int orientation(std::size_t a, std::size_t b) const {
    return sign_of(dot(directions_[0], cross(directions_[a], directions_[b])));
  }

  Symmetric<Number> conic_;
  std::size_t size_;
  Vector<Number> centre_;
  std::vector<Vector<Number>> directions_;
  bool known_ = false;
};

using Pairs = std::vector<std::array<std::size_t, 2>>;

template <class Number>
std::optional<Pairs> join(const Corners<4>& tensors, std::span<const NearTetPoint> points) {
  const Span<Number, 4> span(tensors);
  if (!span.independent()) return std::nullopt;
  const Symmetric<Number> conic = span.conic(0);
  const int sign = sign_of(determinant(conic));
  if (sign == 0) return std::nullopt;
  if (points.size() == 2) return Pairs{{0, 1}};
  const NearOrder<Number> around(conic, sign, points);
  std::vector<std::size_t> order;
  if (!around.sort(order)) return std::nullopt;
  const int rise = around.rise(span.dual(points[0].opposite));
  if (rise == 0) return std::nullopt;
  const bool ahead = rise == points[0].point->type;
  Pairs arcs;
  for (std::size_t i = 0; i < order.size(); i += 2) {
    const std::size_t first = ahead ? i : i + 1;
    arcs.push_back({order[first], order[(first + 1) % order.size()]});
  }
  return arcs;
}

}  // namespace

std::optional<Pairs> find_near_arcs(const Corners<4>& tensors,
                                    std::span<const NearTetPoint> points) {
  if (auto found = join<Ball>(tensors, points)) return found;
  return join<WideBall>(tensors, points);
}

}  // namespace crest::certify::curves

// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/modes/polygons.hpp"

#include <algorithm>
#include <cmath>

namespace crest::certify::modes {
namespace {

template <class Number>
Number cross(const Planar<Number>& a, const Planar<Number>& b, const Planar<Number>& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
int sign_of(const kernel::Rational& x) {
  return x > 0 ? 1 : x < 0 ? -1 : 0;
}

}  // namespace

const PlanarPoints::Exact& PlanarPoints::exact() const {
  if (exact_.empty()) exact_ = make_exact_();
  return exact_;
}

/// A difference is wrong by 2 error and a rounding, a product of two by the sum of each difference
/// times the other's error, and the squares of these.
int PlanarPoints::orientation(u32 a, u32 b, u32 c) const {
  const auto &p = near_[a], &q = near_[b], &r = near_[c];
  const double x = cross(p, q, r);
  double sum = 0, least = 0;
  for (unsigned k = 0; k < 2; ++k) sum += std::fabs(q[k] - p[k]) + std::fabs(r[k] - p[k]);
  least = std::fabs((q[0] - p[0]) * (r[1] - p[1])) + std::fabs((q[1] - p[1]) * (r[0] - p[0]));
  const double bound = widened(2.1 * error_ * sum + 16 * error_ * error_ + 8 * kUnit * least);
  if (x > bound) return 1;
  if (x < -bound) return -1;
  return sign_of(cross(exact()[a], exact()[b], exact()[c]));
}

int PlanarPoints::side(u32 a, u32 b, u32 c) const {
  const auto &p = exact()[a], &q = exact()[b], &r = exact()[c];
  return sign_of((q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1]));
}

bool PlanarPoints::same(u32 a, u32 b) const {
  for (unsigned k = 0; k < 2; ++k)
    if (std::fabs(near_[a][k] - near_[b][k]) > 2.1 * error_) return false;
  return exact()[a] == exact()[b];
}

bool PlanarPoints::above(u32 a, u32 b) const {
  const double gap = near_[a][1] - near_[b][1];
  if (std::fabs(gap) > 2.1 * error_) return gap > 0;
  return exact()[a][1] > exact()[b][1];
}

namespace {

bool apart(const PlanarPoints& points, const Segment& s, const Segment& t) {
  const double room = 2.1 * points.error();
  for (unsigned k = 0; k < 2; ++k) {
    const auto [a, b] = std::minmax(points.near(s[0])[k], points.near(s[1])[k]);
    const auto [c, d] = std::minmax(points.near(t[0])[k], points.near(t[1])[k]);
    if (b + room < c || d + room < a) return true;
  }
  return false;
}

/// Two segments that have no end in common: no point either.
bool disjoint(const PlanarPoints& points, const Segment& s, const Segment& t) {
  const int a = points.orientation(s[0], s[1], t[0]), b = points.orientation(s[0], s[1], t[1]);
  if (a * b > 0) return true;
  const int c = points.orientation(t[0], t[1], s[0]), d = points.orientation(t[0], t[1], s[1]);
  if (c * d > 0) return true;
  if (a != 0 || b != 0 || c != 0 || d != 0) return false;
  // On one line: neither end of one is between those of the other.
  const auto between = [&](u32 i, const Segment& ends) {
    return points.side(i, ends[0], ends[1]) <= 0;
  };
  return !between(t[0], s) && !between(t[1], s) && !between(s[0], t) && !between(s[1], t);
}

/// Segments (a, b) and (a, c) meet in a only.
bool fork(const PlanarPoints& points, u32 a, u32 b, u32 c) {
  return b != c && (points.orientation(a, b, c) != 0 || points.side(a, b, c) < 0);
}

bool may_meet(const PlanarPoints& points, const Segment& s, const Segment& t) {
  for (unsigned i = 0; i < 2; ++i)
    for (unsigned k = 0; k < 2; ++k)
      if (s[i] == t[k]) return fork(points, s[i], s[1 - i], t[1 - k]);
  return apart(points, s, t) || disjoint(points, s, t);
}

}  // namespace

bool are_simple(const PlanarPoints& points, const std::vector<Segment>& segments) {
  struct Entry {
    double low, high;
    u32 segment;
  };
  std::vector<Entry> order;
  for (u32 i = 0; i < segments.size(); ++i) {
    const auto [a, b] = segments[i];
    if (points.same(a, b)) return false;
    const auto [low, high] = std::minmax(points.near(a)[0], points.near(b)[0]);
    order.push_back({low, high, i});
  }
  std::ranges::sort(order, {}, [](const Entry& e) { return std::pair(e.low, e.segment); });
  const double room = 2.1 * points.error();
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t k = i + 1; k < order.size() && order[k].low <= order[i].high + room; ++k)
      if (!may_meet(points, segments[order[i].segment], segments[order[k].segment])) return false;
  return true;
}

bool holds(const PlanarPoints& points, const std::vector<u32>& polygon, u32 point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const u32 a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const bool up = points.above(b, point);
    if (points.above(a, point) == up) continue;
    // The edge passes the height of the point: to its right, going up, iff it turns left there.
    inside ^= points.orientation(a, b, point) == (up ? 1 : -1);
  }
  return inside;
}

}  // namespace crest::certify::modes

// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/rays.hpp"

#include <algorithm>
#include <tuple>

namespace crest::certify::skeleton {
namespace {

using Exact = Plane<Rational>;

/// det(x - z, v(x)) at the ends of a side across from z, and its polar form: Bernstein
/// coefficients along the side, the middle one twice.
struct Quadratic {
  Rational q0, q1, q2;

  Quadratic(const Field& field, u32 side, const Exact& z) {
    const u32 head = next_corner(side);
    const Exact d0 = exact(field.position(side)) - z, d1 = exact(field.position(head)) - z;
    const Exact v0 = exact(field.vector(side)), v1 = exact(field.vector(head));
    q0 = det(d0, v0);
    q1 = det(d0, v1) + det(d1, v0);
    q2 = det(d1, v1);
  }
  int sign_at(const Rational& s) const {
    const Rational r = 1 - s;
    return static_cast<int>(kernel::sign_of(Rational(r * r * q0 + r * s * q1 + s * s * q2)));
  }
  int slope_at(const Rational& s) const {
    return static_cast<int>(kernel::sign_of(Rational(2 * (q0 - q1 + q2) * s + q1 - 2 * q0)));
  }
  /// The number of the root with this sign before it.
  u8 number(int before) const { return q0 * q2 > 0 && before * q0 < 0 ? 1 : 0; }
};

/// The zero of a component in a triangle, seen from one of its sides.
Exact zero_across(const Context& context, u32 side, const Component& zero) {
  const u32 t = side / 3;
  const u32 found = context.zeros.of_triangle[t];
  require(found != kNone && &context.zeros.components[found] == &zero,
          "triangle {}: does not hold the zero where a ray starts", t);
  const u32 opposite = previous_corner(side);
  if (zero.stated.place == ZeroPlace::triangle || zero.stated.place == ZeroPlace::edge) {
    require(zero.place == kNone || (zero.place != side && context.domain.twin[side] != zero.place),
            "side {}: holds the zero whose ray should leave through it", side);
    return zero_point(context.field, context.domain, zero);
  }
  require(is_zero(context.field.vector(opposite)) && !is_zero(context.field.vector(side)) &&
              !is_zero(context.field.vector(next_corner(side))),
          "side {}: not across from the zero", side);
  return exact(context.field.position(opposite));
}

}  // namespace

RaySigns ray_signs(const Context& context, u32 side, const Component& zero, const Rational& left,
                   const Rational& right) {
  const Quadratic q(context.field, side, zero_across(context, side, zero));
  return {q.sign_at(left), q.sign_at(right)};
}

Ray ray_name(const Context& context, const SkeletonLeg& leg, const Component& zero,
             const RaySigns& signs, bool backward) {
  if (zero.stated.place == ZeroPlace::triangle) return {leg.corner, 0, !backward};
  const Quadratic q(context.field, leg.corner, zero_across(context, leg.corner, zero));
  return {leg.corner, q.number(signs.right), !backward};
}

Ray ray_name(const Context& context, const StraightWalk& walk, const Component& zero,
             bool backward) {
  const Field& field = context.field;
  const Spot exit = walk.first_exit();
  if (zero.place == kNone) {
    if (exit.kind == Spot::at_vertex) return {context.domain.fan[exit.name], 3, !backward};
    return {exit.name, 0, !backward};
  }
  const Exact z = zero_point(field, context.domain, zero), d = walk.direction();
  const auto try_side = [&](u32 side) -> std::optional<Ray> {
    const Exact e0 = exact(field.position(side)) - z,
                e1 = exact(field.position(next_corner(side))) - z;
    const Rational from = det(e0, d), to = det(d, e1);
    if (from == 0 && dot(e0, d) > 0) return Ray{side, 2, !backward};
    if (from <= 0 || to <= 0) return std::nullopt;
    const Rational s = from / (from + to);
    const Quadratic q(field, side, z);
    return Ray{side, q.number(-q.slope_at(s)), !backward};
  };
  if (zero.stated.place == ZeroPlace::vertex) {
    for (const u32 c : context.domain.corners_of(zero.place))
      if (const auto ray = try_side(next_corner(c))) return *ray;
  } else {
    for (const u32 side : {zero.place, context.domain.twin[zero.place]})
      for (const u32 exit_side : {next_corner(side), previous_corner(side)})
        if (const auto ray = try_side(exit_side)) return *ray;
  }
  throw Reject("a straight line leaves no cone of its zero");
}

namespace {

/// Lines of one origin and time direction: `known` of them ascending by ray, and more.
struct Group {
  SkeletonOrigin origin;
  u32 from;
  bool backward;
  std::vector<Ray> known;
  std::size_t unknown = 0;
};

void check_group(const Context& context, const Group& g) {
  const char* time = g.backward ? "backward" : "forward";
  const std::size_t count = g.known.size() + g.unknown;
  if (g.origin == SkeletonOrigin::switch_point) {
    const std::size_t expected = context.boundary.switches[g.from].inside;
    require(count == expected, "switch point {}: {} lines {} stated, {} found", g.from, count, time,
            expected);
    return;
  }
  const Component& zero = context.zeros.components[g.from];
  if (zero.stated.index == kNoIndex) return;
  require(std::adjacent_find(g.known.begin(), g.known.end()) == g.known.end(),
          "zero {}: a line twice", g.from);
  std::size_t expected = 0;
  if (zero.stated.place == ZeroPlace::triangle) {
    expected = zero.stated.kind == ZeroClass::saddle ? 2 : 0;
  } else {
    std::vector<Ray> rays;
    for (const Ray& ray : zero.rays)
      if (ray.out != g.backward) rays.push_back(ray);
    expected = rays.size();
    require(std::includes(rays.begin(), rays.end(), g.known.begin(), g.known.end()),
            "zero {}: a line that bounds no hyperbolic sector", g.from);
  }
  require(count == expected, "zero {}: {} lines {} stated, {} found", g.from, count, time,
          expected);
}

}  // namespace

void check_completeness(const Context& context, std::vector<Claimed> lines) {
  const auto key = [](const Claimed& line) {
    return std::tuple(line.origin, line.from, line.backward, !line.known, line.ray);
  };
  std::sort(lines.begin(), lines.end(),
            [&](const Claimed& a, const Claimed& b) { return key(a) < key(b); });
  std::size_t at = 0;
  const auto check = [&](SkeletonOrigin origin, u32 from, bool backward) {
    Group group{origin, from, backward, {}, 0};
    for (; at < lines.size() && lines[at].origin == origin && lines[at].from == from &&
           lines[at].backward == backward;
         ++at)
      if (lines[at].known)
        group.known.push_back(lines[at].ray);
      else
        ++group.unknown;
    check_group(context, group);
  };
  for (u32 i = 0; i < context.zeros.components.size(); ++i)
    for (const bool backward : {false, true}) check(SkeletonOrigin::zero, i, backward);
  for (u32 i = 0; i < context.boundary.switches.size(); ++i)
    for (const bool backward : {false, true}) check(SkeletonOrigin::switch_point, i, backward);
  while (at < lines.size() && lines[at].origin == SkeletonOrigin::vertex) ++at;
  require(at == lines.size(), "a line of nothing");
}

}  // namespace crest::certify::skeleton

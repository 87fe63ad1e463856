// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/straight.hpp"

namespace crest::certify::skeleton {
namespace {

using Exact = Plane<Rational>;

/// Barycentric coordinates of x, times twice the area.
std::array<Rational, 3> coordinates(const Field& field, u32 t, const Exact& x) {
  std::array<Rational, 3> l;
  for (u32 k = 0; k < 3; ++k) {
    const u32 side = next_corner(3 * t + k);
    const Exact p = exact(field.position(side));
    l[k] = det(exact(field.position(next_corner(side))) - p, x - p);
  }
  return l;
}

Exact velocity(const Field& field, u32 t, const Exact& x) {
  const auto l = coordinates(field, t, x);
  Exact sum{0, 0};
  for (u32 k = 0; k < 3; ++k) sum = sum + l[k] * exact(field.vector(3 * t + k));
  return Rational(1 / Rational(l[0] + l[1] + l[2])) * sum;
}

}  // namespace

void StraightWalk::spend(std::size_t corners) const {
  const auto cost = static_cast<std::int64_t>(corners);
  if (context_.budget.corners.fetch_sub(cost) < cost) throw Reject("too long straight lines");
}

StraightWalk::Element StraightWalk::ahead_of_vertex(u32 corner) const {
  const Field& field = context_.field;
  const auto fan = context_.domain.corners_of(context_.domain.fan[corner]);
  spend(fan.size());
  // A side that is followed goes by the triangle at its left, if it has one: whatever the numbers.
  Element along{};
  for (const u32 c : fan) {
    const Exact e1 = exact(field.position(next_corner(c))) - x_,
                e2 = exact(field.position(previous_corner(c))) - x_;
    const Rational from = det(e1, d_), to = det(d_, e2);
    if (from > 0 && to > 0) return {true, 3 * (c / 3), false};
    if (from == 0 && dot(e1, d_) > 0) return {false, c, true};
    if (to == 0 && dot(e2, d_) > 0) along = {false, previous_corner(c), false};
  }
  return along;
}

/// What lies ahead; a name of kNone: nothing.
StraightWalk::Element StraightWalk::ahead() const {
  if (spot_.kind == Spot::inside) return {true, spot_.name, false};
  if (spot_.kind == Spot::at_vertex) return ahead_of_vertex(spot_.name);
  const Field& field = context_.field;
  const Exact e =
      exact(field.position(next_corner(spot_.name))) - exact(field.position(spot_.name));
  const Rational turn = det(e, d_);
  const u32 other = context_.domain.twin[spot_.name];
  if (turn == 0) {
    const bool to_head = dot(e, d_) > 0;
    return to_head || other == kNone ? Element{false, spot_.name, to_head}
                                     : Element{false, other, true};
  }
  if (turn > 0) return {true, 3 * (spot_.name / 3), false};
  return other == kNone ? Element{} : Element{true, 3 * (other / 3), false};
}

bool StraightWalk::leaves() const {
  return ahead().name == kNone;
}

void StraightWalk::check(const Exact& v_from, const Exact& v_to, const Exact& y) {
  const int sense = backward_ ? -1 : 1;
  if (det(v_from, d_) != 0 || det(v_to, d_) != 0) fail("is not straight");
  const Rational from = sense * dot(v_from, d_), to = sense * dot(v_to, d_);
  if (from < 0 || (from == 0 && to <= 0)) fail("runs against the field");
  if (to < 0) {  // a zero in between
    x_ = x_ + Rational(from / (from - to)) * (y - x_);
    spot_ = {Spot::inside, 3 * triangle_};
    at_zero_ = true;
    return;
  }
  x_ = y;
  at_zero_ = to == 0;
}

void StraightWalk::pass(const Element& element) {
  const Field& field = context_.field;
  triangle_ = element.name / 3;
  if (!element.through) {
    const u32 end = element.to_head ? next_corner(element.name) : element.name;
    spot_ = {Spot::at_vertex, end};
    return check(velocity(field, triangle_, x_), exact(field.vector(end)),
                 exact(field.position(end)));
  }
  const auto l = coordinates(field, triangle_, x_), moved = coordinates(field, triangle_, x_ + d_);
  Rational s = -1;
  for (u32 k = 0; k < 3; ++k)
    if (moved[k] < l[k]) {
      const Rational hit = l[k] / (l[k] - moved[k]);
      if (s < 0 || hit < s) s = hit;
    }
  u32 gone = 0, left = 0, side = 0;
  for (u32 k = 0; k < 3; ++k) {
    const bool zero = l[k] + s * (moved[k] - l[k]) == 0;
    gone += zero;
    (zero ? side : left) = 3 * triangle_ + k;
  }
  spot_ = gone == 2 ? Spot{Spot::at_vertex, left} : Spot{Spot::in_side, next_corner(side)};
  const Exact y = x_ + s * d_;
  check(velocity(field, triangle_, x_), velocity(field, triangle_, y), y);
}

void StraightWalk::run(const SkeletonLeg& leg, const Component* zero) {
  if (leg.first.size() != 2 || !leg.second.empty() || leg.elements == 0)
    fail("a straight leg needs a direction and elements");
  d_ = {Rational(leg.first[0]), Rational(leg.first[1])};
  if (d_.x == 0 && d_.y == 0) fail("a straight leg without direction");
  const Field& field = context_.field;
  if (zero == nullptr) {
    x_ = exact(field.position(leg.corner));
    spot_ = {Spot::at_vertex, leg.corner};
  } else if (zero->stated.place == ZeroPlace::triangle || zero->stated.place == ZeroPlace::edge) {
    const bool edge = zero->stated.place == ZeroPlace::edge;
    x_ = zero_point(field, context_.domain, *zero);
    spot_ = {edge ? Spot::in_side : Spot::inside, edge ? zero->place : 3 * zero->stated.triangle};
  } else {
    if (!is_zero(field.vector(leg.corner)) ||
        &context_.zeros.components[context_.zeros.of_triangle[leg.corner / 3]] != zero)
      fail("does not start at its zero");
    x_ = exact(field.position(leg.corner));
    spot_ = {Spot::at_vertex, leg.corner};
  }
  for (u32 i = 0; i < leg.elements; ++i) {
    if (at_zero_) fail("goes on beyond a zero");
    spend(1);
    const Element element = ahead();
    if (element.name == kNone) fail("goes on beyond the boundary");
    passed_.push_back({element.through, element.name / 3, spot_, {}, x_});
    pass(element);
    passed_.back().to = spot_;
    if (i == 0) first_ = spot_;
  }
}

}  // namespace crest::certify::skeleton

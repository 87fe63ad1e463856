// SPDX-License-Identifier: GPL-3.0-or-later
// Where a corridor begins, and its end in a trap (SPEC.md, "Legs").
#include "certify/skeleton/corridor.hpp"
#include "certify/skeleton/rays.hpp"
#include "certify/skeleton/traps.hpp"

namespace crest::certify::skeleton {
namespace {

/// In the order of the list, in numbers of the leg's bits.
template <class Number>
Number sum_of(std::span<const double> parts) {
  Number sum = 0.0;
  for (const double x : parts) sum = sum + Number(x);
  require(is_finite(sum), "a start is not finite");
  return sum;
}

Plane<Rational> between(const Pair& p, const Pair& q, const Rational& s) {
  return exact(p) + s * (exact(q) - exact(p));
}

}  // namespace

template <class Number>
RaySigns Corridor<Number>::start_ray(const SkeletonLeg& leg, const Component& zero) {
  at_ = {leg.corner, sum_of<Number>(leg.first), sum_of<Number>(leg.second)};
  need(in_side(at_.left) && in_side(at_.right), "a start that is not in its side", leg.corner / 3);
  const RaySigns signs =
      ray_signs(context_, leg.corner, zero, tail_distance(at_.left), tail_distance(at_.right));
  need(signs.left * signs.right < 0, "no ray of the zero passes the segment", leg.corner / 3);
  arrive(leg.corner);
  return signs;
}

template <class Number>
void Corridor<Number>::start_point(const SkeletonLeg& leg) {
  need(!is_zero(context_.field.vector(leg.corner)), "starts at a zero", leg.corner / 3);
  const Start start{leg.corner, {Number(0.0), Number(0.0)}};
  starts_ = {start, start};
  at_.side = leg.corner;
  starting_ = true;
}

template <class Number>
void Corridor<Number>::start_along(const SkeletonLeg& leg, u32 vertex) {
  const Field& field = context_.field;
  const u32 side = leg.corner, head = next_corner(side), t = side / 3;
  need(leg.second.size() % 2 == 0, "not as many digits in both coordinates", t);
  const Number q = sum_of<Number>(leg.first);
  need(in_side(q), "a start that is not in its side", t);
  const std::span parts(leg.second);
  const Point<Number> inner{sum_of<Number>(parts.first(parts.size() / 2)),
                            sum_of<Number>(parts.last(parts.size() / 2))};
  const Rational a = to_rational(inner.a), b = to_rational(inner.b);
  need(a > 0 && b > 0 && a + b < 1, "a start that is not inside its triangle", t);

  const double sense = backward_ ? -1 : 1;
  const auto velocity = [&](u32 corner) {
    const Pair& v = field.vector(corner);
    return Pair{sense * v[0], sense * v[1]};
  };
  const Pair &o = field.position(side), &h = field.position(head),
             &apex = field.position(previous_corner(side));
  const Plane<Rational> e = exact(h) - exact(o);
  const Rational n0 = det(e, exact(velocity(side))), n1 = det(e, exact(velocity(head)));
  Rational s = 0;  // of p
  if (vertex == kNone) {
    need(n0 * n1 < 0, "v.N does not change its sign inside the side", t);
    s = n0 / (n0 - n1);
  } else {
    need(vertex == field.vertex(side) || vertex == field.vertex(head), "starts elsewhere", t);
    s = vertex == field.vertex(side) ? 0 : 1;
    need((s == 0 ? n0 : n1) == 0, "v is not along the side at its start", t);
  }
  const Rational to = tail_distance(q);
  need(to != s, "a start without length", t);
  need((1 - to) * n0 + to * n1 > 0, "v is not into the triangle at its start", t);
  const Plane<Rational> v_p = between(velocity(side), velocity(head), s),
                        v_q = between(velocity(side), velocity(head), to), p = between(o, h, s);
  const Plane<Rational> x = exact(o) + a * e + b * (exact(apex) - exact(o));
  const Plane<Rational> v_side = exact(velocity(side));
  const Plane<Rational> v_x = v_side + a * (exact(velocity(head)) - v_side) +
                              b * (exact(velocity(previous_corner(side))) - v_side);
  const int inner_turn = to > s ? 1 : -1;  // the path inside is L if q lies ahead on the side
  const Plane<Rational> step = x - p, along = (to - s) * e;
  need(inner_turn * det(step, v_p) < 0 && inner_turn * det(step, v_x) < 0,
       "the start inside is not one-way", t);
  if (context_.zeros.of_triangle[t] != kNone)
    need(dot(step, v_p) > 0 && dot(step, v_x) > 0 && dot(along, v_p) > 0 && dot(along, v_q) > 0,
         "a start turns away from the field", t);
  const Start inside{side, inner}, outside = on_side(side, q);
  starts_ = inner_turn > 0 ? std::array{inside, outside} : std::array{outside, inside};
  at_.side = side;
  starting_ = true;
}

template <class Number>
void Corridor<Number>::end_in_trap(const Trap& trap, const SkeletonBarrier& barrier) {
  need(!at_boundary_, "ends at the boundary", at_.side / 3);
  need(trap.backward() == backward_, "ends in a zero of the other kind", at_.side / 3);
  ++cells_;
  const auto starts =
      starting_ ? starts_ : std::array{on_side(at_.side, at_.left), on_side(at_.side, at_.right)};
  Point<Number> ends[2];
  for (const std::size_t i : {0U, 1U}) {
    Maker& maker = i == 0 ? left_ : right_;
    const auto trapped = [&](const Point<Number>& p) {
      return trap.seems_to_hold(starts[i].corner, {to_double(p.a), to_double(p.b)});
    };
    const char* what =
        maker.run(task(starts[i], i == 0 ? 1 : -1, kNone, barrier), trapped, ends[i]);
    if (what != nullptr) fail(what, at_.side / 3);
  }
  const auto rational = [](const Point<Number>& p) {
    return Point<Rational>{to_rational(p.a), to_rational(p.b)};
  };
  const u32 corner = starts[0].corner;
  need(trap.holds(corner, rational(ends[0]), reframed(rational(ends[1]), starts[1].corner, corner)),
       "does not end in the trap", at_.side / 3);
}

template class Corridor<double>;
template class Corridor<Big>;

}  // namespace crest::certify::skeleton

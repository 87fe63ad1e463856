// SPDX-License-Identifier: GPL-3.0-or-later
#include "certify/skeleton/corridor.hpp"

namespace crest::certify::skeleton {
namespace {

/// Coordinate that vanishes on a side, seen from a corner of its triangle.
int coordinate_of(u32 corner, u32 side) {
  const u32 opposite = previous_corner(side);
  return opposite == corner ? 0 : opposite == next_corner(corner) ? 1 : 2;
}

}  // namespace

template <class Number>
typename Corridor<Number>::Start Corridor<Number>::on_side(u32 side, const Number& t) {
  if (t > Number(0.0)) return {side, {t, Number(0.0)}};
  return {next_corner(side), {Number(0.0), Number(-t)}};
}

template <class Number>
Number Corridor<Number>::side_point(u32 corner, const Point<Number>& p, u32 exit) const {
  if (exit == corner) return from_tail(p.a);
  if (exit == previous_corner(corner)) return from_head(p.b);
  return p.b <= Number(0.5) ? p.b : Number(-p.a);
}

template <class Number>
typename Corridor<Number>::Maker::Task Corridor<Number>::task(
    const Start& start, int turn, u32 exit, const SkeletonBarrier& barrier) const {
  return {start.corner,
          start.point,
          turn,
          context_.zeros.of_triangle[start.corner / 3] != kNone,
          exit == kNone ? -1 : coordinate_of(start.corner, exit),
          barrier};
}

/// v leaves through both ends of at_, of which the left one is at the left.
template <class Number>
void Corridor<Number>::require_out(u32 exit) const {
  const Sign out = backward_ ? Sign::positive : Sign::negative;
  for (const Number& t : {at_.left, at_.right}) {
    need(in_side(t), "a barrier ends beyond its side", exit / 3);
    need(normal_sign(context_.field, exit, t, sign_) == out,
         "the field does not leave through the exit", exit / 3);
  }
  need(before(at_.right, at_.left), "the barriers cross", exit / 3);
}

template <class Number>
void Corridor<Number>::arrive(u32 exit) {
  require_out(exit);
  const u32 other = context_.domain.twin[exit];
  at_boundary_ = other == kNone;
  at_.side = exit;
  if (at_boundary_) return;
  at_ = {other, mirrored(at_.left), mirrored(at_.right)};
}

template <class Number>
void Corridor<Number>::note(const Start& left, const Start& right) {
  const u32 zero = context_.zeros.of_triangle[left.corner / 3];
  if (zero == kNone || context_.zeros.components[zero].stated.place != ZeroPlace::triangle) return;
  // A path may start inside the triangle, but not both.
  const bool inside = left.point.a > Number(0.0) && left.point.b > Number(0.0);
  const Start& start = inside ? right : left;
  passages_.push_back({static_cast<std::size_t>(cells_),
                       start.corner,
                       {to_rational(start.point.a), to_rational(start.point.b)}});
}

template <class Number>
void Corridor<Number>::cross(const Start& left, const Start& right, u32 exit,
                             const SkeletonBarrier& barrier) {
  note(left, right);
  ++cells_;
  const auto never = [](const auto&) { return false; };
  Point<Number> l{}, r{};
  if (const char* what = left_.run(task(left, 1, exit, barrier), never, l)) fail(what, exit / 3);
  if (const char* what = right_.run(task(right, -1, exit, barrier), never, r)) fail(what, exit / 3);
  at_.left = side_point(left.corner, l, exit);
  at_.right = side_point(right.corner, r, exit);
  arrive(exit);
}

template <class Number>
void Corridor<Number>::follow(const std::vector<Turn>& turns, const SkeletonBarrier& barrier,
                              const std::vector<SkeletonException>& exceptions) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    need(!at_boundary_, "goes on beyond the boundary", at_.side / 3);
    const bool other = next < exceptions.size() && exceptions[next].step == i;
    const SkeletonBarrier& now = other ? exceptions[next++].barrier : barrier;
    const u32 exit = exit_of(at_.side, turns[i]);
    if (starting_)
      cross(starts_[0], starts_[1], exit, now);
    else
      cross(on_side(at_.side, at_.left), on_side(at_.side, at_.right), exit, now);
    starting_ = false;
  }
}

template <class Number>
void Corridor<Number>::end_in_region(u32 region) const {
  need(at_boundary_, "does not reach the boundary", at_.side / 3);
  // v.N has one sign on the segment: it lies at the end of the side with that sign.
  const Sign out = backward_ ? Sign::positive : Sign::negative;
  const u32 side = at_.side;
  const bool at_tail =
      inflow_sign(sign_, context_.field.position(side), context_.field.position(next_corner(side)),
                  context_.field.vector(side)) == out;
  const u32 found = context_.boundary.regions[side][at_tail ? 0 : 1];
  require(found == region, "{}: ends in region {}, {} stated", name_, found, region);
}

template <class Number>
void Corridor<Number>::end_in_segment(const Segment<Number>& other, bool strictly) const {
  need(!at_boundary_ && !starting_ && at_.side == other.side, "does not reach the orbit's segment",
       at_.side / 3);
  // Seen from the triangle entered, left is nearer to the tail.
  const bool inside = strictly ? before(other.left, at_.left) && before(at_.right, other.right)
                               : !before(at_.left, other.left) && !before(other.right, at_.right);
  need(inside, "does not end inside the orbit's segment", at_.side / 3);
}

template <class Number>
void Corridor<Number>::end_in_wall(u32 component) const {
  need(!at_boundary_ && !starting_, "ends at the boundary", at_.side / 3);
  const Field& field = context_.field;
  const u32 t = at_.side / 3;
  need(context_.zeros.of_triangle[t] == component, "not at the zero that is stated", t);
  u32 third = kNone, zeros = 0;
  for (const u32 c : {3 * t, 3 * t + 1, 3 * t + 2})
    if (is_zero(field.vector(c)))
      ++zeros;
    else
      third = c;
  need(zeros == 2, "no wall", t);
  // v is parallel to u: barycentric coordinates move at constant rates.
  Plane<Rational> u = exact(field.vector(third));
  if (backward_) u = {-u.x, -u.y};
  const auto rate = [&](u32 corner) {
    const u32 side = next_corner(corner);
    return Rational(det(exact(field.position(next_corner(side))) - exact(field.position(side)), u));
  };
  const Rational towards = -rate(third);
  need(towards > 0, "does not reach the wall", t);
  for (const Number& end : {at_.left, at_.right}) {
    const Rational s = tail_distance(end);
    const auto coordinate = [&](u32 corner) {
      return corner == at_.side                ? Rational(1 - s)
             : corner == next_corner(at_.side) ? s
                                               : Rational(0);
    };
    for (const u32 c : {next_corner(third), previous_corner(third)})
      need(coordinate(c) * towards + rate(c) * coordinate(third) > 0, "misses the wall", t);
  }
}

template class Corridor<double>;
template class Corridor<Big>;

}  // namespace crest::certify::skeleton

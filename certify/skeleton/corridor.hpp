// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A stream line between two barriers, triangle by triangle (SPEC.md, lemma 13).
#include <atomic>

#include "certify/container/reject.hpp"
#include "certify/skeleton/arc.hpp"
#include "certify/skeleton/boundary.hpp"

namespace crest::certify::skeleton {

class Trap;

/// Of det(x - z, v(x)) at the ends of a segment across from a zero z.
struct RaySigns {
  int left, right;
};

/// What all lines together may still spend: else a short file could cost much.
struct Budget {
  std::atomic<std::int64_t> corners;  ///< that straight lines look at
  std::atomic<std::int64_t> pieces;   ///< of paths, beyond 64 each
};

/// All that is known before lines are followed.
struct Context {
  const SkeletonCertificate& stated;
  const Field& field;
  const Domain& domain;
  const ZeroSet& zeros;
  const Boundary& boundary;
  Budget& budget;
};

/// The side through which a turn leaves the triangle entered through another.
inline u32 exit_of(u32 entered, Turn turn) {
  return turn == Turn::right  ? next_corner(entered)
         : turn == Turn::left ? previous_corner(entered)
                              : entered;
}

/// Where a line enters a triangle that holds a zero: a point of its segment, in a corner's frame.
struct Passage {
  std::size_t turn;
  u32 corner;
  Point<Rational> at;
};

/// How much was done.
struct Work {
  std::uint64_t cells = 0, pieces = 0, exact_pieces = 0;
};

/// Ends of a segment in an open side, as in records.hpp: left and right along the line.
template <class Number>
struct Segment {
  u32 side = kNone;
  Number left = 0.0, right = 0.0;
};

/// From a distance to the tail or head, 0 < d < 1; exact.
template <class Number>
Number from_tail(const Number& d) {
  return d <= Number(0.5) ? d : Number(-(Number(1.0) - d));
}
template <class Number>
Number from_head(const Number& d) {
  return d < Number(0.5) ? Number(-d) : Number(Number(1.0) - d);
}
/// The same point, of the side that runs the other way.
template <class Number>
Number mirrored(const Number& t) {
  return t == Number(0.5) ? t : Number(-t);
}
/// s is strictly nearer to the tail than t.
template <class Number>
bool before(const Number& s, const Number& t) {
  const bool tail_s = s > Number(0.0), tail_t = t > Number(0.0);
  return tail_s == tail_t ? s < t : tail_s;
}
template <class Number>
bool in_side(const Number& t) {
  return is_finite(t) && t <= Number(0.5) && t > Number(-0.5) && !(t == Number(0.0));
}
/// A point as an exact distance from the tail.
template <class Number>
Rational tail_distance(const Number& t) {
  const Rational x = to_rational(t);
  return x > 0 ? x : Rational(1 + x);
}

/// Sign of v.N at a point of a side, N into its triangle.
template <class Number>
Sign normal_sign(const Field& field, u32 side, const Number& t, SignLadder& sign) {
  const u32 head = next_corner(side);
  const Pair &p = field.position(side), &q = field.position(head);
  const Sign at_tail = inflow_sign(sign, p, q, field.vector(side)),
             at_head = inflow_sign(sign, p, q, field.vector(head));
  // v.N is linear, t inside the side.
  if (at_tail == at_head || at_head == Sign::zero) return at_tail;
  if (at_tail == Sign::zero) return at_head;
  const Rational s = tail_distance(t);
  const Plane<Rational> e = exact(q) - exact(p);
  return kernel::sign_of(Rational((1 - s) * det(e, exact(field.vector(side))) +
                                  s * det(e, exact(field.vector(head)))));
}

/// Follows one line; every step throws Reject unless it is proven.
template <class Number>
class Corridor {
 public:
  Corridor(const Context& context, bool backward, SignLadder& sign, std::string name)
      : context_(context),
        sign_(sign),
        backward_(backward),
        name_(std::move(name)),
        left_(context.field, backward, context.budget.pieces),
        right_(context.field, backward, context.budget.pieces) {}

  // Starts (SPEC.md, "Legs").
  void start_segment(const Segment<Number>& entered) { at_ = entered; }
  RaySigns start_ray(const SkeletonLeg& leg, const Component& zero);
  void start_point(const SkeletonLeg& leg);
  /// From `vertex`, an end of the side leg.corner, or where v.N = 0 inside it (kNone).
  void start_along(const SkeletonLeg& leg, u32 vertex);

  /// Crosses one triangle a turn.
  void follow(const std::vector<Turn>& turns, const SkeletonBarrier& barrier,
              const std::vector<SkeletonException>& exceptions);

  // Ends.
  void end_in_region(u32 region) const;
  void end_in_segment(const Segment<Number>& other, bool strictly) const;
  /// Inside an ellipse of a triangle or an edge, or a vertex's polygon.
  void end_in_trap(const Trap& trap, const SkeletonBarrier& barrier);
  void end_in_wall(u32 component) const;

  const Segment<Number>& at() const { return at_; }
  /// Of the turns followed.
  std::vector<Passage> passages() && { return std::move(passages_); }
  bool at_boundary() const { return at_boundary_; }
  Work work() const {
    return {cells_, left_.pieces() + right_.pieces(), left_.exact_pieces() + right_.exact_pieces()};
  }

 private:
  using Maker = ArcMaker<Number>;
  struct Start {
    u32 corner;
    Point<Number> point;
  };
  static Start on_side(u32 side, const Number& t);
  void cross(const Start& left, const Start& right, u32 exit, const SkeletonBarrier& barrier);
  Number side_point(u32 corner, const Point<Number>& p, u32 exit) const;
  void arrive(u32 exit);
  void note(const Start& left, const Start& right);
  void require_out(u32 exit) const;
  void first_segment(const SkeletonLeg& leg, const Point<Number>& inner, const Rational& from,
                     int turn) const;
  typename Maker::Task task(const Start& start, int turn, u32 exit,
                            const SkeletonBarrier& barrier) const;
  [[noreturn]] void fail(const char* what, u32 triangle) const {
    throw Reject(fmt::format("{}, triangle {}: {}", name_, triangle, what));
  }
  void need(bool condition, const char* what, u32 triangle) const {
    if (!condition) fail(what, triangle);
  }

  const Context& context_;
  SignLadder& sign_;
  bool backward_;
  std::string name_;
  Maker left_, right_;
  Segment<Number> at_;
  bool at_boundary_ = false;
  bool starting_ = false;  ///< the next cell starts at starts_
  std::array<Start, 2> starts_{};
  std::uint64_t cells_ = 0;
  std::vector<Passage> passages_;
};

}  // namespace crest::certify::skeleton

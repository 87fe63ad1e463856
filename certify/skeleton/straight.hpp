// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Stream lines that are straight, in rationals (SPEC.md, "Legs").
#include "certify/skeleton/corridor.hpp"

namespace crest::certify::skeleton {

/// A point of the domain.
struct Spot {
  enum Kind : u8 { inside, in_side, at_vertex } kind = inside;
  u32 name = kNone;  ///< corner 0 of the triangle; a side; a corner at the vertex
};

/// Walks from a zero or a vertex in a direction along which v is parallel to it.
class StraightWalk {
 public:
  /// A triangle crossed, or a side followed.
  struct Passed {
    bool through;
    u32 triangle;
    Spot from, to;
    Plane<Rational> start;
  };

  StraightWalk(const Context& context, bool backward, std::string name)
      : context_(context), backward_(backward), name_(std::move(name)) {}

  /// From the zero, or from the vertex of leg.corner. Throws Reject.
  void run(const SkeletonLeg& leg, const Component* zero);

  const Spot& spot() const { return spot_; }
  /// Where the first element ended.
  const Spot& first_exit() const { return first_; }
  const Plane<Rational>& direction() const { return d_; }
  bool at_zero() const { return at_zero_; }
  u32 triangle() const { return triangle_; }  ///< of the last element
  const std::vector<Passed>& passed() const { return passed_; }

  /// Nothing of the domain lies ahead. Requires: not at a zero.
  bool leaves() const;

 private:
  struct Element {
    bool through = false;  ///< through `name`'s triangle, or along the side `name`
    u32 name = kNone;
    bool to_head = false;
  };
  Element ahead() const;
  Element ahead_of_vertex(u32 corner) const;
  void pass(const Element& element);
  void check(const Plane<Rational>& v_from, const Plane<Rational>& v_to, const Plane<Rational>& y);
  /// Throws Reject when all lines together have looked at too many corners.
  void spend(std::size_t corners) const;
  [[noreturn]] void fail(const char* what) const { throw Reject(name_ + ": " + what); }

  const Context& context_;
  bool backward_;
  std::string name_;
  Plane<Rational> x_{}, d_{};
  Spot spot_, first_;
  u32 triangle_ = kNone;
  bool at_zero_ = false;
  std::vector<Passed> passed_;
};

}  // namespace crest::certify::skeleton

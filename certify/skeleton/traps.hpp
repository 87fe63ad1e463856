// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Neighbourhoods of a sink that nobody leaves (of a source: of -v) (SPEC.md, step 4).
#include <map>

#include "certify/skeleton/frame.hpp"
#include "certify/skeleton/zeros.hpp"

namespace crest::certify::skeleton {

class Trap {
 public:
  /// Throws Reject unless it is one. Cost: rationals, a few dozen a point.
  Trap(const Field& field, const Domain& domain, const ZeroSet& zeros, const SkeletonTrap& stated);

  bool backward() const { return backward_; }
  /// Whether two points of the triangle of `corner`, in its frame, are inside together with the
  /// segment between them.
  bool holds(u32 corner, const Point<Rational>& p, const Point<Rational>& q) const;
  /// A guess for one point.
  bool seems_to_hold(u32 corner, const Point<double>& p) const;

 private:
  /// A part of the polygon: the triangle z, from, to in the frame of its corner at z.
  struct Part {
    u32 corner;
    Point<Rational> from, to;
  };
  using Form = std::array<Rational, 3>;  ///< aa, ab, bb
  /// What of an ellipse lies in a triangle, in the frame of its corner 0.
  struct Ellipse {
    u32 triangle;
    Point<Rational> centre;
    Form form;
    std::array<double, 5> rounded;  ///< centre, form
  };
  /// side: that with the zero inside it, or kNone.
  void check_ellipse(const Field& field, u32 zero, u32 triangle, const Form& form, u32 side);
  void check_star(const Field& field, const Domain& domain, const Component& zero,
                  const SkeletonTrap& stated);
  void check_part(const Field& field, const Part& part, u32 zero) const;
  /// The part that holds a point, or kNone. Cost: logarithmic.
  std::size_t part_of(u32 corner, const Point<Rational>& p) const;

  bool backward_ = false;
  std::vector<Ellipse> ellipses_;                       ///< two around a zero inside a side
  std::vector<Part> parts_;                             ///< counter-clockwise
  std::map<u32, std::array<std::size_t, 2>> parts_of_;  ///< of a triangle: from, to
};

/// The same point in the frame of another corner of the triangle.
template <class Number>
Point<Number> reframed(const Point<Number>& p, u32 from, u32 to) {
  if (from == to) return p;
  const Number o = (Number(1.0) - p.a) - p.b;
  return to == next_corner(from) ? Point<Number>{p.b, o} : Point<Number>{o, p.a};
}

}  // namespace crest::certify::skeleton

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A corridor's way through triangles: cells.
#include "algorithms/vector_fields/barrier.hpp"
#include "algorithms/vector_fields/skeleton_result.hpp"

namespace crest::vector_fields {

/// A segment of a side through which all lines enter the side's triangle; left and right as they
/// see it, left nearer to the tail.
template <class Real>
struct Gate {
  HalfEdge side = kNone;
  Real left{}, right{};
};

enum class CellEnd : std::uint8_t { crossed, left_domain, trapped, open };

template <class Real>
struct CellResult {
  CellEnd end = CellEnd::open;
  /// crossed: the next gate; left_domain: the segment as the side's own triangle sees it.
  Gate<Real> gate;
  std::uint8_t turn = 0;  ///< 0: right, through the next side; 1: left; 2: back
  BarrierSetting setting = {};
  bool special = false;  ///< another setting than the maker's own
  bool divided = false;  ///< open: the arcs left through different sides
};

/// Where an arc starts within a triangle: in the frame of a corner.
template <class Real>
struct ArcStart {
  int origin;
  Real x, y;
  int entry;  ///< as BarrierMaker::arc
};

/// A side's point as a start in its triangle.
template <class Real>
ArcStart<Real> start_on_side(HalfEdge side, const Real& t) {
  const int c = static_cast<int>(side % 3), entry = (c + 2) % 3;
  if (t > 0) return {c, t, Real(0), entry};
  return {(c + 1) % 3, Real(0), Real(-t), entry};
}

/// From the two starts through triangle t; c: the corner of the side that turns are counted from.
/// trap: an ellipse in t or none.
template <class Real>
CellResult<Real> cross_cell(BarrierMaker<Real>& maker, bool forward, Index t, int c,
                            const ArcStart<Real>& left, const ArcStart<Real>& right,
                            const TrapShape* trap);

/// Through the triangle behind a gate.
template <class Real>
CellResult<Real> cross_cell(BarrierMaker<Real>& maker, bool forward, const Gate<Real>& gate,
                            const TrapShape* trap) {
  return cross_cell(maker, forward, gate.side / 3, static_cast<int>(gate.side % 3),
                    start_on_side(gate.side, gate.left), start_on_side(gate.side, gate.right),
                    trap);
}

/// Whether `inner` lies strictly inside `outer`, on the same side.
template <class Real, class Other>
bool strictly_inside(const Gate<Real>& inner, const Gate<Other>& outer) {
  return nearer_to_tail(Real(outer.left), inner.left) &&
         nearer_to_tail(inner.right, Real(outer.right));
}

/// A point between the ends, nearly the middle: to look, not to decide.
template <class Real>
Real near_middle(const Gate<Real>& g) {
  return (g.left > 0) == (g.right > 0) ? Real((g.left + g.right) / 2) : g.left;
}

/// The place of a point of a side, in doubles.
template <class Real>
Vec2 place_on(const Domain& domain, HalfEdge side, const Real& t) {
  const double s = static_cast<double>(t);
  const Vec2 &p = domain.point(domain.from(side)), &q = domain.point(domain.to(side));
  const Vec2 &near = s > 0 ? p : q, &far = s > 0 ? q : p;
  const double f = std::fabs(s);
  return {near[0] + f * (far[0] - near[0]), near[1] + f * (far[1] - near[1])};
}

}  // namespace crest::vector_fields

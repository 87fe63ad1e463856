// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/straight.hpp"

#include "algorithms/vector_fields/exact.hpp"
#include "algorithms/vector_fields/starts.hpp"
#include "algorithms/vector_fields/walls.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::dot;
using kernel::operator+;
using kernel::operator-;

namespace {

constexpr Index kMostElements = 100'000;

void end_in_region(Index region, Trace& trace) {
  if (region == kNone) return;
  trace.end = EndKind::boundary;
  trace.target = region;
}

/// Out of the domain through the inside of a side; v: the velocity at its tail.
void leave_on_side(const Surroundings& around, HalfEdge side, const Exact& v, Trace& trace) {
  const EdgeRegions& r = around.boundary.regions.at(side);
  if (r.at_from == r.at_to) return end_in_region(r.at_from, trace);
  const Domain& d = around.domain;
  const Exact e = exact(d.point(d.to(side))) - exact(d.point(d.from(side)));
  // Outward: the end of the edge that flows out, too.
  end_in_region(cross(e, v) < 0 ? r.at_from : r.at_to, trace);
}

void leave_at_vertex(const Surroundings& around, const Fan& fan, Trace& trace) {
  const Domain& d = around.domain;
  const HalfEdge after = fan.leaving.front(), before = Domain::previous(fan.leaving.back());
  const Index v = d.from(after);
  for (Index i = 0; i < around.boundary.switch_points.size(); ++i) {
    const SwitchPoint& s = around.boundary.switch_points[i];
    if (!s.at_vertex || (s.edge != after && s.last_edge != before)) continue;
    if (d.from(s.edge) != v && d.to(s.last_edge) != v) continue;
    trace.end = EndKind::switch_point;
    trace.target = i;
    return;
  }
  const Index r = around.boundary.regions.at(after).at_from;
  end_in_region(r != kNone ? r : around.boundary.regions.at(before).at_to, trace);
}

class Walk {
 public:
  Walk(const Surroundings& around, const Start& start, Trace& trace)
      : around_(around), domain_(around.domain), start_(start), trace_(trace) {
    d_ = exact(*start.direction);
  }

  void run() {
    trace_.straight = StraightPart{*start_.direction, start_.vertex};
    if (!begin()) return;
    while (trace_.end == EndKind::undecided && trace_.straight->elements < kMostElements)
      if (vertex_ != kNone ? !from_vertex() : !from_side()) return;
    if (trace_.end == EndKind::undecided) trace_.reason = OpenReason::budget;
  }

 private:
  Exact at(Index v) const { return exact(domain_.point(v)); }
  /// The field, turned round for lines backward.
  Exact velocity(Index v) const {
    const Exact w = exact(domain_.vector(v));
    return start_.forward ? w : Exact{-w[0], -w[1]};
  }
  bool parallel(const Exact& w) const { return cross(w, d_) == 0; }

  bool begin() {
    if (start_.vertex != kNone) {
      vertex_ = start_.vertex;
      x_ = at(domain_.from(vertex_));
      return true;
    }
    if (start_.kind != StartKind::ray) return false;
    // From inside the triangle to its side or corner ahead.
    const Index t = start_.place / 3;
    const Exact a = at(domain_.from(3 * t)), b = at(domain_.from(3 * t + 1)),
                c = at(domain_.from(3 * t + 2));
    const Exact u = velocity(domain_.from(3 * t)), v = velocity(domain_.from(3 * t + 1)),
                w = velocity(domain_.from(3 * t + 2));
    const Rational l0 = cross(v, w), l1 = cross(w, u), l2 = cross(u, v), sum = l0 + l1 + l2;
    for (std::size_t i = 0; i < 2; ++i) x_[i] = (l0 * a[i] + l1 * b[i] + l2 * c[i]) / sum;
    return through(t, kNone);
  }

  /// Through triangle t from x_, which lies inside, on the side `entry` or at its corner.
  bool through(Index t, HalfEdge entry) {
    trace_.straight->triangles.push_back(t);
    HalfEdge exit = kNone;
    Rational time = -1;
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      if (h == entry) continue;
      const Exact p = at(domain_.from(h)), e = at(domain_.to(h)) - p;
      const Rational towards = cross(e, d_), here = cross(e, x_ - p);
      if (towards >= 0 || here == 0) continue;
      const Rational s = -here / towards;
      if (time < 0 || s < time) {
        time = s;
        exit = h;
      }
    }
    if (exit == kNone) return false;
    const Exact y = {x_[0] + time * d_[0], x_[1] + time * d_[1]};
    const Index a = domain_.from(exit), b = domain_.to(exit);
    const Exact e = at(b) - at(a);
    const Rational share = dot(y - at(a), e) / dot(e, e);
    const Exact u = velocity(a), v = velocity(b);
    Exact w;
    for (std::size_t i = 0; i < 2; ++i) w[i] = u[i] + share * (v[i] - u[i]);
    if (!parallel(w)) return false;
    passed(y);
    if (share == 0 || share == 1) {
      vertex_ = share == 0 ? exit : Domain::next(exit);
    } else {
      vertex_ = kNone;
      side_ = exit;
    }
    look_at(w, t);
    return true;
  }

  void passed(const Exact& y) {
    x_ = y;
    ++trace_.straight->elements;
    trace_.line.push_back({static_cast<double>(y[0]), static_cast<double>(y[1])});
  }

  /// The velocity at the new place: a zero there, or one that was passed on the way, is the end.
  void look_at(const Exact& w, Index t) {
    if (dot(w, d_) > 0) return;
    const auto zero = zero_of_triangle(around_, t);
    if (!zero) return;
    const ZeroPlace where = around_.zeros[*zero].item.where;
    const bool wall = where == ZeroPlace::line || where == ZeroPlace::region;
    trace_.end = wall ? EndKind::zero_flow : EndKind::critical_point;
    trace_.target = *zero;
  }

  bool from_vertex() {
    const Fan fan = domain_.fan(vertex_);
    for (const HalfEdge h : fan.leaving) trace_.straight->triangles.push_back(h / 3);
    for (const HalfEdge h : fan.leaving) {
      const Exact e = at(domain_.to(h)) - x_, f = at(domain_.from(Domain::previous(h))) - x_;
      const Rational s = cross(e, d_), r = cross(f, d_);
      if (s == 0 && dot(e, d_) > 0) return follow_edge(domain_.to(h), Domain::next(h), h / 3);
      if (r == 0 && dot(f, d_) > 0 && domain_.twin(Domain::previous(h)) == kNone)
        return follow_edge(domain_.from(Domain::previous(h)), Domain::previous(h), h / 3);
      if (s > 0 && r < 0) {
        if (through(h / 3, kNone)) return true;
        return go_on(fan);
      }
    }
    leave_at_vertex(around_, fan, trace_);
    return true;
  }
  /// Along an edge to `head`, which the half-edge leaves.
  bool follow_edge(Index head, HalfEdge leaving, Index t) {
    if (!parallel(velocity(head))) return go_on(domain_.fan(vertex_));
    passed(at(head));
    vertex_ = leaving;
    look_at(velocity(head), t);
    return true;
  }
  bool from_side() {
    const HalfEdge twin = domain_.twin(side_);
    if (twin == kNone) {
      leave_on_side(around_, side_, velocity(domain_.from(side_)), trace_);
      return true;
    }
    return through(twin / 3, twin);
  }

  /// The line bends at a vertex: a corridor goes on.
  bool go_on(const Fan& fan) {
    if (domain_.is_zero(domain_.from(vertex_)) || trace_.straight->elements == 0) return false;
    trace_.leg = start_at_vertex(domain_, fan, start_.forward);
    return false;
  }

  const Surroundings& around_;
  const Domain& domain_;
  const Start& start_;
  Trace& trace_;
  Exact x_, d_;
  HalfEdge vertex_ = kNone;  ///< a half-edge that leaves the vertex where the line is; or none
  HalfEdge side_ = kNone;    ///< else the side that it reached, seen from the triangle it left
};

}  // namespace

void walk_straight(const Surroundings& around, const Start& start, Trace& trace) {
  trace = {};
  trace.start = start;
  trace.leg.kind = StartKind::none;
  trace.reason = OpenReason::vertex_hit;
  Walk(around, start, trace).run();
}

}  // namespace crest::vector_fields

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/starts.hpp"

#include "algorithms/vector_fields/reals.hpp"
#include "kernel/arithmetic/rational.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::Rational;
using kernel::Sign;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

namespace {

Sign directed(bool forward, Sign s) {
  return forward ? s : -s;
}

/// Into which triangle the line through a vertex goes, and how its corridor starts there.
Start start_at_vertex(const Domain& domain, const Fan& fan, bool forward) {
  Start start;
  start.forward = forward;
  const Index p = domain.from(fan.leaving.front());
  const Vec2& v = domain.vector(p);
  const auto across = [&](Index q) {
    return directed(forward, kernel::flow_across(domain.point(p), domain.point(q), v));
  };
  const auto along = [&](Index q) {
    return directed(forward, kernel::flow_along(domain.point(p), domain.point(q), v));
  };
  // A line along a side is inside the triangle to which it bends.
  const auto bends = [&](HalfEdge h, Index q) {
    return directed(forward, kernel::flow_across(domain.point(domain.from(h)),
                                                 domain.point(domain.to(h)), domain.vector(q)));
  };
  for (const HalfEdge h : fan.leaving) {
    const Index q = domain.to(h), r = domain.from(Domain::previous(h));
    const Sign s = across(q), e = across(r);
    if (s == Sign::positive && e == Sign::negative) {
      start.kind = StartKind::point;
      start.place = h;
      return start;
    }
    const auto side = [&](HalfEdge g, int sense) {
      start.kind = StartKind::along;
      start.place = g;
      start.sense = sense;
      start.at = -sense;
    };
    if (s == Sign::zero && along(q) == Sign::positive) {
      if (bends(h, q) == Sign::positive) {
        side(h, 1);
        return start;
      }
      if (bends(h, q) == Sign::negative && domain.twin(h) != kNone) {
        side(domain.twin(h), -1);
        return start;
      }
    }
    const HalfEdge g = Domain::previous(h);
    if (domain.twin(g) == kNone && e == Sign::zero && along(r) == Sign::positive &&
        bends(g, r) == Sign::positive) {
      side(g, -1);
      return start;
    }
  }
  return start;
}

void add_switch_starts(const Domain& domain, const SwitchPoint& s, Index number,
                       std::vector<Start>& starts) {
  for (const bool forward : {true, false}) {
    Start start;
    if (s.at_vertex) {
      // Of a run along the boundary the end towards which the line goes.
      const bool run = s.edge != domain.next_on_boundary(s.last_edge);
      const HalfEdge first = s.edge;
      HalfEdge leaving = first;
      if (run) {
        const Index p = domain.from(first);
        const bool ahead =
            directed(forward, kernel::flow_along(domain.point(p), domain.point(domain.to(first)),
                                                 domain.vector(p))) == Sign::positive;
        if (ahead) leaving = domain.next_on_boundary(s.last_edge);
      }
      start = start_at_vertex(domain, domain.fan(leaving), forward);
    } else {
      start.kind = StartKind::along;
      start.forward = forward;
      start.place = s.edge;
      // At an inside touch the flow runs to where it enters: along the loop iff inflow comes after.
      start.sense = s.inflow_after ? 1 : -1;
      if (!forward) start.sense = -start.sense;
    }
    start.from_switch_point = true;
    start.origin = number;
    starts.push_back(start);
  }
}

// --- rays -------------------------------------------------------------------------------------

using Exact = kernel::Vector2<Rational>;

Exact exact(const Vec2& a) {
  return {Rational(a[0]), Rational(a[1])};
}

/// A triangle with a saddle, exactly.
struct SaddleTriangle {
  std::array<Exact, 3> p, v;
  Exact zero;
  SaddleTriangle(const Domain& domain, Index t) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      p[h % 3] = exact(domain.point(domain.from(h)));
      v[h % 3] = exact(domain.vector(domain.from(h)));
    }
    const Rational l[3] = {cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])};
    const Rational sum = l[0] + l[1] + l[2];
    zero = (l[0] / sum) * p[0] + (l[1] / sum) * p[1] + (l[2] / sum) * p[2];
  }
  /// The turn det(x - z, v(x)) and the flow out at the point t of a side, for a line forward.
  std::pair<Sign, Sign> look(int side, const Expansion& t, bool forward) const {
    Rational s = 0;
    for (const double x : t) s += Rational(x);
    if (s < 0) s += 1;
    const auto i = static_cast<std::size_t>(side), k = (i + 1) % 3;
    const Exact x = p[i] + s * (p[k] - p[i]), w = v[i] + s * (v[k] - v[i]);
    return {directed(forward, kernel::sign_of(cross(x - zero, w))),
            directed(forward, kernel::sign_of(-cross(p[k] - p[i], w)))};
  }
};

/// A number from the tail brought into the form of OnSide.
template <class Real>
Real on_side(const Real& t) {
  return t > 0.5 ? Real(t - 1) : t <= -0.5 ? Real(t + 1) : t;
}

template <class Real>
CellResult<Real> begin_ray(BarrierMaker<Real>& maker, const Start& start, Trace& trace) {
  using std::fabs;
  using std::ldexp;
  using std::sqrt;
  const Domain& domain = maker.domain();
  const Index t = start.place / 3;
  CellResult<Real> result;
  const TriangleFrame<Real> f(domain, t, 0, start.forward, maker.unit());
  const Real trace_half = (f.a[0][0] + f.a[1][1]) / 2;
  const Real det = f.a[0][0] * f.a[1][1] - f.a[0][1] * f.a[1][0];
  if (!(det < 0)) return result;
  const Real root = sqrt(trace_half * trace_half - det);
  const Real lambda = trace_half < 0 ? Real(-det / (root - trace_half)) : Real(trace_half + root);
  Real d[2] = {f.a[0][1], lambda - f.a[0][0]};
  if (fabs(f.a[1][0]) + fabs(lambda - f.a[1][1]) > fabs(d[0]) + fabs(d[1])) {
    d[0] = lambda - f.a[1][1];
    d[1] = f.a[1][0];
  }
  const Real zero[2] = {(f.w[1] * f.a[0][1] - f.w[0] * f.a[1][1]) / det,
                        (f.w[0] * f.a[1][0] - f.w[1] * f.a[0][0]) / det};
  const Real z[3] = {1 - zero[0] - zero[1], zero[0], zero[1]};
  const Real g[3] = {-start.sense * (d[0] + d[1]), start.sense * d[0], start.sense * d[1]};
  int exit = -1;
  Real time = 0;
  for (int k = 0; k < 3; ++k)
    if (g[k] < 0 && (exit < 0 || -z[k] / g[k] < time)) {
      exit = k;
      time = -z[k] / g[k];
    }
  if (exit < 0) return result;
  const int i = (exit + 1) % 3, j = (exit + 2) % 3;
  const Real tail = z[j] + time * g[j], head = z[i] + time * g[i];
  const Real at = tail <= 0.5 ? tail : Real(-head);
  const SaddleTriangle exact_triangle(domain, t);
  for (Real delta = 16 * maker.unit(); delta < ldexp(maker.unit(), 24); delta *= 16) {
    const Real left = on_side<Real>(at + delta), right = on_side<Real>(at - delta);
    if ((left > 0) != (at > 0) && fabs(at) < 0.25) break;
    if ((right > 0) != (at > 0) && fabs(at) < 0.25) break;
    if (left == 0 || right == 0) break;
    trace.first = expand(left);
    trace.second = expand(right);
    const auto [turn_l, out_l] = exact_triangle.look(i, trace.first, start.forward);
    const auto [turn_r, out_r] = exact_triangle.look(i, trace.second, start.forward);
    if (turn_l != Sign::negative || turn_r != Sign::positive || out_l != Sign::positive ||
        out_r != Sign::positive)
      continue;
    trace.first_side = 3 * t + static_cast<Index>(i);
    const HalfEdge twin = domain.twin(trace.first_side);
    if (twin == kNone) {
      result.end = CellEnd::left_domain;
      result.gate = {trace.first_side, left, right};
    } else {
      result.end = CellEnd::crossed;
      result.gate = {twin, from_other_side(left), from_other_side(right)};
    }
    break;
  }
  return result;
}

// --- along a side -----------------------------------------------------------------------------

template <class Real>
CellResult<Real> begin_along(BarrierMaker<Real>& maker, const Start& start, Trace& trace,
                             const Ellipse* trap) {
  using std::fabs;
  using std::ldexp;
  const Domain& domain = maker.domain();
  const Index t = start.place / 3;
  const int c = static_cast<int>(start.place % 3);
  const TriangleFrame<Real> f(domain, t, c, start.forward, maker.unit());
  CellResult<Real> result;
  const Real slope = f.a[1][0];
  if (slope == 0) return result;
  const Real p = start.at < 0 ? Real(0) : start.at > 0 ? Real(1) : Real(-f.w[1] / slope);
  const Real speed = fabs(f.w[0] + f.a[0][0] * p);
  const Real size = fabs(f.a[0][0]) + fabs(f.a[0][1]) + fabs(slope) + fabs(f.a[1][1]);
  Real room = start.at != 0 ? Real(1) : start.sense > 0 ? Real(1 - p) : p;
  if (speed < room * size) room = speed / size;
  const Real step = ldexp(room, -(2 * maker.setting().angle / 3));
  if (!(step > 0) || !(speed > 0)) return result;
  const Real q = on_side<Real>(p + start.sense * step);
  const Real a = p + start.sense * step, b = 2 * fabs(slope) * step / speed * step;
  if (q == 0 || !(b > 0)) return result;
  trace.first_side = start.place;
  trace.first = expand(q);
  trace.second = expand(a);
  trace.second_height = expand(b);
  // The straight path to (a, b) is crossed one way, its end points included.
  const auto turn = [&](const Real& x, const Real& y) {
    const auto w = f.value(x, y);
    return Real((start.sense * step) * w[1] - b * w[0]);
  };
  const Real bound = 8 * (step + b) * f.error;
  const int want = start.sense > 0 ? -1 : 1;
  const Real at_p = want * turn(p, Real(0)), at_end = want * turn(a, b);
  const auto w = f.value(a, Real(0));
  if (!(at_p > bound) || !(at_end > bound) || !(w[1] > 4 * f.error)) return result;
  const ArcStart<Real> low = start_on_side(start.place, q), high{c, a, b, -1};
  return start.sense > 0 ? cross_cell(maker, start.forward, t, c, high, low, trap)
                         : cross_cell(maker, start.forward, t, c, low, high, trap);
}

}  // namespace

std::vector<Start> find_starts(const Domain& domain, const std::vector<ZeroComponent>& zeros,
                               const std::vector<FanPortrait>& portraits,
                               const Boundary& boundary) {
  std::vector<Start> starts;
  for (Index i = 0; i < zeros.size(); ++i) {
    const CriticalPoint& item = zeros[i].item;
    if (item.where == ZeroPlace::triangle && item.kind == ZeroKind::saddle)
      for (const bool forward : {true, false})
        for (const int sense : {1, -1})
          starts.push_back({StartKind::ray, forward, false, i, 3 * item.simplex, sense, 0});
    for (const Ray& ray : portraits[i].rays)
      if (ray.separatrix) starts.push_back({StartKind::none, ray.out, false, i});
  }
  for (Index i = 0; i < boundary.switch_points.size(); ++i)
    if (boundary.switch_points[i].inside)
      add_switch_starts(domain, boundary.switch_points[i], i, starts);
  return starts;
}

template <class Real>
CellResult<Real> begin(BarrierMaker<Real>& maker, const Start& start, Trace& trace,
                       const Ellipse* trap) {
  if (start.kind == StartKind::ray) return begin_ray(maker, start, trace);
  if (start.kind == StartKind::along) return begin_along(maker, start, trace, trap);
  if (start.kind == StartKind::none) return {};
  const int c = static_cast<int>(start.place % 3);
  const ArcStart<Real> vertex{c, Real(0), Real(0), 3};
  return cross_cell(maker, start.forward, start.place / 3, c, vertex, vertex, trap);
}

template CellResult<double> begin(BarrierMaker<double>&, const Start&, Trace&, const Ellipse*);
template CellResult<Real133> begin(BarrierMaker<Real133>&, const Start&, Trace&, const Ellipse*);
template CellResult<Real332> begin(BarrierMaker<Real332>&, const Start&, Trace&, const Ellipse*);
template CellResult<Real1000> begin(BarrierMaker<Real1000>&, const Start&, Trace&, const Ellipse*);

}  // namespace crest::vector_fields

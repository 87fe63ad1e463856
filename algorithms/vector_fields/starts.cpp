// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/vector_fields/starts.hpp"

#include "algorithms/vector_fields/exact.hpp"
#include "algorithms/vector_fields/reals.hpp"
#include "kernel/geometry/stop.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::Sign;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;

namespace {

Sign directed(bool forward, Sign s) {
  return forward ? s : -s;
}

void add_switch_starts(const Domain& domain, const SwitchPoint& s, Index number,
                       std::vector<Start>& starts) {
  for (const bool forward : {true, false}) {
    Start start;
    if (s.at_vertex) {
      // Of a run along the boundary its first vertex, whichever way the line goes along it.
      start = start_at_vertex(domain, domain.fan(s.edge), forward);
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

/// Of a ray of a fan.
Start fan_start(const Ray& ray, Index number, const ZeroComponent& zero) {
  Start start;
  start.kind = ray.on_edge ? StartKind::none : StartKind::fan_ray;
  start.forward = ray.out;
  start.origin = number;
  start.place = ray.side;
  start.share = ray.ratio / (1 + ray.ratio);
  start.direction = ray.direction;
  start.vertex = zero.item.where == ZeroPlace::vertex ? zero.place : kNone;
  return start;
}

// --- rays -------------------------------------------------------------------------------------

/// A triangle and a zero in it, exactly.
struct ZeroTriangle {
  std::array<Exact, 3> p, v;
  Exact zero;
  ZeroTriangle(const Domain& domain, Index t) {
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) {
      p[h % 3] = exact(domain.point(domain.from(h)));
      v[h % 3] = exact(domain.vector(domain.from(h)));
    }
    const Rational l[3] = {cross(v[1], v[2]), cross(v[2], v[0]), cross(v[0], v[1])};
    const Rational sum = l[0] + l[1] + l[2];
    if (sum != 0)
      zero = scaled(l[0] / sum, p[0]) + scaled(l[1] / sum, p[1]) + scaled(l[2] / sum, p[2]);
  }
  static Exact scaled(const Rational& s, const Exact& x) { return {s * x[0], s * x[1]}; }
  /// The turn det(x - z, v(x)) and the flow out at the point t of a side, for a line forward.
  std::pair<Sign, Sign> look(int side, const Expansion& t, bool forward) const {
    Rational s = 0;
    for (const double x : t) s += Rational(x);
    if (s < 0) s += 1;
    const auto i = static_cast<std::size_t>(side), k = (i + 1) % 3;
    const Exact x = p[i] + scaled(s, p[k] - p[i]), w = v[i] + scaled(s, v[k] - v[i]);
    return {directed(forward, kernel::sign_of(cross(x - zero, w))),
            directed(forward, kernel::sign_of(-cross(p[k] - p[i], w)))};
  }
};

/// A number from the tail brought into the form of OnSide.
template <class Real>
Real on_side(const Real& t) {
  return t > 0.5 ? Real(t - 1) : t <= -0.5 ? Real(t + 1) : t;
}

/// The smallest gate around a point of a side that provably holds the one ray that leaves by it.
template <class Real>
CellResult<Real> gate_around(BarrierMaker<Real>& maker, const ZeroTriangle& triangle, HalfEdge side,
                             const Real& at, bool forward, Trace& trace) {
  using std::fabs;
  using std::ldexp;
  CellResult<Real> result;
  for (Real delta = 16 * maker.unit(); delta < ldexp(maker.unit(), 24); delta *= 16) {
    trace.first = expand(on_side<Real>(at + delta), maker.setting().bits);
    trace.second = expand(on_side<Real>(at - delta), maker.setting().bits);
    const Real left = sum_of<Real>(trace.first), right = sum_of<Real>(trace.second);
    if (((left > 0) != (at > 0) || (right > 0) != (at > 0)) && fabs(at) < 0.25) break;
    if (left == 0 || right == 0) break;
    const int i = static_cast<int>(side % 3);
    const auto [turn_l, out_l] = triangle.look(i, trace.first, forward);
    const auto [turn_r, out_r] = triangle.look(i, trace.second, forward);
    if (turn_l * turn_r != Sign::negative || out_l != Sign::positive || out_r != Sign::positive)
      continue;
    trace.first_side = side;
    const HalfEdge twin = maker.domain().twin(side);
    if (twin == kNone) {
      result.end = CellEnd::left_domain;
      result.gate = {side, left, right};
    } else {
      result.end = CellEnd::crossed;
      result.gate = {twin, from_other_side(left), from_other_side(right)};
    }
    break;
  }
  return result;
}

/// From which row of A - lambda I a saddle's direction is taken: the same in all precisions, so
/// that `sense` means the same ray.
bool by_second_row(const Domain& domain, const Start& ray) {
  const TriangleFrame<double> f(domain, ray.place / 3, 0, ray.forward, 0x1p-53);
  const double half = (f.a[0][0] + f.a[1][1]) / 2;
  const double det = f.a[0][0] * f.a[1][1] - f.a[0][1] * f.a[1][0];
  const double lambda = half + std::sqrt(half * half - det);
  return std::fabs(f.a[1][0]) + std::fabs(lambda - f.a[1][1]) >
         std::fabs(f.a[0][1]) + std::fabs(lambda - f.a[0][0]);
}

template <class Real>
CellResult<Real> begin_ray(BarrierMaker<Real>& maker, const Start& start, Trace& trace) {
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
  if (by_second_row(domain, start)) {
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
  return gate_around<Real>(maker, ZeroTriangle(domain, t), 3 * t + static_cast<Index>(i), at,
                           start.forward, trace);
}

/// A ray of a fan: det(x - z, v(x)) = 0 on the side, a quadratic, solved from a near root.
template <class Real>
CellResult<Real> begin_fan_ray(BarrierMaker<Real>& maker, const Start& start, Trace& trace) {
  using std::fabs;
  const Domain& domain = maker.domain();
  const ZeroTriangle triangle(domain, start.place / 3);
  const std::size_t i = start.place % 3, k = (i + 1) % 3;
  const auto real = [](const Rational& x) { return Real(x); };
  const Exact r = triangle.p[i] - triangle.zero, s = triangle.p[k] - triangle.zero;
  const Real a = real(cross(r, triangle.v[i])), c = real(cross(s, triangle.v[k])),
             b = real(cross(r, triangle.v[k]) + cross(s, triangle.v[i]));
  Real t = start.share / (1 - start.share);  // det = a + b t + c t^2 at r + t s
  for (int step = 0; step < 60; ++step) {
    const Real slope = b + 2 * c * t;
    if (slope == 0) break;
    const Real change = (a + t * (b + t * c)) / slope;
    t -= change;
    if (fabs(change) <= 2 * maker.unit() * fabs(t)) break;
  }
  const Real tail = t / (1 + t);
  if (!(tail > 0 && tail < 1)) return {};
  const Real at = tail <= 0.5 ? tail : Real(-1 / (1 + t));
  return gate_around<Real>(maker, triangle, start.place, at, start.forward, trace);
}

// --- along a side -----------------------------------------------------------------------------

template <class Real>
CellResult<Real> begin_along(BarrierMaker<Real>& maker, const Start& start, Trace& trace,
                             const TrapShape* trap) {
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
  // Any numbers near these will do: such that few digits hold them.
  const int bits = maker.setting().bits;
  trace.second = expand(Real(p + start.sense * step), bits);
  trace.second_height = expand(Real(2 * fabs(slope) * step / speed * step), 53);
  const Real a = sum_of<Real>(trace.second), b = sum_of<Real>(trace.second_height);
  trace.first = expand(on_side<Real>(a), bits);
  const Real q = sum_of<Real>(trace.first);
  if (q == 0 || !(b > 0)) return result;
  trace.first_side = start.place;
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

Start start_at_vertex(const Domain& domain, const Fan& fan, bool forward) {
  Start start;
  start.forward = forward;
  start.vertex = fan.leaving.front();
  const Index p = domain.from(fan.leaving.front());
  const Vec2& v = domain.vector(p);
  start.direction = forward ? v : Vec2{-v[0], -v[1]};
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

std::vector<Start> find_starts(const Domain& domain, const std::vector<ZeroComponent>& zeros,
                               const std::vector<FanPortrait>& portraits,
                               const Boundary& boundary) {
  std::vector<Start> starts;
  for (Index i = 0; i < zeros.size(); ++i) {
    const CriticalPoint& item = zeros[i].item;
    if (item.where == ZeroPlace::triangle && item.kind == ZeroKind::saddle)
      for (const bool forward : {true, false})
        for (const int sense : {1, -1})
          starts.push_back({StartKind::ray, forward, false, false, i, 3 * item.simplex, sense, 0});
    for (const Ray& ray : portraits[i].rays)
      if (ray.separatrix) starts.push_back(fan_start(ray, i, zeros[i]));
  }
  for (Index i = 0; i < boundary.switch_points.size(); ++i) {
    kernel::stop_point();
    if (boundary.switch_points[i].inside)
      add_switch_starts(domain, boundary.switch_points[i], i, starts);
  }
  return starts;
}

std::optional<Vec2> exact_direction(const Domain& domain, const Start& ray) {
  const ZeroTriangle t(domain, ray.place / 3);
  const Exact e = t.p[1] - t.p[0], f = t.p[2] - t.p[0];
  const Exact a = t.v[1] - t.v[0], b = t.v[2] - t.v[0];
  // J e = a, J f = b; d = alpha e + beta f with J d parallel to d.
  const Rational area = cross(e, f);
  const Rational xx = cross(a, f) / area, xy = cross(b, f) / area, yx = cross(e, a) / area,
                 yy = cross(e, b) / area;  // J in the basis e, f
  const Rational half = (xx + yy) / 2;
  const auto root = square_root(half * half - (xx * yy - xy * yx));
  if (!root) return std::nullopt;
  // Of -J for a line backward, as begin_ray() has it.
  const Rational time = ray.forward ? 1 : -1, eigenvalue = time * half + *root;
  const Exact c = by_second_row(domain, ray) ? Exact{eigenvalue - time * yy, time * yx}
                                             : Exact{time * xy, eigenvalue - time * xx};
  if (c[0] == 0 && c[1] == 0) return std::nullopt;
  const Rational sense = ray.sense;
  return as_doubles(ZeroTriangle::scaled(sense * c[0], e) + ZeroTriangle::scaled(sense * c[1], f));
}

template <class Real>
CellResult<Real> begin(BarrierMaker<Real>& maker, const Start& start, Trace& trace,
                       const TrapShape* trap) {
  if (start.kind == StartKind::ray) return begin_ray(maker, start, trace);
  if (start.kind == StartKind::fan_ray) return begin_fan_ray(maker, start, trace);
  if (start.kind == StartKind::along) return begin_along(maker, start, trace, trap);
  if (start.kind == StartKind::none) return {};
  const int c = static_cast<int>(start.place % 3);
  const ArcStart<Real> vertex{c, Real(0), Real(0), 3};
  return cross_cell(maker, start.forward, start.place / 3, c, vertex, vertex, trap);
}

template CellResult<double> begin(BarrierMaker<double>&, const Start&, Trace&, const TrapShape*);
template CellResult<DoubleDouble> begin(BarrierMaker<DoubleDouble>&, const Start&, Trace&,
                                        const TrapShape*);
template CellResult<Real133> begin(BarrierMaker<Real133>&, const Start&, Trace&, const TrapShape*);
template CellResult<Real332> begin(BarrierMaker<Real332>&, const Start&, Trace&, const TrapShape*);
template CellResult<Real1000> begin(BarrierMaker<Real1000>&, const Start&, Trace&,
                                    const TrapShape*);

}  // namespace crest::vector_fields

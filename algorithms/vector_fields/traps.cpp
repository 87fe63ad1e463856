// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "algorithms/vector_fields/trace.hpp"
#include "kernel/geometry/stop.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::Sign;
using kernel::operator-;

namespace {

/// A form aa, ab, bb.
using LinearForm = std::array<double, 3>;
/// By rows.
using Matrix = std::array<std::array<double, 2>, 2>;

/// A^T P + P A = -I.
LinearForm lyapunov(const Matrix& m) {
  const auto [a, b] = m[0];
  const auto [c, d] = m[1];
  const double det = a * d - b * c, trace = a + d;
  // P = (det I + adj(A)^T adj(A)) / (-2 trace det).
  LinearForm p = {det + d * d + c * c, -(a * c + b * d), det + a * a + b * b};
  for (double& x : p) x /= -2 * trace * det;
  return p;
}

/// The largest level at which an ellipse around coordinates l stays where those that are not 0 are
/// positive.
double level_inside(const LinearForm& p, const std::array<double, 3>& l) {
  const double n[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
  const double det = p[0] * p[2] - p[1] * p[1];
  double level = HUGE_VAL;
  for (std::size_t k = 0; k < 3; ++k) {
    const double x = n[k][0], y = n[k][1];
    const double reach = (p[2] * x * x - 2 * p[1] * x * y + p[0] * y * y) / det;
    if (l[k] != 0) level = std::fmin(level, l[k] * l[k] / reach);
  }
  return level * (1 - 0x1p-20);
}

TrapShape shape_at(const LinearForm& p, double level, double a, double b, bool attracting) {
  return {{p[0] / level, p[1] / level, p[2] / level}, {a, b}, attracting};
}

}  // namespace

std::optional<TrapShape> ellipse_in(const TriangleFrame<double>& f, bool attracting) {
  const double a = f.a[0][0], b = f.a[0][1], c = f.a[1][0], d = f.a[1][1];
  const double det = a * d - b * c;
  const LinearForm p = lyapunov(f.a);
  const double z[2] = {(f.w[1] * b - f.w[0] * d) / det, (f.w[0] * c - f.w[1] * a) / det};
  const double level = level_inside(p, {1 - z[0] - z[1], z[0], z[1]});
  if (!(level > 0 && level < HUGE_VAL)) return std::nullopt;
  return shape_at(p, level, z[0], z[1], attracting);
}

namespace {

/// Between which logarithms of the next share over this one the flow crosses the segment between
/// the two inwards.
std::array<double, 2> share_ratios(const Domain& domain, HalfEdge h, HalfEdge next, bool attracting,
                                   double most) {
  const Vec2 z = domain.point(domain.from(h));
  const Vec2 e = domain.point(domain.to(h)) - z, f = domain.point(domain.to(next)) - z;
  std::array<double, 2> r = {-std::log(most), std::log(most)};
  for (const Index at : {domain.to(h), domain.to(next)}) {
    Vec2 v = domain.vector(at);
    if (!attracting) v = {-v[0], -v[1]};
    // q det(f, v) > det(e, v).
    const double a = cross(f, v), b = cross(e, v);
    if (a == 0 && b >= 0) return {1, -1};
    if (a > 0 && b > 0) r[0] = std::max(r[0], std::log(b / a));
    if (a < 0 && b >= 0) return {1, -1};
    if (a < 0) r[1] = std::min(r[1], std::log(b / a));
  }
  return r;
}

/// Shares whose ratios lie between the bounds, once around; none if there are none.
std::vector<double> closed_shares(const std::vector<std::array<double, 2>>& ratios) {
  double low = 0, high = 0;
  for (const auto& r : ratios) {
    if (!(r[0] < r[1])) return {};
    low += r[0];
    high += r[1];
  }
  if (!(low < 0 && high > 0)) return {};
  const double s = -low / (high - low);
  std::vector<double> shares;
  double at = 0, most = 0;
  for (const auto& r : ratios) {
    shares.push_back(at);
    most = std::max(most, at);
    at += r[0] + s * (r[1] - r[0]);
  }
  for (double& x : shares) x = std::exp(x - most) / 2;
  return shares;
}

/// What the polygon cuts off in each of its triangles.
void add_polygon(const TrapPolygon& polygon, Index zero, std::unordered_map<Index, Trap>& traps) {
  const std::size_t n = polygon.leaving.size();
  for (std::size_t i = 0; i < n; ++i) {
    const HalfEdge h = polygon.leaving[i];
    std::array<double, 3> k{};  // what each coordinate counts
    k[(h % 3 + 1) % 3] = 1 / polygon.shares[i];
    k[(h % 3 + 2) % 3] = 1 / polygon.shares[(i + 1) % n];
    const TrapShape shape{{k[1] - k[0], k[2] - k[0], k[0] - 1}, {}, polygon.attracting, true};
    traps.emplace(h / 3, Trap{zero, shape});
  }
}

}  // namespace

std::optional<TrapPolygon> polygon_around(const Domain& domain, const ZeroComponent& zero) {
  const Fan fan = domain.fan(zero.place);
  if (!fan.closed) return std::nullopt;
  TrapPolygon r;
  r.leaving = fan.leaving;
  Sign trace = Sign::zero;
  for (const HalfEdge h : fan.leaving) {
    const Sign s = kernel::trace_sign(domain.corners(h / 3));
    if (s == Sign::zero || (trace != Sign::zero && s != trace)) return std::nullopt;
    trace = s;
  }
  r.attracting = trace == Sign::negative;
  // v grows linearly on each edge, so what decides is each share over the one before.
  for (const double most : {0x1p4, 0x1p20}) {
    std::vector<std::array<double, 2>> ratios;
    for (std::size_t i = 0; i < fan.leaving.size(); ++i)
      ratios.push_back(share_ratios(domain, fan.leaving[i],
                                    fan.leaving[(i + 1) % fan.leaving.size()], r.attracting, most));
    r.shares = closed_shares(ratios);
    if (!r.shares.empty()) return r;
  }
  return std::nullopt;
}

namespace {

/// How surely a form falls along x' = A x: at most 1/4, not positive if it does not.
double descent(const LinearForm& p, const Matrix& m) {
  const double aa = 2 * (m[0][0] * p[0] + m[1][0] * p[1]),
               bb = 2 * (m[0][1] * p[1] + m[1][1] * p[2]),
               ab = m[0][0] * p[1] + m[1][0] * p[2] + m[0][1] * p[0] + m[1][1] * p[1];
  return aa < 0 && bb < 0 ? (aa * bb - ab * ab) / ((aa + bb) * (aa + bb)) : -1;
}

/// One side of an edge with a zero inside, in the frame of its triangle's corner 0.
struct HalfDisc {
  Vec2 e, f;  ///< the frame's axes
  Matrix matrix;
  std::array<double, 3> zero{};  ///< its coordinates

  HalfDisc(const Domain& domain, HalfEdge edge, bool attracting)
      : matrix(TriangleFrame<double>(domain, edge / 3, 0, attracting, 0x1p-53).a) {
    const auto p = domain.corners(edge / 3).p;
    e = p[1] - p[0];
    f = p[2] - p[0];
    const auto speed = [&](Index v) {
      return std::hypot(domain.vector(v)[0], domain.vector(v)[1]);
    };
    const double tail = speed(domain.from(edge)), head = speed(domain.to(edge));
    zero[edge % 3] = head / (tail + head);
    zero[Domain::next(edge) % 3] = tail / (tail + head);
  }
};

/// The columns of m in a form.
LinearForm congruent(const LinearForm& p, const Matrix& m) {
  const auto product = [&](std::size_t i, std::size_t k) {
    return m[0][i] * (p[0] * m[0][k] + p[1] * m[1][k]) +
           m[1][i] * (p[1] * m[0][k] + p[2] * m[1][k]);
  };
  return {product(0, 0), product(0, 1), product(1, 1)};
}

Matrix product(const Matrix& a, const Matrix& b) {
  Matrix r{};
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k) r[i][k] = a[i][0] * b[0][k] + a[i][1] * b[1][k];
  return r;
}

/// Between the forms that suit two matrices one that falls along both, if there is one.
std::optional<LinearForm> common_form(const Matrix& a, const Matrix& b) {
  const LinearForm p = lyapunov(a), q = lyapunov(b);
  std::optional<LinearForm> best;
  double most = 0x1p-40;
  for (int step = 0; step <= 8; ++step) {
    LinearForm r;
    for (std::size_t k = 0; k < 3; ++k)
      r[k] = (8 - step) * p[k] / (p[0] + p[2]) + step * q[k] / (q[0] + q[2]);
    const double least = std::min(descent(r, a), descent(r, b));
    if (!(r[0] > 0 && r[0] * r[2] > r[1] * r[1] && least > most)) continue;
    most = least;
    best = r;
  }
  return best;
}

/// In the two triangles at an edge with a zero inside, the first with the lesser half-edge.
void add_ellipse_at_edge(const Domain& domain, const ZeroComponent& zero, Index number,
                         std::unordered_map<Index, Trap>& traps) {
  if (zero.at_boundary) return;
  const HalfEdge h = std::min(zero.place, domain.twin(zero.place)), g = domain.twin(h);
  const bool attracting = kernel::trace_sign(domain.corners(h / 3)) == Sign::negative;
  const HalfDisc one(domain, h, attracting), other(domain, g, attracting);
  // The other's axes in the frame of the first.
  const double area = cross(one.e, one.f), back = area / cross(other.e, other.f);
  const Matrix m = {{{cross(other.e, one.f) / area, cross(other.f, one.f) / area},
                     {cross(one.e, other.e) / area, cross(one.e, other.f) / area}}};
  const Matrix inverse = {{{back * m[1][1], -back * m[0][1]}, {-back * m[1][0], back * m[0][0]}}};
  const auto p = common_form(one.matrix, product(m, product(other.matrix, inverse)));
  if (!p) return;
  const LinearForm q = congruent(*p, m);
  const double level = std::min(level_inside(*p, one.zero), level_inside(q, other.zero));
  if (!(level > 0 && level < HUGE_VAL)) return;
  traps.emplace(h / 3, Trap{number, shape_at(*p, level, one.zero[1], one.zero[2], attracting)});
  traps.emplace(g / 3, Trap{number, shape_at(q, level, other.zero[1], other.zero[2], attracting)});
}

}  // namespace

std::unordered_map<Index, Trap> make_traps(const Domain& domain,
                                           const std::vector<ZeroComponent>& zeros) {
  std::unordered_map<Index, Trap> traps;
  for (Index i = 0; i < zeros.size(); ++i) {
    kernel::stop_point();
    const CriticalPoint& item = zeros[i].item;
    if (item.where == ZeroPlace::edge) add_ellipse_at_edge(domain, zeros[i], i, traps);
    if (item.where == ZeroPlace::vertex)
      if (const auto polygon = polygon_around(domain, zeros[i])) add_polygon(*polygon, i, traps);
    if (item.where != ZeroPlace::triangle ||
        (item.kind != ZeroKind::sink && item.kind != ZeroKind::source))
      continue;
    const bool attracting = item.kind == ZeroKind::sink;
    const TriangleFrame<double> f(domain, item.simplex, 0, attracting, 0x1p-53);
    if (const auto ellipse = ellipse_in(f, attracting))
      traps.emplace(item.simplex, Trap{i, *ellipse});
  }
  return traps;
}

}  // namespace crest::vector_fields

// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "algorithms/vector_fields/trace.hpp"
#include "kernel/predicates/planar_field.hpp"

namespace crest::vector_fields {

using kernel::cross;
using kernel::Sign;
using kernel::operator-;

std::optional<TrapShape> ellipse_in(const TriangleFrame<double>& f, bool attracting) {
  const double a = f.a[0][0], b = f.a[0][1], c = f.a[1][0], d = f.a[1][1];
  const double det = a * d - b * c, trace = a + d;
  // A^T P + P A = -I, up to a factor: P = (det I + adj(A)^T adj(A)) / (-2 trace det).
  double p[3] = {det + d * d + c * c, -(a * c + b * d), det + a * a + b * b};
  for (double& x : p) x /= -2 * trace * det;
  const double z[2] = {(f.w[1] * b - f.w[0] * d) / det, (f.w[0] * c - f.w[1] * a) / det};
  const double l[3] = {1 - z[0] - z[1], z[0], z[1]};
  const double n[3][2] = {{-1, -1}, {1, 0}, {0, 1}};
  const double det_p = p[0] * p[2] - p[1] * p[1];
  double level = HUGE_VAL;
  for (int k = 0; k < 3; ++k) {
    const double x = n[k][0], y = n[k][1];
    const double reach = (p[2] * x * x - 2 * p[1] * x * y + p[0] * y * y) / det_p;
    level = std::fmin(level, l[k] * l[k] / reach);
  }
  level *= 1 - 0x1p-20;
  if (!(level > 0 && level < HUGE_VAL)) return std::nullopt;
  return TrapShape{{p[0] / level, p[1] / level, p[2] / level}, {z[0], z[1]}, attracting};
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

std::unordered_map<Index, Trap> make_traps(const Domain& domain,
                                           const std::vector<ZeroComponent>& zeros) {
  std::unordered_map<Index, Trap> traps;
  for (Index i = 0; i < zeros.size(); ++i) {
    const CriticalPoint& item = zeros[i].item;
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/extremal/edge_net.hpp"

#include <algorithm>
#include <cmath>

namespace crest::extremal {
namespace {

constexpr double kEdgeMargin = 1e-6, kEdgeSlack = 1e-10;
constexpr int kDeepestEdge = 14;

double value(const Cubic& c, double t) {
  const double s = 1 - t;
  return s * s * (s * c[0] + 3 * t * c[1]) + t * t * (3 * s * c[2] + t * c[3]);
}

Cubic half_of(const Cubic& c, bool upper) {
  const double ab = (c[0] + c[1]) / 2, bc = (c[1] + c[2]) / 2, cd = (c[2] + c[3]) / 2;
  const double abc = (ab + bc) / 2, bcd = (bc + cd) / 2, middle = (abc + bcd) / 2;
  return upper ? Cubic{middle, bcd, cd, c[3]} : Cubic{c[0], ab, abc, middle};
}

Tensor control(const std::array<Cubic, 6>& t, std::size_t i) {
  return {t[0][i], t[1][i], t[2][i], t[3][i], t[4][i], t[5][i]};
}

/// Coefficients along the edge, the two axes across it at a node.
Cubic along(const Coefficients& c, std::size_t axis, int order_b, int order_c) {
  static constexpr std::array<std::array<double, 3>, 3> kWeights = {
      {{1.0 / 6, 4.0 / 6, 1.0 / 6}, {-0.5, 0, 0.5}, {1, -2, 1}}};
  static constexpr std::array<std::size_t, 3> kStride = {1, 4, 16};
  const std::size_t b = kStride[next(axis)], d = kStride[after_next(axis)];
  const auto& wb = kWeights[static_cast<std::size_t>(order_b)];
  const auto& wd = kWeights[static_cast<std::size_t>(order_c)];
  Cubic r{};
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t y = 0; y < 3; ++y)
      for (std::size_t z = 0; z < 3; ++z)
        r[i] += wb[y] * wd[z] * c[i * kStride[axis] + y * b + z * d];
  return r;
}

Cubic net_of(const Coefficients& c, std::size_t axis, const std::array<int, 3>& orders,
             double scale) {
  const Cubic a = along(c, axis, orders[next(axis)], orders[after_next(axis)]);
  Cubic r = kernel::spline_bezier(a[0], a[1], a[2], a[3], orders[axis]);
  for (double& x : r) x *= scale;
  return r;
}

double largest(const Coefficients& c) {
  double r = 0;
  for (const double x : c) r = std::max(r, std::fabs(x));
  return r;
}

/// n at t, on the side of w.
Vec3 direction_at(const EdgeNet& net, double t, const Vec3& w) {
  const Vec3 n = dominant_direction(net.tensor_at(t));
  return kernel::dot(n, w) < 0 ? -1.0 * n : n;
}

class TypeSearch {
 public:
  bool extremal = false, critical = false, open = false;

  /// w anew at every part: the checker does the same, from the whole edge on.
  void search(const EdgeNet& net, const Vec3& guess, int depth) {
    if (open || (extremal && critical)) return;
    const Vec3 w = direction_at(net, 0.5, guess);
    const EdgeBounds b = edge_bounds(net, w);
    if (b.gap > 0 && decided(net, w, b.theta)) return;
    if (depth == kDeepestEdge || --left_ == 0) {
      open = true;
      return;
    }
    search(net.half(false), w, depth + 1);
    search(net.half(true), w, depth + 1);
  }

 private:
  /// No zero on the net, or all of one type.
  bool decided(const EdgeNet& net, const Vec3& w, double theta) {
    double low = HUGE_VAL, high = -HUGE_VAL, across = 0;
    double least = HUGE_VAL, most = -HUGE_VAL, size = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec3 v = {net.gradient[0][i], net.gradient[1][i], net.gradient[2][i]};
      const double a = kernel::dot(w, v);
      low = std::min(low, a);
      high = std::max(high, a);
      across = std::max(across, kernel::norm(v - a * w));
      const Tensor h = control(net.hessian, i);
      const double bend = kernel::dot(w, product(h, w));
      least = std::min(least, bend);
      most = std::max(most, bend);
      size = std::max(size, h[0] * h[0] + h[1] * h[1] + h[2] * h[2] +
                                2 * (h[3] * h[3] + h[4] * h[4] + h[5] * h[5]));
    }
    const double sine =
        std::sin(theta) * across * (1 + kEdgeMargin) + kEdgeSlack * net.gradient_size;
    const double cosine = std::cos(theta) * (1 - kEdgeMargin);
    if (low * cosine > sine || -high * cosine > sine) return true;
    size = std::sqrt(size);
    const double room = 2 * theta * size + kEdgeMargin * size + kEdgeSlack * net.hessian_size;
    if (least > room) return extremal = true;
    if (-most > room) return critical = true;
    return false;
  }

  int left_ = 64;
};

}  // namespace

Tensor EdgeNet::tensor_at(double t) const {
  Tensor r;
  for (std::size_t i = 0; i < 6; ++i) r[i] = value(tensor[i], t);
  return r;
}
Vec3 EdgeNet::gradient_at(double t) const {
  return {value(gradient[0], t), value(gradient[1], t), value(gradient[2], t)};
}
EdgeNet EdgeNet::half(bool upper) const {
  EdgeNet r = *this;
  for (Cubic& c : r.tensor) c = half_of(c, upper);
  for (Cubic& c : r.hessian) c = half_of(c, upper);
  for (Cubic& c : r.gradient) c = half_of(c, upper);
  return r;
}

EdgeNet edge_net(const Fields& fields, const Node& v, std::size_t axis) {
  static constexpr std::array<std::array<std::size_t, 2>, 6> kAxes = {
      {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
  const Coefficients l = fields.coefficients(fields.scalars(), v);
  const Vec3& d = fields.grid().spacing;
  const double scalar = largest(l), least = std::min({d[0], d[1], d[2]});
  EdgeNet r;
  r.gradient_size = 2 * scalar / least;
  r.hessian_size = 4 * scalar / (least * least);
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<int, 3> orders{};
    orders[k] = 1;
    r.gradient[k] = net_of(l, axis, orders, fields.sign() / d[k]);
  }
  for (std::size_t n = 0; n < 6; ++n) {
    std::array<int, 3> orders{};
    ++orders[kAxes[n][0]];
    ++orders[kAxes[n][1]];
    r.hessian[n] = net_of(l, axis, orders, fields.sign() / (d[kAxes[n][0]] * d[kAxes[n][1]]));
  }
  if (fields.grid().dimension() == 2) {  // across it nothing changes; the errors of sums would
    r.gradient[2] = {};
    r.hessian[2] = r.hessian[4] = r.hessian[5] = {};
  }
  r.tensor = r.hessian;
  r.tensor_size = r.hessian_size;
  if (fields.structure()) {
    r.tensor = {};
    r.tensor_size = 0;
    for (std::size_t t = 0; t < fields.tensors().size(); ++t) {
      const Coefficients c = fields.coefficients(fields.tensors()[t], v);
      r.tensor_size = std::max(r.tensor_size, largest(c));
      r.tensor[fields.entry(t)] = net_of(c, axis, {0, 0, 0}, 1);
    }
  }
  if (fields.grid().dimension() == 2) r.tensor[2].fill(-8 * r.tensor_size);
  return r;
}

EdgeBounds edge_bounds(const EdgeNet& net, const Vec3& w) {
  const auto [u, v] = kernel::frame_across(w);
  double gap = HUGE_VAL, across = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const Tensor t = control(net.tensor, i);
    const Vec3 tw = product(t, w), tu = product(t, u), tv = product(t, v);
    const double a = kernel::dot(u, tu), b = kernel::dot(u, tv), c = kernel::dot(v, tv);
    const double half = 0.5 * (a - c);
    gap = std::min(gap, kernel::dot(w, tw) - 0.5 * (a + c) - std::sqrt(half * half + b * b));
    across = std::max(across, std::hypot(kernel::dot(u, tw), kernel::dot(v, tw)));
  }
  gap = gap * (1 - kEdgeMargin) - kEdgeSlack * net.tensor_size;
  across += kEdgeSlack * net.tensor_size;
  return {gap, gap > 0 ? 0.5 * std::atan(2 * across / gap) : HUGE_VAL};
}

namespace {

void bisect(const EdgeNet& net, const Vec3& lower, const Vec3& upper, double low, double high,
            int depth, Transport& r) {
  if (!r.decided) return;
  const Vec3 sum = kernel::dot(lower, upper) < 0 ? lower - upper : lower + upper;
  const Short3 w = shortened(sum);
  ++r.tests;
  r.depth = std::max(r.depth, depth);
  if (edge_bounds(net, unit(w)).gap > 0) {
    r.tree.push_back(0);
    r.leaves.push_back({low, high, w});
    return;
  }
  if (depth == kDeepestEdge) {
    r.decided = false;
    return;
  }
  r.tree.push_back(1);
  const Vec3 middle = dominant_direction(net.tensor_at(0.5));
  const double half = (low + high) / 2;
  bisect(net.half(false), lower, middle, low, half, depth + 1, r);
  bisect(net.half(true), middle, upper, half, high, depth + 1, r);
}

}  // namespace

Transport transport(const EdgeNet& net, const Vec3& lower, const Vec3& upper) {
  Transport r;
  bisect(net, lower, upper, 0, 1, 0, r);
  return r;
}

ZeroType zero_type(const EdgeNet& net, const std::vector<Leaf>& leaves) {
  TypeSearch search;
  for (const Leaf& leaf : leaves) {
    // Leaves are dyadic: the way down to one.
    EdgeNet part = net;
    int depth = 0;
    for (double low = 0, high = 1; high - low > leaf.high - leaf.low; ++depth) {
      const double middle = (low + high) / 2;
      const bool upper = leaf.low >= middle;
      part = part.half(upper);
      (upper ? low : high) = middle;
    }
    search.search(part, unit(leaf.w), depth);
  }
  if (search.open || search.extremal == search.critical) return ZeroType::undecided;
  return search.extremal ? ZeroType::extremal : ZeroType::merely_critical;
}

double zero_place(const EdgeNet& net, const std::vector<Leaf>& leaves, int lower, int upper) {
  double before = lower;
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    const Vec3 w = unit(leaves[i].w);
    const auto g = [&](double t) {
      return kernel::dot(direction_at(net, t, w), net.gradient_at(t));
    };
    double a = leaves[i].low, b = leaves[i].high;
    // The signs at the edge's ends are exact; what rounding says against them places a zero there.
    double fa = before, fb = upper;
    if (i + 1 < leaves.size()) {
      fb = g(b);
      if (fb == 0) return b;
    }
    if ((fa < 0) == (fb < 0)) {
      before = fb * side(w, i + 1 < leaves.size() ? unit(leaves[i + 1].w) : w);
      continue;
    }
    const double ga = g(a), gb = g(b);
    if ((ga < 0) != (fa < 0) || ga == 0) return a;
    if ((gb < 0) != (fb < 0) || gb == 0) return b;
    fa = ga;
    fb = gb;
    // Regula falsi, an end that stays having its value halved.
    int last = 0;
    for (int step = 0; step < 40 && b - a > 1e-6; ++step) {
      const double t = std::clamp((a * fb - b * fa) / (fb - fa), a, b), f = g(t);
      if (f == 0) return t;
      if ((f < 0) == (fa < 0)) {
        a = t;
        fa = f;
        if (last == 1) fb /= 2;
        last = 1;
      } else {
        b = t;
        fb = f;
        if (last == 2) fa /= 2;
        last = 2;
      }
      if (std::fabs(f) < 1e-9 * net.gradient_size) return t;
    }
    return (a + b) / 2;
  }
  return 0.5;
}

}  // namespace crest::extremal

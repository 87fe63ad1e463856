// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/chart.hpp"

#include <algorithm>

namespace crest::smooth_ridges {
namespace {

using Corners = std::array<Vertex, 3>;

/// The difference of two doubles, enclosed.
template <class Model>
Model difference(double a, double b) {
  const double d = a - b;
  return Model::around(d, std::fabs(d) * 0x1p-53 + 0x1p-1074);
}

template <class Model>
Model linear(const Corners& c, std::size_t k) {
  return Model::linear(c[0][k], c[1][k], c[2][k]);
}

/// What the polynomial says, without what it leaves out.
template <class Model>
Model polynomial(Model m) {
  m.radius = 0;
  return m;
}

}  // namespace

bool jacobian_is_positive(const Corners& c, double h) {
  const Vec3 p1 = position(c[1]) - position(c[0]);
  const Vec3 p2 = position(c[2]) - position(c[0]);
  const Vec3 m1 = normal(c[1]) - normal(c[0]);
  const Vec3 m2 = normal(c[2]) - normal(c[0]);
  double least = HUGE_VAL, first = 0, second = 0;
  for (const Vertex& v : c) {
    const Vec3 m = normal(v);
    least = std::min(least, determinant(p1, p2, m));
    first = std::max(first, std::fabs(determinant(m1, p2, m) + determinant(p1, m2, m)));
    second = std::max(second, std::fabs(determinant(m1, m2, m)));
  }
  const double room = 1e-12 * norm(p1) * norm(p2);
  return least > h * (first + h * second) + room;
}

template <class Model>
Charts<Model>::Charts(const Surface& surface) {
  if (!surface.is_implicit()) return;
  value_.emplace(kernel::double_evaluator(surface.functions()[0]));
  value_model_.emplace(surface);
  gradient_model_.emplace(surface);
}

template <class Model>
double Charts<Model>::guess_reach(const Corners& c) {
  Vec3 centre{}, mean{};
  for (std::size_t k = 0; k < 3; ++k) {
    centre[k] = (c[0][k] + c[1][k] + c[2][k]) / 3;
    mean[k] = (c[0][3 + k] + c[1][3 + k] + c[2][3 + k]) / 3;
  }
  double size = 0, edge = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    size += std::fabs(centre[k]);
    edge += std::fabs(c[1][k] - c[0][k]);
  }
  const double value = (*value_)(centre), d = 0x1p-10 * edge;
  const double slope = ((*value_)(centre + d * mean) - value) / d;
  double largest = std::fabs(value);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex &a = c[i], &b = c[(i + 1) % 3];
    const Vec3 middle = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
    largest = std::max(largest, std::fabs((*value_)(middle)));
  }
  return 2.5 * largest / std::fabs(slope) + 1e-14 * (size + edge);
}

template <class Model>
bool Charts<Model>::solve_fibres(Chart<Model>& chart, const Models& p) {
  constexpr int kTries = 4;
  for (int i = 0; i < kTries; ++i) {
    if (!(chart.h < HUGE_VAL)) return false;
    const Model fibre = Model::around(0, chart.h);
    Models at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = p[k] + fibre * chart.m[k];
    const auto f = (*gradient_model_)(at);
    const Model slope = f.coefficient(1, 0, 0) * chart.m[0] + f.coefficient(0, 1, 0) * chart.m[1] +
                        f.coefficient(0, 0, 1) * chart.m[2];
    if (!(slope.range().low > 0)) return false;
    const Model inverse_slope = inverse(slope);
    // The fibre's model has no polynomial: that of F is F's on the flat face.
    const Model start = polynomial(-(polynomial(f[0]) * polynomial(inverse_slope)));
    for (std::size_t k = 0; k < 3; ++k) at[k] = p[k] + start * chart.m[k];
    const kernel::Range reached = start.range();
    const Model s = start - (*value_model_)(at)[0] * inverse_slope;
    const kernel::Range r = s.range();
    const double needed =
        std::max({-r.low, r.high, -reached.low, reached.high});  // both in |s| <= h
    if (needed < chart.h) {
      chart.s = s;
      return true;
    }
    chart.h = 2 * needed;
  }
  return false;
}

template <class Model>
std::optional<Chart<Model>> Charts<Model>::operator()(const Corners& c) {
  Chart<Model> chart;
  if (!value_) {
    for (std::size_t k = 0; k < 2; ++k) chart.x[k] = linear<Model>(c, k);
    directions(chart, c);
    return chart;
  }
  Models p;
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = linear<Model>(c, k);
    chart.m[k] = linear<Model>(c, 3 + k);
  }
  chart.h = guess_reach(c);
  if (!solve_fibres(chart, p) || !jacobian_is_positive(c, chart.h)) return std::nullopt;
  for (std::size_t k = 0; k < 3; ++k) chart.x[k] = p[k] + chart.s * chart.m[k];
  return chart;
}

template <class Model>
void Charts<Model>::directions(Chart<Model>& chart, const Corners& c) {
  for (std::size_t i = 0; i < 2; ++i)
    for (std::size_t k = 0; k < 2; ++k) chart.dx[i][k] = difference<Model>(c[i + 1][k], c[0][k]);
}

template <class Model>
void Charts<Model>::tangents(Chart<Model>& chart, const Corners& c, const Models& gradient) {
  const Model inverse_slope = inverse(dot(gradient, chart.m));
  for (std::size_t i = 0; i < 2; ++i) {
    Models t;
    for (std::size_t k = 0; k < 3; ++k)
      t[k] = difference<Model>(c[i + 1][k], c[0][k]) +
             chart.s * difference<Model>(c[i + 1][3 + k], c[0][3 + k]);
    const Model along = dot(gradient, t) * inverse_slope;
    for (std::size_t k = 0; k < 3; ++k) chart.dx[i][k] = t[k] - along * chart.m[k];
  }
}

template <class Model>
void Charts<Model>::tangents(Chart<Model>& chart, const Corners& c) {
  if (!value_) return;
  const auto f = (*gradient_model_)(chart.x);
  tangents(chart, c, {f.coefficient(1, 0, 0), f.coefficient(0, 1, 0), f.coefficient(0, 0, 1)});
}

template class Charts<kernel::TaylorModel<3>>;
template class Charts<kernel::TaylorModel<4>>;
template class Charts<kernel::TaylorModel<5>>;

}  // namespace crest::smooth_ridges

// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/square_enclosure.hpp"

#include <algorithm>

namespace crest::smooth_ridges {
namespace {

using kernel::Interval;

Interval interval(const kernel::Range& r) {
  return {r.low, r.high};
}

/// Ranges of all coefficients.
template <class Model, int K>
kernel::Jet<Interval, 2, K> ranges(const kernel::Jet<Model, 2, K>& f) {
  kernel::Jet<Interval, 2, K> r;
  kernel::for_each_bit(f.mask(), [&](std::size_t k) { r.set(k, interval(f[k].range())); });
  return r;
}
template <class Field, std::size_t N>
auto ranges(const std::array<Field, N>& f) {
  std::array<decltype(ranges(f[0])), N> r;
  for (std::size_t k = 0; k < N; ++k) r[k] = ranges(f[k]);
  return r;
}

template <class Geometry>
Over over(const Geometry& g) {
  const auto forms = forms_of<1>(g);
  const auto shape = shape_of(g.template first<2>(), g.template second<2>());
  return {{ranges(forms.i), ranges(forms.l), ranges(forms.t), ranges(forms.d)},
          {ranges(shape.a), ranges(shape.b), ranges(shape.c)}};
}

template <int K>
void widen(kernel::Jet<Interval, 2, K>& a, const kernel::Jet<Interval, 2, K>& b) {
  kernel::for_each_bit(a.mask() | b.mask(), [&](std::size_t k) {
    a.set(k, {std::min(a[k].inf(), b[k].inf()), std::max(a[k].sup(), b[k].sup())});
  });
}
template <class Field, std::size_t N>
void widen(std::array<Field, N>& a, const std::array<Field, N>& b) {
  for (std::size_t k = 0; k < N; ++k) widen(a[k], b[k]);
}
void widen(Over& a, const Over& b) {
  widen(a.forms.i, b.forms.i);
  widen(a.forms.l, b.forms.l);
  widen(a.forms.t, b.forms.t);
  widen(a.forms.d, b.forms.d);
  widen(a.shape.a, b.shape.a);
  widen(a.shape.b, b.shape.b);
  widen(a.shape.c, b.shape.c);
}

}  // namespace

SquareEnclosure::SquareEnclosure(const Surface& surface) : charts_(surface) {
  if (surface.is_implicit()) {
    value_.emplace(surface);
    implicit_.emplace(surface);
  } else {
    map_.emplace(surface);
  }
}

std::optional<Over> SquareEnclosure::operator()(const SurfacePoint& centre, double radius) {
  constexpr int kParts = 2;
  std::array<std::array<SurfacePoint, kParts + 1>, kParts + 1> grid;
  for (std::size_t i = 0; i <= kParts; ++i)
    for (std::size_t j = 0; j <= kParts; ++j) {
      SurfacePoint& p = grid[i][j];
      p = centre;
      // The outermost just beyond the square, whatever the sums' rounding.
      p.z[0] += (static_cast<double>(i) * 2 / kParts - 1) * radius * (1 + 0x1p-20);
      p.z[1] += (static_cast<double>(j) * 2 / kParts - 1) * radius * (1 + 0x1p-20);
      if (value_ && !settle(*value_, p)) return std::nullopt;
    }
  std::optional<Over> all;
  for (std::size_t i = 0; i < kParts; ++i)
    for (std::size_t j = 0; j < kParts; ++j) {
      const SurfacePoint &a = grid[i][j], &b = grid[i + 1][j], &c = grid[i + 1][j + 1],
                         &d = grid[i][j + 1];
      for (const Corners& triangle : {Corners{a, b, c}, Corners{a, c, d}}) {
        const auto piece = over_triangle(triangle);
        if (!piece) return std::nullopt;
        if (all)
          widen(*all, *piece);
        else
          all = piece;
      }
    }
  return all;
}

std::optional<Over> SquareEnclosure::over_triangle(const Corners& corners) {
  std::array<Vertex, 3> vertices{};
  const std::size_t axis = corners[0].axis;
  double sign = 1;
  if (value_) {
    const auto f = (*value_)(in_space(corners[0]));
    sign = (axis == 0   ? f.coefficient(1, 0, 0)
            : axis == 1 ? f.coefficient(0, 1, 0)
                        : f.coefficient(0, 0, 1)) > 0
               ? 1
               : -1;
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (!value_) {
      vertices[k] = {corners[k].z[0], corners[k].z[1]};
      continue;
    }
    const Vec3 x = in_space(corners[k]);
    vertices[k] = {x[0], x[1], x[2]};
    vertices[k][3 + axis] = sign;
  }
  // Fibres along the axis, faces counter-clockwise against it if F falls along the axis.
  if (sign < 0) std::swap(vertices[1], vertices[2]);
  const auto chart = charts_(vertices);
  if (!chart) return std::nullopt;
  if (!value_)
    return over(MapGeometry<Model, 4>{(*map_)(std::array<Model, 2>{chart->x[0], chart->x[1]})});
  const auto f = (*implicit_)(chart->x);
  return over(GraphGeometry<Model, 4>{GraphJet<Model, 4>::of(f, axis), sign > 0 ? 1 : -1});
}

}  // namespace crest::smooth_ridges

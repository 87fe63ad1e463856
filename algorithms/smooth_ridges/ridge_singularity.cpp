// SPDX-License-Identifier: GPL-3.0-or-later
#include "algorithms/smooth_ridges/ridge_singularity.hpp"

#include <algorithm>
#include <cmath>

#include "algorithms/smooth_ridges/forms.hpp"

namespace crest::smooth_ridges {
namespace {

using Field = kernel::Jet<double, 2, 2>;

/// In units in which a generic surface has numbers about 1: lengths by the smaller radius of
/// curvature, E by what its terms may be.
struct Sample {
  std::array<double, 3> residual;               ///< E, its derivatives
  std::array<std::array<double, 2>, 3> slopes;  ///< of the residual, by the two coordinates
  std::array<double, 3> metric;                 ///< in space
};

template <class Geometry>
Sample sample_of(const Geometry& geometry, kernel::Colour colour) {
  const auto forms = forms_of<2>(geometry);
  const auto shape = shape_of(forms.i, forms.l);
  const Field sigma = sqrt(squared_sigma(shape));
  const double a = shape.a[0], s = sigma[0];
  const std::array<double, 2> w =
      a > 0 ? std::array{a + s, shape.c[0]} : std::array{shape.b[0], s - a};
  Pair<Field> v = first_principal(times(shape, w), sigma, w);
  if (colour == kernel::Colour::red) v = second_principal(forms.i, v);
  const Field e = extremality(forms, v);

  const double i11 = forms.i[0][0], i12 = forms.i[1][0], i22 = forms.i[2][0];
  const double det = i11 * i22 - i12 * i12;
  const double trace =
      i22 * forms.l[0][0] - 2 * i12 * forms.l[1][0] + i11 * forms.l[2][0];  // 2 H det |N|
  const double curvature = (std::fabs(trace) / 2 + s) / (det * std::sqrt(det));
  const double size =
      i11 * v[0][0] * v[0][0] + 2 * i12 * v[0][0] * v[1][0] + i22 * v[1][0] * v[1][0];
  const double unit = std::pow(size, 2.5) * curvature * curvature * std::sqrt(det);
  const double along[] = {1 / (curvature * std::sqrt(i11)), 1 / (curvature * std::sqrt(i22))};
  const double e1 = e.derivative(1, 0), e2 = e.derivative(0, 1);
  const double e11 = e.derivative(2, 0), e12 = e.derivative(1, 1), e22 = e.derivative(0, 2);
  Sample r{{e[0] / unit, e1 * along[0] / unit, e2 * along[1] / unit}, {}, {i11, i12, i22}};
  r.slopes[0] = {e1 / unit, e2 / unit};
  r.slopes[1] = {e11 * along[0] / unit, e12 * along[0] / unit};
  r.slopes[2] = {e12 * along[1] / unit, e22 * along[1] / unit};
  return r;
}

/// The step that makes the linearised residual least; along a curve of zeros the shortest, nearly.
std::array<double, 2> least_squares_step(const Sample& s) {
  double m11 = 0, m12 = 0, m22 = 0, b1 = 0, b2 = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [x, y] = s.slopes[k];
    m11 += x * x, m12 += x * y, m22 += y * y;
    b1 -= x * s.residual[k], b2 -= y * s.residual[k];
  }
  const double little = 1e-10 * (m11 + m22);
  m11 += little, m22 += little;
  const double det = m11 * m22 - m12 * m12;
  return {(m22 * b1 - m12 * b2) / det, (m11 * b2 - m12 * b1) / det};
}

}  // namespace

struct SingularityFinder::State {
  explicit State(const Surface& surface) {
    if (surface.is_implicit())
      first.emplace(surface), implicit.emplace(surface);
    else
      map.emplace(surface);
  }

  std::optional<Sample> at(SurfacePoint& p, kernel::Colour colour) {
    if (map) return sample_of(MapGeometry<double, 5>{(*map)(p.z)}, colour);
    if (!settle(*first, p)) return std::nullopt;
    const auto f = (*implicit)(in_space(p));
    std::array<int, 3> axis{};
    axis[p.axis] = 1;
    const int sign = f.coefficient(axis[0], axis[1], axis[2]) > 0 ? 1 : -1;  // normal along grad F
    return sample_of(GraphGeometry<double, 5>{GraphJet<double, 5>::of(f, p.axis), sign}, colour);
  }

  std::optional<ImplicitMap<double, 1>> first;
  std::optional<ImplicitMap<double, 5>> implicit;
  std::optional<ParametricMap<double, 5>> map;
};

SingularityFinder::SingularityFinder(const Surface& surface)
    : state_(std::make_unique<State>(surface)) {}
SingularityFinder::~SingularityFinder() = default;
SingularityFinder::SingularityFinder(SingularityFinder&&) noexcept = default;

std::optional<SurfacePoint> SingularityFinder::near(SurfacePoint p, kernel::Colour colour,
                                                    double size) {
  // A regular crossing this near to a singular one would take 10^5 faces and more.
  constexpr double kZero = 1e-11;
  constexpr int kSteps = 40;
  double gone = 0;
  for (int i = 0; i < kSteps; ++i) {
    const auto s = state_->at(p, colour);
    if (!s) return std::nullopt;
    const auto& [r0, r1, r2] = s->residual;
    if (std::sqrt(r0 * r0 + r1 * r1 + r2 * r2) < kZero) return p;
    const auto [x, y] = least_squares_step(*s);
    gone += std::sqrt(s->metric[0] * x * x + 2 * s->metric[1] * x * y + s->metric[2] * y * y);
    if (!(gone <= size)) return std::nullopt;
    p.z[0] += x;
    p.z[1] += y;
  }
  return std::nullopt;
}

}  // namespace crest::smooth_ridges

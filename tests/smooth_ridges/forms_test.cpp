// SPDX-License-Identifier: GPL-3.0-or-later
// E(v) against the level set formula of b0 and b3, its derivatives against finite differences.
#include "algorithms/smooth_ridges/forms.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/smooth_ridges/frame.hpp"

namespace crest::smooth_ridges {
namespace {

template <int Order>
kernel::Jet<double, 3, Order> function(const std::array<double, 3>& at,
                                       const std::array<kernel::Vec3, 3>& frame) {
  using Jet = kernel::Jet<double, 3, Order>;
  std::array<Jet, 3> x;
  for (std::size_t i = 0; i < 3; ++i) {
    x[i] = Jet::constant(at[i]);
    for (std::size_t k = 0; k < 3; ++k)
      x[i] = x[i] + Jet::variable(static_cast<int>(k), 0.0) * frame[k][i];
  }
  return x[0] * x[0] + x[1] * x[1] * (1 / 2.25) + x[2] * x[2] * 0.25 - 1.0 +
         x[0] * x[1] * x[2] * 0.1 + x[0] * x[0] * x[0] * 0.05;
}
const std::array<kernel::Vec3, 3> kAxes = {kernel::Vec3{1, 0, 0}, kernel::Vec3{0, 1, 0},
                                           kernel::Vec3{0, 0, 1}};

struct Measured {
  std::array<kernel::Jet<double, 2, 2>, 2> e;
  std::array<Pair<kernel::Jet<double, 2, 2>>, 2> v;
  kernel::Jet<double, 2, 5> h;
};

Measured measure(const std::array<double, 3>& at, const std::array<kernel::Vec3, 3>& frame,
                 const std::array<double, 2>& w) {
  Measured m;
  const auto f = function<5>(at, frame);
  m.h = GraphJet<double, 5>::of(f, 2);
  const auto forms =
      forms_of<2>(GraphGeometry<double, 5>{m.h, f.coefficient(0, 0, 1) > 0 ? 1 : -1});
  const auto shape = shape_of(forms.i, forms.l);
  m.v[0] = first_principal(times(shape, w), sqrt(squared_sigma(shape)), w);
  m.v[1] = second_principal(forms.i, m.v[0]);
  for (std::size_t j = 0; j < 2; ++j) m.e[j] = extremality(forms, m.v[j]);
  return m;
}

/// Moves a point along the frame's third vector onto the surface.
std::array<double, 3> settled(std::array<double, 3> x, const kernel::Vec3& m) {
  for (int i = 0; i < 60; ++i) {
    const auto f = function<1>(x, kAxes);
    const double slope = f.coefficient(1, 0, 0) * m[0] + f.coefficient(0, 1, 0) * m[1] +
                         f.coefficient(0, 0, 1) * m[2];
    for (std::size_t k = 0; k < 3; ++k) x[k] -= f[0] / slope * m[k];
  }
  return x;
}

TEST_CASE("E is the derivative of a principal curvature along its line, times a positive factor") {
  for (const Frame& integers : {Frame{1, 0, 0, 0}, Frame{12, -5, 6, 0}, Frame{3, 1, -2, 4}}) {
    const auto frame = frame_vectors(integers);
    const auto x = settled({0.71, 0.88, 0.7}, frame[2]);
    const Measured here = measure(x, frame, {1, 0.3});
    const auto f = function<3>(x, kAxes);
    const std::array<double, 3> g = {f.coefficient(1, 0, 0), f.coefficient(0, 1, 0),
                                     f.coefficient(0, 0, 1)};
    const double size = std::sqrt(g[0] * g[0] + g[1] * g[1] + g[2] * g[2]);
    for (std::size_t j = 0; j < 2; ++j) {
      // t in space, of unit length.
      const double vp = here.v[j][0][0], vq = here.v[j][1][0];
      const double vm = here.h.coefficient(1, 0) * vp + here.h.coefficient(0, 1) * vq;
      std::array<double, 3> t{};
      double length = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        t[k] = frame[0][k] * vp + frame[1][k] * vq + frame[2][k] * vm;
        length += t[k] * t[k];
      }
      for (double& c : t) c /= std::sqrt(length);
      // b = -(F_ttt + 3 k F_tn) / |grad F|, k = -F_tt / |grad F|.
      double tt = 0, tn = 0, ttt = 0;
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b) {
          std::array<int, 3> e{};
          ++e[a], ++e[b];
          const double second = f.derivative(e[0], e[1], e[2]);
          tt += second * t[a] * t[b];
          tn += second * t[a] * g[b] / size;
          for (std::size_t c = 0; c < 3; ++c) {
            auto e3 = e;
            ++e3[c];
            ttt += f.derivative(e3[0], e3[1], e3[2]) * t[a] * t[b] * t[c];
          }
        }
      const double b = -(ttt - 3 * tt / size * tn) / size;
      // In units of the frame's length n: |N| = sqrt(1 + h_p^2 + h_q^2), b scales with n^2.
      const double n = std::sqrt(frame[0][0] * frame[0][0] + frame[0][1] * frame[0][1] +
                                 frame[0][2] * frame[0][2]);
      const double own = length / n / n;  // I(v, v)
      const double normal = std::sqrt(1 + std::pow(here.h.coefficient(1, 0), 2) +
                                      std::pow(here.h.coefficient(0, 1), 2));
      CHECK(here.e[j][0] / (own * normal * std::pow(own, 1.5)) == Approx(b * n * n).epsilon(1e-9));
    }
  }
}

TEST_CASE("E's derivatives along the surface are its differences") {
  const auto frame = frame_vectors({12, -5, 6, 0});
  const auto x = settled({0.71, 0.88, 0.7}, frame[2]);
  const std::array<double, 2> w = {1, 0.3};
  const Measured here = measure(x, frame, w);
  const double d = 1e-6;
  for (std::size_t k = 0; k < 2; ++k) {
    auto before = x, after = x;
    for (std::size_t i = 0; i < 3; ++i) before[i] -= d * frame[k][i], after[i] += d * frame[k][i];
    const Measured a = measure(settled(before, frame[2]), frame, w);
    const Measured b = measure(settled(after, frame[2]), frame, w);
    for (std::size_t j = 0; j < 2; ++j) {
      const double slope = k == 0 ? here.e[j].coefficient(1, 0) : here.e[j].coefficient(0, 1);
      CHECK((b.e[j][0] - a.e[j][0]) / (2 * d) == Approx(slope).epsilon(1e-4));
      const double second =
          2 * (k == 0 ? here.e[j].coefficient(2, 0) : here.e[j].coefficient(0, 2));
      const double difference = k == 0 ? b.e[j].coefficient(1, 0) - a.e[j].coefficient(1, 0)
                                       : b.e[j].coefficient(0, 1) - a.e[j].coefficient(0, 1);
      CHECK(difference / (2 * d) == Approx(second).epsilon(1e-3));
    }
  }
}

TEST_CASE("Frames are exact: orthogonal integer vectors of one length") {
  for (const Frame& f : {Frame{1, 0, 0, 0}, Frame{1, 1, 1, 1}, Frame{127, -128, 5, 0},
                         nearest_frame({0.6, 0, -0.8}), nearest_frame({0, 0, -1})}) {
    const auto r = frame_vectors(f);
    const auto dot = [&](std::size_t a, std::size_t b) {
      return r[a][0] * r[b][0] + r[a][1] * r[b][1] + r[a][2] * r[b][2];
    };
    CHECK(dot(0, 1) == 0);
    CHECK(dot(1, 2) == 0);
    CHECK(dot(0, 2) == 0);
    CHECK(dot(0, 0) == dot(1, 1));
    CHECK(dot(1, 1) == dot(2, 2));
    CHECK(dot(0, 0) > 0);
  }
  const auto m = frame_vectors(nearest_frame({0.36, 0.48, 0.8}))[2];
  const double size = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
  CHECK((0.36 * m[0] + 0.48 * m[1] + 0.8 * m[2]) / size > 0.99);
}

}  // namespace
}  // namespace crest::smooth_ridges

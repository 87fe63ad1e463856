// SPDX-License-Identifier: GPL-3.0-or-later
// Given line fields instead of images' own: figures 1, 3, 4 of paper 000.
#include <catch2/catch.hpp>
#include <complex>

#include "algorithms/extremal/assembly.hpp"
#include "algorithms/extremal/extraction.hpp"

using namespace crest;
using extremal::Extraction;
using extremal::Fields;
using extremal::Grid;

namespace {

constexpr double kSingular[4][2] = {{0.31, 0.42}, {0.68, 0.57}, {0.52, 0.23}, {0.44, 0.81}};

/// Coefficients on the unit square: directions at half the argument of (z - z1) (z - z2) times
/// the conjugate of (z - z3) (z - z4), s = sin(7x + 2y) + 0.7 cos(5y - 3x).
Fields singular_field(unsigned n) {
  const double h = 1.0 / (n - 1);
  const Grid grid({n, n, 1}, {h, h, 1}, {0, 0, 0});
  std::vector<float> l;
  std::vector<std::vector<float>> t(3);
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i) {
      const std::complex<double> z(i * h, j * h);
      const auto at = [](int k) { return std::complex<double>(kSingular[k][0], kSingular[k][1]); };
      const auto f = (z - at(0)) * (z - at(1)) * std::conj((z - at(2)) * (z - at(3)));
      // The traceless part of the tensor with this direction, times |f|.
      t[0].push_back(static_cast<float>(f.real()));
      t[1].push_back(static_cast<float>(-f.real()));
      t[2].push_back(static_cast<float>(f.imag()));
      l.push_back(static_cast<float>(std::sin(7 * z.real() + 2 * z.imag()) +
                                     0.7 * std::cos(5 * z.imag() - 3 * z.real())));
    }
  return Fields(grid, extremal::Side::valley, std::move(l), std::move(t));
}

}  // namespace

TEST_CASE("line fields: one odd square a singularity, at every resolution") {
  for (const unsigned n : {17U, 33U, 65U}) {
    const Extraction e(singular_field(n), {});
    const auto r = e.result(true);
    const auto mesh =
        extremal::Assembly(e.fields().grid(), {}, e.records({false, true})).mesh(true);
    INFO(n);
    CHECK(r.counts.odd_faces == 4);
    CHECK(r.counts.undecided_edges == 0);
    // Each holds one singularity; the splines move them by less than a square.
    std::size_t met = 0;
    for (const kernel::Index f : extremal::crossed_faces(e.fields(), e.edges())) {
      const auto v = e.fields().grid().node(f / 3);
      if (!e.faces().face(v, 2).odd()) continue;
      for (const auto& z : kSingular) {
        const double x = (v[0] + 0.5) / (n - 1) - z[0], y = (v[1] + 0.5) / (n - 1) - z[1];
        met += std::max(std::fabs(x), std::fabs(y)) < 1.0 / (n - 1) ? 1 : 0;
      }
    }
    CHECK(met == 4);
    // A curve ends at each but where three meet.
    CHECK(mesh.trimmed.reasons[0] + mesh.trimmed.valence[2] == 4);
  }
}

TEST_CASE("line fields: proposition 2 as an identity on noise") {
  // Odd faces are those round which the product of the edges' turns is negative: both sides are
  // counted from different things only where cells decide; here most edges are bisected.
  const unsigned n = 24;
  const Grid grid({n, n, 1}, {1, 1, 1}, {0, 0, 0});
  std::vector<float> l;
  std::vector<std::vector<float>> t(3);
  unsigned state = 1;
  const auto noise = [&] {
    state = state * 1664525U + 1013904223U;
    return static_cast<float>(state >> 8) / 8388608.0F - 1;
  };
  for (unsigned i = 0; i < n * n; ++i) {
    l.push_back(noise());
    for (auto& c : t) c.push_back(noise());
  }
  const Extraction e(Fields(grid, extremal::Side::ridge, std::move(l), std::move(t)), {});
  const auto r = e.result(true);
  CHECK(r.counts.odd_faces > 10);
  CHECK(r.counts.bisections.size() > 1);
  // Each face's holonomy by following the directions densely.
  std::size_t odd = 0, tested = 0;
  for (int j = 0; j + 1 < static_cast<int>(n); ++j)
    for (int i = 0; i + 1 < static_cast<int>(n); ++i) {
      const auto face = e.faces().face({i, j, 0}, 2);
      if (!face.tested) continue;
      ++tested;
      kernel::Vec3 first{}, last{};
      const int steps = 4000;
      for (int k = 0; k <= steps; ++k) {
        const double u = 4.0 * k / steps;
        const kernel::Vec3 at = u <= 1   ? kernel::Vec3{u, 0, 0}
                                : u <= 2 ? kernel::Vec3{1, u - 1, 0}
                                : u <= 3 ? kernel::Vec3{3 - u, 1, 0}
                                         : kernel::Vec3{0, 4 - u, 0};
        auto m = extremal::dominant_direction(e.fields().at({i, j, 0}, at).tensor);
        if (k == 0) first = last = m;
        last = kernel::dot(m, last) < 0 ? kernel::operator*(-1.0, m) : m;
      }
      const bool turned = kernel::dot(first, last) < 0;
      odd += turned ? 1 : 0;
      CHECK(turned == face.odd());
    }
  CHECK(tested > 300);
  CHECK(odd == r.counts.odd_faces);
}

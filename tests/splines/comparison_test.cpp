// SPDX-License-Identifier: GPL-3.0-or-later
// The models to compare with: what each reproduces, and that gradients are those of the values.
#include "algorithms/splines/comparison.hpp"

#include <catch2/catch.hpp>

#include "tests/splines/volumes.hpp"
#include "tests/support/degenerate_families.hpp"

using namespace crest;
using namespace crest::tests;
using Model = splines::ValueAndGradient (*)(const SampledGrid&, const Vec3&);

TEST_CASE("comparison models reproduce their polynomials and have the gradients of their values") {
  struct Case {
    Model model;
    int degree;  ///< of all polynomials that are reproduced
    bool own_gradient;
  };
  const auto cubic = random_volume<double>({7, 6, 8}, 100, kSeed + 40);
  for (const Case& c :
       {Case{splines::linear_on_partition, 1, true}, Case{splines::freudenthal_quadratic, 2, true},
        Case{splines::trilinear, 1, true}, Case{splines::trilinear_differences, 1, false},
        Case{splines::triquadratic, 1, true}}) {
    SampledGrid grid = cubic;
    auto& samples = std::get<std::vector<double>>(grid.samples);
    const auto f = [&](const Vec3& p) {
      const double q = p[0] * p[1] - 2 * p[2] * p[2] + p[1] * p[1] - p[0] * p[2];
      return 3 + p[0] - 2 * p[1] + 5 * p[2] + (c.degree == 2 ? q : 0);
    };
    std::size_t i = 0;
    for (int z = 0; z < 8; ++z)
      for (int y = 0; y < 6; ++y)
        for (int x = 0; x < 7; ++x) samples[i++] = f({1.0 * x, 1.0 * y, 1.0 * z});
    Draw d(kSeed + 41);
    for (int k = 0; k < 200; ++k) {
      // Of the whole cubes of side 2, half a spacing inside.
      const Vec3 v = {3 + 2.4 * d.uniform(), 2 + 1.4 * d.uniform(), 3 + 2.4 * d.uniform()};
      CHECK(c.model(grid, v).value == Approx(f(v)).margin(1e-11));
      const auto at = c.model(cubic, v);
      if (!c.own_gradient) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double h = 1e-7;
        Vec3 w = v;
        w[axis] += h;
        CHECK((c.model(cubic, w).value - at.value) / h == Approx(at.gradient[axis]).margin(1e-3));
      }
    }
  }
}

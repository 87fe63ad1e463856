// SPDX-License-Identifier: GPL-3.0-or-later
// Cubic splines of scattered samples.
#include "algorithms/splines/cubic_fit.hpp"

#include <tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cstring>

#include "algorithms/splines/cubic_certificate.hpp"
#include "algorithms/splines/cubic_evaluate.hpp"
#include "kernel/geometry/input_error.hpp"
#include "tests/splines/scattered_functions.hpp"

using namespace crest;
using namespace crest::tests;
using splines::CubicFit;
using splines::CubicModel;
using splines::CubicOptions;
using splines::Smoothness;

namespace {

constexpr Smoothness kModes[] = {Smoothness::c1, Smoothness::local, Smoothness::sequential};
const std::array<Vec3, 2> kUnitBox{Vec3{0, 0, 0}, Vec3{1, 1, 1}};

/// Bit by bit.
bool equal(const CubicModel& a, const CubicModel& b) {
  const auto same = [](const auto& x, const auto& y) {
    return x.size() == y.size() && std::memcmp(x.data(), y.data(), x.size() * sizeof x[0]) == 0;
  };
  return a.unit == b.unit && a.domain.cubes == b.domain.cubes && same(a.vertices, b.vertices) &&
         same(a.slopes, b.slopes) && same(a.centres, b.centres);
}

/// Mean and largest |s - f| at random points; of the largest those in cubes off the border, too.
struct Errors {
  double mean = 0, max = 0, interior = 0;
};
Errors errors(const CubicModel& model, const std::function<double(const Vec3&)>& f,
              std::size_t count) {
  const Samples at = sampled(count, kSeed + 77, f);
  const auto values = splines::evaluate(model, at.points);
  Errors e;
  for (std::size_t i = 0; i < count; ++i) {
    const double d = std::fabs(values[i].value - at.values[i]);
    e.mean += d / static_cast<double>(count);
    e.max = std::max(e.max, d);
    const Vec3 x = model.domain.cube_coordinates(at.points[i]);
    bool interior = true;
    for (std::size_t k = 0; k < 3; ++k)
      interior = interior && x[k] >= 1 && x[k] <= model.domain.cubes[k] - 1.0;
    if (interior) e.interior = std::max(e.interior, d);
  }
  return e;
}

CubicFit fit(const Samples& s, const CubicOptions& options) {
  return splines::fit_cubic(s.points, s.values, options);
}

}  // namespace

TEST_CASE("cubic polynomials are reproduced, values and gradients, by all three extensions") {
  for (const auto& cubes : {std::array<kernel::Index, 3>{3, 4, 5}, {1, 1, 1}, {2, 6, 1}})
    for (const Smoothness mode : kModes) {
      CAPTURE(cubes, static_cast<int>(mode));
      const IntegerCubic f(kSeed + cubes[0]);
      // Sequentially, fits around the box extrapolate: of a few cubes they are of lower degree.
      if (mode == Smoothness::sequential && cubes[0] < 3) continue;
      const Samples s = sampled(mode == Smoothness::sequential ? 700 : 2000, kSeed, f);
      const CubicFit r = fit(s, {mode, cubes, kUnitBox});
      CHECK(r.degrees[3] == r.local_fits);
      const Errors e = errors(r.model, f, 2000);
      CHECK(e.max < 1e-12 * 80);
      double gradient = 0;
      for (const Vec3& p : s.points) {
        const Vec3 g = splines::evaluate(r.model, p).gradient, exact = f.p.gradient(p);
        for (std::size_t d = 0; d < 3; ++d)
          gradient = std::max(gradient, std::fabs(g[d] - exact[d]));
      }
      CHECK(gradient < 1e-9);
    }
}

TEST_CASE("errors of f_test are at or below table 9.1's in its third row") {
  // N = 4000, n = 7: mean 0.00247, at the data 0.02298, of the interior 0.02868.
  const Samples s = sampled(4000, kSeed, f_test);
  for (const Smoothness mode : {Smoothness::c1, Smoothness::local}) {
    const CubicFit r = fit(s, {mode, {}, kUnitBox});
    CHECK(r.model.domain.cubes == std::array<kernel::Index, 3>{7, 7, 7});
    CHECK(r.samples == 4000);
    CHECK(r.outside == 0);
    const auto at_samples = splines::error_at_samples(r.model, s.points, s.values);
    CHECK(at_samples.mean < 0.00247124 / 3);
    CHECK(at_samples.max < 0.02297960);
    CHECK(errors(r.model, f_test, 40000).interior < 0.02867510);
  }
}

TEST_CASE("errors halve sixteenfold with the side (local) and by the third power at least (C1)") {
  const auto mean = [](std::size_t count, Smoothness mode) {
    const Samples s = sampled(count, kSeed, f_test);
    return errors(fit(s, {mode, {}, kUnitBox}).model, f_test, 20000).mean;
  };
  CHECK(mean(64000, Smoothness::local) < mean(8000, Smoothness::local) / 12);
  CHECK(mean(64000, Smoothness::c1) < mean(8000, Smoothness::c1) / 8);
}

TEST_CASE("gradients of a C1 spline meet at faces of all tetrahedra, those of the others jump") {
  const Samples s = sampled(3000, kSeed, f_test);
  for (const Smoothness mode : kModes) {
    const CubicModel model = fit(s, {mode, {}, kUnitBox}).model;
    const double bound = splines::gradient_jump(model).bound;
    CHECK((bound == 0) == (mode == Smoothness::c1));
    const double n = model.domain.cubes[0];
    Random random(kSeed);
    const auto draw = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
    double jump = 0;
    for (std::size_t i = 0; i < 4000; ++i) {
      // A point of the plane y = z through a cube's centre, from both sides.
      const double c = (std::floor(draw() * n) + 0.5) / n, a = (draw() - 0.5) * 0.9 / n;
      const double e = 1e-9;
      const double x = draw();
      const Vec3 below = splines::evaluate(model, {x, c + a + e, c + a - e}).gradient,
                 above = splines::evaluate(model, {x, c + a - e, c + a + e}).gradient;
      using kernel::operator-;
      jump = std::max(jump, kernel::norm(above - below));
    }
    if (mode == Smoothness::c1)
      CHECK(jump < 1e-5);
    else
      CHECK(jump > 1e-3);
    CHECK(jump < bound + 1e-5);
  }
}

TEST_CASE("a spline is the same for any order of the samples and any number of threads") {
  const Samples s = sampled(3000, kSeed, f_test);
  Samples reversed = s;
  std::reverse(reversed.points.begin(), reversed.points.end());
  std::reverse(reversed.values.begin(), reversed.values.end());
  for (const Smoothness mode : kModes) {
    const CubicModel first = fit(s, {mode, {}, {}}).model;
    CHECK(equal(first, fit(reversed, {mode, {}, {}}).model));
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    CHECK(equal(first, fit(s, {mode, {}, {}}).model));
  }
}

TEST_CASE("degrees drop where samples do not determine them") {
  SECTION("three samples: constant") {
    const Samples s{{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 1}}, {1, 2, 6}};
    for (const Smoothness mode : kModes) {
      const CubicFit r = fit(s, {mode, {{2, 2, 2}}, {}});
      CHECK(r.degrees[0] == r.local_fits);
      CHECK(splines::evaluate(r.model, {0.3, 0.4, 0.5}).value == Approx(3));
    }
  }
  SECTION("one sample, equal samples: constant") {
    const Samples one{{{5, 6, 7}}, {8}};
    CHECK(splines::evaluate(fit(one, {}).model, {5, 6, 7}).value == 8);
    const Samples equal{std::vector<Vec3>(100, {5, 6, 7}), std::vector<double>(100, 8)};
    const CubicFit r = fit(equal, {});
    CHECK(splines::evaluate(r.model, {5, 6, 7}).value == Approx(8));
    CHECK(r.warnings.size() == 1);
    CHECK(r.empty_cubes == 0);
  }
  SECTION("samples in a plane across an axis: cubic in it, constant along the axis") {
    Samples s = sampled(500, kSeed, [](const Vec3&) { return 0.0; });
    const auto f = [](const Vec3& p) { return p[0] * p[0] * p[1] - 2 * p[1] + 1; };
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      s.points[i][2] = 3;
      s.values[i] = f(s.points[i]);
    }
    const CubicFit r = fit(s, {});
    CHECK(r.warnings.size() == 1);
    CHECK(r.model.domain.cubes[2] == 1);
    CHECK(r.degrees[3] == r.local_fits);
    for (const double z : {2.9, 3.0, 3.1}) {
      const auto at = splines::evaluate(r.model, {0.3, 0.4, z});
      CHECK(at.value == Approx(f({0.3, 0.4, 3})).margin(1e-12));
      CHECK(std::fabs(at.gradient[2]) < 1e-12);
    }
  }
  SECTION("samples on few layers: a lower degree, values as they are") {
    Samples s = sampled(4000, kSeed, [](const Vec3&) { return 0.0; });
    for (std::size_t i = 0; i < s.points.size(); ++i) {
      s.points[i][2] = static_cast<double>(i % 3) / 2;
      s.values[i] = s.points[i][0] - 2 * s.points[i][2];
    }
    const CubicFit r = fit(s, {Smoothness::local, {{2, 2, 2}}, {}});
    CHECK(r.degrees[3] < r.local_fits);
    CHECK(splines::error_at_samples(r.model, s.points, s.values).max < 1e-10);
  }
}

TEST_CASE("samples outside of the box are left out and counted, points outside have no value") {
  const Samples s = sampled(2000, kSeed, f_test);
  const CubicFit r = fit(s, {Smoothness::c1, {}, {{Vec3{0, 0, 0}, Vec3{0.5, 1, 1}}}});
  CHECK(r.samples + r.outside == 2000);
  CHECK(r.outside > 900);
  CHECK(r.samples ==
        static_cast<std::size_t>(std::count_if(s.points.begin(), s.points.end(),
                                               [](const Vec3& p) { return p[0] <= 0.5; })));
  const auto outside = splines::evaluate(r.model, {0.50000001, 0.5, 0.5});
  CHECK(std::isnan(outside.value));
  CHECK(std::isnan(outside.gradient[1]));
  for (const Vec3& corner : {Vec3{0, 0, 0}, Vec3{0.5, 1, 1}, Vec3{0.5, 0, 1}})
    CHECK(std::isfinite(splines::evaluate(r.model, corner).value));
}

TEST_CASE("numbers of cubes follow the samples and the box's shape") {
  Samples s = sampled(8000, kSeed, f_test);
  CHECK(fit(s, {Smoothness::local, {}, kUnitBox}).model.domain.cubes ==
        std::array<kernel::Index, 3>{9, 9, 9});
  for (Vec3& p : s.points) p = {p[0] * 4, p[1], p[2] / 2};
  // h = (10 * 2 / 8000)^(1/3) = 0.1357
  const auto cubes =
      fit(s, {Smoothness::local, {}, {{Vec3{0, 0, 0}, Vec3{4, 1, 0.5}}}}).model.domain.cubes;
  CHECK(cubes == std::array<kernel::Index, 3>{29, 7, 3});
}

TEST_CASE("bad samples, boxes and numbers of cubes are refused in one line") {
  const auto refused = [](Samples s, const CubicOptions& options, const std::string& words) {
    try {
      fit(s, options);
      FAIL("not refused");
    } catch (const kernel::InputError& error) {
      CHECK(std::string(error.what()).find(words) != std::string::npos);
      CHECK(std::string(error.what()).find('\n') == std::string::npos);
    }
  };
  const Samples good = sampled(50, kSeed, f_test);
  refused({}, {}, "there are none");
  Samples bad = good;
  bad.values[7] = std::nan("");
  refused(bad, {}, "sample 7");
  bad = good;
  bad.points[9][1] = HUGE_VAL;
  refused(bad, {}, "sample 9");
  refused(good, {Smoothness::c1, {}, {{Vec3{2, 2, 2}, Vec3{3, 3, 3}}}}, "no sample");
  refused(good, {Smoothness::c1, {}, {{Vec3{1, 0, 0}, Vec3{0, 1, 1}}}}, "box");
  refused(good, {Smoothness::c1, {{0, 1, 1}}, {}}, "cubes");
  refused(good, {Smoothness::c1, {{4000, 4000, 4000}}, {}}, "2^28");
  Samples far = good;
  for (Vec3& p : far.points) p[0] = 1e15 + p[0];
  refused(far, {}, "box");
}

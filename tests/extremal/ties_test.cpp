// SPDX-License-Identifier: GPL-3.0-or-later
// L equal to the least value, s_nn equal to the least strength, exactly: kept, says the rule, by
// the extraction and by its checker.
#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/extremal/fields.hpp"
#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"

using namespace crest;
using extremal::Options;
using extremal::Result;
using extremal::Volume;

namespace {

/// c - a (x' - m)^2, x' = x + slope y, so that L is c - a (x' - m)^2 - a (1 + slope^2) / 3 but next
/// to the border, and Hess s has the eigenvalues 2 a (1 + slope^2), 0, 0.
Volume parabola(std::array<kernel::Index, 3> size, double c, double a, double slope, double m) {
  Volume v;
  v.size = size;
  std::vector<double> samples;
  for (kernel::Index z = 0; z < size[2]; ++z)
    for (kernel::Index y = 0; y < size[1]; ++y)
      for (kernel::Index x = 0; x < size[0]; ++x)
        samples.push_back(c - a * std::pow(x + slope * y - m, 2));
  v.samples = std::move(samples);
  return v;
}

/// Polygons far from the border, where L is as said. The certificate must be accepted.
std::size_t inner_polygons(const Volume& volume, const Options& options) {
  certify::ExtremalCertificate certificate;
  const Result r = extremal::extract(volume, options, &certificate);
  const auto verdict = certify::verify(certify::encode(certificate));
  CAPTURE(verdict.reason);
  CHECK(verdict.accepted);
  std::size_t inner = 0;
  for (const auto& x : r.points) {
    bool inside = true;
    for (std::size_t k = 0; k < 3; ++k)
      inside = inside && (volume.size[k] == 1 || (x[k] > 3 && x[k] < volume.size[k] - 4.0));
    inner += inside ? 1 : 0;
  }
  return inner;
}

Options unsmoothed(extremal::Definition definition) {
  Options o;
  o.side = extremal::Side::ridge;
  o.definition = definition;
  o.sigma = 0;
  return o;
}

}  // namespace

TEST_CASE("extremal: s_nn equal to the least strength is kept") {
  using extremal::Definition;
  for (const auto definition : {Definition::structure, Definition::hessian})
    for (const std::array<kernel::Index, 3> size :
         {std::array<kernel::Index, 3>{14, 12, 11}, std::array<kernel::Index, 3>{16, 14, 1}})
      for (const double slope : {0.0, 0.5, 2.0}) {
        const double m = slope == 0 ? 6.5 : slope == 0.5 ? 9.25 : 18.5;
        const Volume v = parabola(size, 400, 3, slope, m);
        Options o = unsmoothed(definition);
        const double tie = 6 * (1 + slope * slope);
        CAPTURE(definition == Definition::hessian, size[2], slope);
        o.min_strength = std::nextafter(tie, 0.0);
        const std::size_t all = inner_polygons(v, o);
        CHECK(all > 0);
        o.min_strength = tie;
        CHECK(inner_polygons(v, o) == all);
        o.min_strength = std::nextafter(tie, 1e9);
        CHECK(inner_polygons(v, o) == 0);
      }
}

TEST_CASE("extremal: L equal to the least value is kept") {
  const Volume v = parabola({14, 12, 11}, 300, 3, 0, 6.5);  // L is 299 on the sheet
  Options o = unsmoothed(extremal::Definition::structure);
  o.min_value = std::nextafter(299.0, 0.0);
  const std::size_t all = inner_polygons(v, o);
  CHECK(all > 0);
  o.min_value = 299;
  CHECK(inner_polygons(v, o) == all);
  o.min_value = std::nextafter(299.0, 1e9);
  CHECK(inner_polygons(v, o) == 0);
}

TEST_CASE("extremal: fields at a place are as sums over the coefficients, exactly and not") {
  const Volume v = parabola({9, 8, 7}, 40, 1.25, 0.75, 6.1);
  for (const auto definition : {extremal::Definition::structure, extremal::Definition::hessian}) {
    Options o = unsmoothed(definition);
    o.sigma = 1;
    const extremal::Fields fields(v, o);
    for (const extremal::Node cell : {extremal::Node{3, 3, 3}, extremal::Node{0, 6, 2}}) {
      const kernel::Vec3 t{0.25, 0.8125, 0.375};
      const auto here = fields.at(cell, t);
      const auto exact = fields.exact_at(cell, t);
      const auto c = fields.coefficients(fields.scalars(), cell);
      const auto sum = [&](int a, int b, int d) {
        return kernel::spline_value<double, 3>(
            c, {kernel::spline_weights(t[0], a), kernel::spline_weights(t[1], b),
                kernel::spline_weights(t[2], d)});
      };
      CHECK(here.value == sum(0, 0, 0));
      CHECK(here.gradient == kernel::Vec3{-sum(1, 0, 0), -sum(0, 1, 0), -sum(0, 0, 1)});
      CHECK(here.hessian == extremal::Tensor{-sum(2, 0, 0), -sum(0, 2, 0), -sum(0, 0, 2),
                                             -sum(1, 1, 0), -sum(0, 1, 1), -sum(1, 0, 1)});
      CHECK(here.value == Approx(exact.value.convert_to<double>()).epsilon(1e-14));
      for (std::size_t i = 0; i < 6; ++i) {
        CHECK(here.hessian[i] ==
              Approx(exact.hessian[i].convert_to<double>()).margin(1e-12).epsilon(1e-12));
        CHECK(here.tensor[i] ==
              Approx(exact.tensor[i].convert_to<double>()).margin(1e-12).epsilon(1e-12));
      }
    }
  }
}

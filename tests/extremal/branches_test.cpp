// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices are on the branch of n that the zeros of their sheets are on.
#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/extremal/extraction.hpp"
#include "algorithms/extremal/placing.hpp"
#include "algorithms/extremal/straight_way.hpp"
#include "certify/extremal/encode.hpp"
#include "certify/verify.hpp"
#include "tests/extremal/reference_sheets.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::operator+;
using kernel::operator-;
using kernel::operator*;
using extremal::CellWays;
using extremal::Definition;
using extremal::Fields;
using extremal::Options;
using extremal::Vec3;

namespace {

Options by_hessian(double strength) {
  Options o;
  o.min_value = 0.4;
  o.definition = Definition::hessian;
  o.min_strength = strength;
  return o;
}

}  // namespace

TEST_CASE("extremal branches: by Hess no sliver stands beside a closed shell") {
  // Outside the shell n lies across the radius, s_nn being a tenth of the least strength.
  certify::ExtremalCertificate certificate;
  const auto r = extremal::extract(sampled(sphere_sheet, 48), by_hessian(60), &certificate);
  CHECK(r.counts.valence[0] == 0);
  CHECK(r.counts.valence[2] == 0);
  REQUIRE(r.components.size() == 1);
  CHECK(r.components[0].euler_characteristic == 2);
  CHECK(r.components[0].boundary_loops == 0);
  const auto verdict = certify::verify(certify::encode(certificate));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("extremal branches: a way is on one branch if n turns little along it") {
  // n is along the radius on the shell, across it from some 0.65 on.
  const Options o = by_hessian(0);
  const Fields fields(sampled(sphere_sheet, 64), o);
  const auto cell_at = [](double x) { return 31.5 * (x + 1); };
  std::size_t same = 0, other = 0;
  for (int i = 0; i < 40; ++i) {
    const double angle = 0.11 + 0.03 * i;
    const auto place = [&](double r) {
      return Vec3{cell_at(r * std::cos(angle)), cell_at(r * std::sin(angle)), cell_at(0.013)};
    };
    for (const double r : {0.59, 0.655}) {
      const Vec3 from = place(r), to = place(r + 0.015);
      const extremal::Node cell = {static_cast<int>(from[0]), static_cast<int>(from[1]), 31};
      Vec3 a, b;
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        a[k] = from[k] - cell[k];
        b[k] = to[k] - cell[k];
        inside = inside && b[k] >= 0 && b[k] <= 1;
      }
      if (!inside) continue;
      const auto n = [&](const Vec3& t) {
        return extremal::dominant_direction(fields.at(cell, t).tensor);
      };
      const bool one = CellWays(fields, cell).one_branch(a, b);
      // The least |cosine| on the way between any two of its places.
      double least = 1;
      for (int k = 0; k <= 20; ++k)
        least = std::min(least, std::fabs(kernel::dot(n(a), n(a + k / 20.0 * (b - a)))));
      if (one) CHECK(least > 0);
      if (least < 0.1) CHECK_FALSE(one);
      if (r < 0.6) CHECK(one);
      (one ? same : other) += 1;
    }
  }
  CHECK(same > 10);
  CHECK(other > 3);
}

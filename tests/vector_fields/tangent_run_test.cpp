// SPDX-License-Identifier: GPL-3.0-or-later
// Boundaries that the flow runs along: the separatrices of such a run start at its first vertex.
#include <array>
#include <catch2/catch.hpp>
#include <functional>

#include "algorithms/vector_fields/certificate.hpp"
#include "certify/skeleton/encode.hpp"
#include "certify/verify.hpp"

using namespace crest;
using vector_fields::PlanarField;
using vector_fields::Vec2;

namespace {

/// Unit squares, 5 by 5, without the four from (2, 2) to (4, 4), or without every second one.
PlanarField around_hole(const std::function<Vec2(double, double)>& v, bool checkered) {
  PlanarField field;
  std::array<std::array<kernel::Index, 6>, 6> number;
  for (auto& row : number) row.fill(kernel::kNone);
  const auto vertex = [&](std::size_t x, std::size_t y) {
    kernel::Index& n = number.at(x).at(y);
    if (n == kernel::kNone) {
      n = static_cast<kernel::Index>(field.points.size());
      const auto p = static_cast<double>(x), q = static_cast<double>(y);
      field.points.push_back({p, q});
      field.vectors.push_back(v(p, q));
    }
    return n;
  };
  for (std::size_t y = 0; y < 5; ++y)
    for (std::size_t x = 0; x < 5; ++x) {
      const bool hole = checkered ? x % 2 == 1 && y % 2 == 1 : x / 2 == 1 && y / 2 == 1;
      if (hole) continue;
      const auto a = vertex(x, y), b = vertex(x + 1, y), c = vertex(x + 1, y + 1),
                 d = vertex(x, y + 1);
      field.triangles.push_back({a, b, c});
      field.triangles.push_back({a, c, d});
    }
  return field;
}

}  // namespace

TEST_CASE("Flow along the sides of a hole: certificates are accepted") {
  for (const bool checkered : {false, true})
    for (const double sign : {1.0, -1.0})
      for (const auto& v : {std::function<Vec2(double, double)>([&](double, double) {
                              return Vec2{0, sign};
                            }),
                            std::function<Vec2(double, double)>([&](double, double) {
                              return Vec2{sign, 0};
                            }),
                            std::function<Vec2(double, double)>([&](double x, double y) {
                              return Vec2{0, sign * (x + y - 5.25)};
                            })}) {
        certify::SkeletonCertificate record;
        const auto skeleton = vector_fields::extract_skeleton(around_hole(v, checkered), record);
        CHECK(skeleton.switch_points.size() >= 2);
        const auto verdict = certify::verify(certify::encode(record));
        CAPTURE(checkered, sign, verdict.reason);
        CHECK(verdict.accepted);
      }
}

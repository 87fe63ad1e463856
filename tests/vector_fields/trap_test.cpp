// SPDX-License-Identifier: GPL-3.0-or-later
// Sinks and sources at vertices: lines end in polygons around them, which the checker proves.
#include <catch2/catch.hpp>

#include "algorithms/sampling/planar_fields.hpp"
#include "algorithms/vector_fields/certificate.hpp"
#include "algorithms/vector_fields/trace.hpp"
#include "certify/verify.hpp"
#include "tests/vector_fields/counts.hpp"

using namespace crest;
using namespace crest::tests;
using namespace crest::vector_fields;

namespace {

/// On [-3, 3]^2, with vertices at (-2, 0) and (2, 0).
template <class Flow>
PlanarField field_on_grid(Flow&& flow) {
  PlanarField field = field_of(sampling::lattice_field(1, 12));
  for (std::size_t i = 0; i < field.points.size(); ++i) {
    Vec2& p = field.points[i];
    p = {6 * p[0] - 3, 6 * p[1] - 3};
    for (double& x : p) x = std::round(2 * x) / 2;
    field.vectors[i] = flow(p[0], p[1]);
  }
  return field;
}

/// Lines that end in zeros of this place; all is proven.
std::size_t ends_at(const PlanarField& field, ZeroPlace place) {
  certify::SkeletonCertificate record;
  const Skeleton s = extract_skeleton(field, record);
  const auto verdict = certify::verify(certify::encode(record));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
  std::size_t count = 0;
  for (const Separatrix& l : s.separatrices) {
    CHECK(l.end != EndKind::undecided);
    if (l.end != EndKind::critical_point || s.critical_points[l.target].where != place) continue;
    ++count;
    CHECK(l.line.back() == s.critical_points[l.target].point);
  }
  return count;
}

/// Opposite vectors at the ends of the edges from (2, 0) to (2.5, 0) and from (-2, 0).
PlanarField sinks_inside_edges(double sign, double turn) {
  const auto flow = [&](double x, double y) {
    const double u = (x - 0.3) * (5.0625 - x * x) / 4 - turn * y * x * x / 5;
    const double v = -y + 0.2 * (5.0625 - x * x);
    return Vec2{sign * u, sign * v};
  };
  return field_on_grid([&](double x, double y) {
    if (y != 0 || std::fabs(x) != 2.5) return flow(x, y);
    const Vec2 v = flow(std::copysign(2, x), 0);
    return Vec2{-2 * v[0], -2 * v[1]};
  });
}

}  // namespace

TEST_CASE("Skeletons: lines end in sinks and sources at vertices") {
  for (const double sign : {1.0, -1.0})
    for (const double turn : {0.0, 0.5, -2.0}) {
      INFO("sign " << sign << ", turn " << turn);
      // Two sinks, nodes or spirals, and a saddle between them inside a triangle.
      const PlanarField field = field_on_grid([&](double x, double y) {
        const double u = (x - 0.3) * (4 - x * x) / 4 - turn * y * x * x / 4;
        const double v = -y + 0.2 * (4 - x * x);
        return Vec2{sign * u, sign * v};
      });
      CHECK(ends_at(field, ZeroPlace::vertex) >= 2);
    }
}

TEST_CASE("Skeletons: lines end in sinks and sources inside edges") {
  for (const double sign : {1.0, -1.0})
    for (const double turn : {0.0, 0.5, -1.0}) {
      INFO("sign " << sign << ", turn " << turn);
      const PlanarField field = sinks_inside_edges(sign, turn);
      CHECK(ends_at(field, ZeroPlace::edge) >= 2);
      certify::SkeletonCertificate record;
      extract_skeleton(field, record);
      const auto refused = [&](const auto& edit) {
        bool all = true;
        for (std::size_t i = 0; i < record.traps.size(); ++i) {
          if (record.zeros[record.traps[i].zero].place != certify::ZeroPlace::edge) continue;
          auto other = record;
          edit(other.traps[i]);
          all = all && !certify::verify(certify::encode(other)).accepted;
        }
        return all;
      };
      CHECK_FALSE(refused([](auto&) {}));
      CHECK(refused([](auto& t) {
        for (double& x : t.form) x /= 1.5;
      }));
      CHECK(refused([](auto& t) { t.form[0] = -t.form[0]; }));
      CHECK(refused([](auto& t) { t.zero = t.zero == 0 ? 1 : 0; }));
      CHECK(refused([](auto& t) { t.star.push_back({0, 0.5, 0}); }));
    }
}

TEST_CASE("Polygons around zeros: none where the flow leaves") {
  const auto polygons = [](double a, double b) {
    const PlanarField field = field_on_grid([&](double x, double y) {
      return Vec2{a * (x - 2), b * y};
    });
    const Domain domain(field);
    std::size_t count = 0;
    for (const ZeroComponent& z : find_zeros(domain))
      if (z.item.where == ZeroPlace::vertex) count += polygon_around(domain, z) ? 1 : 0;
    return count;
  };
  CHECK(polygons(-1, -1) == 1);  // a star
  CHECK(polygons(1, 3) == 1);
  CHECK(polygons(1, -3) == 0);
  CHECK(polygons(1, -1) == 0);
}

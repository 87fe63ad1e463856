// SPDX-License-Identifier: GPL-3.0-or-later
// The order of degenerate points round a tet's conic: the exact stage against doubles, and points
// that doubles do not tell apart.
#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "algorithms/modes/curves_certificate.hpp"
#include "algorithms/modes/degenerate_curves.hpp"
#include "algorithms/modes/degenerate_face.hpp"
#include "algorithms/modes/degenerate_order.hpp"
#include "certify/modes_curves/encode.hpp"
#include "certify/verify.hpp"
#include "tests/modes/reference_fields.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/random.hpp"

namespace {

using namespace crest;
using namespace crest::tests;
using namespace crest::modes;

/// Joined points, by their faces' opposite corners and the first weights there.
using Places = std::set<std::set<std::pair<std::size_t, long>>>;

long rounded(double weight) {
  return std::lround(1e6 * weight);
}

Places exact_joins(const std::vector<Tensor>& t) {
  std::vector<ConicPoint> points;
  std::vector<std::pair<std::size_t, long>> places;
  for (std::size_t k = 0; k < 4; ++k) {
    std::array<const Tensor*, 3> face{};
    for (std::size_t i = 0, at = 0; i < 4; ++i)
      if (i != k) face[at++] = &t[i];
    const FaceRoots roots = exact_face_roots(face);
    const std::vector<ExactPoint> exact = exact_face_points(face);
    REQUIRE(exact.size() == roots.count);
    for (std::size_t i = 0; i < roots.count; ++i) {
      points.push_back({exact[i], roots.root[i].type, k});
      places.emplace_back(k, rounded(roots.root[i].weights[0].mid));
    }
  }
  Places joins;
  if (points.empty()) return joins;
  for (const auto& [a, b] :
       joins_round_conic(*exact_forms<4>({&t[0], &t[1], &t[2], &t[3]}), points))
    joins.insert({places[a], places[b]});
  return joins;
}

Places joins_of(const DegenerateCurves& curves) {
  Places joins;
  const auto place = [&](std::uint32_t id) {
    const FacePoint& p = curves.points[id];
    const FaceCorners& f = curves.faces[p.face];
    return std::pair<std::size_t, long>(6 - f[0] - f[1] - f[2], rounded(p.weights[0]));
  };
  for (const DegenerateArc& arc : curves.arcs)
    joins.insert({place(arc.ends[0]), place(arc.ends[1])});
  return joins;
}

/// On the z axis xx = yy and no shears, but for what a solver's rounding leaves: the curve runs
/// along the axis, through faces on all sides.
SampledField nearly_fourfold_load(Random& random, double rounding) {
  SampledField s = box_mesh(4, 2, true);
  std::uniform_real_distribution<double> noise(-rounding, rounding);
  for (const kernel::Vec3& x : s.points) {
    std::array<double, 6> t{x[0] * x[0] - 1 - x[2], x[1] * x[1] - 1 - x[2], 4.5 + x[2], x[0] * x[1],
                            x[1] * (x[2] + 3),      x[0] * (x[2] + 3)};
    for (double& entry : t) entry += noise(random);
    s.tensors.push_back(t);
  }
  return s;
}

}  // namespace

TEST_CASE("degenerate points of random tets: integers join those that doubles do") {
  Random random(kSeed + 91);
  std::normal_distribution<double> normal;
  std::array<int, 5> arcs{};
  for (int i = 0; i < 300 * multiplier(); ++i) {
    std::vector<Tensor> t(4);
    for (Tensor& x : t)
      for (double& entry : x) entry = normal(random);
    const DegenerateCurves found =
        degenerate_curves(std::vector<kernel::Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                          std::vector<TetCorners>{{0, 1, 2, 3}}, t);
    REQUIRE(found.undecided.empty());
    const Places exact = exact_joins(t);
    CHECK(exact == joins_of(found));
    ++arcs[std::min<std::size_t>(exact.size(), 4)];
  }
  CHECK(arcs[1] > 30);
  CHECK(arcs[2] > 3);
}

TEST_CASE("degenerate points beside an edge, closer than doubles tell: their order is decided") {
  Random random(kSeed + 92);
  for (const double rounding : {1e-9, 1e-12, 1e-13, 1e-14, 1e-15}) {
    INFO("rounding " << rounding);
    const SampledField s = nearly_fourfold_load(random, rounding);
    const DegenerateCurves curves = degenerate_curves(s.points, s.tets, s.tensors);
    CHECK(curves.undecided.empty());
    std::size_t close = 0;
    for (const FacePoint& p : curves.points)
      close += std::hypot(p.point[0], p.point[1]) < 100 * rounding;
    CHECK(close > 20);
    const auto verdict =
        certify::verify(certify::encode(curves_certificate(s.points, s.tets, s.tensors, curves)));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
  }
}

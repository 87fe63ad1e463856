// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's vertices found a second time, from their medium eigenvectors (paper 004, section 4).
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "algorithms/modes/sphere.hpp"
#include "tests/modes/samples.hpp"

using namespace crest;
using namespace crest::tests;
using kernel::Vec3;
using kernel::operator-;
using modes::Level;

namespace {

struct Agreement {
  std::size_t compared = 0, near_complex_domain = 0;
  double farthest = 0;
};

/// Of the vertices with the nearer of their medium eigenvector's two points.
Agreement agreement(const Rows& rows, const modes::ModeSurface& s, double mu) {
  // The field's coordinates are those of the tet with corners 0, x, y, z.
  const modes::LinearTensors field({value_at(rows, {0, 0, 0}), value_at(rows, {1, 0, 0}),
                                    value_at(rows, {0, 1, 0}), value_at(rows, {0, 0, 1})});
  Agreement a;
  for (std::size_t i = 0; i < s.points.size(); ++i) {
    const Vec3 v = modes::eigensystem(modes::deviator(s.tensors[i])).vectors[1];
    const auto points = modes::mode_points(field, v, mu);
    // Next to the complex domain both points are one, up to the root of what rounds.
    if (!points || modes::real_domain(field, v, mu) < 1e-3) {
      ++a.near_complex_domain;
      continue;
    }
    double nearest = HUGE_VAL;
    for (const auto& p : *points)
      if (s.sign == 0 || p.sign == s.sign)
        nearest = std::min(
            nearest, kernel::norm(Vec3{p.weights[1], p.weights[2], p.weights[3]} - s.points[i]));
    a.farthest = std::max(a.farthest, nearest);
    ++a.compared;
  }
  return a;
}

}  // namespace

TEST_CASE("vertices are where their medium eigenvectors say, in closed form") {
  for (const Row& row : small_boxes()) {
    const auto field = box(row.rows, 2, 3, Cut::diagonal);
    for (const Level& level : {Level{0, 1}, Level{3, 10}, Level{3, 5}, Level{9, 10}}) {
      modes::ModeOptions options;
      options.deviation = 0.02;
      const auto r = modes::extract(field, level, options);
      Agreement all;
      for (const auto& s : r.surfaces) {
        const Agreement a = agreement(row.rows, s, level.value());
        all.compared += a.compared;
        all.near_complex_domain += a.near_complex_domain;
        all.farthest = std::max(all.farthest, a.farthest);
      }
      INFO("field " << row.name << ", mode " << level.value() << ": " << all.compared
                    << " compared, " << all.near_complex_domain << " next to the complex domain");
      CHECK(all.farthest < 1e-10);
      CHECK(all.compared > 100);
      CHECK(all.compared > 3 * all.near_complex_domain);
    }
  }
}

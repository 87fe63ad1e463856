// SPDX-License-Identifier: GPL-3.0-or-later
// What is extracted is proven by a checker that knows nothing of how.
#include "algorithms/modes/certificate.hpp"

#include <catch2/catch.hpp>

#include "algorithms/modes/tensors.hpp"
#include "certify/verify.hpp"
#include "tests/modes/samples.hpp"
#include "tests/support/random.hpp"

using namespace crest;
using namespace crest::tests;

namespace {

certify::ModesCertificate certified(modes::ModeField field, const std::vector<modes::Level>& levels,
                                    const modes::ModeOptions& options = {}) {
  const modes::ZeroSet zeros = modes::insert_zeros(field);
  std::vector<certify::ModeLevel> records;
  for (const auto& level : levels) modes::extract(field, level, options, records.emplace_back());
  return modes::make_certificate(field, zeros, records);
}

certify::Verdict checked(const modes::ModeField& field, const std::vector<modes::Level>& levels,
                         const modes::ModeOptions& options = {}) {
  return certify::verify(certify::encode(certified(field, levels, options)));
}

/// Pieces said to be placed, and all.
std::array<std::size_t, 2> placed(const certify::ModesCertificate& c) {
  std::array<std::size_t, 2> r{};
  for (const auto& level : c.levels) {
    r[0] += level.placed;
    r[1] += level.placed + level.not_placed;
  }
  return r;
}

}  // namespace

TEST_CASE("certificates of the reference fields are accepted") {
  for (const Row& row : small_boxes()) {
    const auto verdict = checked(box(row.rows, 2, 3, Cut::mirrored), {{0, 1}, {3, 10}, {9, 10}});
    INFO("field " << row.name << ": " << verdict.reason);
    CHECK(verdict.accepted);
  }
}

TEST_CASE("certificates place the pieces of the reference fields") {
  std::array<std::size_t, 2> sum{};
  for (const Row& row : small_boxes()) {
    const auto field = box(row.rows, 2, 3, Cut::mirrored);
    const auto c = certified(field, {{0, 1}, {3, 10}, {9, 10}});
    for (const auto& level : c.levels) {
      CHECK(level.root_places.size() == level.roots.size());
      CHECK(level.arc_points.size() == level.arcs.size());
    }
    const auto found = placed(c);
    sum[0] += found[0];
    sum[1] += found[1];
    // One more than can be is refused.
    auto bold = c;
    auto& level = bold.levels[1];
    level.placed += level.not_placed + 1;
    level.not_placed = 0;
    CHECK_FALSE(certify::verify(certify::encode(bold)).accepted);
  }
  INFO(sum[0] << " of " << sum[1]);
  CHECK(100 * sum[0] >= 99 * sum[1]);
}

TEST_CASE("certificates have all vertices near the level, and none that is not") {
  modes::ModeOptions fine;
  fine.deviation = 0.05;
  std::size_t inner = 0;
  for (const Row& row : small_boxes()) {
    const auto c = certified(box(row.rows, 2, 3, Cut::mirrored), {{0, 1}, {9, 10}}, fine);
    for (std::size_t i = 0; i < c.levels.size(); ++i) {
      const auto& level = c.levels[i];
      CHECK(level.near == level.roots.size() + level.points.size() + level.inner.size());
      inner += level.inner.size();
      // Off by 1e-9 of a weight, it is not near: gradients of the mode are of size 1.
      const auto moved = [&](const auto& change) {
        auto mutant = c;
        change(mutant.levels[i]);
        return certify::verify(certify::encode(mutant)).accepted;
      };
      REQUIRE((!level.inner.empty() && !level.points.empty()));
      CHECK_FALSE(moved([](certify::ModeLevel& l) {
        auto& w = l.inner[l.inner.size() / 2].weights;
        w[0] > w[1] ? w[0] -= 1e-9 : w[1] -= 1e-9;
      }));
      CHECK_FALSE(moved([](certify::ModeLevel& l) {
        auto& w = l.points[l.points.size() / 2];
        w[0] > w[1] ? w[0] -= 1e-9 : w[1] -= 1e-9;
      }));
      CHECK_FALSE(moved([](certify::ModeLevel& l) { l.inner.pop_back(); }));
    }
  }
  INFO(inner);
  CHECK(inner > 1000);
}

TEST_CASE("nothing is placed where a tetrahedron is flat") {
  auto field = box(small_boxes()[2].rows, 2, 3, Cut::diagonal);
  auto points = field.mesh.points();
  for (auto& p : points) p[2] = 0;
  field.mesh = kernel::TetMesh(points, field.mesh.tets());
  const auto c = certified(field, {{3, 10}});
  CHECK(placed(c)[0] == 0);
  CHECK(placed(c)[1] > 0);
  const auto verdict = certify::verify(certify::encode(c));
  INFO(verdict.reason);
  CHECK(verdict.accepted);
}

TEST_CASE("certificates of piecewise linear fields are accepted") {
  for (const Rows& rows : piecewise_linear()) {
    const auto verdict = checked(box(rows, 1.5, 5, Cut::diagonal), {{1, 2}, {4, 5}});
    INFO(verdict.reason);
    CHECK(verdict.accepted);
  }
}

TEST_CASE("certificates with cones, rims and undecided cells are accepted") {
  auto cone = box(small_boxes()[2].rows, 2, 3, Cut::diagonal);
  cone.tensors[13] = {5, 5, 5, 0, 0, 0};
  auto rims = box(small_boxes()[2].rows, 2, 4, Cut::diagonal);
  for (std::size_t v = 0; v < rims.tensors.size(); ++v)
    if (rims.mesh.points()[v][0] < 0) rims.tensors[v] = {};
  modes::ModeOptions shallow;
  shallow.max_depth = 2;
  for (const auto& verdict :
       {checked(cone, {{0, 1}, {3, 5}}), checked(rims, {{3, 5}}),
        checked(box(small_boxes()[2].rows, 2, 3, Cut::diagonal), {{9, 10}}, shallow)}) {
    INFO(verdict.reason);
    CHECK(verdict.accepted);
  }
}

TEST_CASE("certificates of small integers are accepted, exact hits and all") {
  Random random(6);
  modes::ModeOptions options;
  options.budget = 2000;
  for (int i = 0; i < 4; ++i) {
    const auto verdict = checked(
        random_box(3, [&] { return static_cast<double>(static_cast<int>(random() % 5) - 2); }),
        {{0, 1}, {1, 2}, {97, 100}}, options);
    INFO(verdict.reason);
    CHECK(verdict.accepted);
  }
}

TEST_CASE("zeros inside an edge, a face and a tetrahedron become vertices") {
  const auto base = box(small_boxes()[2].rows, 2, 3, Cut::diagonal);
  const auto t = base.mesh.sorted(10);
  for (std::size_t size = 2; size <= 4; ++size) {
    modes::ModeField field = base;
    // The last tensor is minus the others' sum.
    std::array<double, 6> sum{};
    for (std::size_t i = 0; i + 1 < size; ++i)
      for (std::size_t k = 0; k < 6; ++k) sum[k] -= field.tensors[t[i]][k];
    field.tensors[t[size - 1]] = sum;
    modes::ModeField copy = field;
    const auto zeros = modes::insert_zeros(copy);
    REQUIRE(zeros.simplices.size() == 1);
    CHECK(zeros.simplices[0].size() == size);
    const auto r = modes::extract(copy, {3, 5});
    CHECK(r.undecided.empty());
    for (const auto& s : r.surfaces) CHECK(s.watertight);
    const auto verdict = checked(field, {{0, 1}, {3, 5}});
    INFO(verdict.reason);
    CHECK(verdict.accepted);
  }
}

TEST_CASE("zeros between tensors of very different sizes are found") {
  const auto base = box(small_boxes()[2].rows, 2, 3, Cut::diagonal);
  const auto t = base.mesh.sorted(10);
  for (const int power : {-40, -300, -560, -700, -1000})
    for (std::size_t size = 2; size <= 4; ++size) {
      modes::ModeField field = base;
      // The last tensor is minus the others' sum, and a fraction of that.
      std::array<double, 6> sum{};
      for (std::size_t i = 0; i + 1 < size; ++i)
        for (std::size_t k = 0; k < 6; ++k) sum[k] -= field.tensors[t[i]][k];
      for (double& x : sum) x = std::ldexp(x, power);
      field.tensors[t[size - 1]] = sum;
      CAPTURE(power, size);
      REQUIRE(std::fabs(sum[3]) > 0);
      const auto zeros = modes::insert_zeros(field);
      REQUIRE(zeros.simplices.size() == 1);
      CHECK(zeros.simplices[0].size() == size);
    }
}

TEST_CASE("certificates of open tetrahedra with a zero corner are accepted") {
  Random random(11);
  std::size_t open = 0, others = 0;
  for (int i = 0; i < 12; ++i) {
    auto field = random_box(3, [&] { return static_cast<double>(random() % 401) - 200; });
    for (std::size_t v = 0; v < field.tensors.size(); ++v)
      if (random() % 5 == 0) field.tensors[v] = {};
    modes::ModeOptions options;
    options.max_depth = i % 3;
    const modes::Level level = i % 2 == 0 ? modes::Level{9, 10} : modes::Level{0, 1};
    auto copy = field;
    modes::insert_zeros(copy);
    const auto is_zero = [&](kernel::Index v) { return modes::is_isotropic(copy.tensors[v]); };
    for (const kernel::Index t : modes::extract(copy, level, options).undecided) {
      const auto corners = copy.mesh.sorted(t);
      ++(std::any_of(corners.begin(), corners.end(), is_zero) ? open : others);
    }
    const auto verdict = checked(field, {level}, options);
    CAPTURE(i, verdict.reason);
    CHECK(verdict.accepted);
  }
  CHECK(open > 0);
  CHECK(others > 0);
}

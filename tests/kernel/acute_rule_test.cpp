// SPDX-License-Identifier: GPL-3.0-or-later
#include "kernel/predicates/acute_rule.hpp"

#include "tests/kernel/ladder_checks.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

Vec3 opposite(const Vec3& v) {
  return {-v[0], -v[1], -v[2]};
}

struct Case {
  Vec3 d, e;
  Sign sign;
  Stage stage;
};

}  // namespace

TEST_CASE("acute rule: every stage decides") {
  const double tiny = 0x1p-60;
  const Case cases[] = {
      {{1, 0, 0}, {0.5, 1, 0}, Sign::positive, Stage::triage},
      {{1, 0, 0}, {-0.5, 1, 0}, Sign::negative, Stage::triage},
      // Powers of two: the interval is a point, the filter's bound is not reached.
      {{1, 1, 0}, {1, -1 + 0x1p-53, 0}, Sign::positive, Stage::interval},
      // (1 + e)^2 - (1 + 2e) - 2^-120 with e = 2^-52: an interval cannot tell e^2 from 0.
      {{1 + 0x1p-52, 1, tiny}, {1 + 0x1p-52, -(1 + 0x1p-51), -tiny}, Sign::positive, Stage::exact},
      // Exactly 90 degrees: first non-zero term of the perturbed product.
      {{1, 0, 0}, {0, 1, 0}, Sign::positive, Stage::symbolic},
      {{1, 0, 0}, {0, -1, 0}, Sign::negative, Stage::symbolic},
      {{1, 1, 0}, {1, -1, 0}, Sign::positive, Stage::symbolic},
      {{0, 0, 1}, {-1, 0, 0}, Sign::negative, Stage::symbolic},
  };
  for (const Case& c : cases) {
    CAPTURE(c.d, c.e);
    const Decision d = acute_rule(c.d, c.e);
    CHECK(d.sign == c.sign);
    CHECK(d.stage == c.stage);
  }
}

TEST_CASE("acute rule: laws 1, 2, 3 and 5 on all families") {
  Failures failures;
  for (Family family : kFamilies) {
    Draw d(1, family);
    for (std::uint64_t i = 0; i < scaled(20000); ++i) {
      const Vec3 a = draw_vector(d, family), b = draw_vector(d, family);
      const Sign s = acute_rule(a, b).sign;
      const bool odd =
          acute_rule(opposite(a), b).sign == -s && acute_rule(a, opposite(b)).sign == -s;
      failures.expect(s != Sign::zero && acute_rule(b, a).sign == s && odd &&
                          acute_rule(a, a).sign == Sign::positive,
                      "the laws hold for", a, b);
    }
  }
  CHECK(failures.report() == "");
}

TEST_CASE("acute rule: law 4, positive scaling") {
  Draw d(11);
  Failures failures;
  for (std::uint64_t i = 0; i < scaled(20000); ++i) {
    const Vec3 a = draw_vector(d, Family::small_integers), b = draw_vector(d, Family::generic);
    const Vec3 c = {a[0] * 1024, a[1] * 1024, a[2] * 1024};
    failures.expect(
        exact_acute_rule(a, b) == Sign::zero || acute_rule(a, b).sign == acute_rule(c, b).sign,
        "the law holds for", a, b);
  }
  CHECK(failures.report() == "");
}

TEST_CASE("acute rule: stages agree on the degenerate families", "[stress]") {
  require_depth(AcuteProduct{});
  StageCounts all;
  for (Family family : kFamilies) {
    Draw d(100, family);
    const StageCounts counts =
        require_stages_agree<AcuteProduct>(scaled(700000), [&](std::uint64_t) {
          return AcuteProduct{draw_vector(d, family), draw_vector(d, family)};
        });
    if (family == Family::generic)  // the filter's failure rate is a promise
      CHECK(static_cast<double>(counts.interval + counts.exact) <=
            1e-6 * static_cast<double>(counts.calls));
    all += counts;
  }
  // Nearly perpendicular pairs: e = a x b perturbed in the last bits.
  Draw d(200);
  all += require_stages_agree<AcuteProduct>(scaled(700000), [&](std::uint64_t) {
    const Vec3 a = draw_vector(d, Family::generic), b = draw_vector(d, Family::generic);
    return AcuteProduct{
        a, {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  });
  CHECK(all.interval > 0);
  CHECK(all.exact > 0);
}

TEST_CASE("acute rule: the error bound holds in rationals") {
  for (Family family : kFamilies) {
    Draw d(300, family);
    require_bound(scaled(2000), [&] {
      return AcuteProduct{draw_vector(d, family), draw_vector(d, family)};
    });
  }
}

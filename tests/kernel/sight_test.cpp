// SPDX-License-Identifier: GPL-3.0-or-later
// What an eye sees of triangles: laws, stages, ties against points that are displaced by rationals.
#include "kernel/predicates/sight.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <numeric>

#include "kernel/arithmetic/rational.hpp"
#include "kernel/geometry/index.hpp"
#include "tests/kernel/ladder_checks.hpp"

using namespace crest::kernel;
using namespace crest::tests;

namespace {

using Integer =
    boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off>;
using Exact = Vector3<Integer>;

/// 2^-10 for eps: coordinate j of the point of rank i is displaced by 2^(-10 2^(3 i + j)). All is
/// scaled so that points of ranks below `ranks` have integers.
Exact displaced(const Vec3& p, unsigned rank, unsigned ranks) {
  const unsigned scale = 10U << (3 * ranks - 1);
  Exact q;
  for (unsigned j = 0; j < 3; ++j)
    q[j] = (Integer(static_cast<int>(p[j])) << scale) +
           (Integer(1) << (scale - (10U << (3 * rank + j))));
  return q;
}

Integer determinant_of(const Exact& p, int w, const Exact& q, const Exact& r, const Exact& s) {
  return determinant(Exact(p - Integer(w) * q), Exact(r - q), Exact(s - q));
}

struct Scene {
  Eye eye;
  std::vector<Vec3> points;
};

/// Points that differ; of small integers most determinants vanish.
Scene draw_scene(Draw& d, Family family, std::size_t count) {
  Scene scene{{draw_vector(d, family), d.coin()}, {}};
  while (scene.points.size() < count) {
    const Vec3 p = draw_vector(d, family);
    if (std::find(scene.points.begin(), scene.points.end(), p) == scene.points.end())
      scene.points.push_back(p);
  }
  return scene;
}

}  // namespace

TEST_CASE("Depths and error bounds of the formulas of sight") {
  const SightOrientation finite{{}, 1, {}, {}, {}};
  require_depth(finite);
  require_depth(HomogeneousRows{});
  require_depth(PlaceGap{finite, finite, finite, finite});
  require_depth(InFrontOfEye{});
  for (const Family family : kFamilies) {
    Draw d(1, family);
    const auto orientation = [&] {
      return SightOrientation{draw_vector(d, family), d.coin() ? 1.0 : 0.0, draw_vector(d, family),
                              draw_vector(d, family), draw_vector(d, family)};
    };
    require_bound(300, orientation);
    require_bound(100, [&] {
      return PlaceGap{orientation(), orientation(), orientation(), orientation()};
    });
  }
}

TEST_CASE("Stages of sight's formulas agree, and all are reached") {
  StageCounts all;
  for (const Family family : kFamilies) {
    Draw d(2, family);
    all += require_stages_agree<SightOrientation>(400, [&](std::uint64_t) {
      return SightOrientation{draw_vector(d, family), d.coin() ? 1.0 : 0.0, draw_vector(d, family),
                              draw_vector(d, family), draw_vector(d, family)};
    });
  }
  CHECK(all.interval > 0);
  CHECK(all.exact > 0);
  CHECK(all.calls > 4 * (all.interval + all.exact));
  SightCounts counts;
  const Scene flat{{{0, 0, 1}, false}, {{0, 0, 0}, {1, 0, 0}, {2, 0, 3}, {4, 0, 1}}};
  const Sight sight(flat.eye, flat.points);
  CHECK(sight.side(0, 1, 2, counts).stage == Stage::symbolic);
  CHECK(counts.side.symbolic == 1);
}

TEST_CASE("Ties of sight are those of displaced points") {
  Draw d(3, Family::small_integers);
  Failures failures;
  std::uint64_t ties = 0;
  for (int i = 0; i < 1600; ++i) {
    const Scene scene = draw_scene(d, Family::small_integers, 4);
    const Sight sight(scene.eye, scene.points);
    SightCounts counts;
    std::array<Exact, 4> v;
    for (unsigned k = 0; k < 4; ++k) v[k] = displaced(scene.points[k], k, 4);
    const Sign volume = sight.volume(0, 1, 2, 3, counts).sign;
    failures.expect(volume == sign_of(determinant_of(v[0], 1, v[1], v[2], v[3])),
                    "the volume is that of displaced points on", scene.points[0], scene.points[1]);
    const Exact e = displaced(scene.eye.at, 0, 4);
    for (unsigned k = 0; k < 3; ++k) v[k] = displaced(scene.points[k], k + 1, 4);
    const Decision side = sight.side(0, 1, 2, counts);
    const Integer value = determinant_of(e, scene.eye.finite ? 1 : 0, v[0], v[1], v[2]);
    failures.expect(side.sign == sign_of(value), "the side is that of displaced points on",
                    scene.eye.at, scene.points[0], scene.points[1], scene.points[2]);
    ties += side.stage == Stage::symbolic;
  }
  CHECK(failures.report() == "");
  CHECK(ties > 100);
}

TEST_CASE("Sides and volumes are odd, and independent of numbers that keep their order") {
  Failures failures;
  for (const Family family : kFamilies) {
    Draw d(4, family);
    for (int i = 0; i < 150; ++i) {
      const Scene scene = draw_scene(d, family, 4);
      const Sight sight(scene.eye, scene.points);
      SightCounts c;
      const Sign side = sight.side(0, 1, 2, c).sign, volume = sight.volume(0, 1, 2, 3, c).sign;
      failures.expect(side != Sign::zero && volume != Sign::zero, "never zero on", scene.points[0]);
      failures.expect(sight.side(1, 0, 2, c).sign == -side && sight.side(1, 2, 0, c).sign == side,
                      "the side is odd on", scene.points[0]);
      failures.expect(
          sight.volume(1, 0, 2, 3, c).sign == -volume && sight.volume(3, 2, 1, 0, c).sign == volume,
          "the volume is odd on", scene.points[0]);
      std::vector<Vec3> spread = {scene.points[3]};
      for (std::size_t k = 0; k < 4; ++k) spread.insert(spread.end(), {scene.points[k], {9, 9, 9}});
      const Sight other(scene.eye, spread);
      failures.expect(
          other.side(1, 3, 5, c).sign == side && other.volume(1, 3, 5, 7, c).sign == volume,
          "new numbers in the same order change nothing on", scene.points[0]);
    }
  }
  CHECK(failures.report() == "");
}

TEST_CASE("Of crossing edges one is in front, from both ends and both sides") {
  Draw d(5, Family::small_integers);
  Failures failures;
  int crossings = 0;
  for (int i = 0; i < 4000; ++i) {
    Scene scene = draw_scene(d, i % 2 == 0 ? Family::small_integers : Family::generic, 4);
    // In perspective all is in front of the eye.
    if (scene.eye.finite) scene.eye.at = {0.25, 0.5, 40};
    const Sight sight(scene.eye, scene.points);
    SightCounts c;
    const bool crosses = sight.crosses(0, 1, 2, 3, c);
    failures.expect(
        crosses == sight.crosses(1, 0, 2, 3, c) && crosses == sight.crosses(2, 3, 1, 0, c),
        "crossing is symmetric on", scene.points[0]);
    if (!crosses) continue;
    ++crossings;
    const bool front = sight.in_front(0, 1, 2, 3, c);
    failures.expect(front == sight.in_front(1, 0, 3, 2, c), "in front is symmetric on",
                    scene.points[0]);
    failures.expect(front != sight.in_front(2, 3, 0, 1, c), "one is in front on", scene.points[0]);
  }
  CHECK(failures.report() == "");
  CHECK(crossings > 300);
}

TEST_CASE("Places of events are the limits of displaced ones") {
  Draw d(6, Family::small_integers);
  Failures failures;
  int places = 0, ends = 0;
  std::array<Index, 4> role = {0, 1, 2, 3};
  for (int i = 0; i < 700; ++i) {
    const Scene scene = draw_scene(d, Family::small_integers, 4);
    std::next_permutation(role.begin(), role.end());
    const auto [a, b, p, q] = role;
    const Sight sight(scene.eye, scene.points);
    SightCounts c;
    if (sight.side(p, q, a, c).sign == sight.side(p, q, b, c).sign) continue;
    const EventPlace place = sight.place(a, b, {p, q}, c);
    const auto value = [&](Index v) {
      const auto at = [&](Index u) { return displaced(scene.points[u], u + 1, 5); };
      return determinant_of(displaced(scene.eye.at, 0, 5), scene.eye.finite ? 1 : 0, at(p), at(q),
                            at(v));
    };
    const Integer x = value(a), y = value(b);
    const double t = Rational(Rational(x) / Rational(x - y)).convert_to<double>();
    failures.expect(std::abs(t - place.guess()) < 0.05, "the place is the limit on",
                    scene.points[a], scene.points[b], scene.points[p], scene.points[q]);
    failures.expect(
        place.at_start() == (place.guess() == 0) && place.at_end() == (place.guess() == 1),
        "the ends are ends on", scene.points[a]);
    ++places;
    ends += place.at_start() || place.at_end();
  }
  CHECK(failures.report() == "");
  CHECK(places > 100);
  CHECK(ends > 20);
}

TEST_CASE("The order of events is that of their places") {
  Draw d(7, Family::small_integers);
  Failures failures;
  int symbolic = 0, ties = 0;
  for (int i = 0; i < 3000; ++i) {
    const Scene scene = draw_scene(d, Family::small_integers, 7);
    const Sight sight(scene.eye, scene.points);
    SightCounts c;
    std::vector<EventPlace> found;
    for (const EventPlane& plane : {EventPlane{2, 3}, EventPlane{4, 5}, EventPlane{2, 4, 6}}) {
      const auto value = [&](Index v) {
        return plane.r == kNone ? sight.side(plane.p, plane.q, v, c).sign
                                : sight.volume(plane.p, plane.q, plane.r, v, c).sign;
      };
      if (value(0) != value(1)) found.push_back(sight.place(0, 1, plane, c));
    }
    for (const EventPlace& x : found)
      for (const EventPlace& y : found) {
        const Sign order = sight.event_order(0, 1, x, y, c);
        failures.expect(order == -sight.event_order(0, 1, y, x, c), "the order is odd on",
                        scene.points[0]);
        const bool tie = std::abs(x.guess() - y.guess()) < 1e-9;
        failures.expect(order == (tie ? Sign::zero : sign_of(x.guess() - y.guess())),
                        "the order is the places' on", scene.points[0], scene.points[1]);
        ties += tie && &x != &y;
      }
    symbolic += c.order.symbolic > 0;
  }
  CHECK(failures.report() == "");
  CHECK(ties > 20);
  CHECK(symbolic > 20);
}

TEST_CASE("An edge in a face's plane leaves at its end whatever the numbers") {
  // A is larger than B by a whole power of eps: the limit is 1, not the ratio of coefficients.
  const std::vector<Vec3> names = {{2, 3, 0}, {8, 3, 0}, {-20, -20, 0}, {40, -20, 0}, {0, 40, 0}};
  std::array<Index, 5> number = {0, 1, 2, 3, 4};
  int tried = 0;
  do {
    std::vector<Vec3> points(5);
    for (std::size_t k = 0; k < 5; ++k) points[number[k]] = names[k];
    const Sight sight({{1, 2, 3}, false}, points);
    SightCounts c;
    const auto [a, b, p, q, r] = number;
    if (sight.volume(p, q, r, a, c).sign == sight.volume(p, q, r, b, c).sign) continue;
    const EventPlace place = sight.place(a, b, {p, q, r}, c);
    CHECK((place.at_start() || place.at_end() || (place.guess() > 0 && place.guess() < 1)));
    // Numbered a < p < b < q < r.
    if (a < p && p < b && b < q && q < r) CHECK(place.at_end());
    ++tried;
  } while (std::next_permutation(number.begin(), number.end()));
  CHECK(tried > 20);
}

TEST_CASE("Edges seen end-on, and points in front of an eye") {
  const std::vector<Vec3> points = {{0, 0, 0}, {1, 2, 3}, {1, 2, 3.0000000000000004}, {3, 6, 9}};
  const Sight along({{1, 2, 3}, false}, points), from({{-1, -2, -3}, true}, points);
  CHECK(along.end_on(0, 1));
  CHECK(along.end_on(1, 3));
  CHECK_FALSE(along.end_on(0, 2));
  CHECK(from.end_on(0, 3));
  CHECK_FALSE(from.end_on(2, 3));
  CHECK(in_front_of_eye({0, 0, 5}, {0, 0, -1}, {7, 7, 5}) == Sign::zero);
  CHECK(in_front_of_eye({0, 0, 5}, {0, 0, -1}, {7, 7, 4.999999999999999}) == Sign::positive);
  CHECK(in_front_of_eye({1e200, 0, 5}, {1e200, 0, 0}, {-1e200, 7, 5}) == Sign::negative);
}

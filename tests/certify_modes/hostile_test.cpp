// SPDX-License-Identifier: GPL-3.0-or-later
// Claims 6 and 7: files made to break the checker; stages that must agree.
#include <catch2/catch.hpp>
#include <cmath>
#include <ctime>
#include <iostream>

#include "certify/container/reject.hpp"
#include "certify/modes/encode.hpp"
#include "certify/modes_curves/cones.hpp"
#include "certify/modes_curves/encode.hpp"
#include "certify/modes_curves/face_points.hpp"
#include "certify/modes_curves/near.hpp"
#include "certify/modes_curves/tet_arcs.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/environment.hpp"
#include "tests/support/failures.hpp"
#include "tests/support/random.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using Entries = std::array<double, 6>;

/// Numbers of six kinds: random, of all sizes, huge and tiny, small integers, these disturbed below
/// a double's digits and far below.
double number(Random& random, unsigned kind) {
  const double unit = static_cast<double>(random() % 2001) / 1000 - 1;
  const double whole = static_cast<double>(random() % 3) - 1;
  switch (kind) {
    case 0:
      return unit;
    case 1:
      return std::ldexp(unit, static_cast<int>(random() % 2000) - 1000);
    case 2:
      return random() % 3 ? 1e300 * unit : 5e-324 * whole;
    case 3:
      return whole;
    case 4:
      return whole + std::ldexp(unit, -45);
    default:
      return whole + std::ldexp(unit, -52);
  }
}
constexpr unsigned kKinds = 6;

template <std::size_t n>
std::vector<Entries> tensors(Random& random, unsigned kind) {
  std::vector<Entries> list(n);
  for (auto& t : list)
    for (double& x : t) x = number(random, kind);
  return list;
}

ModesCurvesCertificate one_tet(const std::vector<Entries>& corners) {
  ModesCurvesCertificate c;
  c.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  c.tets = {{0, 1, 2, 3}};
  c.tensors = corners;
  return c;
}

/// What integers say of a face for these boxes; empty: refused, or not decided.
std::optional<std::vector<curves::FacePoint>> exact_points(const std::vector<Entries>& corners,
                                                           const std::vector<curves::Box>& boxes) {
  modes::Field field(corners);
  modes::ExactTensors exact(field);
  try {
    return curves::find_points(exact, {0, 1, 2}, boxes);
  } catch (const Reject&) {
    return std::nullopt;
  }
}

}  // namespace

TEST_CASE("modes-curves: doubles, pairs and integers say the same of a face") {
  Random random(kSeed);
  Failures failures;
  std::array<std::array<std::uint64_t, 2>, kKinds> decided{};
  for (std::uint64_t i = 0; i < scaled(600); ++i) {
    const auto kind = static_cast<unsigned>(i % kKinds);
    const auto corners = tensors<3>(random, kind);
    const curves::Corners<3> near = {&corners[0], &corners[1], &corners[2]};
    for (const int type : {0, 1, -1}) {
      std::vector<curves::Box> boxes;
      if (type != 0) boxes.push_back({{-1, -1}, {2, 2}, type, 7});
      const auto found = curves::find_near_points(near, boxes);
      if (!found) continue;
      ++decided[kind][0];
      const auto exact = exact_points(corners, boxes);
      failures.expect(exact && exact->size() == found->size(), "points", corners[0][0],
                      static_cast<double>(kind));
      if (!exact || exact->size() != found->size()) continue;
      for (std::size_t k = 0; k < found->size(); ++k)
        failures.expect(
            (*exact)[k].type == (*found)[k].type && (*exact)[k].listed == (*found)[k].listed,
            "type", corners[0][0], static_cast<double>(kind));
      decided[kind][1] += !found->empty();
    }
  }
  CHECK(failures.report() == "");
  for (const auto& [all, with] : decided)
    std::cout << all << " faces decided by doubles and pairs, " << with << " with a point\n";
  CHECK(decided[0][1] > 20);
}

TEST_CASE("modes-curves: no cone holds a degenerate tensor") {
  // A mixture of four tensors that is degenerate, at all distances, inside and on the boundary.
  Random random(kSeed);
  std::normal_distribution<double> normal;
  Failures failures;
  std::uint64_t free = 0;
  for (std::uint64_t i = 0; i < scaled(20000); ++i) {
    std::array<double, 3> v{};
    for (double& x : v) x = normal(random);
    const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    const double s =
        (random() % 2 ? 1 : -1) * std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
    const Entries degenerate = {s * (v[0] * v[0] - square / 3),
                                s * (v[1] * v[1] - square / 3),
                                s * (v[2] * v[2] - square / 3),
                                s * v[0] * v[1],
                                s * v[1] * v[2],
                                s * v[0] * v[2]};
    const double spread = std::fabs(s) * square * std::ldexp(1.0, -static_cast<int>(random() % 30));
    std::vector<Entries> corners(4, degenerate);
    const bool with = random() % 2;
    Entries sum{};
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 6; ++k) {
        const double off = spread * normal(random);
        corners[c][k] += off, sum[k] += off;
      }
    for (std::size_t k = 0; k < 6; ++k)
      corners[3][k] += with ? -sum[k] : 3 * spread * normal(random) + 4 * sum[k];
    const modes::Field field(corners);
    const curves::Cones cones(field);
    const bool found = cones.free(std::array<std::uint32_t, 4>{0, 1, 2, 3});
    if (with) failures.expect(!found, "free", corners[0][0], spread);
    free += found;
    const bool corner = cones.free(std::array<std::uint32_t, 3>{0, 1, 2});
    free += corner;
    // And a corner itself.
    corners[1] = degenerate;
    const modes::Field other(corners);
    failures.expect(!curves::Cones(other).free(std::array<std::uint32_t, 3>{0, 1, 2}), "corner",
                    corners[0][0], spread);
  }
  CHECK(failures.report() == "");
  std::cout << free << " free simplices\n";
  CHECK(free > 200);
}

TEST_CASE("modes-curves: nothing, and nothing but special places, of all kinds of numbers") {
  Random random(kSeed);
  const std::vector<std::array<std::uint32_t, 3>> faces = {
      {0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  std::uint64_t accepted = 0;
  double longest = 0;
  for (std::uint64_t i = 0; i < scaled(12); ++i) {
    const auto c = one_tet(tensors<4>(random, static_cast<unsigned>(i % kKinds)));
    auto special = c;
    special.special_faces = faces;
    special.special_tets = {0};
    const Verdict verdict = verify(encode(special));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    const auto start = std::clock();
    accepted += verify(encode(c)).accepted;
    longest = std::max(longest, static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
  }
  std::cout << accepted << " tetrahedra without curves; " << longest << " s the longest\n";
  CHECK(longest < 20);
}

TEST_CASE("modes, modes-curves: empty and tiny input") {
  ModesCurvesCertificate curves;
  CHECK_FALSE(verify(encode(curves)).accepted);
  curves = one_tet({4, Entries{1, -1, 0, 0, 0, 0}});
  CHECK(verify(encode(curves)).accepted);  // constant
  curves.tensors.assign(4, Entries{});
  CHECK_FALSE(verify(encode(curves)).accepted);  // zero: to be listed
  curves.special_tets = {0};
  CHECK_FALSE(verify(encode(curves)).accepted);
  curves.special_faces = {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
  CHECK(verify(encode(curves)).accepted);
  curves.tets.push_back(curves.tets[0]);
  CHECK_FALSE(verify(encode(curves)).accepted);
  ModesCertificate surfaces;
  CHECK_FALSE(verify(encode(surfaces)).accepted);
  surfaces.points.resize(4), surfaces.tensors.resize(4);
  surfaces.tets = {{0, 1, 2, 3}};
  surfaces.levels.resize(1);
  CHECK(verify(encode(surfaces)).accepted);  // zero everywhere carries nothing
  surfaces.tets = {{0, 1, 2, 2}};
  CHECK_FALSE(verify(encode(surfaces)).accepted);
}

namespace {

/// Halved `depth` times everywhere.
void halve(std::vector<std::uint8_t>& codes, unsigned depth) {
  if (depth == 0) return codes.push_back(modes_code::kRoots);
  codes.push_back(32);
  halve(codes, depth - 1);
  halve(codes, depth - 1);
}

}  // namespace

TEST_CASE("modes: a much divided edge of many faces is refused before it costs") {
  // 400 tetrahedra around one edge, which is in 4096 parts.
  constexpr std::uint32_t kAround = 400;
  ModesCertificate c;
  c.points.assign(2 + kAround, {0, 0, 0});
  c.tensors.assign(2 + kAround, Entries{1, -2, 1, 0, 0, 0});
  for (std::uint32_t i = 0; i < kAround; ++i)
    c.tets.push_back({0, 1, 2 + i, 2 + (i + 1) % kAround});
  ModeLevel level;
  level.edges = {{0, 1}};
  for (std::uint32_t i = 0; i < kAround; ++i) level.faces.push_back({0, 1, 2 + i});
  for (const unsigned depth : {2U, 12U}) {
    level.codes.clear();
    halve(level.codes, depth);
    level.codes.insert(level.codes.end(), kAround, modes_code::kRejectedFace);
    c.levels = {level};
    const auto start = std::clock();
    const Verdict verdict = verify(encode(c));
    INFO(verdict.reason);
    CHECK(verdict.accepted == (depth == 2));
    if (depth > 2) CHECK(verdict.reason.find("divided too often") != std::string::npos);
    CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < 5);
  }
}

TEST_CASE("modes: many points of arcs in one cell are not compared in pairs") {
  // One cell with two arcs of 30 000 points each, all in one place.
  ModesInput input;
  input.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  input.tets = {{0, 1, 2, 3}};
  for (int v = 0; v < 4; ++v)
    input.tensors.push_back(
        tensor(v == 0 ? Traceless{2, -1, 0, 0, 0} : Traceless{1, -2, 0.1 * v, 0, 0}));
  auto c = reference_modes(input, {{0, 1}});
  REQUIRE(verify(encode(c)).accepted);
  add_positions(c);
  auto& level = c.levels[0];
  REQUIRE(level.placed == 1);
  for (const std::uint16_t count : {std::uint16_t{20}, std::uint16_t{30000}}) {
    level.arc_points.assign(level.arcs.size(), count);
    level.points.assign(level.arcs.size() * count, {0.25, 0.25});
    level.placed = 0, level.not_placed = 1;
    const auto start = std::clock();
    const Verdict verdict = verify(encode(c));
    INFO(verdict.reason);
    CHECK(verdict.accepted);
    CHECK(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC < 5);
  }
}

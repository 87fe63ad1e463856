// SPDX-License-Identifier: GPL-3.0-or-later
// Claim 7: refereed hole 9, multiple roots, points on edges, pairs of lines, and what is named of
// them; each case is decided, or refused unless it is listed as special.
#include <catch2/catch.hpp>
#include <numeric>

#include "certify/modes_curves/encode.hpp"
#include "certify/modes_curves/face_points.hpp"
#include "certify/modes_curves/near.hpp"
#include "certify/verify.hpp"
#include "tests/certify_modes/modes_samples.hpp"
#include "tests/support/verdicts.hpp"

using namespace crest::certify;
using namespace crest::tests;

namespace {

using Certificate = ModesCurvesCertificate;
using Entries = std::array<double, 6>;

Entries operator+(Entries a, const Entries& b) {
  for (std::size_t i = 0; i < 6; ++i) a[i] += b[i];
  return a;
}
Entries operator*(double x, Entries a) {
  for (double& entry : a) entry *= x;
  return a;
}

/// One tetrahedron, nothing listed.
Certificate one_tet(const std::array<Entries, 4>& tensors) {
  Certificate c;
  c.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  c.tets = {{0, 1, 2, 3}};
  c.tensors.assign(tensors.begin(), tensors.end());
  return c;
}
constexpr std::array<std::array<std::uint32_t, 3>, 4> kFaces = {
    {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
/// All faces and the tetrahedron listed as special but the face given.
Certificate special_but(Certificate c, std::array<std::uint32_t, 3> face = {}) {
  for (const auto& f : kFaces)
    if (f != face) c.special_faces.push_back(f);
  c.special_tets = {0};
  return c;
}
/// diag(-1, -1, 2), and two tensors so that the conics of the three touch at v = (0, 0, 1).
const Entries kAxis = {-1, -1, 2, 0, 0, 0}, kFirst = {0, 0, 0, 0, 1, 0},
              kSecond = {-1, 1, 0, -1, 0, 1};
const Entries kOther = {1, 2, -3, 0, 1, 2};

std::optional<std::size_t> exact_points(const Certificate& c) {
  modes::Field field(c.tensors);
  modes::ExactTensors exact(field);
  const auto found = curves::find_points(exact, {0, 1, 2}, {});
  if (!found) return std::nullopt;
  return found->size();
}

}  // namespace

TEST_CASE("modes-curves: hole 9, a multiple point inside a face is special") {
  const auto c =
      one_tet({kAxis + kFirst, kAxis + -1 * kFirst + kSecond, kAxis + -1 * kSecond, kOther});
  CHECK_FALSE(exact_points(c));
  require_accepted(special_but(c));
  CHECK(reason(special_but(c, {0, 1, 2})).find("multiple point") != std::string::npos);
}

TEST_CASE("modes-curves: a multiple point outside a face does not matter") {
  // Weights -1, -1, 1 of the point: outside, whatever its multiplicity.
  const auto c = one_tet({kFirst, -1 * kSecond, kAxis + kFirst + -1 * kSecond, kOther});
  const curves::Corners<3> corners = {&c.tensors[0], &c.tensors[1], &c.tensors[2]};
  CHECK_FALSE(curves::find_near_points(corners, {}));  // no doubles decide it
  CHECK(exact_points(c) == std::optional<std::size_t>(0));
  require_accepted(special_but(c, {0, 1, 2}));
}

TEST_CASE("modes-curves: hole 9, a point on an edge or at a vertex is special") {
  const auto edge = one_tet({kAxis + kFirst, kAxis + -1 * kFirst, kSecond, kOther});
  require_accepted(special_but(edge));
  CHECK(reason(special_but(edge, {0, 1, 2})).find("on an edge") != std::string::npos);
  CHECK(reason(special_but(edge, {0, 1, 3})).find("on an edge") != std::string::npos);
  const auto vertex = one_tet({kAxis, kFirst, kSecond, kOther});
  require_accepted(special_but(vertex));
  CHECK_FALSE(verify(encode(special_but(vertex, {0, 1, 2}))).accepted);
}

TEST_CASE("modes-curves: hole 9, a tetrahedron whose conic is a pair of lines") {
  // xx = yy: the conic is x^2 = y^2.
  const Entries axis = {-1, -1, 2, 0, 0, 0}, xy = {0, 0, 0, 1, 0, 0}, yz = {0, 0, 0, 0, 1, 0},
                xz = {0, 0, 0, 0, 0, 1};
  // All four near one free tensor: no point on a face, so none inside.
  const Entries mid = xy + yz;
  const auto empty =
      one_tet({mid + 0.1 * axis, mid + 0.1 * xz, mid + -0.1 * axis + 0.05 * xy, mid + -0.1 * xz});
  require_accepted(empty);
  // Around diag(-1, -1, 2), whose v = (0, 0, 1) is where both lines meet.
  const auto crossing =
      one_tet({axis + xz, axis + -1 * xz + yz, axis + xy + -1 * yz, axis + -1 * xy});
  require_accepted(special_but(crossing));
  auto bare = crossing;
  CHECK_FALSE(verify(encode(bare)).accepted);
}

TEST_CASE("modes-curves: dependent tensors are decided by edges and faces") {
  // Rank 2 and 3 far from degenerate tensors, and rank 1 with and without.
  const Entries a = {1, -1, 0, 0, 0, 0}, b = {0, 0, 0, 1, 0, 0}, d = {1, -1, 0, 0, 0.5, 0};
  for (const auto& tensors : {std::array{a, a + 0.2 * b, a + 0.1 * b, a + -0.2 * b},
                              std::array{a, a + 0.2 * b, d, a + 0.3 * d}, std::array{a, a, a, a}}) {
    const auto c = one_tet(tensors);
    require_accepted(c);
  }
  CHECK_FALSE(verify(encode(one_tet({kAxis, kAxis, kAxis, kAxis}))).accepted);
  // A degenerate tensor inside an edge of a face of rank 2.
  const auto c = one_tet({kAxis + kFirst, kAxis + -1 * kFirst, kAxis + 0.5 * kFirst, kOther});
  CHECK(reason(special_but(c, {0, 1, 2})).find("dependent") != std::string::npos);
  // A zero inside an edge: nothing is degenerate, but the mode is not below 1 there.
  CHECK_FALSE(verify(encode(special_but(one_tet({a, -1 * a, b, kOther}), {0, 1, 2}))).accepted);
}

TEST_CASE("modes-curves: faces of a symmetry plane and edges of an axis are named") {
  // xz = yz = 0 on face 012: a curve lies in it; kAxis and 2 kAxis along edge 03.
  const Entries in_plane = {1, 0, -1, 1, 0, 0}, other = {0, 1, -1, -2, 0, 0};
  auto c = special_but(one_tet({kAxis, in_plane, other, 2 * kAxis}));
  require_accepted(c);
  auto named = c;
  named.plane_faces = {{0, 1, 2}};
  named.degenerate_edges = {{0, 3}};
  require_accepted(named);
  const Verdict verdict = verify(encode(named));
  CHECK(std::ranges::any_of(verdict.lines, [](const std::string& line) {
    return line.find("1 edges of degenerate tensors") != std::string::npos;
  }));
  for (const auto& edge : {std::array{0U, 1U}, std::array{1U, 2U}, std::array{3U, 0U},
                           std::array{0U, 0U}, std::array{0U, 9U}}) {
    auto wrong = named;
    wrong.degenerate_edges = {edge};
    CHECK_FALSE(verify(encode(wrong)).accepted);
  }
  for (const auto& face : {std::array{0U, 1U, 3U}, std::array{0U, 2U, 3U}, std::array{2U, 1U, 0U},
                           std::array{0U, 1U, 9U}}) {
    auto wrong = named;
    wrong.plane_faces = {face};
    CHECK_FALSE(verify(encode(wrong)).accepted);
  }
  auto twice = named;
  twice.degenerate_edges = {{0, 3}, {0, 3}};
  CHECK_FALSE(verify(encode(twice)).accepted);
  auto general = special_but(one_tet({kAxis, in_plane, kOther, kFirst}));
  general.plane_faces = {{0, 1, 2}};
  CHECK(reason(general).find("no line in common") != std::string::npos);
  // A face that is not special, and an edge with zero inside.
  auto bare = named;
  std::erase(bare.special_faces, std::array<std::uint32_t, 3>{0, 1, 2});
  CHECK_FALSE(verify(encode(bare)).accepted);
  auto zero = special_but(one_tet({kAxis, in_plane, other, -2 * kAxis}));
  zero.degenerate_edges = {{0, 3}};
  CHECK_FALSE(verify(encode(zero)).accepted);
}
